// SPDX-License-Identifier: MIT
//
// Ctrl-C and the end of a job, as a question that is asked between two ticks.
#pragma once

namespace mirocup::app {

class Interrupt {
 public:
  // From here on SIGINT and SIGTERM wait until they are asked for. Made before any thread.
  Interrupt();

  bool is_asked_for();

 private:
  bool asked_ = false;
};

}  // namespace mirocup::app
