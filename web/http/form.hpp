// SPDX-License-Identifier: MIT
//
// Values in a query or a form of a browser (application/x-www-form-urlencoded).
#pragma once

#include "web/http/request.hpp"

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace mirocup::web {

// Returns the text with its percent signs decoded, and pluses as spaces if `plus_is_space`. A
// percent sign without two hexadecimal digits after it stays unchanged.
std::string decoded(std::string_view coded, bool plus_is_space);

using Form = std::multimap<std::string, std::string>;

// Adds the keys and values of "key=value&key=value", decoded.
void add_form_values(std::string_view form, Form& values);

// Reads a form of at most 4 KiB, such as the form to log in. Returns nothing if the form is longer
// or did not arrive whole.
std::optional<Form> read_form(const Body& body);

// Returns the first value of a name in the form; "" if the form lacks the name.
std::string value_of(const Form& form, const std::string& key);

}  // namespace mirocup::web
