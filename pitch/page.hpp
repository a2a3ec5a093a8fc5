// SPDX-License-Identifier: MIT
//
// Pages of an identification and of a validation: one file each, with its pictures in it.
#pragma once

#include "pitch/identify.hpp"
#include "pitch/validate.hpp"

#include <string>

namespace mirocup::pitch {

// `title` is text; the page escapes it.
std::string page_of(const Identified& identified, const std::string& title);
std::string page_of(const Validation& validation, const std::string& title);

// The same as text for a terminal.
std::string text_of_result(const Identified& identified);
std::string text_of_result(const Validation& validation);

}  // namespace mirocup::pitch
