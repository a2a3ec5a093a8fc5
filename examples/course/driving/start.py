# SPDX-License-Identifier: MIT
"""Sheet "driving": each robot has a place to go to. Write drive(), and better ways to the ball."""

from mirocup.team import Point, Team, atan2, ball, position, unit, wrapped


class Mine(Team):
    name = "mine"

    def decide(self, now):
        along = unit(Point(self.setup.half_length, 0.0) - ball(now))
        return [
            # Robot 0 stands in the middle of its goal.
            self.drive(now.own[0], Point(-0.7, 0.0)),
            # Robot 1 lines up behind the ball, on the line to the middle of the opponents' goal.
            self.drive(now.own[1], ball(now) - 0.08 * along),
            # Robot 2 touches the ball as soon as it can.
            self.drive(now.own[2], ball(now))]

    def drive(self, robot, target):
        """Drives on and on at 0.4 m/s, and turns towards the target."""
        to = target - position(robot)
        error = wrapped(atan2(to.y, to.x) - robot.heading)  # rad
        forward = 0.4  # m/s
        turn = 4.0 * error  # rad/s
        side = turn * self.setup.wheel_distance / 2.0
        return (forward - side) / self.setup.wheel_radius, (forward + side) / self.setup.wheel_radius
