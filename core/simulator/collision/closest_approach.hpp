// SPDX-License-Identifier: MIT
//
// Whether and when two bodies can meet, from the bounds of their motions alone.
#pragma once

#include "core/geometry/separation.hpp"
#include "core/simulator/trajectory/motion_bound.hpp"

namespace mirocup::simulator::collision {

// Two bodies and their ways, over the times at which both hold. A wall has the default way.
struct ApproachQuery {
  trajectory::MotionBound a, b;
  double reach;       // m: farther apart than this, the reference points' bodies cannot touch
  double begin, end;  // s of the tick
};

// Do the reference points stay out of reach?
bool stays_out_of_reach(const ApproachQuery& encounter);

// Not before this (s of the tick), or never, can a gap have fallen to `margin`; the separation is
// that at the begin. radius_a and radius_b: of the circles that hold the outlines.
double earliest_contact_time(const ApproachQuery& encounter, const geometry::Separation& separation,
                             double radius_a, double radius_b, double margin);

}  // namespace mirocup::simulator::collision
