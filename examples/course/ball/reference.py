# SPDX-License-Identifier: MIT
"""Sheet "ball": the reference, 100 on the scale of the sheet."""

from mirocup.team import Point, Team, ball_after, dot, drive_to, inside, length, position, unit


class Reference(Team):
    name = "reference"

    def decide(self, now):
        robot = now.own[1]
        meet = self.meeting(now, robot)
        along = unit(Point(self.setup.half_length, 0.0) - meet)
        left = Point(-along.y, along.x)
        from_ball = position(robot) - meet
        behind = -dot(from_ball, along)  # m
        aside = dot(from_ball, left)  # m
        wheels = [(0.0, 0.0)] * now.robots
        if behind > 0.0 and abs(aside) < 0.02 + 0.35 * behind:
            # Near the line of the shot: back to the line, and through the ball.
            through = meet + 0.3 * along - (2.0 * aside) * left
            wheels[1] = drive_to(self.setup, robot, through, 2.2, 2.2)
        else:
            # Round the ball, never nearer than the robot needs to turn.
            side = 0.0 if behind > 0.05 else 0.11 if aside > 0.0 else -0.11
            place = inside(self.setup, meet - 0.11 * along + side * left)
            wheels[1] = drive_to(self.setup, robot, place, 0.5, 1.7)
        return wheels

    def meeting(self, now, robot):
        """Returns the first place on the way of the ball at which the robot can be as early as the ball."""
        pace = 1.2  # m/s, of the robot on its way
        t = 0.0
        while t < 2.0 and length(self.ball_at(now, t) - position(robot)) > pace * t:
            t += 0.033
        return self.ball_at(now, t)

    def ball_at(self, now, t):
        """Returns the place of the ball after t seconds, also if a wall has thrown it back."""
        free = ball_after(now, t)
        return Point(self.thrown_back(free.x, self.setup.half_length), self.thrown_back(free.y, self.setup.half_width))

    def thrown_back(self, at, wall):
        most = wall - self.setup.ball_radius
        over = max(0.0, abs(at) - most) * (1.0 + self.setup.ball_wall_restitution)
        return at - over if at > 0.0 else at + over
