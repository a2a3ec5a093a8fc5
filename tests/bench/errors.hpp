// SPDX-License-Identifier: MIT
//
// What engines get wrong, against yardsticks that are none of them: closed forms and extended
// precision for what moves alone (tests/support/exact_motion.hpp), tiny steps for crowds
// (tests/support/tiny_world.hpp).
#pragma once

#include "tests/bench/engine.hpp"

#include <array>

namespace mirocup::bench {

// Of errors in position over many moments, m.
struct Spread {
  double p50 = 0.0;
  double p90 = 0.0;
};

// Moments of a scene with what the yardstick makes of them.
struct Moment {
  Start start;
  std::vector<Commands> commands;              // of each tick
  std::array<std::vector<Vec2>, 2> positions;  // of robots, then the ball: after 1 tick, at the end
};

struct Moments {
  std::vector<Moment> all;
  // The yardstick against itself with steps of twice the length: errors below this mean nothing.
  Spread after_one, after_all;
};

inline constexpr int ticks_of_moment = 5;

// One robot and the ball, apart, on a plane.
Moments free_motion(int count);
// Six robots and the ball within 0.6 m.
Moments crowds(int count, double step);

struct MomentErrors {
  Spread one_tick;      // of whichever body is worst
  Spread five_ticks;    // the same
  Spread robots, ball;  // after five ticks
};
MomentErrors errors(const Moments& moments, const Contender& contender);

// Shots at a robot that stands, and at a plate of 5 mm: the share that got through.
inline constexpr double shot_speeds[] = {3.0, 6.0, 10.0, 30.0};  // m/s
struct Shots {
  std::array<double, 4> through_robot{};
  std::array<double, 4> through_plate{};
};
Shots shots(const Contender& contender);

}  // namespace mirocup::bench
