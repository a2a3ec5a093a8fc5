// SPDX-License-Identifier: MIT
//
// Coulomb friction between bodies in an impact: an option (Parameters::contact_friction), off by
// default as in the paper.
//
// Normal impulses first act as if there were no friction. Then each contact's tangential impulse
// stops the contact's sliding, but is at most the coefficient times the normal impulse. Then
// contacts that approach again are stopped. Each of the three steps can only take energy. The ball
// rolls without slipping, so friction acts on its path and gives it no spin.
#pragma once

#include "core/simulator/impact/impact.hpp"
#include "core/simulator/solver/box_qp.hpp"

#include <span>

namespace mirocup::simulator::impact {

// Returns the row of the contact's sliding velocity: along its tangent, which is the normal turned
// to the left, instead of its normal.
solver::ConstraintRow tangent_row(const collision::Contact& contact,
                                  std::span<const BodyState> bodies);

// True if any kind of pair has a friction coefficient.
bool has_friction(const Parameters& parameters);

// Applies friction to the twists of the bodies after resolve_impacts(), which has set the contacts'
// normal impulses; adds further normal impulses itself. `problem` is scratch space.
void resolve_friction(std::span<collision::Contact> contacts,
                      std::span<const solver::InverseMass> mass, std::span<BodyState> bodies,
                      solver::BoxQp& problem);

}  // namespace mirocup::simulator::impact
