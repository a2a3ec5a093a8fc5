// SPDX-License-Identifier: MIT
//
// The end of a program that has printed its answer: a full disk must not look like success.
#pragma once

namespace mirocup::system {

// Flushes standard output. Returns `code`. If `code` is 0 and the output could not be written,
// prints a sentence on standard error and returns 3. A reader that has gone (`| head`) and a closed
// output are not errors.
int after_standard_output(int code);

}  // namespace mirocup::system
