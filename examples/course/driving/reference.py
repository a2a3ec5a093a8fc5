# SPDX-License-Identifier: MIT
"""Sheet "driving": the reference, 100 on the scale of the sheet."""

from math import copysign, pi

from mirocup.team import Point, Team, atan2, ball, cos, dot, length, position, unit, wheels_for, wrapped


class Reference(Team):
    name = "reference"

    def decide(self, now):
        return [self.drive(now.own[0], Point(-0.7, 0.0), 0.0), self.line_up(now, now.own[1]),
                self.hurry(now, now.own[2])]

    def line_up(self, now, robot):
        """Comes to the ball along the line of the shot: the nearer to the ball, the nearer to the line."""
        along = unit(Point(self.setup.half_length, 0.0) - ball(now))
        from_ball = position(robot) - ball(now)
        behind = -dot(from_ball, along)  # m
        aside = abs(from_ball.x * along.y - from_ball.y * along.x)  # m
        if behind < 0.7 * aside:
            return self.drive(robot, ball(now) - 0.16 * along, 0.3)
        if behind < 0.1 and aside < 0.03:
            return self.drive(robot, ball(now) + 0.2 * along, 1.0)
        return self.drive(robot, ball(now) - max(0.06, 0.75 * behind) * along, 0.5)

    def hurry(self, now, robot):
        """Drives to the ball at full speed, and past the side of an opponent that stands on the way."""
        berth = 0.11  # m, between the middles of two robots
        along = unit(ball(now) - position(robot))
        left = Point(-along.y, along.x)
        target = ball(now)
        free = length(ball(now) - position(robot))  # m, of the way
        for opponent in now.opponent:
            other = position(opponent) - position(robot)
            ahead, aside = dot(other, along), dot(other, left)
            if 0.02 <= ahead <= free and abs(aside) <= berth:
                free = ahead
                target = position(opponent) + (-berth if aside > 0.0 else berth) * left
        return self.drive(robot, target, 2.0)

    def drive(self, robot, target, arrival):
        """Drives to a target and arrives there at `arrival` m/s, forwards or backwards, whichever needs the smaller turn."""
        to = target - position(robot)
        error = wrapped(atan2(to.y, to.x) - robot.heading)
        direction = 1.0
        if abs(error) > pi / 2.0:
            error = wrapped(error + pi)
            direction = -1.0
        # A command is driven one tick later, and the motors lag: the robot brakes for the place where
        # it will be then.
        delay = self.setup.control_period + self.setup.motor_time_constant
        rolls_on = delay * dot(Point(robot.vx, robot.vy), unit(to))  # m
        wanted = arrival + 10.0 * (length(to) - rolls_on)
        forward = min(max(wanted, -2.0), 2.0) * cos(error)
        # Near the target its direction changes too fast to follow.
        turn = 0.0 if length(to) < 0.02 and arrival == 0.0 else 10.0 * error
        # Sliding wheels do not steer.
        steady = 0.8 * self.setup.grip * 9.81  # m/s^2
        if abs(forward * turn) > steady:
            forward = copysign(steady / abs(turn), forward)
        return wheels_for(self.setup, direction * forward, turn)
