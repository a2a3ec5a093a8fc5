// SPDX-License-Identifier: MIT
//
// Values as browsers send them in a query or a form (application/x-www-form-urlencoded).
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace mirocup::web {

// Returns the text with its percent signs decoded, and pluses as spaces if `plus_is_space`. A
// percent sign before anything but two hexadecimal digits stays as it is.
std::string decoded(std::string_view coded, bool plus_is_space);

// Adds the keys and values of "key=value&key=value", decoded.
void add_form_values(std::string_view form, std::multimap<std::string, std::string>& values);

}  // namespace mirocup::web
