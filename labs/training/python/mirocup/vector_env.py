# SPDX-License-Identifier: MIT
"""Many matches at once behind Gymnasium's VectorEnv, and one behind its Env."""
from __future__ import annotations

import enum
import operator
from typing import Any

import numpy as np

from . import pictures, records
from ._library import Batch, TrainingError
from .configuration import ARGUMENTS, configuration, in_arguments, learners_of_a_match, with_defaults
from .spaces import batched, box_of

try:
    import gymnasium as _gymnasium
    from gymnasium.vector import VectorEnv as _VectorBase

    _EnvBase: Any = _gymnasium.Env
except ImportError:
    _VectorBase = object  # type: ignore[misc,assignment]
    _EnvBase = object

try:
    from gymnasium.vector import AutoresetMode
except ImportError:

    class AutoresetMode(enum.Enum):  # type: ignore[no-redef]
        """When an environment whose episode has ended starts the next one, as in Gymnasium."""

        NEXT_STEP = "NextStep"  # in the next step, whose action is ignored
        SAME_STEP = "SameStep"  # at once; the last observation is infos["final_obs"]
        DISABLED = "Disabled"  # when reset(options={"reset_mask": ...}) is called


_AUTORESET = {AutoresetMode.NEXT_STEP: "next_step", AutoresetMode.SAME_STEP: "same_step",
              AutoresetMode.DISABLED: "disabled"}


def _refuse(options: dict[str, Any] | None, known: tuple[str, ...]) -> None:
    """An option of reset() that nobody reads is a slip."""
    for name in options or {}:
        if name not in known:
            raise ValueError(f"there is no option {name!r}" + (f": there is {known[0]}" if known else ""))


class VectorEnv(_VectorBase):  # type: ignore[misc,valid-type]
    """Many matches at once, with the methods, shapes and autoreset modes of gymnasium.vector.VectorEnv.

    An environment is one learner: a team, or with agents="robot" one robot. With opponent="self" both teams learn, and
    environments 2 i and 2 i + 1 are the two teams of match i.

    num_envs         number of learners; a multiple of those of a match
    league           "small" (3 a side), "middle" (5) or "large" (11)
    conditions       "hall" (default), "exact", "camera", or a dict with a preset and changes: docs/conditions.md
    opponent         a house team ("idle", "chaser", "keeper", "striker", "navigator", "tactician"), the path of a
                     library, "noise", or "self"
    opponent_parameters  numbers of the opponent by name, as --param of mirocup match; reset() refuses those that it has
                     not asked for by the time play begins
    learners         "all", or the indices of the robots that learn
    mates            who steers the others: as opponent
    agents           "team": a learner steers all these robots; "robot": one learner for each
    observation      "standard", "relative" (one robot) or "vss"; action: "wheels", "drive" or "vss"
    rewards          weight of each term of the reward, by name; default {"goal": 1.0}
    referee          "laws", or "goals": no fouls, and restarts take no time
    rules            a preset ("mirosot", "simurosot", "vsss") or a dict with a preset and changes: docs/laws.md
    control_period   s; ticks_per_step: control periods for which an action holds
    episode_seconds  of play, after which an episode is truncated; float("inf"): never
    max_episode_steps  steps after which an episode is truncated, too; None: only by episode_seconds
    ends_at_goal     a goal terminates the episode; otherwise a leg is played to its end
    start            where episodes start: a situation as a dict, in which any number may be {"from": a, "to": b}, the name
                     of a drill, the path of a file of either, or a list, of which each episode draws one. None: the
                     kick-off
    pitch            numbers of the physics as in a scene, {"ball_mass": 0.05}; each may be a range, of which each episode
                     draws one, which its record holds
    skip_stops       steps go on until play is on; otherwise robots stand for some steps after a restart
    preset           "vss": rSoccer's VSS-v0
    autoreset_mode   an AutoresetMode
    threads          0: one for each processor; the result is the same
    seed             of the first reset() that is called without one
    render_mode      None or "rgb_array"
    copy             False: observations are the library's own buffer, which the next step overwrites
    """

    metadata: dict[str, Any] = {"render_modes": ["rgb_array"], "render_fps": 30}
    spec = None
    closed = False

    def __init__(self, num_envs: int = 1, *, league: str | None = None, conditions: Any = None,
                 opponent: str | None = None, opponent_parameters: dict[str, float] | None = None,
                 learners: Any = None, mates: str | None = None, agents: str | None = None,
                 observation: str | None = None, action: str | None = None,
                 rewards: dict[str, float] | None = None, referee: str | None = None, rules: Any = None,
                 control_period: float | None = None, ticks_per_step: int | None = None,
                 episode_seconds: float | None = None, max_episode_steps: int | None = None, ends_at_goal: bool | None = None,
                 start: Any = None, pitch: dict[str, Any] | None = None, skip_stops: bool | None = None, preset: str | None = None,
                 autoreset_mode: AutoresetMode = AutoresetMode.NEXT_STEP, threads: int = 0,
                 seed: int | None = None, render_mode: str | None = None, copy: bool = True) -> None:
        given = locals()
        chosen = with_defaults({name: given[name] for name in ARGUMENTS})
        if render_mode not in (None, "rgb_array"):
            raise ValueError(f"render_mode={render_mode!r}: there is no window; take 'rgb_array', which makes render() return pictures, "
                             "or see an episode in a browser with replay_page()")
        slots = learners_of_a_match(chosen)
        num_envs = operator.index(num_envs)
        if slots < 1 or num_envs < 1 or num_envs % slots != 0:
            raise ValueError(f"num_envs={num_envs}: a match has {slots} learners, so a multiple of {slots} is expected")
        autoreset_mode = AutoresetMode(autoreset_mode)
        config = configuration(num_envs // slots, _AUTORESET[autoreset_mode], chosen)
        try:
            self.batch = Batch(config)
        except TrainingError as error:
            raise TrainingError(in_arguments(str(error))) from None
        # None if it is not known beforehand: a step of several control periods ends with a stop of play.
        self.max_episode_steps: int | None = chosen["max_episode_steps"]
        if config["episode"]["seconds"] is not None and self.batch.spec["ticks_per_step"] == 1:
            steps = max(1, round(config["episode"]["seconds"] / self.batch.spec["control_period"]))
            self.max_episode_steps = min(steps, self.max_episode_steps or steps)
        self.num_envs = num_envs
        self.autoreset_mode = autoreset_mode
        self.metadata = {**self.metadata, "autoreset_mode": autoreset_mode}
        self.render_mode = render_mode
        self.copy = copy
        self.single_observation_space = box_of(self.batch.spec["observation"])
        self.single_action_space = box_of(self.batch.spec["action"])
        self.observation_space = batched(self.single_observation_space, num_envs)
        self.action_space = batched(self.single_action_space, num_envs)
        self.observation_names: list[str] = [q["name"] for q in self.batch.spec["observation"]]
        self.reward_terms: list[str] = [term["name"] for term in self.batch.spec["rewards"]]
        self._first_seed = seed
        self._np_random: np.random.Generator | None = None
        self._np_random_seed: int | None = None
        self._was_reset = False

    # ---- Gymnasium's methods

    def reset(self, *, seed: int | list[int] | np.ndarray | None = None,
              options: dict[str, Any] | None = None) -> tuple[np.ndarray, dict[str, Any]]:
        """Starts an episode in every environment.

        seed     int: environment i gets seed + i; or a seed for each environment. Later episodes follow from it. The
                 environments of one match have the seed of its first one. None: the next episodes.
        options  {"reset_mask": bool (num_envs,)}: only these environments, whole matches

        Returns observations, float32 (num_envs, *single_observation_space.shape), and infos.
        """
        slots = self.batch.slots
        _refuse(options, ("reset_mask",))
        mask = None
        if options is not None and "reset_mask" in options:
            of_rows = np.asarray(options["reset_mask"], np.bool_).reshape(-1, slots)
            mask = of_rows.any(axis=1)
            if of_rows.shape[0] != self.batch.matches or not np.array_equal(mask, of_rows.all(axis=1)):
                raise ValueError("reset_mask: one value for each environment is expected, equal for those of one match")
            if not self._was_reset and not mask.all():
                raise ValueError("reset_mask: the first reset must be of all environments")
        if seed is None and not self._was_reset:
            seed = self._first_seed if self._first_seed is not None else self.np_random_seed
        seeds = None
        if seed is not None:
            is_one = np.ndim(seed) == 0
            given = [seed] if is_one else list(seed)  # type: ignore[arg-type]
            if any(not isinstance(s, (int, np.integer)) or s < 0 for s in given):
                raise ValueError(f"seed={seed}: a whole number of at least 0 is expected, or one for each environment")
            if is_one:
                self._set_random(int(given[0]))
                given = [int(given[0]) + i for i in range(self.num_envs)]
            if len(given) != self.num_envs:
                raise ValueError(f"{self.num_envs} seeds are expected, not {len(given)}")
            seeds = np.array([int(s) % 2**64 for s in given[::slots]], np.uint64)
        self.batch.reset(mask, seeds)
        self._was_reset = True
        return self._observations(), {}

    def step(self, actions: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, dict[str, Any]]:
        """Plays one step of every environment.

        actions  float (num_envs, *single_action_space.shape), each in [-1, 1]: beyond, it is clamped

        Returns
        observations  float32 (num_envs, *single_observation_space.shape)
        rewards       float64 (num_envs,)
        terminations  bool (num_envs,): a goal, or the end of the leg
        truncations   bool (num_envs,): the episode was cut at its length
        infos         "reward_terms": each term without its weight, by name, (num_envs,) each; when episodes ended,
                      "statistics" of each, by name, where "_statistics" is true; with SAME_STEP "final_obs" and
                      "_final_obs". ("episode" is the key of Gymnasium's RecordEpisodeStatistics)
        """
        batch = self.batch
        actions = np.asarray(actions)
        if actions.shape != batch.actions.shape:
            raise ValueError(f"actions of shape {batch.actions.shape} are expected, not {actions.shape}")
        batch.actions[:] = actions
        batch.step()
        return (self._observations(), batch.rewards.astype(np.float64), batch.terminations.copy(),
                batch.truncations.copy(), self._infos())

    def render(self) -> tuple[np.ndarray, ...] | None:
        """With render_mode="rgb_array" a picture of each environment's match: uint8 (height, width, 3)."""
        if self.render_mode is None:
            return None
        frames = [self.frame(match) for match in range(self.batch.matches)]
        return tuple(frame for frame in frames for _ in range(self.batch.slots))

    def close(self, **_: Any) -> None:
        """Ends all matches; the environment cannot be used any more."""
        self.batch.close()
        self.closed = True

    @property
    def np_random(self) -> np.random.Generator:
        """A generator for wrappers, seeded by reset(seed=...). What happens in matches does not use it."""
        if self._np_random is None:
            self._set_random(None)
        assert self._np_random is not None
        return self._np_random

    @property
    def np_random_seed(self) -> int:
        if self._np_random_seed is None:
            self._set_random(None)
        assert self._np_random_seed is not None
        return self._np_random_seed

    # ---- more than Gymnasium has

    @property
    def state(self) -> np.ndarray:
        """The true state of all matches in the field's frame: float64 (matches, 2 * robots + 1, 6). For each robot of
        blue, each of yellow, and the ball: x, y (m), heading (rad), velocity along x and y (m/s), turn (rad/s)."""
        return np.stack([self.batch.bodies(match) for match in range(self.batch.matches)])

    def set_rewards(self, weights: dict[str, float]) -> None:
        """Sets the weights of the terms of the reward, by name; those that are not named become 0."""
        unknown = sorted(set(weights) - set(self.reward_terms))
        if unknown:
            raise ValueError(f"no term {unknown[0]!r}: there are {', '.join(self.reward_terms)}")
        self.batch.set_weights(np.array([weights.get(name, 0.0) for name in self.reward_terms]))

    def column(self, name: str) -> int:
        """The index of a number in an observation: observations[:, envs.column("ball_x")]."""
        if name not in self.observation_names:
            raise ValueError(f"there is no number {name!r}: there are {', '.join(self.observation_names)}")
        return self.observation_names.index(name)

    def frame(self, match: int = 0, width: int = 480) -> np.ndarray:
        """A picture of a match: uint8 (height, width, 3)."""
        return pictures.draw(self.batch.spec, self.batch.bodies(match), width)

    def record(self, path: str, match: int = 0, episode: str = "last") -> None:
        """Writes an episode as a record, which `mirocup verify` proves: "last", the one that ended last, or "current",
        as far as it has been played."""
        self.batch.record(match, records.is_last(episode), path)

    def replay_page(self, path: str, match: int = 0, episode: str = "last") -> None:
        """Writes an episode as a page that any browser shows, with the program `mirocup`."""
        records.write_page(self.batch, match, episode, path)

    def save(self, match: int = 0) -> bytes:
        """A copy of a match's state, with which restore() continues from here."""
        return self.batch.save(match)

    def restore(self, copy: bytes, match: int = 0) -> np.ndarray:
        """Puts a match into the state of a copy, of this or of any environment with the same arguments. Returns the
        observations of this state, float32 (environments of the match, *single_observation_space.shape)."""
        self.batch.restore(match, copy)
        return self._observations()[match * self.batch.slots:][:self.batch.slots]

    # ---- inside

    def _observations(self) -> np.ndarray:
        return self.batch.observations.copy() if self.copy else self.batch.observations

    def _set_random(self, seed: int | None) -> None:
        sequence = np.random.SeedSequence(seed)
        self._np_random = np.random.Generator(np.random.PCG64(sequence))
        self._np_random_seed = int(sequence.entropy) % 2**63  # type: ignore[arg-type]

    def _infos(self) -> dict[str, Any]:
        batch = self.batch
        everywhere = np.ones(self.num_envs, np.bool_)
        terms = batch.terms.T.copy()
        infos: dict[str, Any] = {"reward_terms": dict(zip(self.reward_terms, terms)), "_reward_terms": everywhere}
        ended = batch.terminations | batch.truncations
        if not ended.any():
            return infos
        statistics = np.where(ended[:, None], batch.statistics, 0.0).T
        infos["statistics"] = dict(zip(batch.spec["statistics"], statistics))
        infos["_statistics"] = ended
        if self.autoreset_mode == AutoresetMode.SAME_STEP:
            infos["final_obs"] = np.where(ended[:, None], batch.final_observations, np.float32(0.0))
            infos["_final_obs"] = ended.copy()
        return infos


class OneMatch:
    """What the environments of one match have in common."""

    envs: VectorEnv
    render_mode: str | None

    def render(self) -> np.ndarray | None:
        """With render_mode="rgb_array" a picture: uint8 (height, width, 3)."""
        return None if self.render_mode is None else self.envs.frame()

    def close(self) -> None:
        self.envs.close()

    def record(self, path: str, episode: str = "current") -> None:
        """As VectorEnv.record(); the episode that has ended is the current one until reset()."""
        self.envs.record(path, episode=episode)

    def replay_page(self, path: str, episode: str = "current") -> None:
        """As VectorEnv.replay_page()."""
        self.envs.replay_page(path, episode=episode)

    def set_rewards(self, weights: dict[str, float]) -> None:
        """As VectorEnv.set_rewards()."""
        self.envs.set_rewards(weights)

    def column(self, name: str) -> int:
        """The index of a number in an observation: observation[env.column("ball_x")]."""
        return self.envs.column(name)

    def save(self) -> bytes:
        """A copy of the match's state, with which restore() continues from here."""
        return self.envs.save()

    def has_ended(self) -> bool:
        """True from the end of an episode until reset() or restore()."""
        return bool(self.envs.batch.terminations[0] or self.envs.batch.truncations[0])


class Env(OneMatch, _EnvBase):  # type: ignore[misc,valid-type]
    """One match with one learner, with the methods of gymnasium.Env: takes the arguments of VectorEnv.

    env = mirocup.Env(preset="vss")  # instead of gymnasium.make("VSS-v0") of rSoccer
    """

    metadata: dict[str, Any] = {"render_modes": ["rgb_array"], "render_fps": 30}

    def __init__(self, *, render_mode: str | None = None, **arguments: Any) -> None:
        self._spec: Any = None
        arguments.setdefault("threads", 1)
        self.envs = VectorEnv(1, autoreset_mode=AutoresetMode.DISABLED, render_mode=render_mode, **arguments)
        self.observation_space = self.envs.single_observation_space
        self.action_space = self.envs.single_action_space
        self.render_mode = render_mode

    @property
    def spec(self) -> Any:
        """What Gymnasium's make() has made; its wrappers look up there how many steps an episode has at most."""
        return self._spec

    @spec.setter
    def spec(self, spec: Any) -> None:
        self._spec = spec
        if spec is not None and spec.max_episode_steps is None:
            spec.max_episode_steps = self.envs.max_episode_steps

    def reset(self, *, seed: int | None = None,
              options: dict[str, Any] | None = None) -> tuple[np.ndarray, dict[str, Any]]:
        """Starts an episode. Returns its first observation, float32 of observation_space.shape, and an info. There are no
        options."""
        _refuse(options, ())
        observations, _ = self.envs.reset(seed=seed)
        return observations[0], {}

    def restore(self, copy: bytes) -> np.ndarray:
        """As VectorEnv.restore(). Returns the observation of this state."""
        return self.envs.restore(copy)[0]

    def step(self, action: np.ndarray) -> tuple[np.ndarray, float, bool, bool, dict[str, Any]]:
        """Plays one step. Returns observation, reward, terminated, truncated, info. The info has "reward_terms", and
        "statistics" when the episode has ended. Then reset() has to be called: another step is an error."""
        if self.has_ended():
            raise TrainingError("the episode has ended: call reset()")
        observations, rewards, terminations, truncations, infos = self.envs.step(np.asarray(action)[None])
        info: dict[str, Any] = {"reward_terms": {k: float(v[0]) for k, v in infos["reward_terms"].items()}}
        if "statistics" in infos:
            info["statistics"] = {k: v[0].item() for k, v in infos["statistics"].items()}
        return observations[0], float(rewards[0]), bool(terminations[0]), bool(truncations[0]), info

    # Gymnasium's programs read the generator and its seed under both names.
    @property
    def np_random(self) -> np.random.Generator:
        """A generator for wrappers, as VectorEnv.np_random."""
        return self.envs.np_random

    @property
    def np_random_seed(self) -> int:
        return self.envs.np_random_seed

    _np_random = np_random
    _np_random_seed = np_random_seed
