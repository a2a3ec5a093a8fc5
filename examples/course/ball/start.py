# SPDX-License-Identifier: MIT
"""Sheet "ball": robot 1 drives to the ball, and pushes it to wherever it happens to go."""

from mirocup.team import Team, ball, drive_to


class Mine(Team):
    name = "mine"

    def decide(self, now):
        wheels = [(0.0, 0.0)] * now.robots
        wheels[1] = drive_to(self.setup, now.own[1], ball(now), 0.0, 0.35)
        return wheels
