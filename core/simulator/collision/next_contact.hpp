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
// Only a persistent contact of one of two kinds gives this guarantee: the ball on an edge or
// corner, or a robot's corner on an edge of a half-plane wall or of another robot. In the second
// kind no other corner of the robot may be behind the edge's line. (Where two corners meet, another
// corner can be behind that line.)
bool is_separating_edge(const StaticWorld& world, const Contact& contact);

// Returns the first time, s of the tick, at which another corner of the point's side reaches the
// contact's edge; trajectory::never if none does before the segments end. A corner that is on the
// edge at the start counts once it has come closer by `penetration`, m. Both segments of the pair
// must begin at the same time. `others` is true if the pair has another persistent contact: then
// the bodies cannot turn against each other, and the function returns trajectory::never.
double next_corner_contact(const StaticWorld& world, const Contact& contact, bool others,
                           std::span<const trajectory::Segment> segments, double penetration);

// Searches the contacts of an island for a contact of this pair with a separating edge, and returns
// the next_corner_contact() of that contact. Returns nothing if the pair has no such contact: then
// the caller must use contact_time().
std::optional<double> next_contact_time(const StaticWorld& world, const Pair& pair,
                                        std::span<const Contact> contacts,
                                        std::span<const trajectory::Segment> segments,
                                        double penetration);

}  // namespace mirocup::simulator::collision
