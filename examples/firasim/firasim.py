# SPDX-License-Identifier: MIT
"""The protocol of FIRASim and VSSReferee for teams, with Python's standard library only.

A team gets each vision packet by `Client.wait()`, answers with `Client.drive()`, and answers the
referee's call with `Client.place()`. On the wire blue is left and attacks +x. Metres, radians,
rad/s; the headings of a placement are in degrees, as VSSReferee wants them.
"""
import select
import socket
import struct

FREE_KICK, PENALTY_KICK, GOAL_KICK, FREE_BALL, KICKOFF, STOP, GAME_ON, HALT = range(8)


def fields(data):
    """Yields (number, value) of each field of a protobuf message: int, float or bytes."""
    at = 0

    def varint():
        nonlocal at
        value = shift = 0
        while True:
            byte = data[at]
            at += 1
            value |= (byte & 0x7F) << shift
            shift += 7
            if byte < 0x80:
                return value

    while at < len(data):
        tag = varint()
        kind = tag & 7
        if kind == 0:
            value = varint()
        elif kind == 1:
            value = struct.unpack_from("<d", data, at)[0]
            at += 8
        elif kind == 2:
            size = varint()
            value = data[at:at + size]
            at += size
        else:
            at += 4
            continue
        yield tag >> 3, value


def varint(value):
    out = bytearray()
    while value >= 0x80:
        out.append(value & 0x7F | 0x80)
        value >>= 7
    out.append(value)
    return bytes(out)


def number(field, value):
    return varint(field << 3) + varint(value)


def real(field, value):
    return varint(field << 3 | 1) + struct.pack("<d", value)


def message(field, data):
    return varint(field << 3 | 2) + varint(len(data)) + data


class Body:
    """The ball or a robot: x, y, heading, vx, vy, turn."""

    def __init__(self, data, is_robot):
        values = dict(fields(data))
        first = 2 if is_robot else 1
        self.id = int(values.get(1, 0)) if is_robot else 0
        self.x = values.get(first, 0.0)
        self.y = values.get(first + 1, 0.0)
        self.heading = values.get(4, 0.0) if is_robot else 0.0
        self.vx = values.get(5 if is_robot else 4, 0.0)
        self.vy = values.get(6 if is_robot else 5, 0.0)
        self.turn = values.get(7, 0.0) if is_robot else 0.0


class Vision:
    def __init__(self, data):
        self.step, self.robots, self.field, self.goals = 0, ([], []), {}, [0, 0]
        for field, value in fields(data):
            if field == 1:
                self.step = value
            elif field == 2:
                for part, inner in fields(value):
                    if part == 1:
                        self.ball = Body(inner, False)
                    else:  # yellow is 2, blue is 3
                        self.robots[1 if part == 2 else 0].append(Body(inner, True))
            elif field == 3:
                self.field = dict(fields(value))
            elif field in (4, 5):
                self.goals[field - 4] = value


class Call:
    """What the referee said. colour: 0 blue, 1 yellow, 2 none."""

    def __init__(self, data):
        values = dict(fields(data))
        self.foul = values.get(1, 0)
        self.colour = values.get(2, 0)
        self.quadrant = values.get(3, 0)
        self.timestamp = values.get(4, 0.0)
        self.half = values.get(5, 0)


def listener(address, port):
    """Returns a socket that hears what is sent to the address: a group, or one of this host."""
    heard = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    heard.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    heard.bind((address, port))
    if 224 <= int(address.split(".")[0]) <= 239:
        for interface in ("0.0.0.0", "127.0.0.1"):  # whichever this host has
            group = socket.inet_aton(address) + socket.inet_aton(interface)
            try:
                heard.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, group)
            except OSError:
                pass
    return heard


def ways_of(instance):
    """Returns the addresses of match number `instance` on this host (--firasim-instance)."""
    return {"vision": "224.0.0.1:%d" % (10002 + instance),
            "command": "127.0.0.1:%d" % (20011 + instance),
            "referee": "224.5.23.2:%d" % (40000 + instance if instance else 10003),
            "placement": "224.5.23.2:%d" % (50000 + instance if instance else 10004)}


class Client:
    def __init__(self, is_yellow, vision="224.0.0.1:10002", command="127.0.0.1:20011",
                 referee="224.5.23.2:10003", placement="224.5.23.2:10004", echo=True):
        def split(text):
            address, port = text.rsplit(":", 1)
            return address, int(port)

        self.is_yellow = is_yellow
        self.echo = echo  # say which step a command answers; FIRASim itself ignores it
        self.command, self.placement = split(command), split(placement)
        self.vision = listener(*split(vision))
        self.referee = listener(*split(referee))
        self.out = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        if self.placement[0].startswith("2"):
            try:
                self.out.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF,
                                    socket.inet_aton("127.0.0.1"))
            except OSError:
                pass

    def wait(self, seconds):
        """Returns (vision or None, [calls]): the newest picture, and all calls since the last one."""
        select.select([self.vision, self.referee], [], [], seconds)
        calls, picture = [], None
        while select.select([self.referee], [], [], 0)[0]:
            calls.append(Call(self.referee.recv(2048)))
        while select.select([self.vision], [], [], 0)[0]:
            picture = Vision(self.vision.recv(2048))
        return picture, calls

    def drive(self, wheels, step=None):
        """Sends the wheel speeds, a list of (left, right) in rad/s."""
        commands = b""
        for i, (left, right) in enumerate(wheels):
            robot = number(1, i) + number(2, int(self.is_yellow)) + real(6, left) + real(7, right)
            commands += message(1, robot)
        packet = message(1, commands)
        if self.echo and step is not None:
            packet += number(15, step)
        self.out.sendto(packet, self.command)

    def place(self, poses):
        """Asks for places, a list of (x, y, heading in degrees)."""
        world = number(1, int(self.is_yellow))
        for i, (x, y, degrees) in enumerate(poses):
            world += message(2, number(1, i) + real(2, x) + real(3, y) + real(4, degrees))
        self.out.sendto(message(1, world), self.placement)
