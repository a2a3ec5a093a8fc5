#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A bad wire between a match and a team: forwards datagrams, loses some and sends some twice, the
second time after the datagram that follows.

wire.py LOSS DOUBLED SEED PORT:ADDRESS:PORT...: probabilities; what arrives at the first port of this
host goes to the address. Runs until it is ended; prints "ready" when it listens.
"""
import random
import select
import socket
import sys

loss, doubled = float(sys.argv[1]), float(sys.argv[2])
dice = random.Random(int(sys.argv[3]))
ways, late = {}, {}
for text in sys.argv[4:]:
    port, address, to = text.split(":")
    way = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    way.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton("127.0.0.1"))
    way.bind(("127.0.0.1", int(port)))
    ways[way] = (address, int(to))
print("ready", flush=True)
while True:
    for way in select.select(list(ways), [], [])[0]:
        data = way.recv(4096)
        if dice.random() >= loss:
            way.sendto(data, ways[way])
        if way in late:
            way.sendto(late.pop(way), ways[way])
        if dice.random() < doubled:
            late[way] = data
