"""Calls the team as a match would: ./test runs it, or python3 -m unittest."""

import math
import unittest

import mirocup.team as m
import team

SETUP = m.Setup(league=m.SMALL, team=0, robots=3, seed=1, control_period=0.033, half_s=300.0,
                ready_s=0.33, half_length=0.75, half_width=0.65, corner_leg=0.07, goal_half_width=0.2,
                goal_depth=0.1, goal_area_depth=0.15, goal_area_half_width=0.25,
                penalty_area_depth=0.0, penalty_area_half_width=0.0, centre_circle_radius=0.2,
                robot_side=0.075, robot_mass=0.5, wheel_distance=0.07, wheel_radius=0.025,
                wheel_speed_limit=60.0, grip=1.0, motor_time_constant=0.05, turn_time_constant=0.0,
                brake_time_constant=0.0, ball_radius=0.02135, ball_mass=0.046)
TEAM = next(c for c in vars(team).values()
            if isinstance(c, type) and issubclass(c, m.Team) and c is not m.Team)


def play_with_ball_at(x, y, tick=0):
    own = tuple(m.Robot(-0.7 + 0.3 * i, 0.0, 0.0, 0.0, 0.0, 0.0) for i in range(3))
    opponent = tuple(m.Robot(0.7 - 0.2 * i, 0.0, math.pi, 0.0, 0.0, 0.0) for i in range(3))
    return m.Observation(tick, 0.033 * tick, 0.0, m.PLAY, m.FIRST_HALF, m.KICK_OFF, 0, 0, 0, 0, 3, 0,
                         x, y, 0.0, 0.0, own, opponent, (0,) * 3, (0,) * 3, 0.0, 0.0, m.Counts(),
                         m.Counts())


class Decides(unittest.TestCase):
    def test_wheel_speeds_are_numbers(self):
        mine = TEAM(SETUP)
        for tick in range(100):
            wheels = mine.decide(play_with_ball_at(0.005 * tick, 0.1, tick))
            self.assertEqual(len(wheels), 3)
            for left, right in wheels:
                self.assertTrue(math.isfinite(left) and math.isfinite(right))


if __name__ == "__main__":
    unittest.main()
