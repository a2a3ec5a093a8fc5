// SPDX-License-Identifier: MIT
//
// Other engines with recordings of pitches: as a yardstick of a validation, and as a pitch.
#pragma once

#include "labs/bench/engine.hpp"
#include "labs/pitch/validate.hpp"

#include <optional>
#include <string>

namespace mirocup::bench {

// Returns the contender of an engine with so many steps in a period. `name` is box2d, chipmunk or
// ode. Nothing: there is none of that name, or this program was built without it.
std::optional<Contender> peer_engine(const std::string& name, int steps);

// Returns the engine as a yardstick, in steps of about 1 ms. Its motors have the lag of driving
// alone.
std::optional<pitch::Peer> peer_of(const std::string& name);

// The command `validate --against ENGINE [--pitch NAME|FILE] [-o PAGE] [--json] -- RECORDING…`,
// which `mirocup validate --against` runs. `words` are those behind "validate". Returns the exit
// code.
int run_validation(const std::vector<std::string>& words);

}  // namespace mirocup::bench
