// SPDX-License-Identifier: MIT
//
// Shows a person the progress of a league that is being played.
#pragma once

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

}  // namespace mirocup::league
