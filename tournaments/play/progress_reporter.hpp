// SPDX-License-Identifier: MIT
//
// What a person sees of a league that is being played.
#pragma once

#include <string>

namespace mirocup::league {

class ProgressReporter {
 public:
  virtual ~ProgressReporter() = default;

  // Something happened that is worth a line.
  virtual void say(const std::string& line) = 0;

  // So many legs of so many are decided, so many are being played.
  virtual void update(int decided, int legs, int playing) = 0;
};

}  // namespace mirocup::league
