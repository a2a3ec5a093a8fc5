// SPDX-License-Identifier: MIT
//
// When two moving outlines first touch.
//
// Method: at a time when they are apart, an edge of one separates them, or the ball is nearest to a
// corner. Seen from the body with that edge, the distance of each corner of the other one is a
// power series; until the first of them has fallen to zero nothing can touch. At that time either
// another edge still separates the two, and the search goes on with it, or this is the first touch.
// Nothing is ever skipped, whatever the speed or the length of the tick.
#pragma once

#include "core/field/field.hpp"
#include "core/geometry/outline.hpp"
#include "core/simulator/trajectory/segment.hpp"

namespace mirocup::simulator::collision {

// A body on its way: its outline and its segment.
struct MovingOutline {
  const geometry::Outline& shape;
  const trajectory::Segment& segment;
};

// The first t in [begin, end] at which the gap has fallen to `level` (0, or negative for two that
// touch already), or never. Both segments hold over [begin, end]; a circle comes first.
double time_of_impact(const MovingOutline& a, const MovingOutline& b, double level, double begin,
                      double end);
double time_of_impact(const MovingOutline& a, const field::Wall& wall, double level, double begin,
                      double end);

// The same to level 0; where they touch at the begin already, or are about to, until they have come
// closer than then by `sink`, m.
double time_of_impact_or_penetration(const MovingOutline& a, const MovingOutline& b, double sink,
                                     double begin, double end);
double time_of_impact_or_penetration(const MovingOutline& a, const field::Wall& wall, double sink,
                                     double begin, double end);

}  // namespace mirocup::simulator::collision
