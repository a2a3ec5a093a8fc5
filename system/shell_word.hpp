// SPDX-License-Identifier: MIT
//
// Text as a word of a command of the shell.
#pragma once

#include <string>

namespace mirocup::system {

// Returns a word that a POSIX shell reads as this text: the text itself if it has only plain
// characters, otherwise the text in single quotation marks.
std::string shell_word(const std::string& text);

}  // namespace mirocup::system
