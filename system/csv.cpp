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

std::vector<std::string> csv_cells(std::string_view line) {
  std::vector<std::string> cells(1);
  bool is_quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (is_quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"') {
      cells.back() += line[++i];
    } else if (c == '"') {
      is_quoted = !is_quoted;
    } else if (c == ',' && !is_quoted) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

}  // namespace mirocup::system
