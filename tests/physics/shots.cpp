// SPDX-License-Identifier: MIT
//
// Fast balls and long ticks: nothing gets through or into anything.
#include "tests/physics/bars.hpp"
#include "tests/physics/scene.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::scenes {

using namespace test_support;

namespace {

// Somewhere worth shooting at: a robot, a post, a corner of the field, anywhere.
Vec2 random_aim(Random& random, const field::Field& f, const Vec2& robot) {
  const double side = random.coin() ? 1.0 : -1.0;
  const double up = random.coin() ? 1.0 : -1.0;
  const Vec2 nearby = random_in(random, 0.05, 0.05);
  switch (random.below(4)) {
    case 0:
      return robot + nearby;
    case 1:
      return Vec2{side * f.half_length, up * f.goal_half_width} + nearby;
    case 2:
      return Vec2{side * f.half_length, up * f.half_width} + nearby;
    default:
      return random_in(random, f.half_length, f.half_width);
  }
}

// Does a ball on its straight way, longer than `most` or not, run into the robot before it runs
// into something solid? The robot stands still.
bool runs_into_robot(const Parameters& p, const BallState& ball, const Outline& robot,
                     const std::vector<Outline>& solids, double most) {
  const Vec2 along = ball.velocity.normalized();
  double way = 0.0;
  while (way < most) {
    const Outline there = circle_at(ball.position + way * along, p.ball_radius);
    double solid = HUGE_VAL;
    for (const Outline& s : solids) solid = std::min(solid, distance(there, s));
    const double from_robot = distance(there, robot);
    if (from_robot < 1e-7) return true;
    if (solid < 1e-7) return false;
    way += std::min(solid, from_robot);
  }
  return false;
}

}  // namespace

Bars shots(Size size) {
  Random random(4);
  const field::Field field = field::make_field(RobotLeague::small);
  const auto solids = test_support::solids_around(field);
  double deepest = 0.0;
  double deepest_own = 0.0;
  int through = 0;
  int not_finite = 0;
  int stepped = 0;
  const int shots = cases(size, 5000, 1000000);
  for (int i = 0; i < shots; ++i) {
    Start s;
    s.field = &field;
    const bool stands = random.coin();
    BodyState robot{random_in(random, 0.6, 0.5), random_heading(random), {}};
    if (!stands) robot.twist = {random.uniform(-2.0, 2.0), 0.0, random.uniform(-40.0, 40.0)};
    s.robots.push_back(robot);
    const Vec2 from = random_in(random, 0.7, 0.6);
    const Vec2 direction = (random_aim(random, field, robot.position) - from).normalized();
    s.ball.push_back({from, random_logarithmic(random, 0.1, 100.0) * direction});
    if (overlap(s)) continue;
    const double length = random_logarithmic(random, 1e-3, 0.1);
    const WheelCommand command = stands ? WheelSpeeds{} : random_wheels(random, 80.0);

    const auto world = world_of(s);
    const auto rolled = roll_exactly(s.parameters, exactly(s.ball[0]), length);
    const double way = std::hypot(static_cast<double>(rolled.x) - from.x(),
                                  static_cast<double>(rolled.y) - from.y());
    const Outline robot_there = square_at(
        robot.position, std::atan2(robot.heading.sin, robot.heading.cos), s.parameters.robot_side);
    const bool must_hit =
        stands && runs_into_robot(s.parameters, s.ball[0], robot_there, solids, way - 1e-6);
    for (int k = 0; k < 3; ++k) {
      const simulator::TickEvents& events = world->advance({&command, 1}, length);
      deepest_own = std::max(deepest_own, events.deepest_overlap);
      deepest = std::max(deepest, deepest_overlap(*world, solids));
      if (k == 0 && must_hit && !events.touched[1][0]) ++through;
      stepped += events.stepped;
      not_finite += !is_finite(*world);
    }
  }
  // A robot that a ball of 98 m/s throws at the wall has 280 impacts in 44 ms, more than the event
  // budget follows.
  const double ticks = 3.0 * shots;
  const std::string scene = "shots, 0.1 to 100 m/s, ticks 1 to 100 ms";
  return {{scene, "went through or did not touch", static_cast<double>(through), 0.0},
          {scene, "deepest overlap at the end of a tick, m", deepest, 1e-9},
          {scene, "deepest overlap within a tick, m", deepest_own, 1e-9},
          {scene, "share of ticks with small steps", stepped / ticks, 1e-6},
          {scene, "ticks with numbers that are not finite", static_cast<double>(not_finite), 0.0}};
}

}  // namespace mirocup::scenes
