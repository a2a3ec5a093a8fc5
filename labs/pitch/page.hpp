// SPDX-License-Identifier: MIT
//
// Pages of an identification and of a validation. Each page is one file that contains its pictures.
#pragma once

#include "labs/pitch/identify.hpp"
#include "labs/pitch/validate.hpp"

#include <string>

namespace mirocup::pitch {

// Return a page. `title` is plain text; the page escapes it.
std::string page_of(const Identified& identified, const std::string& title);
std::string page_of(const Validation& validation, const std::string& title);

// Return the content of the page as text for a terminal.
std::string text_of_result(const Identified& identified);
std::string text_of_result(const Validation& validation);

}  // namespace mirocup::pitch
