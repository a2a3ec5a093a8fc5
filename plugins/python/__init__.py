# SPDX-License-Identifier: MIT
"""Robot soccer for programs that learn, with Gymnasium's and PettingZoo's interfaces.

    import mirocup

    envs = mirocup.VectorEnv(num_envs=64, opponent="chaser", seed=1)
    observations, infos = envs.reset()
    observations, rewards, terminations, truncations, infos = envs.step(envs.action_space.sample())

`VectorEnv` plays many matches at once, `Env` one, `ParallelEnv` one with an agent for each robot. All
are parts of mirocup-labs and need numpy. gymnasium and pettingzoo
are used where they are installed, and not needed. Gymnasium makes them by their ids, too: see register_ids().
labs/docs/training.md has the whole story.

`mirocup.team` is the interface of teams that are written in Python: docs/python.md. It needs none of
this, so the environments are loaded when they are first asked for.
"""
import importlib.util
import sys

__version__ = "@PROJECT_VERSION@"

TYPE_CHECKING = False  # for programs that check types, which read what __getattr__ finds
if TYPE_CHECKING:
    from ._library import TrainingError as TrainingError
    from .configuration import PRESETS as PRESETS
    from .parallel_env import ParallelEnv as ParallelEnv
    from .policy import Policy as Policy
    from .vector_env import AutoresetMode as AutoresetMode, Env as Env, VectorEnv as VectorEnv

_HOMES = {"TrainingError": "_library", "PRESETS": "configuration", "ParallelEnv": "parallel_env",
          "Policy": "policy",
          "AutoresetMode": "vector_env", "Env": "vector_env", "VectorEnv": "vector_env"}

__all__ = sorted(_HOMES)


def __getattr__(name):
    home = _HOMES.get(name)
    if home is None:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    if importlib.util.find_spec(f"{__name__}.{home}") is None:
        raise ImportError(f"mirocup.{name} is a part of mirocup-labs: install the package mirocup-labs, or build it by "
                          "cmake -D MIROCUP_LABS=ON build && cmake --build build --target mirocup_training")
    value = getattr(importlib.import_module("." + home, __name__), name)
    globals()[name] = value
    return value


def __dir__():
    return sorted({*globals(), *__all__})


def register_ids():
    """Registers mirocup/MiroSot-v0 and mirocup/VSS-v0 (preset="vss") with Gymnasium. Called here if gymnasium was imported
    before: make("mirocup:mirocup/MiroSot-v0") imports both in this order."""
    from gymnasium.envs.registration import register, registry
    for name, arguments in (("MiroSot", {}), ("VSS", {"preset": "vss"})):
        if f"mirocup/{name}-v0" not in registry:
            register(id=f"mirocup/{name}-v0", entry_point="mirocup:Env", vector_entry_point="mirocup:VectorEnv",
                     kwargs=arguments)


if "gymnasium" in sys.modules:
    register_ids()
