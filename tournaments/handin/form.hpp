// SPDX-License-Identifier: MIT
//
// Values as browsers send them in a form (application/x-www-form-urlencoded).
#pragma once

#include <string>
#include <string_view>

namespace mirocup::league {

// Returns a key or value of a form with its percent signs and pluses decoded. A percent sign before
// anything but two hexadecimal digits stays as it is.
std::string decoded_form_text(std::string_view coded);

}  // namespace mirocup::league
