# SPDX-License-Identifier: MIT
"""Sheet "roles": the reference, 100 on the scale of the sheet."""

from mirocup.team import (Team, attack_ball, avoid_own_goals, ball, cheapest_robot, drive_clear, free_ball, guard_goal,
                          is_stuck, keep_laws, kick_off, must_kick_off, shooting_aim, spare_keeper, supporting_place,
                          time_behind)


class Reference(Team):
    name = "reference"
    attacker = 1

    def decide(self, now):
        # The robot that can be behind the ball first attacks. It keeps the role unless another robot
        # is clearly faster. At a kick-off robot 1 stands before the ball.
        self.attacker = 1 if must_kick_off(now) else cheapest_robot(
            now, 1, self.attacker, 0.2, lambda i: time_behind(self.setup, now, i))
        wheels = [guard_goal(self.setup, now, now.own[0])]
        rank = 0
        for i in range(1, now.robots):
            wheels.append(self.attack(now, i) if i == self.attacker else self.support(now, i, rank))
            rank += i != self.attacker
        wheels = avoid_own_goals(self.setup, now, wheels)
        wheels = keep_laws(self.setup, now, wheels)
        return spare_keeper(self.setup, now, wheels)

    def attack(self, now, i):
        if must_kick_off(now):
            return kick_off(self.setup, now.own[i])
        if is_stuck(now):
            return free_ball(self.setup, now, now.own[i])
        return attack_ball(self.setup, now, i, shooting_aim(self.setup, now, ball(now)))

    def support(self, now, i, rank):
        """Waits behind the ball, where the robot takes over a lost ball."""
        return drive_clear(self.setup, now, now.own[i], supporting_place(self.setup, now, i, rank))
