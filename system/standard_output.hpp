// SPDX-License-Identifier: MIT
//
// The end of a program that has printed its answer: a full disk must not look like success.
#pragma once

namespace mirocup::system {

// Writes what is left of standard output. Returns `code`, or 3 after a sentence on standard error
// if `code` is 0 and the output could not be written. A reader that has gone (`| head`) and an
// output that is closed are no errors.
int after_standard_output(int code);

}  // namespace mirocup::system
