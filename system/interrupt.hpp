// SPDX-License-Identifier: MIT
//
// SIGINT (Ctrl-C) and SIGTERM (the end of a job), polled between two ticks.
#pragma once

namespace mirocup::system {

class Interrupt {
 public:
  // Blocks both signals from now on, in this thread and in threads that it starts later. So create
  // this object before any thread.
  Interrupt();

  // True if one of the signals has arrived since the construction. Until a signal has arrived, each
  // call makes a system call.
  bool is_asked_for();

 private:
  bool asked_ = false;
};

}  // namespace mirocup::system
