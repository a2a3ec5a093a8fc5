// SPDX-License-Identifier: MIT
//
// The interface through which a runner reports the progress of a league to a person.
#pragma once

#include <string>

namespace mirocup::league {

class ProgressReporter {
 public:
  virtual ~ProgressReporter() = default;

  // Shows a line about an event, without a line feed at its end.
  virtual void say(const std::string& line) = 0;

  // Shows that `decided` of `legs` legs are decided and `playing` legs are in progress.
  virtual void update(int decided, int legs, int playing) = 0;
};

}  // namespace mirocup::league
