// SPDX-License-Identifier: MIT
#include "mirocup/skills/univector_field.hpp"

#include "tests/support/skill_field.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace mirocup::strategy {
namespace {

using test_support::SkillField;

// Catches spirals about the wrong centre: the field then jumps at the edges of its strip, and a
// point that follows it passes the target sideways.
TEST(UnivectorField, LeadsAPointThroughTheTargetWithTheHeadingWanted) {
  const UnivectorField field;
  const Target target{{0.1, -0.2}, 0.7};
  const Point along{std::cos(target.heading), std::sin(target.heading)};
  const double step = 0.0005;
  for (int start = 0; start < 36; ++start) {
    const double angle = start * pi / 18.0;
    Point p = target.at + 0.6 * Point{std::cos(angle), std::sin(angle)};
    double nearest = 1.0;
    double heading_there = 0.0;
    double last = field_heading(field, p, target);
    for (double driven = 0.0; driven < 1.2; driven += step) {
      const double heading = field_heading(field, p, target);
      EXPECT_LT(std::abs(wrapped(heading - last)), 0.1) << "a jump, start " << start;
      last = heading;
      p = p + step * Point{std::cos(heading), std::sin(heading)};
      const double distance = length(p - target.at);
      if (distance > nearest && nearest < 0.012) break;  // passed: beyond, the field turns back
      if (distance < nearest) {
        nearest = distance;
        heading_there = heading;
      }
    }
    EXPECT_LT(nearest, 0.012) << start;
    EXPECT_GT(std::cos(heading_there - std::atan2(along.y, along.x)), 0.99) << start;
  }
}

// Catches a robot that slides off the field where it bends, or hunts about the line.
TEST(FollowField, BringsARobotThroughTheBallAtTheGoal) {
  int forward = 0;
  for (int start = 0; start < 12; ++start) {
    SkillField field;
    const double angle = (start + 0.3) * pi / 6.0;
    const Point from{0.1 + 0.35 * std::cos(angle), 0.35 * std::sin(angle)};
    field.put_ball({0.1, 0.0});
    field.put_robot(from, 0.4 * start);
    const Target target{{0.07, 0.0}, 0.0};
    const UnivectorField wide{.radius = 0.1};
    bool is_hit = false;
    for (int tick = 0; tick < 60 && !is_hit; ++tick) {
      field.tick(follow_field(field.setup(), field.robot(), target, 1.5, nullptr, 0, wide));
      is_hit = length(field.ball_velocity()) > 0.3;
    }
    EXPECT_TRUE(is_hit) << start;
    if (unit(field.ball_velocity()).x > 0.8) ++forward;
  }
  EXPECT_GE(forward, 11);
}

// Catches an avoidance that only brakes, or that turns to the longer side.
TEST(Around, PassesARobotThatStandsOnTheWay) {
  SkillField field;
  field.put_ball({0.0, 0.6});
  field.put_robot({-0.5, 0.01}, 0.0);
  const std::array<Obstacle, 1> obstacles{{{{-0.1, 0.0}, {0.0, 0.0}}}};
  double nearest = 1.0;
  for (int tick = 0; tick < 45; ++tick) {
    field.tick(
        follow_field(field.setup(), field.robot(), {{0.4, 0.0}, 0.0}, 1.2, obstacles.data(), 1));
    nearest = std::min(nearest, length(position(field.robot()) - obstacles[0].at));
  }
  EXPECT_GT(nearest, 0.075);
  EXPECT_GT(field.robot().x, 0.2);
}

}  // namespace
}  // namespace mirocup::strategy
