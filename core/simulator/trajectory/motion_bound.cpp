// SPDX-License-Identifier: MIT
#include "core/simulator/trajectory/motion_bound.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator::trajectory {

namespace {

struct Chord {
  double velocity;
  double max_deviation;
};

// On [0, 1], s - s^2 is at most a quarter, s - s^k below one.
Chord chord_of(const Series& p, double length) {
  double velocity = p[1];
  double power = 1.0;
  double max_deviation = 0.0;
  for (int k = 2; k < p.terms; ++k) {
    power *= length;
    const double change = p[k] * power;
    velocity += change;
    max_deviation += std::abs(change) * (k == 2 ? 0.25 : 1.0);
  }
  return {velocity, max_deviation * length};
}

}  // namespace

MotionBound bound_of_segment(const Segment& s) {
  const double length = s.end - s.begin;
  const Chord x = chord_of(s.x, length);
  const Chord y = chord_of(s.y, length);
  const Range turn = change_over(s.omega, length);
  return {.begin = s.begin,
          .from = {s.x[0], s.y[0]},
          .velocity = {x.velocity, y.velocity},
          .max_deviation = x.max_deviation + y.max_deviation + position_round_off,
          .max_omega = std::max(std::abs(s.omega[0] + turn.low), std::abs(s.omega[0] + turn.high))};
}

Box box_around(const MotionBound& way, double span) {
  const Vec2 to = way.at(way.begin + span);
  return {std::min(way.from.x(), to.x()) - way.max_deviation,
          std::max(way.from.x(), to.x()) + way.max_deviation,
          std::min(way.from.y(), to.y()) - way.max_deviation,
          std::max(way.from.y(), to.y()) + way.max_deviation};
}

}  // namespace mirocup::simulator::trajectory
