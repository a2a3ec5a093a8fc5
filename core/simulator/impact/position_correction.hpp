// SPDX-License-Identifier: MIT
//
// Position projection: corrects the gaps and overlaps that rounding and time steps leave, by moving
// bodies as little as their masses allow. Velocities stay. (Box2D does this by non-linear
// Gauss-Seidel; here all contacts are one regularised QP.) Uses collision and solver.
#pragma once

#include "core/simulator/collision/contact_constraint.hpp"
#include "core/simulator/solver/regularized_qp.hpp"

#include <span>

namespace mirocup::simulator::impact {

// A displacement of a body in its own frame: forward and left in m, rotation in rad.
using Displacement = Twist;

// Adds M^-1 J' times an amount, kg m, to the displacements of the row's bodies: what an impulse
// does to velocities, applied to positions. To first order, the row's gap changes by
// inverse_effective_mass(row, mass) times the amount.
void add_displacement(const solver::ConstraintRow& row, double amount,
                      std::span<const solver::InverseMass> mass,
                      std::span<Displacement> displacements);

// Returns the body after a displacement. Its twist keeps its components in the body's frame.
BodyState displaced(const BodyState& body, const Displacement& by);

// Moves the bodies of the contacts so that negative gaps vanish, to first order in the
// displacement. If contacts contradict each other, they share the overlap. The contacts' points and
// rows must be those of the bodies' poses; they are not updated. `problem` is scratch space.
void project_positions(std::span<const collision::Contact> contacts,
                       std::span<const solver::InverseMass> free_mass, std::span<BodyState> bodies,
                       solver::RegularizedQp& problem);

}  // namespace mirocup::simulator::impact
