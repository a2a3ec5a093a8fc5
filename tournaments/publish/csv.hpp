// SPDX-License-Identifier: MIT
//
// Lines of comma-separated values (RFC 4180).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mirocup::league {

// Returns the cells as a line with its end. Cells of strangers are made printable.
std::string csv_line(const std::vector<std::string>& cells);

// Returns the cells of a line without its end.
std::vector<std::string> csv_cells(std::string_view line);

}  // namespace mirocup::league
