// SPDX-License-Identifier: MIT
//
// Next contact: when two bodies in resting contact touch at one more point.
//
// While a contact presses, its gap stays zero on the whole curve, so the line of its edge separates
// the two bodies until another corner reaches that line. The height of that corner above the line
// depends on the angle between the bodies alone, which makes the search much cheaper than
// time_of_impact(). Uses model, trajectory and solver.
#pragma once

#include "core/simulator/collision/collision_queries.hpp"

#include <optional>
#include <span>

namespace mirocup::simulator::collision {

// True if the contact's edge is guaranteed to separate the pair until another corner reaches it.
// That takes a persistent contact, either of the ball, or of a robot's corner on an edge of a
// half-plane wall or of a robot. No other corner of that robot may be beyond the edge's line, as
// one can be where corner meets corner.
bool is_separating_edge(const StaticWorld& world, const Contact& contact);

// Returns the first time, s of the tick, at which another corner of the point's side reaches the
// contact's edge; trajectory::never if none does before the segments end. A corner that is on the
// edge at the start counts once it has come closer by `penetration`, m. The segments of the pair
// begin together. `others` says that another contact of the pair persists, too: then the bodies
// cannot turn against each other, and the result is never.
double next_corner_contact(const StaticWorld& world, const Contact& contact, bool others,
                           std::span<const trajectory::Segment> segments, double penetration);

// Looks among the contacts of an island for one of the pair with a separating edge, and returns its
// next_corner_contact(). Nothing if there is none: then contact_time() must be used.
std::optional<double> next_contact_time(const StaticWorld& world, const Pair& pair,
                                        std::span<const Contact> contacts,
                                        std::span<const trajectory::Segment> segments,
                                        double penetration);

}  // namespace mirocup::simulator::collision
