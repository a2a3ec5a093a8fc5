// SPDX-License-Identifier: MIT
//
// When two that press on each other touch at one more place.
//
// Where they press, their gap stays zero as long as their curves hold; so the line of that edge
// keeps separating them until another corner comes down on it. How far that corner is above the
// line depends on nothing but how the two are turned towards each other.
#pragma once

#include "core/simulator/collision/collision_queries.hpp"

#include <optional>
#include <span>

namespace mirocup::simulator::collision {

// Is `contact` one of those that this is known of: is it kept pressing, with a body on a plane wall, or
// with the ball or a robot's corner on a robot, and is no other corner beyond the line? (One can be
// where corner presses on corner: there the edges' ends are what separates the two.)
bool is_separating_edge(const StaticWorld& world, const Contact& contact);

// The first time, s of the tick, at which another corner of the contact's pair has come down on its
// line, closer by `sink` (m) if it is there already; or never until the end of their segments,
// which begin together. `others` of the same pair press, too: then nothing can turn.
double next_corner_contact(const StaticWorld& world, const Contact& contact, bool others,
                           std::span<const trajectory::Segment> segments, double sink);

// The same of all contacts of a pair; nothing if none of them is known to keep it apart.
std::optional<double> next_contact_time(const StaticWorld& world, const Pair& pair,
                                        std::span<const Contact> contacts,
                                        std::span<const trajectory::Segment> segments, double sink);

}  // namespace mirocup::simulator::collision
