// SPDX-License-Identifier: MIT
//
// Motion bounds: where a body can be on its trajectory, in a few numbers. A bound is a point that
// moves along the chord of the curve, the largest distance of the curve from that point, and the
// largest turn rate. Bounds rule out most pairs of bodies before any series is computed.
#pragma once

#include "core/simulator/trajectory/segment.hpp"

namespace mirocup::simulator::trajectory {

// The bound of one motion. At time t, in s of the tick, the body's reference point is within
// max_deviation of at(t).
struct MotionBound {
  double begin = 0.0;          // s of the tick
  Vec2 from{0.0, 0.0};         // m: the reference point at `begin`
  Vec2 velocity{0.0, 0.0};     // m/s: of the point that moves along the chord
  double max_deviation = 0.0;  // m
  double max_omega = 0.0;      // rad/s: upper bound of the turn rate's size

  Vec2 at(double t) const { return from + (t - begin) * velocity; }
};

// Returns the bound of a segment.
MotionBound bound_of_segment(const Segment& segment);

// Returns the bound of a point that goes from one place to another within `span` seconds and whose
// acceleration is never more than `acceleration`, m/s^2. Such a curve leaves its chord by at most
// acceleration * span^2 / 8.
inline MotionBound bound_between(const Vec2& from, const Vec2& to, double begin, double span,
                                 double acceleration, double max_omega) {
  return {
      .begin = begin,
      .from = from,
      .velocity = span > 0.0 ? Vec2{(to - from) / span} : Vec2{0.0, 0.0},
      .max_deviation = acceleration * span * span / 8.0 + settings::motion_bound.position_round_off,
      .max_omega = max_omega};
}

// Returns a box that holds the reference point for `span` seconds from bound.begin.
Box box_around(const MotionBound& bound, double span);

}  // namespace mirocup::simulator::trajectory
