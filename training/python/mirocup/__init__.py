# SPDX-License-Identifier: MIT
"""Robot soccer for programs that learn, with Gymnasium's and PettingZoo's interfaces.

    import mirocup

    envs = mirocup.VectorEnv(num_envs=64, opponent="chaser", seed=1)
    observations, infos = envs.reset()
    observations, rewards, terminations, truncations, infos = envs.step(envs.action_space.sample())

`VectorEnv` plays many matches at once, `Env` one, `ParallelEnv` one with an agent for each robot. All
need numpy and libmirocup_training, which is built and installed with mirocup. gymnasium and pettingzoo
are used where they are installed, and not needed. docs/training.md has the whole story.
"""
from ._library import TrainingError
from .configuration import PRESETS
from .parallel_env import ParallelEnv
from .policy import Policy
from .vector_env import AutoresetMode, Env, VectorEnv

__all__ = ["AutoresetMode", "Env", "PRESETS", "ParallelEnv", "Policy", "TrainingError", "VectorEnv"]
