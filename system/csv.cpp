// SPDX-License-Identifier: MIT
#include "system/csv.hpp"

#include "system/printable.hpp"

namespace mirocup::system {

std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  bool is_first = true;
  for (const std::string& text : cells) {
    const std::string cell = printable(text);
    if (!is_first) line += ',';
    is_first = false;
    if (cell.find_first_of(",\"\r\n") == std::string::npos) {
      line += cell;
      continue;
    }
    line += '"';
    for (const char c : cell) line += c == '"' ? std::string("\"\"") : std::string(1, c);
    line += '"';
  }
  return line + "\r\n";
}

}  // namespace mirocup::system
