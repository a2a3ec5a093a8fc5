#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A team in Python: robot 0 keeps the goal, all others get behind the ball and push it.

    mirocup match --blue dds:snake --yellow keeper --match final &
    examples/python/chaser.py final blue snake [SERVER [CREDENTIALS]]

It plays over the network, from any computer. $MIROCUP_TEAM_LIBRARY names the library; without it
that of the build tree is used, or the installed one. docs/python.md has teams in Python without a
network.
"""

import math
import sys

import mirocup_team


def wheels_for(setup, forward, turn):
    """Returns the wheel speeds for a forward speed (m/s) and an angular velocity (rad/s)."""
    side = turn * setup.wheel_distance / 2.0
    return (forward - side) / setup.wheel_radius, (forward + side) / setup.wheel_radius


def drive_to(setup, robot, x, y):
    """Drives to a point, forwards or backwards, whichever needs the smaller turn."""
    distance = math.hypot(x - robot.x, y - robot.y)
    if distance < 0.01:
        return 0.0, 0.0
    error = math.remainder(math.atan2(y - robot.y, x - robot.x) - robot.heading, 2.0 * math.pi)
    direction = 1.0
    if abs(error) > math.pi / 2.0:
        error = math.remainder(error + math.pi, 2.0 * math.pi)
        direction = -1.0
    speed = min(1.2, 3.0 * distance) * max(0.0, math.cos(error))
    return wheels_for(setup, direction * speed, 6.0 * error)


def behind_ball(setup, now, robot, aside):
    """Returns the place to drive to so that the ball goes to the opponents' goal."""
    to_x, to_y = setup.half_length - now.ball_x, -now.ball_y
    distance = math.hypot(to_x, to_y)
    ux, uy = to_x / distance, to_y / distance
    dx, dy = robot.x - now.ball_x, robot.y - now.ball_y
    along, across = dx * ux + dy * uy, dy * ux - dx * uy
    if along < -0.05 and abs(across) < 0.03:  # straight behind it: through it
        return now.ball_x + 0.3 * ux, now.ball_y + 0.3 * uy
    if along > -0.05:  # beside or before it: first around
        aside = math.copysign(0.15, across)
    return now.ball_x - 0.15 * ux - aside * uy, now.ball_y - 0.15 * uy + aside * ux


def decide(setup, now):
    commands = []
    for i in range(now.robots):
        if i == 0:
            x = -setup.half_length + setup.robot_side
            y = max(-setup.goal_half_width, min(setup.goal_half_width, now.ball_y))
        else:
            x, y = behind_ball(setup, now, now.own[i], 0.1 * (i - 1))
        commands.append(drive_to(setup, now.own[i], x, y))
    return commands


def place(setup, now, placement):
    """At an own kick-off places robot 2 aside, where it can receive the ball from robot 1."""
    if now.restart == mirocup_team.KICK_OFF and now.own_restart:
        placement.robots[2].y = 0.3


def main(arguments):
    if not 3 <= len(arguments) <= 5:
        print(__doc__, file=sys.stderr)
        return 2
    try:
        how, score = mirocup_team.play(*arguments[:3], decide, *arguments[3:], place=place)
    except mirocup_team.Error as error:
        print(f"chaser.py: {error}", file=sys.stderr)
        return 3
    print(f"the match is over ({how}): blue {score[0]}, yellow {score[1]}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
