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

// The deviation of p(t) from its chord over [0, length]. With s = t / length, term k of p deviates
// from its own chord by p[k] length^k (s - s^k), where s - s^2 <= 1/4 and s - s^k < 1. Position and
// deviation are divided by `length` up to the last line.
Chord chord_of(const Series& p, double length) {
  double velocity = p[1];
  double power = 1.0;
  double max_deviation = 0.0;
  with_terms(p.terms, [&](auto n) {
    for (int k = 2; k < n; ++k) {
      power *= length;
      const double change = p[k] * power;
      velocity += change;
      max_deviation += std::abs(change) * (k == 2 ? 0.25 : 1.0);
    }
  });
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
          .max_deviation =
              x.max_deviation + y.max_deviation + settings::motion_bound.position_round_off,
          .max_omega = std::max(std::abs(s.omega[0] + turn.low), std::abs(s.omega[0] + turn.high))};
}

Box box_around(const MotionBound& bound, double span) {
  const Vec2 to = bound.at(bound.begin + span);
  return {std::min(bound.from.x(), to.x()) - bound.max_deviation,
          std::max(bound.from.x(), to.x()) + bound.max_deviation,
          std::min(bound.from.y(), to.y()) - bound.max_deviation,
          std::max(bound.from.y(), to.y()) + bound.max_deviation};
}

}  // namespace mirocup::simulator::trajectory
