#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
#
# Draws docs/collisions.svg: the three kinds of collision of the paper's Figure 7 in three models.
# Usage: docs/collisions.py [build/mirocup] >docs/collisions.svg
import json
import math
import subprocess
import sys
import tempfile

PROGRAM = sys.argv[1] if len(sys.argv) > 1 else "build/mirocup"
SIDE = 0.075
DURATION = 0.4
SAMPLES = [i * DURATION / 9 for i in range(1, 9)]

# Who runs into whom: pose of the one that is hit, offset of the one that hits. Both motors are off
# after the impact: wheels are asked for nothing, which brakes them.
KINDS = [
    ("plain: along the wheels, through the centre", [0.0, 0.0, 0.0], [-0.15, 0.0, 0.0], 1.2),
    ("turning: along the wheels, beside the centre", [0.0, 0.0, 0.0], [-0.15, 0.045, 0.0], 1.2),
    ("sliding: across the wheels", [0.0, 0.0, math.pi / 2], [-0.15, 0.02, 0.0], 1.2),
]
MODELS = ["this model", "paper: wheels hold at once", "point masses"]


def scene(robots, grip, duration, samples):
    text = json.dumps({
        "schema": "mirocup/scene/1", "walls": False, "duration": duration, "sample_at": samples,
        "parameters": {"grip": grip},
        "robots": [{"name": n, "pose": p, "twist": t, "wheels": [[0.0, u, u]]} for n, p, t, u in robots],
    })
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        file.write(text)
        file.flush()
        return json.loads(subprocess.run([PROGRAM, "scene", file.name], check=True, capture_output=True, text=True).stdout)


def start(kind):
    _, hit, hitting, speed = kind
    wheels = speed / 0.0225
    return [("b", hit, [0.0, 0.0, 0.0], 0.0), ("a", hitting, [speed, 0.0, 0.0], wheels)]


# Both robots' poses at each sample.
def poses(samples):
    return [[r["pose"] for r in s["robots"]] for s in samples]


def this_model(kind):
    return poses(scene(start(kind), 0.8, DURATION, SAMPLES)["samples"])


# The state at the impact, then infinite grip with what the model makes of the velocities.
def after_impact(kind, velocities):
    whole = scene(start(kind), 0.8, DURATION, [])
    at = whole["impacts"][0]["t"]
    before = scene(start(kind), 0.8, at - 1e-9, [s for s in SAMPLES if s < at - 1e-9])["samples"]
    after = scene(start(kind), 0.8, at, [])["samples"][-1]["robots"]
    twists = velocities(before[-1]["robots"], after, whole["impacts"][0])
    robots = [(n, r["pose"], t, u) for (n, _, _, u), r, t in zip(start(kind), after, twists)]
    rest = scene(robots, "infinite", DURATION - at, [s - at for s in SAMPLES if s > at])["samples"]
    return poses(before[:-1]) + poses(rest[1:])


def paper(kind):
    return after_impact(kind, lambda before, after, impact: [[r["twist"][0], 0.0, r["twist"][2]] for r in after])


def points(kind):
    def velocities(before, after, impact):
        n = impact["normal"] if impact["bodies"][0] == "b" else [-c for c in impact["normal"]]
        approach = before[1]["twist"][0] * n[0]  # a drives along x
        change = 1.3 * approach / 2.0            # e = 0.3, equal masses
        heading = before[0]["pose"][2]
        along = change * (n[0] * math.cos(heading) + n[1] * math.sin(heading))
        return [[along, 0.0, 0.0], [before[1]["twist"][0] - change * n[0], 0.0, 0.0]]
    return after_impact(kind, velocities)


def robot(pose, colour, opacity):
    x, y, angle = pose
    return (f'<g transform="translate({x:.4f} {y:.4f}) rotate({math.degrees(angle):.2f})" opacity="{opacity:.2f}">'
            f'<rect x="{-SIDE / 2}" y="{-SIDE / 2}" width="{SIDE}" height="{SIDE}" fill="none" stroke="{colour}" stroke-width="0.003"/>'
            f'<line x1="0" y1="0" x2="{SIDE / 2}" y2="0" stroke="{colour}" stroke-width="0.004"/></g>')


def main():
    width, height, scale = 0.62, 0.3, 520
    w, h, head, side = width * scale, height * scale, 34, 16
    print(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {3 * w + 2 * side:.0f} {head + 3 * (h + 30):.0f}" font-family="sans-serif" font-size="13">')
    print('<rect width="100%" height="100%" fill="white"/>')
    for column, name in enumerate(MODELS):
        print(f'<text x="{side + (column + 0.5) * w:.0f}" y="22" text-anchor="middle" font-weight="bold">{name}</text>')
    for row, kind in enumerate(KINDS):
        top = head + row * (h + 30)
        print(f'<text x="{side}" y="{top + 14}" fill="#444">{kind[0]}</text>')
        for column, model in enumerate([this_model, paper, points]):
            frames = model(kind)
            print(f'<g transform="translate({side + column * w + 0.2 * scale:.1f} {top + 20 + h / 2:.1f}) scale({scale} {-scale})">')
            for i, frame in enumerate(frames):
                opacity = 0.2 + 0.8 * i / (len(frames) - 1)
                print(robot(frame[0], "#c08a00", opacity) + robot(frame[1], "#1f5fbf", opacity))
            print("</g>")
    print("</svg>")


main()
