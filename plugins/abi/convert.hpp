// SPDX-License-Identifier: MIT
//
// Conversions between the match's structures and those of strategy.h: the only file that knows both
// kinds. Both have the same frames and units.
#pragma once

#include "core/match/controller.hpp"
#include "mirocup/strategy.h"

namespace mirocup::abi {

// Leaves the functions and the handle of the host null: the program that runs the team sets them.
mirocup_setup to_setup(const match::Briefing& briefing);
mirocup_observation to_observation(const match::Observation& observation);
match::Command to_command(const mirocup_command& command);
match::PlacementRequest to_poses(const mirocup_placement& placement);

}  // namespace mirocup::abi
