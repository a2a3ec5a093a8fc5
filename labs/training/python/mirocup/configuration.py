# SPDX-License-Identifier: MIT
"""From the arguments of an environment to the configuration of libmirocup_training."""
from __future__ import annotations

import math
import os
import re
from typing import Any

# The environment VSS-v0 of rSoccer: what its agent sees, does and gets, 1200 steps of 25 ms; one robot learns, five
# move at random. Here every episode begins with a kick-off.
PRESETS: dict[str, dict[str, Any]] = {
    "vss": {
        "observation": "vss",
        "action": "vss",
        "learners": [0],
        "mates": "noise",
        "opponent": "noise",
        "conditions": "exact",
        "referee": "goals",
        "control_period": 0.025,
        "episode_seconds": 30.0,
        "rewards": {"vss_goal": 10.0, "vss_ball_grad": 0.8, "vss_move": 0.2, "vss_energy": 2e-4},
    },
}

# The arguments of an environment that go into the configuration as they are, if they are given.
_KEYS = ("league", "rules", "referee", "control_period", "conditions", "start", "pitch", "agents", "observation", "action",
         "ticks_per_step", "skip_stops", "rewards", "threads")

DEFAULTS: dict[str, Any] = {
    "opponent": "idle",
    "learners": "all",
    "mates": "idle",
    "episode_seconds": 30.0,
    "max_episode_steps": None,
    "ends_at_goal": True,
}

# All arguments of an environment that say what is played.
ARGUMENTS = (*_KEYS, *DEFAULTS, "opponent_parameters", "preset")


def plain(value: Any, name: str = "") -> Any:
    """An argument as json writes it: scalars and arrays of numpy become numbers and lists. An error names the argument."""
    if isinstance(value, dict):
        return {key: plain(one, f"{name}[{key!r}]" if name else str(key)) for key, one in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(one, f"{name}[{i}]") for i, one in enumerate(value)]
    if hasattr(value, "tolist"):
        return plain(value.tolist(), name)
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, float) and not math.isfinite(value) and (name, value) != ("episode_seconds", math.inf):
        raise ValueError(f"{name}={value}: a finite number is expected")
    if not isinstance(value, (str, int, float, type(None))):
        raise TypeError(f"{name}={value!r}: a number, a text, a list or a dict is expected")
    return value


def in_arguments(message: str) -> str:
    """A complaint about the configuration, with the name of the argument instead of the place in the JSON."""
    found = re.match(r"configuration: /([^: ]+): ", message)
    if not found:
        return message
    first, *rest = found[1].split("/")
    name = {"matches": "num_envs", "autoreset": "autoreset_mode", "blue": "learners", "yellow": "opponent"}.get(first, first)
    if rest and first in ("blue", "yellow"):
        part = rest.pop(0)
        if part != "mates" or first == "blue":
            name = "opponent_parameters" if part == "parameters" else part
    elif rest and first == "episode":
        name = {"seconds": "episode_seconds", "steps": "max_episode_steps"}.get(rest[0], rest[0])
        rest = []
    places = "".join(f"[{part}]" if part.isdigit() else f"[{part!r}]" for part in rest)
    return f"{name}{places}: {message[found.end():]}"


def with_defaults(arguments: dict[str, Any]) -> dict[str, Any]:
    """The keyword arguments of an environment; what is None is left to the preset or the default."""
    preset = arguments.get("preset")
    if preset is not None and preset not in PRESETS:
        raise ValueError(f"preset {preset!r}: there are {', '.join(PRESETS)}")
    return {**DEFAULTS, **PRESETS.get(preset or "", {}), **{key: v for key, v in plain(arguments).items() if v is not None}}


def configuration(matches: int, autoreset: str, chosen: dict[str, Any]) -> dict[str, Any]:
    """The JSON configuration of a batch, from arguments with_defaults()."""
    learners: Any = {"learners": chosen["learners"], "mates": chosen["mates"]}
    opponent: Any = chosen["opponent"]
    if opponent == "self":
        if chosen.get("opponent_parameters"):
            raise ValueError("opponent_parameters: with opponent='self' no team plays that could ask for them")
        opponent = learners
    elif chosen.get("opponent_parameters"):
        opponent = {"mates": opponent, "parameters": chosen["opponent_parameters"]}
    seconds = chosen["episode_seconds"]
    return {
        "matches": matches,
        "autoreset": autoreset,
        "blue": learners,
        "yellow": opponent,
        "episode": {"seconds": None if seconds in (None, float("inf")) else seconds, "steps": chosen["max_episode_steps"],
                    "ends_at_goal": chosen["ends_at_goal"]},
        **{key: chosen[key] for key in _KEYS if key in chosen},
    }


def learners_of_a_match(chosen: dict[str, Any]) -> int:
    """How many rows a match has, from arguments with_defaults()."""
    of_a_team = 1
    if chosen.get("agents") == "robot":
        robots = {"middle": 5, "large": 11}.get(chosen.get("league"), 3)
        of_a_team = len(chosen["learners"]) if isinstance(chosen["learners"], list) else robots
    return of_a_team * (2 if chosen["opponent"] == "self" else 1)
