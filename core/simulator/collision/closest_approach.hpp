// SPDX-License-Identifier: MIT
//
// Closest approach: lower bounds of the time at which two bodies can touch, from the bounds of
// their motions alone. No series is needed. Uses geometry and trajectory only.
#pragma once

#include "core/geometry/separation.hpp"
#include "core/simulator/trajectory/motion_bound.hpp"

namespace mirocup::simulator::collision {

// Two bodies, their motion bounds, and a time span in which both bounds hold. A wall has the
// default motion bound, which stays at the origin.
struct ApproachQuery {
  trajectory::MotionBound a, b;
  double reach;       // m: outlines cannot touch if the reference points are farther apart
  double begin, end;  // s of the tick
};

// True if from `begin` to `end` the reference points stay farther apart than the reach.
bool stays_out_of_reach(const ApproachQuery& query);

// Returns a time, s of the tick, before which the gap cannot fall to `margin`, m; trajectory::never
// if it cannot fall so low until `end`. `separation` is that of the outlines at query.begin;
// radius_a and radius_b, m, are those of circles around the reference points that hold the
// outlines.
double earliest_contact_time(const ApproachQuery& query, const geometry::Separation& separation,
                             double radius_a, double radius_b, double margin);

}  // namespace mirocup::simulator::collision
