// SPDX-License-Identifier: MIT
//
// Over which edge two robots came to overlap, or a robot and an end wall.
//
// Where bodies would be at the end of a step, if nothing stopped them, two may overlap deeper than a
// corner is wide. The edge that is nearest to parting them there need not be the one over which they
// came in, and would push them past each other's corner: however short the step, to where they were
// not. So they are kept apart by the last edge that parted them on their way.
#pragma once

#include "core/simulator/collision/collision_queries.hpp"

#include <span>

namespace mirocup::simulator::collision {

// The contacts in the list are of bodies that are at `end`, and were at `begin` without overlapping. Of
// pairs that came in over another edge than their contacts have, the contacts are replaced: by both
// corners that face that edge. All contacts of a pair still follow each other.
void use_reference_edges(const StaticWorld& world, std::span<const BodyState> begin,
                         std::span<const BodyState> end, ContactList& list);

}  // namespace mirocup::simulator::collision
