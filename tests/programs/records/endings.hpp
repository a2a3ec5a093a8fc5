// SPDX-License-Identifier: MIT
//
// Short legs of scripted teams, one for each kind of ending.
#pragma once

#include "core/replay/recording.hpp"

namespace mirocup::test_support {

replay::Recording leg_that_ends(match::OutcomeKind end);

}  // namespace mirocup::test_support
