// SPDX-License-Identifier: MIT
//
// Puts positions right: what rounding and small steps leave of gaps and overlaps is taken away by
// moving bodies as little as their masses allow. Velocities stay.
#pragma once

#include "core/simulator/collision/contact_constraint.hpp"
#include "core/simulator/solver/regularized_qp.hpp"

#include <span>

namespace mirocup::simulator::impact {

// How a body is moved, in its own frame: m, m, rad.
using Displacement = Twist;

// What an impulse of that amount would do to velocities, done to positions: adds to the shifts of
// both bodies. The row's gap changes by inverse_effective_mass(row, mass) times the amount, kg m.
void add_displacement(const solver::ConstraintRow& row, double amount,
                      std::span<const solver::InverseMass> mass,
                      std::span<Displacement> displacements);

BodyState displaced(const BodyState& body, const Displacement& by);

// Moves bodies apart until next to nothing is left of negative gaps, or, where contacts contradict each
// other, as far as all of them together leave room.
void project_positions(std::span<const collision::Contact> contacts,
                       std::span<const solver::InverseMass> free_mass, std::span<BodyState> bodies,
                       solver::RegularizedQp& problem);

}  // namespace mirocup::simulator::impact
