// SPDX-License-Identifier: MIT
#include "core/referee/touches.hpp"

#include "core/base/assert.hpp"
#include "core/geometry/separation.hpp"

namespace mirocup::referee {

namespace {

// True if two points are at most `distance` apart: a cheap test before gaps are computed.
bool within(const Vec2& a, const Vec2& b, double distance) {
  return (a - b).squaredNorm() <= distance * distance;
}

// Returns half the diagonal of a robot.
double reach_of(const JudgedField& pitch) {
  return pitch.robot_side * std::sqrt(0.5);
}

}  // namespace

double robot_gap(const JudgedField& pitch, const Pose& a, const Pose& b, double reach) {
  if (!within(a.position, b.position, 2.0 * reach_of(pitch) + reach)) return HUGE_VAL;
  const geometry::Outline square = geometry::square(pitch.robot_side);
  return geometry::gap(square, a, square, b);
}

double ball_gap(const JudgedField& pitch, const Vec2& ball, const Pose& robot) {
  return geometry::gap(geometry::circle(pitch.ball_radius), Pose{ball, Heading{}},
                       geometry::square(pitch.robot_side), robot);
}

void set_touch(TickFacts& s, const RobotId& a, const RobotId& b) {
  MIROCUP_ASSERT(!(a == b));
  auto& sets = a.end == b.end ? s.touched_mates : s.touched_opponents;
  sets[index_of(a.end)][a.index].set(b.index);
  sets[index_of(b.end)][b.index].set(a.index);
}

void add_near_touches(const JudgedField& pitch, TickFacts& s) {
  const int n = pitch.field.robots_per_team;
  const double touch = pitch.rules.touch_m;
  const double ball_reach = reach_of(pitch) + pitch.ball_radius + touch;
  for (const End end : both_ends) {
    const auto& robots = s.robots[index_of(end)];
    for (int i = 0; i < n; ++i) {
      if (within(robots[i].position, s.ball, ball_reach) &&
          ball_gap(pitch, s.ball, robots[i]) <= touch) {
        s.touched_ball[index_of(end)].set(i);
      }
      for (int j = 0; j < i; ++j) {
        if (robot_gap(pitch, robots[i], robots[j], touch) <= touch) {
          set_touch(s, {end, i}, {end, j});
        }
      }
    }
  }
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const Pose& left = s.robots[index_of(End::left)][i];
      const Pose& right = s.robots[index_of(End::right)][j];
      if (robot_gap(pitch, left, right, touch) <= touch) {
        set_touch(s, {End::left, i}, {End::right, j});
      }
    }
  }
}

}  // namespace mirocup::referee
