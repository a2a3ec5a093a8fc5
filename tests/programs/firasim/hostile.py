#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Sends COUNT datagrams that must have no effect to a match, from one socket that no team has:
mutated packets, cut ones, commands for both colours, NaN, replacements, placements.

hostile.py INSTANCE COUNT [SEED]; prints how many it sent of each kind. Waits for the first vision,
and spreads its datagrams over the leg.
"""
import os
import random
import struct
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../../examples/firasim"))
import firasim  # noqa: E402

instance, count = int(sys.argv[1]), int(sys.argv[2])
dice = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 1)


def command(robot, yellow, left, right):
    body = firasim.number(1, robot) + firasim.number(2, yellow)
    body += firasim.real(6, left) + firasim.real(7, right)
    return firasim.message(1, firasim.message(1, body))


def placement(colour):
    robot = firasim.number(1, 0) + firasim.real(2, 0.0) + firasim.real(3, 0.0)
    return firasim.message(1, firasim.number(1, colour) + firasim.message(2, robot))


def mutated(data):
    data = bytearray(data)
    for _ in range(dice.randrange(1, 5)):
        data[dice.randrange(len(data))] = dice.randrange(256)
    return bytes(data[:dice.randrange(len(data) + 1)])


ways = firasim.ways_of(instance)
client = firasim.Client(False, **ways)
ball = b"".join(firasim.real(k, 0.1) for k in (1, 2, 3, 4))
nan = struct.unpack("<d", b"\xff" * 8)[0]
sent = {}


def send(kind, data):
    to = client.placement if kind == "placement" else client.command
    client.out.sendto(data, to)
    sent[kind] = sent.get(kind, 0) + 1


while not client.wait(5.0)[0]:
    pass
is_over = False
for i in range(count):
    if i % 8 == 0 and not is_over:
        picture, calls = client.wait(1.0)
        is_over = any(call.foul == firasim.HALT for call in calls)
    kind = i % 7
    colour = dice.randrange(2)
    if kind == 0:
        send("mutated", mutated(command(dice.randrange(4), colour, 50.0, -50.0)))
    elif kind == 1:
        send("noise", dice.randbytes(dice.randrange(200)))
    elif kind == 2:
        send("foreign", command(dice.randrange(3), colour, 60.0, -60.0))
    elif kind == 3:
        send("not finite", command(0, colour, nan, float("inf")))
    elif kind == 4:
        send("replacement", firasim.message(2, firasim.message(1, ball)))
    elif kind == 5:
        send("long", command(7, colour, 1e9, 1e300) * dice.randrange(1, 60))
    else:
        send("placement", mutated(placement(colour)) if dice.random() < 0.5 else placement(colour))
print(sent)
