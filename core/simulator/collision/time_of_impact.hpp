// SPDX-License-Identifier: MIT
//
// Time of impact: when two moving convex outlines first touch.
//
// Method: conservative advancement along separating axes (Mirtich 1996; b2TimeOfImpact of Box2D).
// Two outlines are apart while a line separates them: an edge of one of them or, for the ball at a
// corner, the line perpendicular to the direction from the corner to the ball. Seen from the body
// with that edge, the distance of each corner of the other body is a power series in time. Until
// the first of these series falls to zero the bodies cannot touch. At that time either another edge
// separates them, and the search continues with that edge, or they touch. No touch is ever missed,
// whatever the speed or the length of the tick.
//
// Units are m and s of the tick. Pure functions. Uses geometry and trajectory only.
#pragma once

#include "core/field/field.hpp"
#include "core/geometry/outline.hpp"
#include "core/geometry/separation.hpp"
#include "core/simulator/trajectory/segment.hpp"

#include <optional>

namespace mirocup::simulator::collision {

// An outline that moves along a segment. Outline and segment must outlive this object.
struct MovingOutline {
  const geometry::Outline& shape;
  const trajectory::Segment& segment;
};

// Returns the first time in [begin, end] at which the gap has fallen to `level`, m, or
// trajectory::never. `level` is 0 for a touch, or negative for outlines that touch already. Both
// segments hold over [begin, end]. If one outline is a circle, it is `a`.
double time_of_impact(const MovingOutline& a, const MovingOutline& b, double level, double begin,
                      double end);
double time_of_impact(const MovingOutline& a, const field::Wall& wall, double level, double begin,
                      double end);

// Returns the first time at which the gap has fallen to 0. If the gap at `begin` is already at most
// `penetration`, m, the function instead returns the first time at which the gap has fallen to
// min(gap at `begin`, 0) - `penetration`. In both cases the result is trajectory::never if
// the gap does not fall so far by `end`. `reference` is the reference edge of two polygons at
// `begin`, if it is known; a wall has none.
double time_of_impact_or_penetration(const MovingOutline& a, const MovingOutline& b,
                                     double penetration, double begin, double end,
                                     const std::optional<geometry::Reference>& reference = {});
double time_of_impact_or_penetration(const MovingOutline& a, const field::Wall& wall,
                                     double penetration, double begin, double end,
                                     const std::optional<geometry::Reference>& = {});

}  // namespace mirocup::simulator::collision
