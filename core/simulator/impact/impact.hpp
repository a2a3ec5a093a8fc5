// SPDX-License-Identifier: MIT
//
// Impacts: the change of velocities at the instant of a collision.
//
// One contact follows equation (21): v_rel+ = -e v_rel-. Simultaneous impacts go beyond the paper
// and follow Smith, Kaufman, Vouga, Tamstorf and Grinspun 2012, "Reflections on simultaneous
// impact": in each round, all contacts that approach are stopped together by the smallest impulses
// that do so, and these impulses are multiplied by (1 + e); rounds are repeated until no contact
// approaches. A row of equal bodies passes the impulse on, a symmetric impact stays symmetric, and
// energy never rises.
//
// The functions change the twists in `bodies` and the ContactImpact of the contacts. `contacts` are
// those of one or more islands, `mass` holds the inverse mass of every body, and `problem` is
// scratch space whose contents don't matter. Uses collision and solver.
#pragma once

#include "core/simulator/impact/delassus.hpp"
#include "core/simulator/solver/box_qp.hpp"

#include <span>

namespace mirocup::simulator::impact {

// Resolves the impacts of all contacts, and sets their approach and impulse. Afterwards no contact
// approaches. The contacts' restitution thresholds must be set.
void resolve_impacts(std::span<collision::Contact> contacts,
                     std::span<const solver::InverseMass> mass, std::span<BodyState> bodies,
                     solver::BoxQp& problem);

// Stops all contacts that approach, together and without restitution; adds to their impulses.
void stop_approaches(std::span<collision::Contact> contacts,
                     std::span<const solver::InverseMass> mass, std::span<BodyState> bodies,
                     solver::BoxQp& problem);

}  // namespace mirocup::simulator::impact
