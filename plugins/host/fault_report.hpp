// SPDX-License-Identifier: MIT
//
// In the team's process: what a deadly signal leaves behind for the server.
#pragma once

#include "plugins/host/mailbox.hpp"

namespace mirocup::plugins {

// Writes the signal, or the forbidden system call, into the page and ends the process with
// exit_faulted. Runs on a stack of its own, so that a stack that is full can be told, too.
// `page` outlives the process's other code. False: errno says why.
bool report_faults_to(CommandPage& page);

}  // namespace mirocup::plugins
