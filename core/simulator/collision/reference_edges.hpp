// SPDX-License-Identifier: MIT
//
// Reference edges: over which edge two robots, or a robot and an end wall, came to overlap within a
// time step.
//
// At the end of a step without contact forces two bodies may overlap deeper than the distance to
// the nearest corner. The edge of least penetration there need not be the one that was crossed, and
// correcting along it would push a body past the corner, however short the step. The last
// separating edge is used instead: temporal coherence of the separating axis. Uses model and
// solver.
#pragma once

#include "core/simulator/collision/collision_queries.hpp"

#include <span>

namespace mirocup::simulator::collision {

// Replaces contacts of pairs that crossed another edge than the one their contacts have: by both
// corners of the incident edge, over the line of the edge that was crossed. The contacts in the
// list are those of the bodies at `end`; at `begin` the same bodies did not overlap. Both spans
// hold all bodies. Afterwards all contacts of a pair still follow each other.
void use_reference_edges(const StaticWorld& world, std::span<const BodyState> begin,
                         std::span<const BodyState> end, ContactList& list);

}  // namespace mirocup::simulator::collision
