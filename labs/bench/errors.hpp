// SPDX-License-Identifier: MIT
//
// The errors of engines, measured with yardsticks that share no code with them: closed forms and
// extended precision for bodies that move alone (tests/support/exact_motion.hpp), tiny steps for
// crowds (tests/support/tiny_world.hpp).
#pragma once

#include "labs/bench/engine.hpp"

#include <array>

namespace mirocup::bench {

// Quantiles of errors in position over many moments, m.
struct Spread {
  double p50 = 0.0;
  double p90 = 0.0;
  double p99 = 0.0;
};

// A short piece of a scene, and where the yardstick puts its bodies.
struct Moment {
  Start start;
  std::vector<Commands> commands;              // of each tick
  std::array<std::vector<Vec2>, 2> positions;  // of robots, then the ball: after 1 tick, at the end
};

struct Moments {
  std::vector<Moment> all;
  // Difference of the yardstick from itself at steps of twice the length: smaller errors mean
  // nothing.
  Spread after_one, after_all;
};

inline constexpr int ticks_of_moment = 5;

// One robot and the ball, apart, on a plane.
Moments free_motion(int count);
// Six robots and the ball within 0.6 m.
Moments crowds(int count, double step);

struct MomentErrors {
  Spread one_tick;      // of the body with the largest error
  Spread five_ticks;    // the same
  Spread robots, ball;  // after five ticks
};
MomentErrors errors(const Moments& moments, const Contender& contender);

// The shares of shots that pass through a robot that stands, and through a plate of 5 mm.
inline constexpr double shot_speeds[] = {3.0, 6.0, 10.0, 30.0};  // m/s
struct Shots {
  std::array<double, 4> through_robot{};
  std::array<double, 4> through_plate{};
};
Shots shots(const Contender& contender);

}  // namespace mirocup::bench
