// SPDX-License-Identifier: MIT
//
// Shows a person the progress of a league that is being played.
#pragma once

#include <memory>
#include <string>

namespace mirocup::league {

class ProgressReporter {
 public:
  virtual ~ProgressReporter() = default;

  // Prints a line about an event.
  virtual void say(const std::string& line) = 0;

  // Shows that `decided` of `legs` legs are decided and `playing` legs are being played.
  virtual void update(int decided, int legs, int playing) = 0;
};

// Returns a reporter that fits standard error: on a terminal one with a bar and the remaining time,
// which its destructor removes, elsewhere one with plain lines.
std::unique_ptr<ProgressReporter> make_progress_reporter();

}  // namespace mirocup::league
