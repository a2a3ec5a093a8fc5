// SPDX-License-Identifier: MIT
//
// Comma-separated values (RFC 4180).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mirocup::system {

// Returns one line of comma-separated values, with its line end. The cells are escaped by
// printable().
std::string csv_line(const std::vector<std::string>& cells);

// Returns the cells of a line that has no line end.
std::vector<std::string> csv_cells(std::string_view line);

}  // namespace mirocup::system
