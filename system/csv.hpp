// SPDX-License-Identifier: MIT
//
// Comma-separated values (RFC 4180).
#pragma once

#include "core/base/error.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace mirocup::system {

// Returns one line of comma-separated values, with its line end. The cells are escaped by
// printable(). A cell that a spreadsheet would take for a formula gets an apostrophe in front.
std::string csv_line(const std::vector<std::string>& cells);

struct CsvRow {
  int line = 1;  // the line in which the row begins, from 1
  std::vector<std::string> cells;
};

struct CsvTable {
  std::vector<CsvRow> rows;  // without rows whose cells are all empty
  bool was_windows_1252 = false;
};

// Reads a table that a spreadsheet or a person wrote, in UTF-8 (with or without a byte order mark),
// UTF-16 or Windows-1252, with any line ends. The separator is a comma, a semicolon or a tab,
// whichever is most frequent in the first row, or the character that a line "sep=;" before the
// first row names. Blanks around a cell are dropped. Errors (Errc::input, a sentence): damaged
// UTF-16, a workbook, a quotation mark that is not closed.
Result<CsvTable> read_csv(std::string_view bytes);

}  // namespace mirocup::system
