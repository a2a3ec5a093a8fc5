#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
#
# Draws tick.svg, the messages of one tick: a sequence diagram. Usage: tick.py >tick.svg

PARTS = [("pacer", 80), ("leg", 270), ("controllers\nblue, yellow", 640), ("world", 800), ("referee", 950)]
AT = {name.split("\n")[0]: x for name, x in PARTS}

# (from, to, text, is an answer) or (part, text, lines of it)
STEPS = [
    ("pacer", "leg", "tick t is due", False),
    ("leg", "controllers", "post(observation t), to both", False),
    ("controllers", "leg", "collect(): Command, Late, Fault or HostFailure", True),
    ("leg", "checks both commands: clamps, counts bad values,\nrounds to 1/256 rad/s. A fault ends the leg here."),
    ("leg", "world", "advance(commands of tick t-1, control period)", False),
    ("world", "plays the tick from\nevent to event"),
    ("world", "leg", "touches and counts (TickEvents)", True),
    ("leg", "referee", "judge(situation), only in state PLAY", False),
    ("referee", "leg", "at most one decision, and notes", True),
    ("leg", "at a restart: default placement, state READY;\nthen placement requests, one team in each tick"),
    ("leg", "logs commands and state hash;\nt becomes t+1"),
]

WIDTH, TOP, GAP = 1030, 70, 46
FONT = 'font-family="Helvetica, Arial, sans-serif" font-size="14"'
out, y = [], TOP + 34


def text(x, y, words, anchor="middle", colour="#222"):
    out.append(f'<text x="{x}" y="{y}" text-anchor="{anchor}" fill="{colour}" {FONT}>{words}</text>')


for step in STEPS:
    if len(step) == 4:
        a, b, words, answer = AT[step[0]], AT[step[1]], step[2], step[3]
        dash = ' stroke-dasharray="6 4"' if answer else ""
        tip = 2 if b > a else -2
        middle = (a + b) / 2
        half = 3.7 * len(words)
        out.append(f'<rect x="{middle - half:.0f}" y="{y - 21}" width="{2 * half:.0f}" height="19" fill="#ffffff"/>')
        text(middle, y - 7, words)
        out.append(f'<line x1="{a}" y1="{y}" x2="{b - tip}" y2="{y}" stroke="#1f4e79" stroke-width="1.5"{dash} '
                   'marker-end="url(#tip)"/>')
        y += GAP
    else:
        x, lines = AT[step[0]], step[1].split("\n")
        half = max(len(line) for line in lines) * 3.6 + 12
        height = 18 * len(lines) + 10
        out.append(f'<rect x="{x - half:.0f}" y="{y - 20}" width="{2 * half:.0f}" height="{height}" rx="4" '
                   'fill="#fff7d6" stroke="#b8a04a"/>')
        for i, line in enumerate(lines):
            text(x, y - 3 + 18 * i, line)
        y += height + 26

bottom = y
print(f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{bottom + 10}" '
      f'viewBox="0 0 {WIDTH} {bottom + 10}">')
print('<!-- Made by tick.py. -->')
print('<defs><marker id="tip" viewBox="0 0 10 10" refX="9" refY="5" markerWidth="8" markerHeight="8" orient="auto">'
      '<path d="M0,0 L10,5 L0,10 z" fill="#1f4e79"/></marker></defs>')
print(f'<rect width="{WIDTH}" height="{bottom + 10}" fill="#ffffff"/>')
for name, x in PARTS:
    print(f'<line x1="{x}" y1="{TOP - 10}" x2="{x}" y2="{bottom}" stroke="#999" stroke-dasharray="2 4"/>')
    print(f'<rect x="{x - 65}" y="12" width="130" height="46" rx="4" fill="#e3edf7" stroke="#1f4e79"/>')
    lines = name.split("\n")
    for i, line in enumerate(lines):
        print(f'<text x="{x}" y="{40 - 9 * (len(lines) - 1) + 18 * i}" text-anchor="middle" fill="#222" {FONT}>{line}</text>')
print("\n".join(out))
print("</svg>")
