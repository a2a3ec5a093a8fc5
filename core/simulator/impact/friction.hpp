// SPDX-License-Identifier: MIT
//
// Coulomb friction between bodies that touch: an option (Parameters::contact_friction), off by
// default as in the paper.
//
// In an impact, first the normal impulses act as if there were no friction; then each contact's
// tangential impulse stops the sliding there, but is at most the coefficient times the normal
// impulse; then whatever approaches anew is stopped. Each of the three can only take energy. The
// ball rolls without slipping whatever touches it, so friction acts on its path, not on a spin.
#pragma once

#include "core/simulator/impact/impact.hpp"
#include "core/simulator/solver/box_qp.hpp"

#include <span>

namespace mirocup::simulator::impact {

// The row of the contact's sliding velocity: along its tangent instead of its normal.
solver::ConstraintRow tangent_row(const collision::Contact& contact,
                                  std::span<const BodyState> bodies);

bool has_friction(const Parameters& parameters);

// After resolve_impacts(), which has set the impulses.
void resolve_friction(std::span<collision::Contact> contacts,
                      std::span<const solver::InverseMass> mass, std::span<BodyState> bodies,
                      solver::BoxQp& problem);

}  // namespace mirocup::simulator::impact
