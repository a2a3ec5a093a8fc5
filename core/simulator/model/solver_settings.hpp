// SPDX-License-Identifier: MIT
//
// Every constant of the simulator's solvers that no caller chooses, in one table: name, unit, reason.
//
// Tolerances (tolerances.hpp) are what an accuracy level chooses. The numbers here are the same at
// every level. They were tuned on crowds of six and of twenty-two robots (build/physics_bars); a
// change of any of them changes the state hash.
#pragma once

namespace mirocup::simulator::settings {

// ---- trajectory/

// ---- solver/

// ---- collision/

// ---- impact/

// ---- resting_contact/

// ---- stepping/

// ---- world.cpp

}  // namespace mirocup::simulator::settings
