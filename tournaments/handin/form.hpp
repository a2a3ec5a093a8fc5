// SPDX-License-Identifier: MIT
//
// A form that a browser sends, such as a form of the staff page or the form to log in.
#pragma once

#include "web/http/request.hpp"

#include <map>
#include <optional>
#include <string>

namespace mirocup::league {

using Form = std::multimap<std::string, std::string>;

// Reads a form of at most 4 KiB. Returns nothing if the form is longer or did not arrive whole.
std::optional<Form> read_form(const web::Body& body);

// Returns the first value of a name in the form; "" if the form lacks the name.
std::string value_of(const Form& form, const std::string& key);

}  // namespace mirocup::league
