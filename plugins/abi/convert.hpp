// SPDX-License-Identifier: MIT
//
// Between the match's structures and those of strategy.h. The only place that knows both.
#pragma once

#include "core/match/controller.hpp"
#include "mirocup/strategy.h"

namespace mirocup::abi {

mirocup_setup to_setup(const match::Briefing& briefing);
mirocup_observation to_observation(const match::Observation& observation);
match::Command to_command(const mirocup_command& command);
match::PlacementRequest to_poses(const mirocup_placement& placement);

}  // namespace mirocup::abi
