// SPDX-License-Identifier: MIT
//
// Short legs, one for each kind of ending, played by scripted teams.
#pragma once

#include "core/replay/recording.hpp"

namespace mirocup::test_support {

replay::Recording leg_that_ends(match::OutcomeKind end);

}  // namespace mirocup::test_support
