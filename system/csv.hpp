// SPDX-License-Identifier: MIT
//
// Comma-separated values (RFC 4180).
#pragma once

#include <string>
#include <vector>

namespace mirocup::system {

// Returns one line of comma-separated values, with its line end. The cells are escaped by
// printable().
std::string csv_line(const std::vector<std::string>& cells);

}  // namespace mirocup::system
