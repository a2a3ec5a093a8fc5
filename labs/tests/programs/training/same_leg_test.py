#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""An episode is a leg: with an agent that stands, the library of training plays the bits that `mirocup match` plays with `idle`.

Usage: same_leg_test.py BUILD [--seed N], with PYTHONPATH=BUILD/python. Each preset of the rules has a leg under each preset of the
conditions, with halves of four seconds; the seeds follow from today's date, or from --seed, and are printed. Catches a rule, a
condition or a number of the pitch that one of the two drops.
"""
import argparse
import datetime
import json
import os
import random
import subprocess
import sys
import tempfile

import numpy
from mirocup._library import Batch

RULES = {"mirosot": [], "simurosot": [], "vsss": ["ready_s=0.3"]}
CONDITIONS = {"exact": [], "hall": [], "camera": ["unseen_rate=0.1", "radio_loss=0.05"]}


def played(build, yellow, rules, conditions, seed, path):
    words = ["match", "--blue", "idle", "--yellow", yellow, "--stage", "group", "--seed", str(seed), "--record", path,
             "--rules", rules, "--rule", "half_s=4", "--conditions", conditions]
    for rule in RULES[rules]:
        words += ["--rule", rule]
    for condition in CONDITIONS[conditions]:
        words += ["--condition", condition]
    subprocess.run([f"{build}/mirocup", *words], check=True, stdout=subprocess.DEVNULL)
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def trained(match, yellow, seed, path):
    """Plays the same leg in the library and returns its record."""
    batch = Batch({"matches": 1, "threads": 1, "blue": "agent", "yellow": yellow, "rules": match["rules"],
                   "conditions": match["conditions"], "control_period": match["control_period"], "skip_stops": False,
                   "autoreset": "disabled", "episode": {"seconds": None, "ends_at_goal": False}})
    batch.reset(seeds=numpy.array([seed], numpy.uint64))
    batch.actions[:] = 0.0
    while not (batch.terminations.all() or batch.truncations.all()):
        batch.step()
    batch.record(0, False, path)
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("build")
    parser.add_argument("--seed", type=int, default=datetime.date.today().toordinal())
    arguments = parser.parse_args()
    print("seed", arguments.seed)
    draw, bad = random.Random(arguments.seed), 0
    with tempfile.TemporaryDirectory() as folder:
        for rules in RULES:
            for conditions in CONDITIONS:
                yellow, seed = draw.choice(["chaser", "striker", "navigator", "tactician", "keeper"]), draw.getrandbits(50)
                match = played(arguments.build, yellow, rules, conditions, seed, os.path.join(folder, "match.json"))
                episode = trained(match, yellow, seed, os.path.join(folder, "episode.json"))
                same = match["state_hash"] == episode["state_hash"]
                bad += not same
                print(f"{rules}/{conditions}: {yellow}, {match['ticks']} ticks: " + ("same" if same else
                      f"{match['state_hash']}, but the episode {episode['ticks']} ticks, {episode['state_hash']}"))
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
