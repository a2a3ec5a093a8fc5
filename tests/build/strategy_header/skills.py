#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""mirocup.team has each function of skills.h with its parameters in their order and with the usual values that the header gives; and
what a test of a student puts together is packed as the host packs it. Catches a function that declarations.py leaves out, one that
Python defines by itself with another parameter or usual value, and a member of the setup or the observation that moved.
Usage: skills.py ROOT BUILD"""
import math
import re
import sys

root, build = sys.argv[1:]
sys.path.insert(0, build + "/python")
import mirocup.team as m  # noqa: E402

header = re.sub(r"\s+", " ", open(root + "/plugins/include/mirocup/skills.h").read().split('extern "C" {')[1])
returned = {"double": float, "int32_t": bool, "void": None, "mirocup_wheels": m.Wheels, "mirocup_point": m.Point, "mirocup_pose": m.Pose,
            "mirocup_robot": m.Robot, "mirocup_ball": m.Ball, "mirocup_shot": m.Shot, "mirocup_crossing": m.Crossing,
            "mirocup_interception": m.Interception}
# Python computes these itself, makes these arrays itself, or changes a command by returning another one.
different = {"wrapped", "dot", "length", "unit", "position", "ball_velocity",
             "follow_field", "cheapest_robot", "assign_places", "out_of_reach", "keep_laws", "avoid_own_goals", "spare_keeper"}
failures = []


def expect(holds, what):
    if not holds:
        failures.append(what)


functions = re.findall(r"(\w+)(?: const)?(\*?) mirocup_(\w+)\(([^)]*)\);(?: /\* \{?([-\d., e]*)\}? \*/)?", header)
expect(len(functions) > 90, f"only {len(functions)} functions were found")
for result, star, name, text, usual in functions:
    expect(len(getattr(m, "_" + name).argtypes) == text.count(",") + (text != "void"), f"{name}: arguments of {text}")
    if name.split("_")[0] in ("filter", "penalty", "scene", "simulator", "tracker"):
        continue
    expect(name in m.__all__, f"{name}: Python lacks it")
    bound = getattr(m, name)
    expect(bound.__doc__, f"{name}: no description")
    given = [float(d) for d in bound.__defaults__ or () if isinstance(d, (int, float))]
    expect(given == [float(n) for n in usual.split(",") if n], f"{name}: Python has {given}, the header says {usual}")
    if name not in different:
        names = [re.search(r"\w+$", p)[0] for p in text.split(",")]
        expect(names == list(bound.__code__.co_varnames[:bound.__code__.co_argcount]), f"{name}: {names}")
        expect(bound.__annotations__["return"] == returned[result], f"{name}: returns {bound.__annotations__['return']}")

# What a test puts together is what the host would send.
SETUP = m.Setup(*range(3), *[0.5 + n for n in range(37)], (1.5, 2.5, 3.5, 4.5), (1, 2, 3, 0), (m.Point(1.0, 2.0), m.Point(3.0, 4.0), m.Point(5.0, 6.0)))
SETUP = SETUP._replace(team=1, robots=3, seed=9)
expect(m._setup_of(m._setup_bytes(SETUP)) == SETUP, "a setup is packed otherwise than it is read")
robots = [tuple(m.Robot(*[t + i + k / 8 for k in range(6)]) for i in range(3)) for t in (0, 10)]
counts = [m.Counts(tuple(t + k / 8 for k in range(4)), tuple(range(t, t + 4)), -1, t + 3) for t in (1, 5)]
now = m.Observation(7, 0.25, 0.5, 1, 2, 3, 1, 0, 4, 5, 3, 7, 0.1, 0.2, 0.3, 0.4, *robots, (1, 2, 3), (4, 5, 6), 1.5, 2.5, *counts)
expect(m._observation_of(m._observation_bytes(now)) == now, "an observation is packed otherwise than it is read")
moved = m._observation_of(m._observation_bytes(now))._replace(ball_x=-0.5)
expect(m.ball_after(moved, 0.0) == (-0.5, 0.2), "a skill sees the observation before _replace()")

# Each function can be called, and takes what Python has: tuples, whole numbers, None for a robot that stands.
expect(m.drive_to(SETUP, now.own[0], (1, 0)) == m.drive_to(SETUP, now.own[0], m.Point(1.0, 0.0)), "whole numbers")
expect(m.out_of_reach(now.own, (0.5, 0.0)) == m.out_of_reach([tuple(r) for r in now.own], m.Point(0.5, 0.0)), "a list of robots")
try:
    m.attack_ball(SETUP, now, 3, (0.5, 0.0))
except TypeError as error:
    expect("me is 3; the number of an own robot is expected" in str(error), f"of a robot that is not there: {error}")
else:
    expect(False, "a robot that is not there attacks")
expect(len(m.keep_laws(SETUP, now, [None, (1, 2), (3, 4)])) == 3, "None for a robot")
expect(m.time_at_x(SETUP, ((0.0, 0.0), (1.0, 0.0)), -0.3) is None, "a ball that goes away crosses a line")
expect(math.isfinite(m.worth_of(SETUP, now)), "worth_of")
scene = m.Scene(now)
copy = scene.copy()
expect(copy.show(now).own == tuple(m.Robot(*copy.show(now).own[i]) for i in range(3)), "a scene shows itself")
for line in failures:
    print("skills:", line, file=sys.stderr)
sys.exit(1 if failures else 0)
