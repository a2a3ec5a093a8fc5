// SPDX-License-Identifier: MIT
//
// Reference edges: over which edge two robots, or a robot and an end wall, came to overlap within a
// time step.
//
// After a step without contact forces two bodies may overlap by more than the distance from their
// contact to the nearest corner. With such an overlap the edge of least penetration can be another
// edge than the one that was crossed. A correction along that other edge would push the body around
// the corner, however short the step is. So the edge that separated the pair last is used instead,
// which textbooks call temporal coherence of the separating axis. Uses model and solver.
#pragma once

#include "core/simulator/collision/collision_queries.hpp"

#include <span>

namespace mirocup::simulator::collision {

// If a pair crossed another edge than its contacts say, replaces these contacts by the two corners
// of the incident edge, measured from the line of the edge that was crossed. The contacts in the
// list are those of the bodies at `end`; at `begin` the same bodies did not overlap. Both spans
// hold all bodies. Afterwards all contacts of a pair still follow each other.
void use_reference_edges(const StaticWorld& world, std::span<const BodyState> begin,
                         std::span<const BodyState> end, ContactList& list);

}  // namespace mirocup::simulator::collision
