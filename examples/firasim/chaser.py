#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A team for FIRASim, and for `mirocup match --blue firasim:NAME`: the nearest robot chases the
ball, the keeper stays on the line, the others wait behind the ball. Ends when the referee says HALT, or after SECONDS of silence.

chaser.py blue|yellow [--vision ADDR:PORT] [--command ADDR:PORT] [--referee ADDR:PORT]
          [--placement ADDR:PORT] [--instance K] [--no-echo] [--patience SECONDS]
"""
import argparse
import math
import time

import firasim

FASTEST = 60.0  # rad/s


def towards(robot, x, y):
    """Returns the wheels that drive the robot to a point; it drives backwards as well."""
    error = math.atan2(y - robot.y, x - robot.x) - robot.heading
    error = math.atan2(math.sin(error), math.cos(error))
    sign = 1.0
    if abs(error) > math.pi / 2:
        sign, error = -1.0, error - math.copysign(math.pi, error)
    speed = sign * FASTEST * max(0.0, math.cos(error)) ** 2
    turn = 25.0 * error
    return speed - turn, speed + turn


def decide(picture, is_yellow):
    """Returns the wheels of all robots. `side` turns the field so that the team attacks +x."""
    side = -1.0 if is_yellow else 1.0
    own = picture.robots[int(is_yellow)]
    ball = picture.ball
    half_length = picture.field.get(2, 1.5) / 2
    half_goal = picture.field.get(3, 0.4) / 2
    chaser = min(own[1:], key=lambda robot: math.hypot(robot.x - ball.x, robot.y - ball.y))
    wheels = []
    for robot in own:
        if robot.id == 0:
            y = max(-half_goal, min(half_goal, ball.y))
            wheels.append(towards(robot, side * (0.05 - half_length), y))
            continue
        if robot is not chaser:  # two of a team in the other goal area are one too many
            x = side * min(side * ball.x - 0.35, half_length - 0.45)
            wheels.append(towards(robot, x, -ball.y / 2))
            continue
        behind = side * (ball.x - robot.x) > 0.05
        x = ball.x if behind else ball.x - side * 0.2
        y = ball.y if behind else ball.y + math.copysign(0.12, robot.y - ball.y)
        wheels.append(towards(robot, x, y))
    return wheels


def places(call, robots, is_yellow, field):
    """Returns where the robots want to stand: all in the own half, the kicker behind the ball."""
    side = -1.0 if is_yellow else 1.0
    heading = 180.0 if is_yellow else 0.0
    half_length = field.get(2, 1.5) / 2
    poses = [(side * (0.06 - half_length), 0.0, heading)]
    takes = call.foul == firasim.KICKOFF and call.colour == int(is_yellow)
    for i in range(1, robots):
        x = -0.09 if takes and i == 1 else -0.35
        poses.append((side * x, side * (0.0 if i == 1 else 0.2 * (i - 2) - 0.2), heading))
    return poses


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("team", choices=["blue", "yellow"])
    for name in ("vision", "command", "referee", "placement"):
        arguments.add_argument("--" + name)
    arguments.add_argument("--instance", type=int, default=0)
    arguments.add_argument("--no-echo", action="store_true")
    arguments.add_argument("--patience", type=float, default=60.0)
    given = arguments.parse_args()
    is_yellow = given.team == "yellow"
    ways = firasim.ways_of(given.instance)
    ways.update({name: getattr(given, name) for name in ways if getattr(given, name)})
    client = firasim.Client(is_yellow, echo=not given.no_echo, **ways)
    robots, field, call, is_on, heard = 3, {}, None, False, time.monotonic()
    while time.monotonic() - heard < given.patience:
        picture, calls = client.wait(0.5)
        if picture or calls:
            heard = time.monotonic()
        if picture:
            robots, field = len(picture.robots[0]), picture.field
        for call in calls:
            is_on = call.foul == firasim.GAME_ON
            if call.foul == firasim.HALT:
                return
            if call.foul not in (firasim.STOP, firasim.GAME_ON):
                client.place(places(call, robots, is_yellow, field))
        if picture:
            wheels = decide(picture, is_yellow) if is_on else [(0.0, 0.0)] * robots
            client.drive(wheels, picture.step)


if __name__ == "__main__":
    main()
