// SPDX-License-Identifier: MIT
//
// In the team's process: tells the server which signal ended the process.
#pragma once

#include "plugins/host/mailbox.hpp"

namespace mirocup::plugins {

// Installs handlers of the deadly signals. A handler writes the signal, or the number of the
// forbidden system call, into the page and ends the process with exit_faulted. A signal from
// another process is ignored, because it is not a fault of the team. The handlers run on a separate
// stack, so that they can also report a stack overflow. After the signal a handler writes, if
// possible, the trace of the calls in the library that was loaded from `library`. After the
// installation this function unblocks all signals, which the server blocked when it started the
// process. `page`, `library` and `lent`, which the team can only read, must stay until the process
// ends. Returns false on failure; errno says why.
bool report_faults_to(CommandPage& page, const char* library, const ObservationPage* lent);

}  // namespace mirocup::plugins
