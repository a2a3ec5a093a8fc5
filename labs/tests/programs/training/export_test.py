# SPDX-License-Identifier: MIT
"""mirocup export: the team that it writes sees and decides as the network in Python does. Run with
PYTHONPATH=BUILD/python."""
import datetime
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

import mirocup
from mirocup._library import Batch

BUILD = Path(sys.argv.pop(1)) if len(sys.argv) > 1 and not sys.argv[1].startswith("-") else Path("build")
SOURCE = Path(__file__).resolve().parents[4]

# Reads observations from standard input and writes actions.
DRIVER = """
#include "learned.cpp"
#include <cstdio>
int main() {
  float observation[observation_size], action[action_size];
  while (std::fread(observation, sizeof observation, 1, stdin) == 1) {
    network(observation, action);
    std::fwrite(action, sizeof action, 1, stdout);
  }
}
"""

# Whole legs have seeds that nobody chose. It is printed, for MIROCUP_EXPORT_SEED.
SEED = int(os.environ.get("MIROCUP_EXPORT_SEED", 1000 * datetime.date.today().toordinal()))

KINDS = {
    "relative": {"agents": "robot", "observation": "relative", "ticks_per_step": 2},
    "standard": {"agents": "robot", "observation": "standard", "action": "drive"},
    "team": {"observation": "standard"},
    "vss": {"observation": "vss", "action": "vss", "learners": [0]},
}


def random_network(spec, activation="tanh"):
    """A network of random weights for an environment."""
    random = np.random.default_rng(3)
    sizes = [len(spec["observation"]), 24, 24, len(spec["action"])]
    layers = [(random.normal(size=(o, i)) / i**0.5, random.normal(size=o) * 0.3) for i, o in zip(sizes, sizes[1:])]
    return mirocup.Policy(spec, layers, activation)


def random_policy(kind, activation):
    """A network of random weights for an environment, and this environment with the learner in blue."""
    envs = mirocup.VectorEnv(3 if kind in ("relative", "standard") else 1, threads=1, **KINDS[kind])
    return random_network(envs.batch.spec, activation), envs


def run(*command, expected=0, **arguments):
    result = subprocess.run([str(part) for part in command], capture_output=True, check=False, **arguments)
    if result.returncode != expected:
        raise AssertionError(f"{command}: {result.returncode}: {result.stderr.decode()}{result.stdout.decode()}")
    return result


class Export(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = Path(self.temporary.name)
        self.addCleanup(self.temporary.cleanup)

    def export(self, kind, activation="tanh"):
        policy, envs = random_policy(kind, activation)
        policy.save(self.folder / "policy.npz")
        run(BUILD / "mirocup", "export", self.folder / "policy.npz", "-o", self.folder / "learned.cpp")
        return policy, envs

    def compile(self, source, *arguments):
        run("c++", "-std=c++17", "-O1", "-Wall", "-Wextra", "-Werror", "-I", SOURCE / "plugins" / "include", source,
            *arguments)

    def test_decisions(self):
        """Catches a layer, an order or an activation that is not the network's, in 10 000 observations."""
        for kind, activation in (("relative", "tanh"), ("team", "relu")):
            policy, envs = self.export(kind, activation)
            (self.folder / "driver.cpp").write_text(DRIVER)
            self.compile(self.folder / "driver.cpp", "-Wno-unused-function", "-o", self.folder / "driver")
            size = envs.single_observation_space.shape[0]
            observations = np.random.default_rng(1).uniform(-2.0, 2.0, (10000, size)).astype(np.float32)
            output = run(self.folder / "driver", input=observations.tobytes()).stdout
            actions = np.frombuffer(output, np.float32).reshape(10000, -1)
            self.assertLess(np.abs(actions - policy(observations)).max(), 1e-6)
            self.assertGreater(actions.std(), 0.1)

    def test_plays_as_in_training(self):
        """Catches a team that sees, steers or holds an action in another way than the environment did."""
        for kind in KINDS:
            policy, envs = self.export(kind)
            self.compile(self.folder / "learned.cpp", "-fPIC", "-shared", "-o", self.folder / "learned.so")
            places = []
            # The same legs: the network in Python steers blue, then the library does, and a robot of yellow only learns.
            learned = {key: value for key, value in KINDS[kind].items() if key not in ("agents", "action")}
            for envs, acts in ((envs, True), (None, False)):
                if envs is None:
                    batch = Batch({
                        "matches": 1, "threads": 1, "blue": str(self.folder / "learned.so"),
                        "yellow": {"learners": [0], "mates": "idle"}, "ticks_per_step": learned.get("ticks_per_step", 1)})
                    batch.reset(seeds=np.array([5]))
                    for _ in range(40):
                        batch.step()
                    places.append(batch.bodies(0))
                else:
                    observations, _ = envs.reset(seed=5)
                    for _ in range(40):
                        observations, *_ = envs.step(policy(observations))
                    places.append(envs.batch.bodies(0))
            self.assertLess(np.abs(places[0] - places[1]).max(), 1e-6, kind)
            self.assertGreater(np.abs(places[0][0, 3:5]).max(), 0.01, "it stands")

    def test_decides_in_whole_legs_as_the_network_does(self):
        """Catches an action that is held across a stop, and another decision after a goal, a foul, a penalty, a half, or a
        picture that the camera lost. Legs part in the end, since a number may be rounded in another way, but only a little
        at once."""
        shots = [{"ball": {"position": [x, {"from": 0.1, "to": 0.15}], "velocity": [10.0 * x, 0.0]}} for x in (-0.3, 0.3)]
        start = 3 * shots
        for restart in ("KICK_OFF", "GOAL_KICK", "PENALTY_KICK", "FREE_BALL", "FREE_KICK"):
            start += [{"restart": {"kind": restart, "taker": taker}} for taker in ("blue", "yellow")]
        print(f"MIROCUP_EXPORT_SEED={SEED}")
        legs = 250
        ends = dict.fromkeys(("score", "opponent_score", "foul"), 0.0)
        whole = 0
        for kind, ticks, conditions, skips in (("relative", 2, "hall", True), ("standard", 3, "exact", False),
                                               ("team", 2, "camera", False), ("vss", 3, "hall", True)):
            played = {"matches": legs, "yellow": "striker", "start": start, "conditions": conditions, "ticks_per_step": ticks,
                      "skip_stops": skips, "rules": {"preset": "mirosot", "half_s": 5, "ready_s": 0.2},
                      "episode": {"seconds": None, "ends_at_goal": False}, "autoreset": "disabled"}
            kind = {key: value for key, value in KINDS[kind].items() if key not in ("ticks_per_step", "learners")}
            network = Batch({**played, **kind, "blue": {"learners": [0, 1], "mates": "idle"}})
            policy = random_network(network.spec)
            policy.save(self.folder / "policy.npz")
            run(BUILD / "mirocup", "export", self.folder / "policy.npz", "-o", self.folder / "learned.cpp")
            library = self.folder / f"{len(list(self.folder.iterdir()))}.so"
            self.compile(self.folder / "learned.cpp", "-fPIC", "-shared", "-o", library)
            team = Batch({**played, "blue": {"learners": [2], "mates": str(library)}})
            for batch in (network, team):
                batch.reset(seeds=SEED + np.arange(legs))
            same = np.ones(legs, np.bool_)
            while not network.terminations.all():
                network.actions[:] = policy(network.observations)
                network.step()
                team.step()
                for leg in np.flatnonzero(same):
                    apart = np.abs(network.bodies(leg) - team.bodies(leg)).max()
                    same[leg] = apart == 0.0
                    self.assertLess(apart, 1e-3, f"{kind}, leg {leg}")
            whole += int(same.sum())
            for name in ends:
                ends[name] += np.abs(network.statistics[:, network.spec["statistics"].index(name)]).sum()
        self.assertGreater(whole, 0.9 * 4 * legs)
        for name, times in ends.items():
            self.assertGreater(times, 0.1 * legs, name)

    def test_refuses(self):
        """Catches a file that is taken though it cannot play, and a crash where a sentence is due."""
        policy, _ = self.export("relative")
        arrays = dict(np.load(self.folder / "policy.npz"))
        wrong = {
            "w0 is missing": {"w0": None},
            "one bias for each output": {"b1": arrays["b1"][:3]},
            "layer 1": {"w1": arrays["w1"][:, :5]},
            "float32": {"w2": arrays["w2"].astype(np.float64)},
            "activation": {"activation": np.array("sine")},
            "not finite": {"b0": np.full_like(arrays["b0"], np.nan)},
            "unknown": {"w7": arrays["w1"]},
            "/league": {"spec": np.array(str(arrays["spec"]).replace('"small"', '"huge"'))},
            "outputs": {"w2": arrays["w2"][:1], "b2": arrays["b2"][:1]},
        }
        out = self.folder / "out.cpp"
        for words, changes in wrong.items():
            np.savez(self.folder / "bad.npz", **{k: v for k, v in {**arrays, **changes}.items() if v is not None})
            result = run(BUILD / "mirocup", "export", self.folder / "bad.npz", "-o", out, expected=2)
            self.assertIn(words, result.stderr.decode())
        whole = (self.folder / "policy.npz").read_bytes()
        for part in (b"", b"PK\x03\x04", whole[:len(whole) // 2]):
            (self.folder / "bad.npz").write_bytes(part)
            run(BUILD / "mirocup", "export", self.folder / "bad.npz", "-o", out, expected=4)
        self.assertFalse(out.exists())


if __name__ == "__main__":
    unittest.main()
