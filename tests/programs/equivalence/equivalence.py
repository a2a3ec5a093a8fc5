#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Two ways to the same leg give the same bits, past its first goal, foul, penalty, half and camera gap.

Usage: equivalence.py BUILD [--seed N] [WAY...]

Each preset of the rules under each preset of the conditions has a leg with halves of four seconds, whose seed nobody chose: it follows
from today's date, or from --seed, and is printed. The legs start with a kick-off, with a ball that rolls into a goal, or with a penalty,
and end by extra time or a shoot-out where they are level. Each is played again in each of these ways:

  verify      the simulator and the referee again, from the recorded commands
  rerun       the teams again
  trusted     without a sandbox
  browser     by the module for browsers, if it was built
  dds         one team over the network
  play_on     from a tick on, by teams without a memory: the same leg; by others: a leg that verifies and is played again
  late        in real time with a team whose answers are late: a leg that verifies

known_failures.txt lists what is known to fail, with the reason. A way that passes and is listed there is a failure, too: strike it.
"""
import argparse
import collections
import datetime
import itertools
import json
import os
import random
import subprocess
import sys
import tempfile

here = os.path.dirname(os.path.abspath(__file__))
root = os.path.dirname(os.path.dirname(os.path.dirname(here)))
rules_of = {"mirosot": ["golden_goal_s=3"], "simurosot": ["golden_goal_s=3"], "vsss": ["extra_halves_s=3", "ready_s=0.3"]}
every_rule = ["half_s=4", "attempt_s=2", "shoot_out_rounds=2", "shoot_out_most_rounds=4", "stalemate_s=0.8"]
conditions_of = {"exact": [], "hall": [], "camera": ["unseen_rate=0.1", "radio_loss=0.05"]}
starts = [
    None,
    {"ball": {"position": [0.45, 0.05], "velocity": [2.0, 0.0]}, "yellow": [{"pose": [0.6, 0.5, 0.0]}, {"pose": [0.2, -0.4, 0.0]}, {}]},
    {"restart": {"kind": "PENALTY_KICK", "taker": "blue"}},
]
memoryless = ["drill:keeper", "drill:crowd"]
late_team = """
import time
from mirocup.team import Team

class Late(Team):
    def decide(self, now):
        if now.tick % 4 == 0:
            time.sleep(0.01)
        return [(20.0, 25.0 + robot.y) for robot in now.own]
"""


class Failure(Exception):
    pass


class Leg:
    """A leg of one preset, as it was played first."""

    def __init__(self, tests, number, rules, conditions):
        self.tests, self.build, self.name = tests, tests.build, f"{rules}/{conditions}"
        draw = random.Random(tests.seed * 9 + number)
        self.seed = draw.getrandbits(50)
        self.start = starts[(number + tests.seed) % len(starts)]
        self.blue, self.yellow = draw.sample(["chaser", "striker", "navigator", "tactician", "keeper"], 2)
        self.rules = ["--rules", rules, *itertools.chain(*(["--rule", rule] for rule in every_rule + rules_of[rules]))]
        self.conditions = ["--conditions", conditions, *itertools.chain(*(["--condition", c] for c in conditions_of[conditions]))]
        self.draw = draw

    def file(self, name):
        return os.path.join(self.tests.folder, f"{self.name.replace('/', '-')}-{name}.json")

    def play(self, name, blue, yellow, *more, stage="knockout", start=True):
        """Plays the leg with these teams and returns its record."""
        words = ["match", "--blue", blue, "--yellow", yellow, "--stage", stage, "--seed", str(self.seed),
                 *self.rules, *self.conditions]
        if start and self.start is not None:
            with open(self.file("start"), "w", encoding="utf-8") as file:
                json.dump({"schema": "mirocup/situation/1", **self.start}, file)
            words += ["--start", self.file("start")]
        return self.mirocup(name, *words, *more)

    def mirocup(self, name, *words):
        self.run([f"{self.build}/mirocup", *words, "--record", self.file(name)])
        return self.record(name)

    def record(self, name):
        with open(self.file(name), encoding="utf-8") as file:
            record = json.load(file)
        self.tests.events.update(decision["decision"] for decision in record["decisions"])
        return record

    def run(self, command):
        done = subprocess.run(command, capture_output=True, text=True, timeout=120)
        if done.returncode != 0:
            raise Failure(f"{' '.join(command)}: exit code {done.returncode}: {done.stdout[-300:]}{done.stderr[-300:]}")
        return done.stdout

    def expect_same(self, first, second):
        if first["state_hash"] != second["state_hash"]:
            raise Failure(f"{first['ticks']} ticks to {first['state_hash']}, {second['ticks']} ticks to {second['state_hash']}")

    # ---- the ways

    def verify(self):
        self.run([f"{self.build}/mirocup", "verify", self.file("first")])

    def rerun(self):
        self.run([f"{self.build}/mirocup", "rerun", self.file("first")])

    def trusted(self):
        self.expect_same(self.record("first"), self.play("trusted", self.blue, self.yellow, "--trusted"))

    def browser(self):
        if os.path.exists(f"{self.build}/browser/mirocup.wasm"):
            self.run(["node", f"{root}/browser/verify.mjs", self.file("first")])

    def dds(self):
        match, colour = f"equivalence-{os.getpid()}-{self.name.replace('/', '-')}", self.draw.choice(["blue", "yellow"])
        library = getattr(self, colour)
        teams = {"blue": self.blue, "yellow": self.yellow, colour: "dds:remote"}
        with open(self.file("join"), "w", encoding="utf-8") as log, subprocess.Popen(
                [f"{self.build}/mirocup", "join", "--match", match, "--team", colour, "--name", "remote",
                 f"{self.build}/house/{library}.so"], stdout=log, stderr=log) as team:
            try:
                self.expect_same(self.record("first"), self.play("dds", teams["blue"], teams["yellow"], "--match", match))
            finally:
                team.terminate()

    def play_on(self):
        whole = self.play("plain", *memoryless)
        tick = self.draw.randrange(1, whole["ticks"])
        words = ["match", "--blue", memoryless[0], "--yellow", memoryless[1], "--from", self.file("plain"), "--tick", str(tick)]
        on = self.mirocup("on", *words)
        if on["state_hash"] != whole["state_hash"]:
            raise Failure(f"from tick {tick}: {on['state_hash']} and not {whole['state_hash']}")
        tick = self.draw.randrange(1, self.record("first")["ticks"])
        words = ["match", "--blue", self.yellow, "--yellow", self.blue, "--from", self.file("first"), "--tick", str(tick)]
        self.mirocup("other", *words)
        self.run([f"{self.build}/mirocup", "verify", self.file("other")])
        self.run([f"{self.build}/mirocup", "rerun", self.file("other")])

    def late(self):
        path = os.path.join(self.tests.folder, "late.py")
        with open(path, "w", encoding="utf-8") as file:
            file.write(late_team)
        record = self.play("late", path, self.yellow, "--speed", "10", stage="group")
        self.tests.late += record["budget"]["blue"]["late_ticks"]
        self.run([f"{self.build}/mirocup", "verify", self.file("late")])


ways = ["verify", "rerun", "trusted", "browser", "dds", "play_on", "late"]
dear = {"dds": 3, "late": 3, "browser": 3}  # one leg of so many, another one each day


class Tests:
    def __init__(self, build, seed, folder):
        self.build, self.seed, self.folder = build, seed, folder
        self.events, self.late = set(), 0

    def run(self, wanted):
        with open(f"{here}/known_failures.txt", encoding="utf-8") as file:
            known = dict(line.strip().split(": ", 1) for line in file if line.strip() and not line.startswith("#"))
        bad, counts = [], collections.Counter()
        for number, preset in enumerate(itertools.product(rules_of, conditions_of)):
            leg = Leg(self, number, *preset)
            leg.play("first", leg.blue, leg.yellow)
            for way in ways:
                if way not in wanted or (number + number // 3 + self.seed) % dear.get(way, 1) != 0:
                    continue
                name = f"{way} {leg.name}"
                try:
                    getattr(leg, way)()
                    counts["passed"] += 1
                    if name in known:
                        bad.append(f"{name}: passes, and known_failures.txt says: {known[name]}. Strike it")
                except (Failure, subprocess.TimeoutExpired) as failure:
                    if name in known:
                        counts["known to fail"] += 1
                    else:
                        bad.append(f"{name}: {failure}")
        for events in ({"GOAL"}, {"HALF_END"}, {"PENALTY_KICK"}, {"PHASE"}, {"FREE_BALL", "GOAL_KICK", "FREE_KICK"}):
            if not self.events & events:
                bad.append(f"no leg had a {' or '.join(events)}")
        if "late" in wanted and self.late == 0:
            bad.append("no answer was late")
        return bad, counts


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("build")
    options.add_argument("ways", nargs="*", default=ways)
    options.add_argument("--seed", type=int, default=(datetime.date.today() - datetime.date(2026, 1, 1)).days)
    o = options.parse_args()
    print(f"seed {o.seed}: once more with --seed {o.seed}")
    with tempfile.TemporaryDirectory() as folder:
        tests = Tests(os.path.abspath(o.build), o.seed, folder)
        bad, counts = tests.run(o.ways)
    print(f"{counts['passed']} passed, {counts['known to fail']} known to fail, {len(bad)} failed; "
          f"seen: {', '.join(sorted(tests.events))}; {tests.late} late answers")
    for sentence in bad:
        print(sentence)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
