// SPDX-License-Identifier: MIT
//
// Impacts: what bodies that run into each other do to their velocities in no time.
//
// One contact is equation (21): v_rel+ = -e v_rel-. Several at once go beyond the paper, after
// Smith, Kaufman, Vouga, Tamstorf and Grinspun 2012, "Reflections on simultaneous impact": all
// contacts that approach are first stopped together, then thrown back by (1 + e) times what stopped
// them, again and again until none approaches. A row of equal bodies hands the impulse through, a
// symmetric hit stays symmetric, and energy never rises.
#pragma once

#include "core/simulator/impact/delassus.hpp"
#include "core/simulator/solver/box_qp.hpp"

#include <span>

namespace mirocup::simulator::impact {

// Changes the twists of the bodies, and sets approach and impulse of the contacts.
void resolve_impacts(std::span<collision::Contact> contacts,
                     std::span<const solver::InverseMass> mass, std::span<BodyState> bodies,
                     solver::BoxQp& problem);

// Stops all contacts that approach, together and without throwing them back; adds to the impulses.
void stop_approaches(std::span<collision::Contact> contacts,
                     std::span<const solver::InverseMass> mass, std::span<BodyState> bodies,
                     solver::BoxQp& problem);

}  // namespace mirocup::simulator::impact
