# SPDX-License-Identifier: MIT
"""Sheet "roles": all robots attack, nobody keeps the goal, and nobody knows a law."""

from mirocup.team import Team, attack_ball, open_corner


class Mine(Team):
    name = "mine"

    def decide(self, now):
        return [attack_ball(self.setup, now, i, open_corner(self.setup, now)) for i in range(now.robots)]
