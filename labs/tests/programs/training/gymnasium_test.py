# SPDX-License-Identifier: MIT
"""The written rules of gymnasium.vector.VectorEnv, gymnasium.Env and pettingzoo.ParallelEnv. Debian has neither package: what
their own checkers and wrappers say is asked by ../../peers. Run with PYTHONPATH=BUILD/python."""
import copy
import os
import pickle
import signal
import subprocess
import sys
import tempfile
import types
import unittest
from pathlib import Path

import numpy as np

import mirocup
from mirocup import AutoresetMode, Env, ParallelEnv, VectorEnv

BUILD = Path(sys.argv.pop(1)) if len(sys.argv) > 1 and not sys.argv[1].startswith("-") else Path("build")


def short(**arguments):
    """Ten environments whose episodes have 15 steps."""
    return VectorEnv(num_envs=10, **{"episode_seconds": 0.5, "threads": 2, **arguments})


class Vector(unittest.TestCase):
    def test_spaces_contain_what_is_returned(self):
        """Catches an observation that its space does not contain, a wrong shape or type, and two arrays that share
        memory."""
        for arguments in ({}, {"preset": "vss"}, {"opponent": "self"}, {"conditions": "camera", "opponent": "chaser"}):
            envs = short(**arguments)
            observations, infos = envs.reset(seed=1)
            self.assertIsInstance(infos, dict)
            self.assertEqual(envs.observation_space.shape, (10, *envs.single_observation_space.shape))
            self.assertEqual(envs.action_space.shape, (10, *envs.single_action_space.shape))
            for _ in range(40):
                self.assertIn(observations, envs.observation_space)
                self.assertIn(observations[3], envs.single_observation_space)
                before = observations.copy()
                result = envs.step(envs.action_space.sample())
                self.assertTrue(np.array_equal(before, observations), "the last observations were overwritten")
                observations, rewards, terminations, truncations, infos = result
                self.assertEqual((rewards.shape, rewards.dtype), ((10,), np.float64))
                for ends in (terminations, truncations):
                    self.assertEqual((ends.shape, ends.dtype), ((10,), np.bool_))
                for key in infos:
                    if not key.startswith("_"):
                        self.assertEqual(infos["_" + key].dtype, np.bool_, key)
            envs.close()

    def test_seeds(self):
        """Catches a start or an episode that the seed does not fix, and environments that are copies."""
        def play(seed):
            envs = short()
            first, _ = envs.reset(seed=seed)
            random = np.random.default_rng(4)
            rest = [envs.step(random.uniform(-1, 1, envs.action_space.shape))[0] for _ in range(40)]
            return np.stack([first, *rest])

        self.assertTrue(np.array_equal(play(7), play(7)))
        self.assertTrue(np.array_equal(play(7)[:, 3], play(list(range(7, 17)))[:, 3]), "environment i gets seed + i")
        self.assertFalse(np.array_equal(play(7), play(8)))
        self.assertTrue(np.array_equal(play(7)[0, 1], play(8)[0, 0]))
        first = play(7)[0]
        self.assertEqual(len(np.unique(first, axis=0)), 10)
        envs = short(seed=5)
        one, _ = envs.reset()
        two, _ = envs.reset()
        self.assertFalse(np.array_equal(one, two), "the next episodes are others")
        three, _ = short().reset(seed=5)
        self.assertTrue(np.array_equal(one, three), "seed of the constructor")

    def test_next_step(self):
        """Catches an autoreset in the same step, and an action that acts in the step of the reset."""
        envs = short(autoreset_mode=AutoresetMode.NEXT_STEP)
        self.assertEqual(envs.metadata["autoreset_mode"], AutoresetMode.NEXT_STEP)
        envs.reset(seed=1)
        zero = np.zeros(envs.action_space.shape)
        for step in range(15):
            _, _, terminations, truncations, infos = envs.step(zero)
            self.assertEqual(truncations.all(), step == 14)
            self.assertFalse(terminations.any())
        self.assertTrue(infos["_statistics"].all())
        self.assertTrue((infos["statistics"]["steps"] == 15).all())
        observations, rewards, terminations, truncations, infos = envs.step(zero + 1.0)
        self.assertFalse(truncations.any() or terminations.any() or rewards.any())
        self.assertNotIn("statistics", infos)
        reference = short(autoreset_mode=AutoresetMode.SAME_STEP)
        reference.reset(seed=1)
        for _ in range(15):
            same, _, _, truncations, infos = reference.step(zero)
        self.assertTrue(truncations.all() and infos["_final_obs"].all())
        self.assertTrue(np.array_equal(observations, same), "the first observation of the second episode")
        self.assertIn(infos["final_obs"][0], reference.single_observation_space)
        self.assertFalse(np.array_equal(infos["final_obs"], same))

    def test_disabled(self):
        """Catches an autoreset where none is wanted, and a mask that resets others."""
        envs = short(autoreset_mode=AutoresetMode.DISABLED)
        envs.reset(seed=1)
        zero = np.zeros(envs.action_space.shape)
        for _ in range(16):
            observations, _, _, truncations, _ = envs.step(zero)
        self.assertTrue(truncations.all())
        mask = np.arange(10) % 2 == 0
        again, _ = envs.reset(options={"reset_mask": mask})
        self.assertTrue(np.array_equal(again[~mask], observations[~mask]))
        self.assertFalse((again[mask] == observations[mask]).all())
        _, _, _, truncations, _ = envs.step(zero)
        self.assertTrue(np.array_equal(truncations, ~mask))

    def test_termination_is_no_truncation(self):
        """Catches a goal that truncates, and a cut that terminates."""
        envs = VectorEnv(num_envs=30, opponent="chaser", episode_seconds=15.0, threads=2,
                         autoreset_mode=AutoresetMode.SAME_STEP)
        envs.reset(seed=3)
        ends = {"goal": 0, "cut": 0}
        for _ in range(700):
            _, rewards, terminations, truncations, infos = envs.step(envs.action_space.sample())
            self.assertFalse((terminations & truncations).any())
            self.assertTrue((rewards[truncations] == 0.0).all())
            self.assertTrue((np.abs(rewards[terminations]) == 1.0).all())
            ends["goal"] += int(terminations.sum())
            ends["cut"] += int(truncations.sum())
            if terminations.any():
                goals = infos["statistics"]["score"] - infos["statistics"]["opponent_score"]
                self.assertTrue(np.array_equal(goals[terminations], rewards[terminations]))
        self.assertGreater(ends["goal"], 3)
        self.assertGreater(ends["cut"], 3)

    def test_rewards(self):
        """Catches weights that do not reach the library, and terms that do not add up."""
        envs = short(rewards={"ball_to_goal": 2.0, "energy": 0.5})
        envs.reset(seed=1)
        for weights in ({"ball_to_goal": 2.0, "energy": 0.5}, {"touch": 3.0, "time": 1.0}):
            envs.set_rewards(weights)
            for _ in range(10):
                _, rewards, _, _, infos = envs.step(envs.action_space.sample())
                total = sum(weight * infos["reward_terms"][name] for name, weight in weights.items())
                self.assertTrue(np.allclose(rewards, total, atol=1e-6))
        with self.assertRaisesRegex(ValueError, "ball_to_goal"):
            envs.set_rewards({"goals": 1.0})

    def test_self_play(self):
        """Catches two teams of a match that see it from the same end, or end at different times."""
        envs = short(opponent="self", conditions="exact")
        observations, _ = envs.reset(seed=1)
        x = [envs.column(name) for name in ("own_0_x", "own_1_y", "ball_x")]
        other = [envs.column(name) for name in ("opponent_0_x", "opponent_1_y", "ball_x")]
        for _ in range(20):
            observations, _, terminations, truncations, _ = envs.step(envs.action_space.sample())
            self.assertTrue(np.allclose(observations[0::2][:, x], -observations[1::2][:, other]))
            self.assertTrue(np.array_equal(truncations[0::2], truncations[1::2]))
        with self.assertRaisesRegex(ValueError, "multiple of 2"):
            VectorEnv(num_envs=3, opponent="self")

    def test_complaints(self):
        """Catches a slip that is taken silently."""
        for arguments in ({"opponent": "nobody"}, {"league": "huge"}, {"rewards": {"gaol": 1.0}}):
            with self.assertRaises(mirocup.TrainingError):
                VectorEnv(**arguments)
        with self.assertRaises(TypeError):
            VectorEnv(opponents="idle")
        for words, arguments in {
            "opponent: .*nobody": {"opponent": "nobody"},
            "opponent_parameters: only a library": {"opponent": "noise", "opponent_parameters": {"wait": 1.0}},
            r"learners\[0\]: ": {"learners": [7]},
            "mates: ": {"learners": [0], "mates": "nobody"},
            r"rewards\['goals'\]: ": {"rewards": {"goals": 1.0}},
            "episode_seconds: ": {"episode_seconds": -1.0},
            "ends_at_goal: ": {"ends_at_goal": 2},
            "max_episode_steps: ": {"max_episode_steps": 0},
            "conditions: ": {"conditions": "rain"},
        }.items():
            with self.assertRaisesRegex(mirocup.TrainingError, "^" + words):
                VectorEnv(**arguments)
        for words, arguments in {
            "render_mode='human': there is no window": {"render_mode": "human"},
            r"rewards\['goal'\]=nan": {"rewards": {"goal": float("nan")}},
            "episode_seconds=nan": {"episode_seconds": np.float32("nan")},
            "autoreset": {"autoreset_mode": "same"},
            "opponent_parameters: ": {"opponent": "self", "num_envs": 2, "opponent_parameters": {"wait": 1.0}},
        }.items():
            with self.assertRaisesRegex(ValueError, "(?i)" + words):
                VectorEnv(**arguments)
        with self.assertRaisesRegex(mirocup.TrainingError, "asked for no parameter nosuch"):
            VectorEnv(opponent="striker", opponent_parameters={"nosuch": 1.0}).reset()
        with self.assertRaisesRegex(ValueError, "vss"):
            VectorEnv(preset="ssl")
        envs = short()
        with self.assertRaisesRegex(mirocup.TrainingError, "reset"):
            envs.step(np.zeros(envs.action_space.shape))
        for words, arguments in {"reset_mask": {"options": {"resetmask": 1}}, "seed=1.5": {"seed": 1.5},
                                 "seed=-1": {"seed": -1}, "seed=.*-1": {"seed": [1, -1] * 5}, "10 seeds": {"seed": [1, 2]}}.items():
            with self.assertRaisesRegex(ValueError, words):
                envs.reset(**arguments)
        with self.assertRaisesRegex(ValueError, "ball_x, "):
            envs.column("ball_z")
        envs.reset()
        with self.assertRaisesRegex(ValueError, "shape"):
            envs.step(np.zeros(6))
        envs.close()
        with self.assertRaisesRegex(mirocup.TrainingError, "closed"):
            envs.reset()

    def test_numbers_of_numpy(self):
        """Catches a number of numpy that is none here: sweeps and optimisers give them."""
        def play(number, whole, robots):
            envs = VectorEnv(num_envs=whole(2), ticks_per_step=whole(2), episode_seconds=number(3), learners=robots([0, 2]),
                             rewards={"goal": number(0.5)}, threads=whole(1), opponent="chaser", autoreset_mode="SameStep",
                             start={"ball": {"position": robots([0.1, 0.2])}}, ends_at_goal=np.bool_(True))
            envs.reset(seed=whole(4))
            return np.array([envs.step(np.full(envs.action_space.shape, 0.7))[0] for _ in range(20)])
        self.assertTrue(np.array_equal(play(float, int, list), play(np.float32, np.int64, np.array)))

    def test_after_a_fork(self):
        """Catches a step in a child, which waited for ever for threads that only the parent has."""
        envs = short()
        envs.reset(seed=1)
        zero = np.zeros(envs.action_space.shape)
        envs.step(zero)
        child = os.fork()
        if child == 0:
            signal.alarm(60)
            code = 1
            try:
                envs.step(zero)
            except mirocup.TrainingError as error:
                code = 0 if "make one after the fork" in str(error) else 2
            envs.close()
            os._exit(code)
        self.assertEqual(os.waitpid(child, 0)[1], 0)
        envs.step(zero)

    def test_copies(self):
        """Catches a copy that shares its matches with the original: closing one would end those of both."""
        for copied in (copy.deepcopy, pickle.dumps):
            with self.assertRaisesRegex(mirocup.TrainingError, "make another one"):
                copied(short())

    def test_records_and_pictures(self):
        """Catches an episode that does not verify, a page that is none, and a picture without bodies."""
        envs = short(opponent="chaser", render_mode="rgb_array", autoreset_mode=AutoresetMode.SAME_STEP,
                     pitch={"ball_mass": {"from": 0.03, "to": 0.06}, "turn_time_constant": 0.04})
        envs.reset(seed=1)
        for _ in range(20):
            envs.step(envs.action_space.sample())
        with tempfile.TemporaryDirectory() as folder:
            record, page = f"{folder}/episode.json", f"{folder}/episode.html"
            envs.record(record, match=4)
            envs.replay_page(page, match=4, episode="current")
            subprocess.run([BUILD / "mirocup", "verify", record], check=True, capture_output=True)
            self.assertIn("<html", Path(page).read_text(encoding="utf-8")[:300])
        frames = envs.render()
        self.assertEqual(len(frames), 10)
        self.assertEqual((frames[0].dtype, frames[0].shape[2]), (np.uint8, 3))
        self.assertGreater(len(np.unique(frames[0].reshape(-1, 3), axis=0)), 5)
        self.assertFalse(np.array_equal(frames[0], frames[1]))

    def test_save_and_restore(self):
        """Catches a copy that is not the state."""
        envs = short(opponent="chaser", episode_seconds=30.0)
        envs.reset(seed=1)
        random = np.random.default_rng(1)
        actions = random.uniform(-1, 1, (60, *envs.action_space.shape))
        for action in actions[:20]:
            seen = envs.step(action)[0]
        copy = envs.save(2)
        one = [envs.step(action)[0][2] for action in actions]
        self.assertTrue(np.array_equal(envs.restore(copy, 2), seen[2:3]), "the observation of the restored state")
        self.assertTrue(np.array_equal(one, [envs.step(action)[0][2] for action in actions]))


class Single(unittest.TestCase):
    def test_env(self):
        """Catches what is not as gymnasium.Env has it: scalars, shapes, five results."""
        env = Env(preset="vss")
        observation, info = env.reset(seed=1)
        self.assertEqual((observation.shape, info), ((40,), {}))
        self.assertEqual(env.action_space.shape, (2,))
        for _ in range(1200):
            result = env.step(env.action_space.sample())
            self.assertEqual([type(x) for x in result], [np.ndarray, float, bool, bool, dict])
            observation, _, terminated, truncated, info = result
            self.assertIn(observation, env.observation_space)
            if terminated or truncated:
                break
        self.assertTrue(terminated or truncated)
        with self.assertRaisesRegex(mirocup.TrainingError, "reset"):
            env.step(env.action_space.sample())
        with self.assertRaisesRegex(ValueError, "foo"):
            env.reset(options={"foo": 1})
        self.assertIn("return", info["statistics"])
        self.assertNotIn("episode", info, "the key of RecordEpisodeStatistics")
        self.assertEqual((env._np_random_seed, env._np_random), (1, env.np_random), "what Gymnasium's checker reads")
        ended = env.save()
        env.reset()
        env.set_rewards({"time": 1.0})
        running, first = env.save(), env.step(np.zeros(2))
        self.assertAlmostEqual(first[1], -0.025)
        env.restore(ended)
        with self.assertRaisesRegex(mirocup.TrainingError, "reset"):
            env.step(np.zeros(2))
        env.restore(running)
        self.assertTrue(np.array_equal(env.step(np.zeros(2))[0], first[0]))

    def test_limits_of_steps(self):
        """Catches a limit that counts control periods instead of steps, and one that Gymnasium's wrappers do not find."""
        for arguments, steps, known in (({"max_episode_steps": 4, "ticks_per_step": 3}, 4, 4), ({"episode_seconds": 0.5}, 15, 15),
                                        ({"episode_seconds": 0.5, "ticks_per_step": 3}, 5, None),
                                        ({"episode_seconds": 0.5, "max_episode_steps": 20}, 15, 15)):
            env = Env(**arguments)
            env.reset(seed=1)
            self.assertEqual([env.step(np.zeros(6))[3] for _ in range(steps)], [False] * (steps - 1) + [True], arguments)
            env.spec = types.SimpleNamespace(max_episode_steps=None)
            self.assertEqual(env.spec.max_episode_steps, known, arguments)


class Parallel(unittest.TestCase):
    def test_rules(self):
        """Catches keys that are not the live agents, spaces that change, and agents that stay after the end."""
        env = ParallelEnv(episode_seconds=0.5)
        self.assertEqual(env.possible_agents, [f"{team}_{i}" for team in ("blue", "yellow") for i in range(3)])
        for seed in (1, 2):
            observations, infos = env.reset(seed=seed)
            self.assertEqual(set(observations), set(env.agents))
            self.assertEqual(set(infos), set(env.agents))
            self.assertEqual(env.num_agents, env.max_num_agents)
            steps = 0
            while env.agents:
                live = list(env.agents)
                result = env.step({agent: env.action_space(agent).sample() for agent in live})
                steps += 1
                for by_agent in result:
                    self.assertEqual(list(by_agent), live)
                for agent in live:
                    self.assertIn(result[0][agent], env.observation_space(agent))
                    self.assertIs(env.observation_space(agent), env.observation_space(agent))
                    self.assertIsInstance(result[1][agent], float)
                    self.assertIsInstance(result[2][agent], bool)
            self.assertEqual(steps, 15)
            self.assertTrue(all(result[3].values()))
            self.assertEqual(env.step({}), ({}, {}, {}, {}, {}))
            self.assertEqual(env.state().shape, (42,))
            self.assertIn(env.state(), env.state_space)
        copy = env.save()
        first, _ = env.reset()
        running = env.save()
        self.assertEqual((env.restore(copy).keys(), env.agents), (first.keys(), []))
        self.assertTrue(all(np.array_equal(again, first[agent]) for agent, again in env.restore(running).items()))
        self.assertEqual(env.agents, env.possible_agents)
        env.reset(seed=1)
        actions = {agent: env.action_space(agent).sample() for agent in env.agents}
        with self.assertRaisesRegex(ValueError, "green_0"):
            env.step({**actions, "green_0": actions["blue_0"]})

    def test_an_agent_comes_first_in_its_own_observation(self):
        """Catches an agent that sees another robot as itself."""
        env = ParallelEnv(conditions="exact")
        observations, _ = env.reset(seed=1)
        for _ in range(10):
            observations, *_ = env.step({agent: env.action_space(agent).sample() for agent in env.agents})
        bodies = env.envs.state[0]
        metre = env.envs.batch.spec["observation"][0]["scale"]
        x = env.envs.column("own_0_x")
        for i, agent in enumerate(env.possible_agents):
            own = np.abs(bodies[i, :2])  # the frame of a team may be turned
            self.assertTrue(np.allclose(np.abs(observations[agent][x:x + 2]) * metre, own, atol=1e-5), agent)


class Vss(unittest.TestCase):
    def test_observation_and_reward_are_those_of_rsoccer(self):
        """Catches a preset that is not rSoccer's: its observation and reward, computed here from the true state."""
        env = Env(preset="vss")
        spec = env.envs.batch.spec
        field, robot = spec["field"], spec["bodies"]
        half_length, goal_depth = field["half_length"], field["goal_depth"]
        max_pos = max(field["half_width"], half_length + 0.15)
        max_v = robot["wheel_speed_limit"] * robot["wheel_radius"]
        max_w = np.rad2deg(max_v / 0.04)
        random = np.random.default_rng(2)
        compared = 0
        for seed in range(1, 5):
            observation, _ = env.reset(seed=seed)
            previous = None
            for _ in range(150):
                action = random.uniform(-1, 1, 2).astype(np.float32)
                observation, reward, terminated, truncated, info = env.step(action)
                bodies = env.envs.state[0]
                if np.abs(bodies[0, 0] + observation[4] * max_pos) < 1e-5:  # blue defends the right end
                    bodies = bodies * [-1, -1, 1, -1, -1, 1] + [0, 0, np.pi, 0, 0, 0]
                ball = bodies[6]
                expected = [ball[0] / max_pos, ball[1] / max_pos, ball[3] / max_v, ball[4] / max_v]
                for x, y, angle, vx, vy, turn in bodies[:3]:
                    expected += [x / max_pos, y / max_pos, np.sin(angle), np.cos(angle), vx / max_v, vy / max_v,
                                 np.rad2deg(turn) / max_w]
                for x, y, _, vx, vy, turn in bodies[3:6]:
                    expected += [x / max_pos, y / max_pos, vx / max_v, vy / max_v, np.rad2deg(turn) / max_w]
                expected = np.clip(expected, -1.2, 1.2)
                self.assertTrue(np.allclose(observation, expected, atol=1e-5))
                if terminated:
                    self.assertEqual(abs(reward), 10.0)
                    break
                to_attack = np.hypot((half_length + goal_depth - ball[0]) * 100, np.sqrt(2.0) * ball[1] * 100)
                to_defence = np.hypot((half_length + goal_depth + ball[0]) * 100, np.sqrt(2.0) * ball[1] * 100)
                potential = ((-to_attack + to_defence) / (2.0 * half_length * 100) - 1.0) / 2.0
                gradient = 0.0 if previous is None else np.clip((potential - previous) * 3.0 / 0.025, -5.0, 5.0)
                previous = potential
                way = ball[:2] - bodies[0, :2]
                move = np.clip(np.dot(way / np.linalg.norm(way), bodies[0, 3:5]) / 0.4, -5.0, 5.0)
                speeds = np.clip(action.astype(float) * max_v, -max_v, max_v)
                speeds[np.abs(speeds) < 0.05] = 0.0
                energy = -np.abs(speeds / robot["wheel_radius"]).sum()
                self.assertAlmostEqual(reward, 0.8 * gradient + 0.2 * move + 2e-4 * energy, places=4)
                compared += 1
                if truncated:
                    break
        self.assertGreater(compared, 200)


if __name__ == "__main__":
    unittest.main()
