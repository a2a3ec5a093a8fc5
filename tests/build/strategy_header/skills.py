#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""mirocup.team calls each function of skills.h with its parameters in their order, of their types and with the usual values that
the header gives; and what a test of a student puts together is packed as the host packs it. Catches a function that Python lacks,
a parameter at another place, a default that differs, and a member of the setup or the observation that moved.
Usage: skills.py ROOT BUILD"""
import ctypes
import math
import re
import sys

root, build = sys.argv[1:]
sys.path.insert(0, build + "/python")
import mirocup.team as m  # noqa: E402

header = re.sub(r"\s+", " ", open(root + "/plugins/include/mirocup/skills.h").read().split('extern "C" {')[1])
value = {"double": ctypes.c_double, "int32_t": ctypes.c_int32, "mirocup_point": m._CPoint, "mirocup_wheels": m._CWheels,
         "mirocup_pose": m._CPose, "mirocup_ball": m._CBall, "mirocup_shot": m._CShot, "mirocup_robot": m._CRobot,
         "mirocup_crossing": m._CCrossing, "mirocup_interception": m._CInterception, "void": None}
handled = ("filter", "penalty", "scene", "simulator", "tracker")
failures = []


def expect(holds, what):
    if not holds:
        failures.append(what)


functions = re.findall(r"(\w+)(?: const)?(\*?) mirocup_(\w+)\(([^)]*)\);(?: /\* ([^*]*) \*/)?", header)
expect(len(functions) > 90, f"only {len(functions)} functions were found")
for result, star, name, text, usual in functions:
    if name.split("_")[0] in handled:
        expect(hasattr(m._c, "mirocup_" + name), f"{name}: not in the library")
        continue
    expect(name in m.__all__, f"{name}: Python lacks it")
    if name not in m.__all__:
        continue
    parameters = [p.strip() for p in text.split(",")]
    bound = getattr(m, {"inside": "_inside"}.get(name, name))
    if name in ("keep_laws", "avoid_own_goals", "spare_keeper", "follow_field", "cheapest_robot", "assign_places", "out_of_reach"):
        function = {"out_of_reach": m._out_of_reach, "follow_field": m._follow_field, "cheapest_robot": m._cheapest_robot,
                    "assign_places": m._assign_places}.get(name) or getattr(m, "_" + name).__closure__[0].cell_contents
    else:
        function = bound.__globals__["_function"]
        names = [re.search(r"\w+$", p)[0] for p in parameters]
        expect(names == list(bound.__code__.co_varnames[:bound.__code__.co_argcount]), f"{name}: {names}")
    types = [ctypes.c_char_p if "char" in p else ctypes.c_void_p if "*" in p else value[p.split()[0]] for p in parameters]
    expect(function.argtypes == types or list(function.argtypes) == types, f"{name}: {text} is called as {function.argtypes}")
    expect(function.restype == value[result], f"{name}: returns {result}, not {function.restype}")
    numbers = [float(n) for n in re.findall(r"(?<![\w.])\d[\d.e]*", usual)] if usual and "mirocup_" not in usual else []
    given = [float(d) for d in bound.__defaults__ or () if isinstance(d, (int, float))]
    expect(given == numbers, f"{name}: Python has {given}, the header says {numbers}")

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
expect(len(m.keep_laws(SETUP, now, [None, (1, 2), (3, 4)])) == 3, "None for a robot")
expect(m.time_at_x(SETUP, ((0.0, 0.0), (1.0, 0.0)), -0.3) is None, "a ball that goes away crosses a line")
expect(math.isfinite(m.worth_of(SETUP, now)), "worth_of")
scene = m.Scene(now)
copy = scene.copy()
expect(copy.show(now).own == tuple(m.Robot(*copy.show(now).own[i]) for i in range(3)), "a scene shows itself")
for line in failures:
    print("skills:", line, file=sys.stderr)
sys.exit(1 if failures else 0)
