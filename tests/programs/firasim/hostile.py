#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The team of chaser.py, and beside it strangers: sockets that no team has send COUNT datagrams that
must have no effect: mutated commands, replacements and placements, cut ones, noise, commands for
both colours, NaN.

hostile.py INSTANCE COUNT [SEED] [FLOOD]; prints how many it sent of each kind. Some of them come
before each answer of the team, so that a slow machine sends as many in a leg as a quick one. With
FLOOD it sends that many more, as fast as it can, after each thousand.
"""
import os
import random
import socket
import struct
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../../examples/firasim"))
import chaser  # noqa: E402
import firasim  # noqa: E402

BEFORE_AN_ANSWER = 16

instance, count = sys.argv[1], int(sys.argv[2])
dice = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 1)
flood = int(sys.argv[4]) if len(sys.argv) > 4 else 0


def command(robot, yellow, left, right):
    body = firasim.number(1, robot) + firasim.number(2, yellow)
    body += firasim.real(6, left) + firasim.real(7, right)
    return firasim.message(1, firasim.message(1, body))


def placement(colour):
    robot = firasim.number(1, 0) + firasim.real(2, 0.0) + firasim.real(3, 0.0)
    return firasim.message(1, firasim.number(1, colour) + firasim.message(2, robot))


def replacement(colour):
    ball = b"".join(firasim.real(k, 0.1) for k in (1, 2, 3, 4))
    place = firasim.message(1, firasim.number(1, 0) + firasim.real(2, 0.1) + firasim.real(3, 0.1))
    robot = place + firasim.number(5, colour) + firasim.number(6, 1)
    return firasim.message(2, firasim.message(1, ball) + firasim.message(2, robot))


def mutated(data):
    data = bytearray(data)
    for _ in range(dice.randrange(1, 5)):
        data[dice.randrange(len(data))] = dice.randrange(256)
    return bytes(data[:dice.randrange(len(data) + 1)])


client = firasim.Client(False, **firasim.ways_of(int(instance)))
senders = [client.out] + [socket.socket(socket.AF_INET, socket.SOCK_DGRAM) for _ in range(7)]
for sender in senders:
    sender.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton("127.0.0.1"))
nan = struct.unpack("<d", b"\xff" * 8)[0]
sent = {}


def send(kind, data):
    to = client.placement if kind.split()[-1] == "placement" else client.command
    dice.choice(senders).sendto(data, to)
    sent[kind] = sent.get(kind, 0) + 1


def send_one(i):
    kind, colour = i % 9, dice.randrange(2)
    if kind == 0:
        send("mutated command", mutated(command(dice.randrange(4), colour, 50.0, -50.0)))
    elif kind == 1:
        send("noise", dice.randbytes(dice.randrange(200)))
    elif kind == 2:
        send("command", command(dice.randrange(3), colour, 60.0, -60.0))
    elif kind == 3:
        send("not finite", command(0, colour, nan, float("inf")))
    elif kind == 4:
        send("replacement", replacement(colour))
    elif kind == 5:
        send("mutated replacement", mutated(replacement(colour)))
    elif kind == 6:
        send("long", command(7, colour, 1e9, 1e300) * dice.randrange(1, 60))
    elif kind == 7:
        send("placement", placement(colour))
    else:
        send("mutated placement", mutated(placement(colour)))


def send_some(first):
    for i in range(first, min(first + BEFORE_AN_ANSWER, count)):
        send_one(i)
        for k in range(flood if i % 1000 == 500 else 0):
            data = command(dice.randrange(3), k % 2, 60.0, -60.0)
            senders[k % len(senders)].sendto(data, client.command)
            sent["flood"] = sent.get("flood", 0) + 1


class Team(firasim.Client):
    answers = 0

    def drive(self, wheels, step=None):
        # The team has its seat before the strangers come: a free seat is for whoever comes first.
        if Team.answers >= 10:
            send_some(BEFORE_AN_ANSWER * (Team.answers - 10))
        Team.answers += 1
        super().drive(wheels, step)


firasim.Client = Team
sys.argv[1:] = ["blue", "--instance", instance]
chaser.main()
print(sent)
