// SPDX-License-Identifier: MIT
#include "core/simulator/trajectory/motion_bound.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator {

namespace {

struct Straightened {
  double velocity;
  double bulge;
};

// On [0, 1], s - s^2 is at most a quarter, s - s^k below one.
Straightened straightened(const Series& p, double length) {
  double velocity = p[1];
  double power = 1.0;
  double bulge = 0.0;
  for (int k = 2; k < p.terms; ++k) {
    power *= length;
    const double change = p[k] * power;
    velocity += change;
    bulge += std::abs(change) * (k == 2 ? 0.25 : 1.0);
  }
  return {velocity, bulge * length};
}

}  // namespace

Way way_along(const Segment& s) {
  const double length = s.end - s.begin;
  const Straightened x = straightened(s.x, length);
  const Straightened y = straightened(s.y, length);
  const Range turn = change_over(s.turn, length);
  return {.begin = s.begin,
          .from = {s.x[0], s.y[0]},
          .velocity = {x.velocity, y.velocity},
          .bulge = x.bulge + y.bulge + rounding_of_ways,
          .turn_rate = std::max(std::abs(s.turn[0] + turn.low), std::abs(s.turn[0] + turn.high))};
}

Box box_around(const Way& way, double span) {
  const Vec2 to = way.at(way.begin + span);
  return {std::min(way.from.x(), to.x()) - way.bulge, std::max(way.from.x(), to.x()) + way.bulge,
          std::min(way.from.y(), to.y()) - way.bulge, std::max(way.from.y(), to.y()) + way.bulge};
}

}  // namespace mirocup::simulator
