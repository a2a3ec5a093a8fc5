// SPDX-License-Identifier: MIT
#include "system/csv.hpp"

#include "system/number_of.hpp"
#include "system/printable.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace mirocup::system {

namespace {

constexpr std::string_view mark = "\xef\xbb\xbf";  // with which many programs begin UTF-8

// Files that are no table, by their first bytes.
using namespace std::string_view_literals;
constexpr std::array<std::pair<std::string_view, const char*>, 4> other_files{{
    {"\xff\xfe"sv, "text in UTF-16: save it as \"CSV UTF-8\""},
    {"\xfe\xff"sv, "text in UTF-16: save it as \"CSV UTF-8\""},
    {"PK\x03\x04"sv, "a workbook: save the sheet as \"CSV UTF-8\""},
    {"\xd0\xcf\x11\xe0"sv, "a workbook: save the sheet as \"CSV UTF-8\""},
}};

// The characters of the bytes 0x80 to 0x9f; 0 where there is none.
constexpr std::array<std::uint16_t, 32> windows_1252{
    0x20ac, 0,      0x201a, 0x0192, 0x201e, 0x2026, 0x2020, 0x2021, 0x02c6, 0x2030, 0x0160,
    0x2039, 0x0152, 0,      0x017d, 0,      0,      0x2018, 0x2019, 0x201c, 0x201d, 0x2022,
    0x2013, 0x2014, 0x02dc, 0x2122, 0x0161, 0x203a, 0x0153, 0,      0x017e, 0x0178};

// Bytes that mean nothing stay as they are, so that no name takes them.
std::string from_windows_1252(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    const unsigned code = byte >= 0x80 && byte < 0xa0 ? windows_1252[byte - 0x80] : byte;
    if (code < 0x80) {
      text += c;
    } else if (code < 0x800) {
      text += {static_cast<char>(0xc0 | code >> 6), static_cast<char>(0x80 | (code & 0x3f))};
    } else {
      text += {static_cast<char>(0xe0 | code >> 12), static_cast<char>(0x80 | (code >> 6 & 0x3f)),
               static_cast<char>(0x80 | (code & 0x3f))};
    }
  }
  return text;
}

std::string without_blanks(std::string_view text) {
  constexpr std::array<std::string_view, 4> blanks{" ", "\t", "\n", "\xc2\xa0"};
  for (bool more = true; more;) {
    more = false;
    for (const std::string_view blank : blanks) {
      if (text.starts_with(blank)) {
        text.remove_prefix(blank.size());
        more = true;
      }
      if (!text.empty() && text.ends_with(blank)) {
        text.remove_suffix(blank.size());
        more = true;
      }
    }
  }
  return std::string(text);
}

// Returns the separator that the first row has most of, outside of quotation marks.
char separator_of(std::string_view text) {
  std::array<std::pair<int, char>, 3> counts{{{0, ','}, {0, ';'}, {0, '\t'}}};
  bool is_quoted = false;
  for (const char c : text) {
    if (c == '"') is_quoted = !is_quoted;
    if (is_quoted) continue;
    if (c == '\n' || c == '\r') break;
    for (auto& [count, separator] : counts) count += c == separator ? 1 : 0;
  }
  return std::max_element(counts.begin(), counts.end(),
                          [](const auto& a, const auto& b) { return a.first < b.first; })
      ->second;
}

// A number, or a dash for none, is no formula.
bool looks_like_a_formula(std::string_view cell) {
  constexpr std::string_view begins_formulas = "=+-@\t";
  if (cell.empty() || begins_formulas.find(cell[0]) == std::string_view::npos) return false;
  return cell != "-" && !number_of<double>(cell.substr(cell[0] == '+' ? 1 : 0));
}

}  // namespace

std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  bool is_first = true;
  for (const std::string& text : cells) {
    const std::string cell = (looks_like_a_formula(text) ? "'" : "") + printable(text);
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

Result<CsvTable> read_csv(std::string_view bytes) {
  for (const auto& [begin, what] : other_files) {
    if (bytes.starts_with(begin)) return fail(Errc::input, std::string("line 1: it is ") + what);
  }
  if (bytes.substr(0, 2).find('\0') != std::string_view::npos)
    return fail(Errc::input, std::string("line 1: it is ") + other_files[0].second);
  if (bytes.starts_with(mark)) bytes.remove_prefix(mark.size());
  CsvTable table{.rows = {}, .was_windows_1252 = !is_utf8(bytes)};
  const std::string text = table.was_windows_1252 ? from_windows_1252(bytes) : std::string(bytes);
  std::size_t at = 0;
  int line = 1;
  char separator = separator_of(text);
  if (constexpr std::string_view says = "sep="; text.starts_with(says)) {
    separator = text.size() > says.size() ? text[says.size()] : ',';
    at = std::min(text.find_first_of("\r\n"), text.size());
  }
  CsvRow row{.line = line, .cells = {""}};
  bool is_blank = true;  // the cell, up to here
  const auto end_cell = [&] {
    row.cells.back() = without_blanks(row.cells.back());
    is_blank = true;
  };
  const auto end_row = [&] {
    end_cell();
    const bool is_empty = std::all_of(row.cells.begin(), row.cells.end(),
                                      [](const std::string& cell) { return cell.empty(); });
    if (!is_empty) table.rows.push_back(std::move(row));
  };
  bool is_quoted = false;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    const bool ends_line = c == '\n' || c == '\r';
    if (c == '\r' && at + 1 < text.size() && text[at + 1] == '\n') ++at;
    if (ends_line) ++line;
    std::string& cell = row.cells.back();
    if (is_quoted) {
      const bool is_doubled = c == '"' && at + 1 < text.size() && text[at + 1] == '"';
      if (is_doubled) ++at;
      if (c == '"' && !is_doubled) {
        is_quoted = false;
      } else {
        cell += ends_line ? '\n' : c;
      }
    } else if (ends_line) {
      end_row();
      row = {.line = line, .cells = {""}};
    } else if (c == separator) {
      end_cell();
      row.cells.emplace_back();
    } else if (c == '"' && is_blank) {
      is_quoted = true;
    } else {
      cell += c;
    }
    // In UTF-8, each of the two last bytes is of a no-break space, or beside a byte of a letter.
    constexpr std::string_view blanks = " \t\n\xc2\xa0";
    const std::string& now = row.cells.back();
    is_blank = is_blank && (now.empty() || blanks.find(now.back()) != std::string_view::npos);
  }
  if (is_quoted) {
    return fail(Errc::input, "line " + std::to_string(row.line) +
                                 ": a quotation mark begins a cell and no other one ends it");
  }
  end_row();
  return table;
}

}  // namespace mirocup::system
