# SPDX-License-Identifier: MIT
"""From the arguments of an environment to the configuration of libmirocup_training."""
from __future__ import annotations

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

# The arguments that go into the configuration as they are, if they are given.
_KEYS = ("league", "rules", "referee", "control_period", "conditions", "start", "pitch", "agents", "observation", "action",
         "ticks_per_step", "skip_stops", "rewards", "threads")

DEFAULTS: dict[str, Any] = {
    "opponent": "idle",
    "learners": "all",
    "mates": "idle",
    "episode_seconds": 30.0,
    "ends_at_goal": True,
}


def configuration(matches: int, autoreset: str, arguments: dict[str, Any]) -> dict[str, Any]:
    """The JSON configuration of a batch.

    arguments: the keyword arguments of an environment; what is None is left to the preset or the default.
    """
    preset = arguments.get("preset")
    if preset is not None and preset not in PRESETS:
        raise ValueError(f"preset {preset!r}: there are {', '.join(PRESETS)}")
    given = {key: value for key, value in arguments.items() if value is not None}
    given.pop("preset", None)
    chosen = {**DEFAULTS, **PRESETS.get(preset or "", {}), **given}
    unknown = sorted(set(chosen) - set(_KEYS) - set(DEFAULTS) - {"opponent_parameters"})
    if unknown:
        raise TypeError(f"unexpected argument {unknown[0]!r}")
    learners: Any = {"learners": chosen["learners"], "mates": chosen["mates"]}
    opponent: Any = chosen["opponent"]
    if opponent == "self":
        opponent = learners
    elif chosen.get("opponent_parameters"):
        opponent = {"mates": opponent, "parameters": chosen["opponent_parameters"]}
    seconds = chosen["episode_seconds"]
    return {
        "matches": matches,
        "autoreset": autoreset,
        "blue": learners,
        "yellow": opponent,
        "episode": {"seconds": None if seconds in (None, float("inf")) else seconds,
                    "ends_at_goal": chosen["ends_at_goal"]},
        **{key: chosen[key] for key in _KEYS if key in chosen},
    }


def learners_of_a_match(arguments: dict[str, Any]) -> int:
    """How many rows a match has."""
    preset = PRESETS.get(arguments.get("preset") or "", {})

    def chosen(key: str, default: Any) -> Any:
        value = arguments.get(key)
        return preset.get(key, default) if value is None else value

    learners = chosen("learners", "all")
    robots = {"small": 3, "middle": 5, "large": 11}.get(chosen("league", "small"), 3)
    of_a_team = 1
    if chosen("agents", "team") == "robot":
        of_a_team = robots if learners == "all" else len(learners)
    return of_a_team * (2 if chosen("opponent", "idle") == "self" else 1)
