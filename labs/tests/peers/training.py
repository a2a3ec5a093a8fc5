# SPDX-License-Identifier: MIT
"""Our environments in the programs of others, which are not in Debian: training.py BUILD, with PYTHONPATH=BUILD/python.

$MIROCUP_PEERS is a folder with checkouts of Gymnasium, PettingZoo, stable-baselines3 and cleanrl, named so. What is not there is
skipped, and named. One exemption: PettingZoo's render_test asks for the mode "human", a window, which our environments do not have."""
import dataclasses
import os
import runpy
import subprocess
import sys
import tempfile
import types
import unittest
import unittest.mock
import warnings
from pathlib import Path

PEERS = Path(os.environ.get("MIROCUP_PEERS", "/nowhere"))
NAMES = ("Gymnasium", "PettingZoo", "stable-baselines3", "cleanrl")
ID = "mirocup:mirocup/MiroSot-v0"
VSS = "mirocup:mirocup/VSS-v0"
sys.path[:0] = [str(PEERS / name) for name in NAMES]
sys.modules["farama_notifications"] = types.ModuleType("farama_notifications")  # Gymnasium's news, for one of its versions
sys.modules["farama_notifications"].notifications = {}


def needs(*names):
    missing = [name for name in names if not (PEERS / name).is_dir()]
    return unittest.skipIf(missing, f"$MIROCUP_PEERS has no {', '.join(missing)}")


def version(name):
    return subprocess.run(["git", "-C", PEERS / name, "describe", "--always"], capture_output=True, text=True,
                          check=False).stdout.strip() or "unknown"


class Gymnasium(unittest.TestCase):
    @needs("Gymnasium")
    def test_checker_and_wrappers(self):
        """Catches an environment of which check_env says anything, an id that is not registered, and infos that wrappers do not
        bear."""
        import gymnasium
        import numpy as np
        from gymnasium.utils.env_checker import check_env
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            for arguments in ({}, {"render_mode": "rgb_array"}, {"conditions": "camera", "opponent": "chaser"},
                              {"ticks_per_step": 3, "skip_stops": False}):
                for name in (ID, VSS):
                    check_env(gymnasium.make(name, **arguments).unwrapped)
        wrapped = gymnasium.wrappers.RecordEpisodeStatistics(gymnasium.make(ID, episode_seconds=0.5))
        wrapped.reset(seed=1)
        for _ in range(15):
            info = wrapped.step(wrapped.action_space.sample())[-1]
        self.assertEqual((info["episode"]["l"], info["statistics"]["steps"]), (15, 15.0))
        gymnasium.wrappers.TimeAwareObservation(gymnasium.make(VSS))
        for mode in ("sync", "async", "vector_entry_point"):
            limit = {"max_episode_steps": 15} if mode == "vector_entry_point" else {"episode_seconds": 0.5}
            envs = gymnasium.make_vec(ID, num_envs=10, vectorization_mode=mode, **limit)
            wrapped = gymnasium.wrappers.vector.RecordEpisodeStatistics(envs)
            wrapped.reset(seed=1)
            for _ in range(15):
                infos = wrapped.step(wrapped.action_space.sample())[-1]
            self.assertTrue(np.allclose(infos["episode"]["r"], infos["statistics"]["return"]))
            wrapped.close()


class PettingZoo(unittest.TestCase):
    @needs("Gymnasium", "PettingZoo")
    def test_its_tests(self):
        """Catches what PettingZoo's own tests of an environment refuse."""
        from mirocup import ParallelEnv
        from pettingzoo.test import api_test, parallel_api_test, parallel_seed_test, seed_test
        from pettingzoo.test.state_test import test_parallel_env
        from pettingzoo.utils.conversions import parallel_to_aec
        for agents in ("robot", "team"):
            parallel_api_test(ParallelEnv(episode_seconds=1.0, agents=agents), num_cycles=100)
            api_test(parallel_to_aec(ParallelEnv(episode_seconds=1.0, agents=agents)), num_cycles=100)
        parallel_seed_test(lambda: ParallelEnv(episode_seconds=1.0))
        seed_test(lambda: parallel_to_aec(ParallelEnv(episode_seconds=1.0)))
        test_parallel_env(ParallelEnv(episode_seconds=1.0))


class StableBaselines(unittest.TestCase):
    @needs("Gymnasium", "stable-baselines3")
    def test_learns(self):
        """Catches an environment that its checker refuses, and one in which PPO does not run."""
        import gymnasium
        from stable_baselines3 import PPO
        from stable_baselines3.common.env_checker import check_env
        from stable_baselines3.common.env_util import make_vec_env
        from stable_baselines3.common.evaluation import evaluate_policy
        from stable_baselines3.common.vec_env import DummyVecEnv, SubprocVecEnv
        with warnings.catch_warnings():
            warnings.simplefilter("error", UserWarning)
            for name in (ID, VSS):
                check_env(gymnasium.make(name).unwrapped)
            for kind in (DummyVecEnv, SubprocVecEnv):
                envs = make_vec_env(ID, n_envs=2, env_kwargs={"episode_seconds": 2.0}, vec_env_cls=kind)
                model = PPO("MlpPolicy", envs, n_steps=128).learn(1024)
                self.assertGreater(len(model.ep_info_buffer), 3)
                evaluate_policy(model, envs, n_eval_episodes=2)
                envs.close()


class CleanRl(unittest.TestCase):
    @needs("Gymnasium", "cleanrl")
    def test_ppo_with_only_the_id_changed(self):
        """Catches an end of an episode that its script does not bear. tyro and tensorboard, which are not in Debian, are replaced, and
        so is the signature that TransformObservation had in Gymnasium 0.29, for which the script was written."""
        import gymnasium
        tyro = types.ModuleType("tyro")
        tyro.cli = lambda kind: dataclasses.replace(kind(), env_id=ID, total_timesteps=4096, cuda=False)
        tensorboard = types.ModuleType("torch.utils.tensorboard")
        tensorboard.SummaryWriter = lambda folder: unittest.mock.MagicMock()
        sys.modules.update({"tyro": tyro, "torch.utils.tensorboard": tensorboard})
        new = gymnasium.wrappers.TransformObservation
        with unittest.mock.patch.object(gymnasium.wrappers, "TransformObservation",
                                        lambda env, change: new(env, change, env.observation_space)):
            script = PEERS / "cleanrl" / "cleanrl" / "ppo_continuous_action.py"
            after = runpy.run_path(str(script), run_name="__main__")
        self.assertEqual(after["global_step"], 4096)
        self.assertGreater(after["envs"].envs[0].get_wrapper_attr("episode_count"), 2)


if __name__ == "__main__":
    if not PEERS.is_dir():
        print("skipped: $MIROCUP_PEERS names no folder with " + ", ".join(NAMES))
        sys.exit(77)
    print(", ".join(f"{name} {version(name)}" for name in NAMES if (PEERS / name).is_dir()))
    os.chdir(tempfile.mkdtemp())
    unittest.main(argv=sys.argv[:1], verbosity=2)
