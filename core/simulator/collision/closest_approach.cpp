// SPDX-License-Identifier: MIT
#include "core/simulator/collision/closest_approach.hpp"

#include <algorithm>

namespace mirocup::simulator::collision {

namespace {

// How far a body can be from where its velocity leads it from where it is at time t.
double max_deviation_at(const trajectory::MotionBound& way, double t) {
  return t == way.begin ? way.max_deviation : 2.0 * way.max_deviation;
}

}  // namespace

bool stays_out_of_reach(const ApproachQuery& e) {
  const Vec2 apart = e.a.at(e.begin) - e.b.at(e.begin);
  const Vec2 velocity = e.a.velocity - e.b.velocity;
  const double speed_squared = velocity.squaredNorm();
  double nearest_after = 0.0;
  if (speed_squared > 0.0) {
    nearest_after = std::clamp(-apart.dot(velocity) / speed_squared, 0.0, e.end - e.begin);
  }
  const double reach = e.reach + e.a.max_deviation + e.b.max_deviation;
  return (apart + nearest_after * velocity).squaredNorm() > reach * reach;
}

// The normal stays where it is while the outlines turn: each then reaches farther towards the
// other, by the speed of its outermost point at first, and up to its radius at most.
double earliest_contact_time(const ApproachQuery& e, const geometry::Separation& separation,
                             double radius_a, double radius_b, double margin) {
  const double room =
      separation.gap - margin - (max_deviation_at(e.a, e.begin) + max_deviation_at(e.b, e.begin));
  if (room <= 0.0) return e.begin;
  const double closing = -separation.normal.dot(e.a.velocity - e.b.velocity);
  const double turning = radius_a * e.a.max_omega + radius_b * e.b.max_omega;
  const double max_extra_reach = (radius_a - separation.reach_a) + (radius_b - separation.reach_b);
  const auto time_for = [](double way, double speed) {
    if (way <= 0.0) return 0.0;
    return speed > 0.0 ? way / speed : trajectory::never;
  };
  const double after =
      std::max(time_for(room, closing + turning), time_for(room - max_extra_reach, closing));
  return e.begin + after <= e.end ? e.begin + after : trajectory::never;
}

}  // namespace mirocup::simulator::collision
