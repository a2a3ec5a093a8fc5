# SPDX-License-Identifier: MIT
"""One match with several agents, behind PettingZoo's ParallelEnv."""
from __future__ import annotations

from typing import Any

import numpy as np

from .spaces import Box
from .vector_env import AutoresetMode, OneMatch, VectorEnv
from .configuration import learners_of_a_match, with_defaults

try:
    from pettingzoo import ParallelEnv as _ParallelBase
except ImportError:
    _ParallelBase = object  # type: ignore[misc,assignment]


class ParallelEnv(OneMatch, _ParallelBase):  # type: ignore[misc,valid-type]
    """One match with an agent for each learner, with the methods of pettingzoo.ParallelEnv.

    Takes the arguments of VectorEnv except num_envs, autoreset_mode and copy. The defaults are agents="robot" and
    opponent="self": the agents are blue_0, blue_1, … yellow_0, …. With agents="team" they are blue and yellow. All
    agents of a match end together.
    """

    metadata: dict[str, Any] = {"name": "mirocup_v0", "render_modes": ["rgb_array"], "render_fps": 30,
                                "is_parallelizable": True}

    def __init__(self, *, render_mode: str | None = None, **arguments: Any) -> None:
        arguments = {"agents": "robot", "opponent": "self", "threads": 1, **arguments}
        self.envs = VectorEnv(learners_of_a_match(with_defaults(arguments)), autoreset_mode=AutoresetMode.DISABLED,
                              render_mode=render_mode, **arguments)
        self.render_mode = render_mode
        self.possible_agents: list[str] = [slot["name"] for slot in self.envs.batch.spec["slots"]]
        self.agents: list[str] = []
        self.state_space = Box(-np.inf, np.inf, (self.envs.batch.bodies_count * 6,), dtype=np.float32)
        self.observation_spaces: dict[str, Box] = {a: self.envs.single_observation_space for a in self.possible_agents}
        self.action_spaces: dict[str, Box] = {}
        for agent in self.possible_agents:  # each with a generator of its own
            space = self.envs.single_action_space
            self.action_spaces[agent] = Box(space.low, space.high, dtype=np.float32)

    def reset(self, seed: int | None = None,
              options: dict[str, Any] | None = None) -> tuple[dict[str, np.ndarray], dict[str, dict[str, Any]]]:
        """Starts an episode with all agents. Returns an observation, float32 of observation_space(agent).shape, and an
        info for each. There are no options; PettingZoo's own tests give one that nobody knows, so they are ignored."""
        observations, _ = self.envs.reset(seed=seed)
        self.agents = list(self.possible_agents)
        return dict(zip(self.agents, observations)), {agent: {} for agent in self.agents}

    def restore(self, copy: bytes) -> dict[str, np.ndarray]:
        """As VectorEnv.restore(). Returns the observation of this state for each agent."""
        observations = self.envs.restore(copy)
        self.agents = [] if self.has_ended() else list(self.possible_agents)
        return dict(zip(self.possible_agents, observations))

    def step(self, actions: dict[str, np.ndarray]) -> tuple[
            dict[str, np.ndarray], dict[str, float], dict[str, bool], dict[str, bool], dict[str, dict[str, Any]]]:
        """Plays one step with an action, float of action_space(agent).shape, of each agent in `agents`.

        Returns observations, rewards, terminations, truncations and infos, each by agent. After the end of an episode
        `agents` is empty, until reset().
        """
        if not self.agents:
            return {}, {}, {}, {}, {}
        missing = [agent for agent in self.agents if agent not in actions]
        if missing:
            raise ValueError(f"no action of {missing[0]}: every agent acts in every step")
        unknown = [agent for agent in actions if agent not in self.agents]
        if unknown:
            raise ValueError(f"there is no agent {unknown[0]!r}: the agents are {', '.join(self.agents)}")
        stacked = np.stack([np.asarray(actions[agent], np.float32) for agent in self.agents])
        observations, rewards, terminations, truncations, vector_infos = self.envs.step(stacked)
        agents = self.agents
        infos: dict[str, dict[str, Any]] = {}
        for i, agent in enumerate(agents):
            infos[agent] = {"reward_terms": {k: float(v[i]) for k, v in vector_infos["reward_terms"].items()}}
            if "statistics" in vector_infos:
                infos[agent]["statistics"] = {k: v[i].item() for k, v in vector_infos["statistics"].items()}
        if self.has_ended():
            self.agents = []
        return (dict(zip(agents, observations)), dict(zip(agents, rewards.tolist())),
                dict(zip(agents, terminations.tolist())), dict(zip(agents, truncations.tolist())), infos)

    def observation_space(self, agent: str) -> Box:
        """The space of the agent's observations; the same object at each call."""
        return self.observation_spaces[agent]

    def action_space(self, agent: str) -> Box:
        """The space of the agent's actions; the same object at each call."""
        return self.action_spaces[agent]

    def state(self) -> np.ndarray:
        """The true state of all bodies in the field's frame, as VectorEnv.state: float32 of state_space.shape, which is
        ((2 * robots + 1) * 6,)."""
        return self.envs.state[0].astype(np.float32).ravel()

    @property
    def num_agents(self) -> int:
        return len(self.agents)

    @property
    def max_num_agents(self) -> int:
        return len(self.possible_agents)
