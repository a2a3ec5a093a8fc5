// SPDX-License-Identifier: MIT
#include "core/simulator/collision/closest_approach.hpp"

#include "core/base/assert.hpp"

#include <algorithm>

namespace mirocup::simulator::collision {

namespace {

// Bounds how far a body can be from where the chord's velocity takes it, if it starts from its true
// place at time t. At the start of the chord the body is on it. At another time both the place at t
// and the later place can deviate from the chord.
double deviation_since(const trajectory::MotionBound& bound, double t) {
  return t == bound.begin ? bound.max_deviation : 2.0 * bound.max_deviation;
}

// Returns how long it takes to close a distance, m, at a speed, m/s.
double time_to_close(double distance, double speed) {
  if (distance <= 0.0) return 0.0;
  return speed > 0.0 ? distance / speed : trajectory::never;
}

}  // namespace

bool stays_out_of_reach(const ApproachQuery& q) {
  const Vec2 apart = q.a.at(q.begin) - q.b.at(q.begin);
  const Vec2 velocity = q.a.velocity - q.b.velocity;
  const double speed_squared = velocity.squaredNorm();
  double nearest_after = 0.0;  // s from begin, on the chords
  if (speed_squared > 0.0) {
    nearest_after = std::clamp(-apart.dot(velocity) / speed_squared, 0.0, q.end - q.begin);
  }
  const double reach = q.reach + q.a.max_deviation + q.b.max_deviation;
  return (apart + nearest_after * velocity).squaredNorm() > reach * reach;
}

// The separating normal of `begin` is kept. Along it the gap after time s is at least
//   gap - deviations - closing s - min(turning s, max_extra_reach):
// `closing` is the closing speed of the chords. While the outlines turn, each reaches farther
// towards the other, by the speed of its outermost point at most, and never beyond its radius. Each
// of the two terms of the minimum gives a time before which the margin is not reached; the later
// one counts.
double earliest_contact_time(const ApproachQuery& q, const geometry::Separation& separation,
                             double radius_a, double radius_b, double margin) {
  MIROCUP_ASSERT(q.begin <= q.end);
  const double room =
      separation.gap - margin - (deviation_since(q.a, q.begin) + deviation_since(q.b, q.begin));
  if (room <= 0.0) return q.begin;
  const double closing = -separation.normal.dot(q.a.velocity - q.b.velocity);
  const double turning = radius_a * q.a.max_omega + radius_b * q.b.max_omega;
  const double max_extra_reach = (radius_a - separation.reach_a) + (radius_b - separation.reach_b);
  const double after = std::max(time_to_close(room, closing + turning),
                                time_to_close(room - max_extra_reach, closing));
  return q.begin + after <= q.end ? q.begin + after : trajectory::never;
}

}  // namespace mirocup::simulator::collision
