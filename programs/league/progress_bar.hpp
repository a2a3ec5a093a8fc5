// SPDX-License-Identifier: MIT
//
// Progress on standard error: on a terminal a bar with the remaining time, elsewhere plain lines.
#pragma once

#include "tournaments/play/progress_reporter.hpp"

#include <memory>

namespace mirocup::league {

// Returns a reporter that fits standard error: a bar or plain lines.
std::unique_ptr<ProgressReporter> make_progress_reporter();

}  // namespace mirocup::league
