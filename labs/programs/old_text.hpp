// SPDX-License-Identifier: MIT
//
// Converts sources that were written on Windows to text for today's compilers.
#pragma once

#include <string>

namespace mirocup::labs {

// Returns the text in a form that g++ accepts. The function changes only these bytes: UTF-16
// becomes UTF-8; bytes after the end of an old file (0 and 26) are dropped; of two or more carriage
// returns at the end of a line one is left; in GBK a second byte that is a backslash becomes \134,
// so that it ends no string and joins no lines. The number of lines stays the same.
std::string readable(std::string text);

}  // namespace mirocup::labs
