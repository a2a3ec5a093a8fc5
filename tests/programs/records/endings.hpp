// SPDX-License-Identifier: MIT
//
// A short leg of each way in which a leg can end, played by teams of the test's own.
#pragma once

#include "core/replay/recording.hpp"

namespace mirocup::test_support {

replay::Recording leg_that_ends(match::OutcomeKind end);

}  // namespace mirocup::test_support
