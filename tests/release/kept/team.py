"""A keeper, one robot that kicks to the opponents' goal, and the others behind the ball."""

from mirocup.team import (Team, attack_ball, avoid_own_goals, drive_clear, free_ball, inside, is_stuck,
                          keep_goal, keep_laws, keep_out, kick_off, make_way, must_kick_off, open_corner)


class Mine(Team):
    name = "python"

    def __init__(self, setup):
        super().__init__(setup)
        self.distance = self.parameter("wait", 0.45)  # how far behind, m

    def decide(self, now):
        wheels = [keep_goal(self.setup, now, now.own[0]), self.kick(now)]
        for i in range(2, now.robots):  # the others wait behind the ball
            post = inside(self.setup, (now.ball_x - self.distance - 0.2 * (i - 2), -0.5 * now.ball_y))
            legal = make_way(self.setup, now, keep_out(self.setup, i, post))
            wheels.append(drive_clear(self.setup, now, now.own[i], legal))
        wheels = avoid_own_goals(self.setup, now, wheels)
        return keep_laws(self.setup, now, wheels)  # no pushing

    def kick(self, now):  # you always attack +x
        if must_kick_off(now):
            return kick_off(self.setup, now.own[1])
        if is_stuck(now):
            return free_ball(self.setup, now, now.own[1])
        return attack_ball(self.setup, now, 1, open_corner(self.setup, now))
