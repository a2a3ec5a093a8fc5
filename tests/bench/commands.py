#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What a command does on the pitches of other platforms, beside those platforms' own numbers.

commands.py BUILD: prints a table for each pitch, in Markdown.

A robot at rest gets one command and keeps it. "There" follows the numbers that are published for the
platform and no code of this project; "here" is `mirocup scene` with the parameters of the pitch.
"""
import json
import math
import os
import subprocess
import sys
import tempfile

build = sys.argv[1]
INCH = 0.0254


def run(*arguments):
    return subprocess.run([os.path.join(build, "mirocup"), *arguments], check=True,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE).stdout


def parameters_of(pitch, folder):
    """Returns the parameters of a pitch as a scene has them, from the record of a short leg."""
    record = os.path.join(folder, pitch + ".json")
    run("match", "--blue", "idle", "--yellow", "idle", "--pitch", pitch, "--half", "1",
        "--conditions", "exact", "--record", record)
    with open(record) as file:
        given = json.load(file)["pitch"]
    motor = {key: value for key, value in given["motor"].items() if key != "kind"}
    return {**given["parameters"], **motor}


def here(parameters, rows, times, folder):
    """Returns (speed, turn, way) of a robot at each time: m/s, rad/s, m along its path. `rows`: time,
    left, right."""
    limit = parameters["wheel_speed_limit"]
    wheels = []
    for t, left, right in rows:
        scale = min(1.0, limit / max(abs(left), abs(right), 1e-9))
        wheels.append([t, left * scale, right * scale])
    end = max(times)
    steps = int(round(end * 1000))
    scene = {"schema": "mirocup/scene/1", "walls": False, "duration": end, "parameters": parameters,
             "robots": [{"pose": [0.0, 0.0, 0.0], "wheels": wheels}],
             "sample_at": [k / 1000 for k in range(1, steps)]}
    path = os.path.join(folder, "scene.json")
    with open(path, "w") as file:
        json.dump(scene, file)
    samples = json.loads(run("scene", path))["samples"]
    found, way, last = {}, 0.0, (0.0, 0.0)
    for sample in samples:
        robot = sample["robots"][0]
        way += math.hypot(robot["pose"][0] - last[0], robot["pose"][1] - last[1])
        last = robot["pose"][:2]
        found[round(sample["t"], 6)] = (robot["twist"][0], robot["twist"][2], way)
    return [found[round(t, 6)] for t in times]


def at_simurosot(rows, times):
    """The published fit, in ticks of 1/60 s, inches and degrees."""
    v = w = way = 0.0
    found, command = [], (0.0, 0.0)
    for tick in range(int(round(max(times) * 60))):
        for t, left, right in rows:
            if tick >= round(t * 60):
                command = (left, right)
        mean, half = (command[0] + command[1]) / 2, (command[1] - command[0]) / 2
        v += 0.060 * (0.015222305 * mean - v)
        if command == (0.0, 0.0):
            v *= 1 - 0.662
        w += 0.273575 * (0.534262 * half - w)
        turned = w
        if command[0] * command[1] > 0:
            turned -= math.copysign(4 * 0.000294678 * half * half, half)
        way += abs(v) * INCH
        found.append((v * INCH * 60, math.radians(turned) * 60, way))
    return [found[int(round(t * 60)) - 1] for t in times]


def at_firasim(rows, times):
    """Two wheels of at most 5.5 N each under 2.4 kg, as fast as they can to their speeds. No source
    has the moment of inertia: here a box of 2 kg and two wheels of 0.2 kg at 0.04 m."""
    mass, arm, force, radius = 2.4, 0.04, 5.5, 0.02
    inertia = 2.0 * 0.075 ** 2 / 6 + 2 * 0.2 * arm ** 2
    v = w = way = 0.0
    found, dt, command = {}, 1e-4, (0.0, 0.0)
    for step in range(int(round(max(times) / dt))):
        for t, left, right in rows:
            if step * dt >= t - 1e-9:
                command = (left, right)
        pushes = []
        for speed, side in ((command[0], -1.0), (command[1], 1.0)):
            wanted = speed * radius - (v + side * w * arm)
            pushes.append(max(-force, min(force, 0.2 * mass / dt * wanted)))
        v += dt * (pushes[0] + pushes[1]) / mass
        w += dt * (pushes[1] - pushes[0]) * arm / inertia
        way += abs(v) * dt
        found[step + 1] = (v, w, way)
    return [found[int(round(t / dt))] for t in times]


def cells_of(there, own, least):
    """Returns both numbers and the error; `least`: what is smaller counts as 0."""
    if abs(there) < least and abs(own) < least:
        return ["–", "–"]
    if abs(there) < least:
        return ["0, %.3g" % own, "–"]
    error = round(100 * (own / there - 1), 1)
    return ["%.3g, %.3g" % (there, own), "%+.1f %%" % error if error else "0 %"]


def lines_of(pitch, there, cases, folder):
    parameters = parameters_of(pitch, folder)
    lines = ["| `%s` | left, right | after | m/s there, here | error | rad/s there, here | error | "
             "m there, here | error |" % pitch,
             "| --- | --- | --- | --- | --- | --- | --- | --- | --- |"]
    for name, rows, times in cases:
        wheels = "; then ".join("%g, %g" % (left, right) for _, left, right in rows)
        theirs, ours = there(rows, times), here(parameters, rows, times, folder)
        for t, other, own in zip(times, theirs, ours):
            cells = ["%s | %s | %.2f s" % (name, wheels, t)]
            for their, our, least in zip(other, own, (0.005, 0.05, 0.0005)):
                cells += cells_of(their, our, least)
            lines.append("| " + " | ".join(cells) + " |")
    return lines


with tempfile.TemporaryDirectory() as scratch:
    tables = [
        lines_of("vsss", at_firasim, [
            ("straight", [(0.0, 30.0, 30.0)], (0.1, 0.25, 0.5, 1.0)),
            ("straight", [(0.0, 60.0, 60.0)], (0.1, 0.25, 0.5, 1.0)),
            ("straight, beyond the limit", [(0.0, 100.0, 100.0)], (0.25, 1.0)),
            ("spin", [(0.0, -20.0, 20.0)], (0.1, 0.25, 1.0)),
            ("curve", [(0.0, 20.0, 40.0)], (0.1, 0.25, 0.5, 1.0)),
            ("curve, beyond the limit", [(0.0, 40.0, 80.0)], (0.25, 1.0)),
            ("stop", [(0.0, 40.0, 40.0), (1.0, 0.0, 0.0)], (1.1, 1.25, 1.5)),
        ], scratch),
        lines_of("simurosot", at_simurosot, [
            ("straight", [(0.0, 50.0, 50.0)], (0.1, 0.25, 0.5, 1.0)),
            ("straight", [(0.0, 125.0, 125.0)], (0.1, 0.25, 0.5, 1.0, 2.0)),
            ("spin", [(0.0, -40.0, 40.0)], (0.05, 0.1, 0.25)),
            ("spin", [(0.0, -125.0, 125.0)], (0.05, 0.1, 0.25)),
            ("curve", [(0.0, 60.0, 100.0)], (0.1, 0.25, 0.5, 1.0)),
            ("curve", [(0.0, 40.0, 125.0)], (0.1, 0.25, 0.5, 1.0)),
            ("stop", [(0.0, 100.0, 100.0), (1.0, 0.0, 0.0)], (1.05, 1.1)),
        ], scratch)]

print("\n\n".join("\n".join(table) for table in tables))
