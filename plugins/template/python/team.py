"""A keeper, one robot that kicks to the opponents' goal, and the others behind the ball."""

from mirocup.team import (Team, ball, drive_clear, inside, keep_goal, keep_laws, keep_out, kick_off,
                          kick_to, length, must_kick_off, position)


class Mine(Team):
    name = "mine"

    def __init__(self, setup):
        super().__init__(setup)
        # How far behind the ball the others wait, m. To try another value: --param wait=0.4
        self.distance = self.parameter("wait", 0.45)
        print(setup.robots, "robots a side, seed", setup.seed)

    def decide(self, now):
        wheels = [keep_goal(self.setup, now, now.own[0])]
        kicker = self.nearest(now)
        for i in range(1, now.robots):
            wheels.append(self.kick(now, i) if i == kicker else self.wait(now, i))
        return keep_laws(self.setup, now, wheels)  # no pushing

    def nearest(self, now):
        """Returns the robot nearest to the ball; robot 0 stays in the goal and is never chosen."""
        return min(range(1, now.robots), key=lambda i: length(position(now.own[i]) - ball(now)))

    def kick(self, now, i):
        if must_kick_off(now):
            return kick_off(self.setup, now.own[i])
        return kick_to(self.setup, now, now.own[i], (self.setup.half_length, 0.0))

    def wait(self, now, i):
        post = inside(self.setup, (now.ball_x - self.distance, 0.2 if i % 2 == 0 else -0.2))
        return drive_clear(self.setup, now, now.own[i], keep_out(self.setup, i, post))
