// SPDX-License-Identifier: MIT
//
// Values in a query or a form of a browser (application/x-www-form-urlencoded).
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace mirocup::web {

// Returns the text with its percent signs decoded, and pluses as spaces if `plus_is_space`. A
// percent sign without two hexadecimal digits after it stays unchanged.
std::string decoded(std::string_view coded, bool plus_is_space);

// Adds the keys and values of "key=value&key=value", decoded.
void add_form_values(std::string_view form, std::multimap<std::string, std::string>& values);

}  // namespace mirocup::web
