// SPDX-License-Identifier: MIT
//
// Progress on standard error: on a terminal a bar with the remaining time, elsewhere plain lines.
#pragma once

#include "tournaments/play/progress_reporter.hpp"

#include <memory>

namespace mirocup::league {

// Returns a reporter that fits standard error: a bar or plain lines.
std::unique_ptr<ProgressReporter> make_progress_reporter();

// Returns "[######......]  37 of 100 legs, 2 playing, 4 min left" with a bar of `width` characters.
// The remaining time is estimated from `seconds`, the time since the moment at which `first` legs
// were decided.
std::string bar_text(int first, int decided, int legs, int playing, double seconds, int width);

}  // namespace mirocup::league
