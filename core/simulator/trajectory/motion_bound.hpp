// SPDX-License-Identifier: MIT
//
// Where a body can be on its curve, in a few numbers: a straight way, how far the curve is from it,
// how fast the body turns. What says, long before any series, that two bodies do not meet.
#pragma once

#include "core/simulator/trajectory/segment.hpp"

namespace mirocup::simulator::trajectory {

struct MotionBound {
  double begin = 0.0;          // s of the tick
  Vec2 from{0.0, 0.0};         // m
  Vec2 velocity{0.0, 0.0};     // m/s, from the curve's begin straight to its end
  double max_deviation = 0.0;  // m: the reference point is never farther from where that leads
  double max_omega = 0.0;      // rad/s, at most

  Vec2 at(double t) const { return from + (t - begin) * velocity; }
};

// What rounding adds to a bulge, m.
inline constexpr double position_round_off = 1e-12;

// Along a segment that has its end.
MotionBound bound_of_segment(const Segment& segment);

// Of a point that goes from one place to another within `span` seconds and never gains more than
// `acceleration`, m/s^2.
inline MotionBound bound_between(const Vec2& from, const Vec2& to, double begin, double span,
                                 double acceleration, double max_omega) {
  return {.begin = begin,
          .from = from,
          .velocity = span > 0.0 ? Vec2{(to - from) / span} : Vec2{0.0, 0.0},
          .max_deviation = acceleration * span * span / 8.0 + position_round_off,
          .max_omega = max_omega};
}

// A box that holds the reference point for `span` seconds from the way's begin.
Box box_around(const MotionBound& way, double span);

}  // namespace mirocup::simulator::trajectory
