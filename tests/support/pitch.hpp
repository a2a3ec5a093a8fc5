// SPDX-License-Identifier: MIT
//
// Situations for the tests of the laws: a ball and some robots, all others out of the way.
#pragma once

#include "core/referee/judged_field.hpp"
#include "core/referee/tick_facts.hpp"

#include <vector>

namespace mirocup::test_support {

struct TestPitch {
  explicit TestPitch(RobotLeague league = RobotLeague::small,
                     referee::Preset preset = referee::Preset::mirosot)
      : field(field::make_field(league)), rules(referee::make_rules(preset)) {}

  referee::JudgedField pitch() const {
    return {.field = field, .rules = rules, .ball_radius = 0.02135, .robot_side = 0.075};
  }

  field::Field field;
  referee::Rules rules;
};

// Returns a situation in which the ball lies still and the robots stand along the upper wall of
// their own half.
inline referee::TickFacts empty_situation(const field::Field& field, const Vec2& ball) {
  referee::TickFacts s;
  s.duration = 0.033;
  s.ball_before = s.ball = ball;
  for (const End end : both_ends) {
    for (int i = 0; i < field.robots_per_team; ++i) {
      const Vec2 at{-0.1 - 0.1 * i, field.half_width - 0.1};
      s.robots[index_of(end)][i] = {attack_sign(end) * at, Heading{}};
    }
  }
  return s;
}

// Returns the situation turned by 180 degrees: what happened to the left team happens to the right
// one.
inline referee::TickFacts half_turned(const referee::TickFacts& s) {
  referee::TickFacts t = s;
  t.ball_before = -s.ball_before;
  t.ball = -s.ball;
  for (const End end : both_ends) {
    const int from = index_of(opposite(end));
    const int to = index_of(end);
    for (int i = 0; i < max_robots_per_team; ++i) {
      t.robots[to][i] = {-s.robots[from][i].position, s.robots[from][i].heading.half_turned()};
      t.velocity[to][i] = -s.velocity[from][i];
      t.commanded[to][i] = -s.commanded[from][i];
    }
    t.touched_ball[to] = s.touched_ball[from];
    t.touched_opponents[to] = s.touched_opponents[from];
    t.touched_mates[to] = s.touched_mates[from];
    t.hand[to] = s.hand[from];
    t.fallen[to] = s.fallen[from];
  }
  if (s.last_touch)
    t.last_touch = referee::RobotId{opposite(s.last_touch->end), s.last_touch->index};
  return t;
}

}  // namespace mirocup::test_support
