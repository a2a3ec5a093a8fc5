// SPDX-License-Identifier: MIT
//
// Progress on standard error: on a terminal a bar with the remaining time, elsewhere plain lines.
#pragma once

#include "tournaments/play/progress_reporter.hpp"

#include <memory>

namespace mirocup::league {

std::unique_ptr<ProgressReporter> make_progress_reporter();

// "[######......]  37 of 100 legs, 2 playing, 4 min left": `width` characters of bar.
// `seconds` have gone since `first` legs were decided.
std::string bar_text(int first, int decided, int legs, int playing, double seconds, int width);

}  // namespace mirocup::league
