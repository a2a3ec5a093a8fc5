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
// Requires a persistent contact of a corner or the ball on a wall or robot edge, with no corner
// beyond the edge's line (which happens for corner-corner contacts).
bool is_separating_edge(const StaticWorld& world, const Contact& contact);

// Returns the first time, s of the tick, at which another corner of the point's side reaches the
// contact's edge; trajectory::never if none does before the segments end. A corner that is on the
// edge at the start counts once it has come closer by `penetration`, m. The segments of the pair
// begin together. `others` says that another contact of the pair persists, too: then the bodies
// cannot turn against each other, and the result is never.
double next_corner_contact(const StaticWorld& world, const Contact& contact, bool others,
                           std::span<const trajectory::Segment> segments, double penetration);

// Returns next_corner_contact() of a pair from all contacts of its island; nothing if none of them
// has a separating edge, so that the time must be found by contact_time().
std::optional<double> next_contact_time(const StaticWorld& world, const Pair& pair,
                                        std::span<const Contact> contacts,
                                        std::span<const trajectory::Segment> segments,
                                        double penetration);

}  // namespace mirocup::simulator::collision
