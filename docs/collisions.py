#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
#
# Draws docs/collisions.svg: the three kinds of collision of the paper's Figure 7 in three models. A test runs it.
# Usage: docs/collisions.py [build/mirocup] >docs/collisions.svg
import json
import math
import subprocess
import sys
import tempfile

PROGRAM = sys.argv[1] if len(sys.argv) > 1 else "build/mirocup"
SIDE, LAG, RESTITUTION, WHEEL = 0.075, 0.06, 0.3, 0.0225  # m, s, 1, m: the defaults of parameters.hpp
TICK = 0.033                                              # s between two poses, as in the paper
SAMPLES = [TICK * i for i in range(13)]
DURATION = SAMPLES[-1]
SPEED = 1.2  # m/s, of the one that hits

# Who runs into whom: pose of the one that is hit, whose motors are off, and of the one that hits and drives on.
KINDS = [
    ("plain: along the wheels, through the centre", [0.0, 0.0, 0.0], [-0.15, 0.0, 0.0]),
    ("turning: along the wheels, beside the centre", [0.0, 0.0, 0.0], [-0.15, 0.045, 0.0]),
    ("sliding: across the wheels", [0.0, 0.0, math.pi / 2], [-0.15, 0.02, 0.0]),
]
MODELS = ["this model", "paper: wheels hold at once", "oversimplified: round, no turn"]


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
    _, hit, hitting = kind
    return [("b", hit, [0.0, 0.0, 0.0], 0.0), ("a", hitting, [SPEED, 0.0, 0.0], SPEED / WHEEL)]


# Both robots' poses at each sample.
def poses(samples):
    return [[r["pose"] for r in s["robots"]] for s in samples]


def this_model(kind):
    return poses(scene(start(kind), 0.8, DURATION, SAMPLES[:-1])["samples"])


# The free impulse, then infinite grip.
def paper(kind):
    at = scene(start(kind), 0.8, DURATION, [])["impacts"][0]["t"]
    before = scene(start(kind), 0.8, at, [s for s in SAMPLES if s < at])["samples"]
    robots = [(n, r["pose"], [r["twist"][0], 0.0, r["twist"][2]], u) for (n, _, _, u), r in zip(start(kind), before[-1]["robots"])]
    rest = scene(robots, "infinite", DURATION - at, [s - at for s in SAMPLES[:-1] if s > at])["samples"]
    return poses(before[:-1]) + poses(rest)


# Discs as wide as the robots are long, that hit along the line of their centres and never turn; their wheels hold. In steps of 0.1 ms.
def oversimplified(kind):
    step, frames = 1e-4, []
    bodies = [{"at": list(p[:2]), "way": [math.cos(p[2]), math.sin(p[2])], "angle": p[2], "v": t[0], "wanted": u * WHEEL}
              for _, p, t, u in start(kind)]
    for k in range(round(DURATION / step) + 1):
        if any(abs(k * step - s) < step / 2 for s in SAMPLES):
            frames.append([[*b["at"], b["angle"]] for b in bodies])
        b, a = bodies
        between = [b["at"][i] - a["at"][i] for i in (0, 1)]
        apart = math.hypot(*between)
        normal = [c / apart for c in between]
        along = [sum(w * n for w, n in zip(body["way"], normal)) for body in bodies]
        approach = a["v"] * along[1] - b["v"] * along[0]
        if apart <= SIDE and approach > 0:
            impulse = (1 + RESTITUTION) * approach / 2  # of equal masses, per mass
            b["v"] += impulse * along[0]
            a["v"] -= impulse * along[1]
        for body in bodies:
            body["v"] += step * (body["wanted"] - body["v"]) / LAG
            body["at"] = [p + step * body["v"] * w for p, w in zip(body["at"], body["way"])]
    return frames


def robot(pose, colour, opacity, is_round):
    x, y, angle = pose
    outline = f'<circle r="{SIDE / 2}"' if is_round else f'<rect x="{-SIDE / 2}" y="{-SIDE / 2}" width="{SIDE}" height="{SIDE}"'
    return (f'<g transform="translate({x:.4f} {y:.4f}) rotate({math.degrees(angle):.2f})" opacity="{opacity}">'
            f'{outline} fill="none" stroke="{colour}" stroke-width="0.003"/>'
            f'<line x1="0" y1="0" x2="{SIDE / 2}" y2="0" stroke="{colour}" stroke-width="0.004"/></g>')


# The way of the centre, with a dot at each pose.
def trace(track, colour):
    return (f'<polyline points="{" ".join(f"{x:.4f},{y:.4f}" for x, y, _ in track)}" fill="none" stroke="{colour}" stroke-width="0.002"/>'
            + "".join(f'<circle cx="{x:.4f}" cy="{y:.4f}" r="0.004" fill="{colour}"/>' for x, y, _ in track))


def main():
    width, height, scale = 0.68, 0.3, 480
    w, h, head, side = width * scale, height * scale, 34, 16
    print(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {3 * w + 2 * side:.0f} {head + 3 * (h + 26):.0f}" font-family="sans-serif" font-size="13">')
    print('<rect width="100%" height="100%" fill="white"/>')
    for column, name in enumerate(MODELS):
        print(f'<text x="{side + (column + 0.5) * w:.0f}" y="22" text-anchor="middle" font-weight="bold">{name}</text>')
    for row, kind in enumerate(KINDS):
        top = head + row * (h + 26)
        print(f'<text x="{side}" y="{top + 14}" fill="#444">{kind[0]}</text>')
        for column, model in enumerate([this_model, paper, oversimplified]):
            frames = model(kind)
            print(f'<g transform="translate({side + column * w + 0.27 * scale:.1f} {top + 20 + h / 2:.1f}) scale({scale} {-scale})">')
            for i, frame in enumerate(frames):
                opacity = 1 if i in (0, len(frames) - 1) else 0.25
                print(robot(frame[0], "#c08a00", opacity, column == 2) + robot(frame[1], "#1f5fbf", opacity, column == 2))
            print(trace([f[0] for f in frames], "#c08a00") + trace([f[1] for f in frames], "#1f5fbf"))
            print("</g>")
    print("</svg>")


main()
