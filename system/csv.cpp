// SPDX-License-Identifier: MIT
#include "system/csv.hpp"

#include "system/number_of.hpp"
#include "system/printable.hpp"

#include <algorithm>
#include <array>
#include <iconv.h>
#include <utility>

namespace mirocup::system {

namespace {

constexpr std::string_view mark = "\xef\xbb\xbf";  // with which many programs begin UTF-8

// Files that are no table begin so.
using namespace std::string_view_literals;
constexpr std::array<std::string_view, 2> workbooks{"PK\x03\x04"sv, "\xd0\xcf\x11\xe0"sv};

// Returns the encoding of text in UTF-16, in which a table begins with a mark or a letter of ASCII;
// "": it is none.
const char* utf16_of(std::string_view bytes) {
  const std::string_view begin = bytes.substr(0, 2);
  if (begin == "\xff\xfe" || begin.find('\0') == 1) return "UTF-16LE";
  return begin == "\xfe\xff" || begin.find('\0') == 0 ? "UTF-16BE" : "";
}

// Returns text of another encoding in UTF-8. Bytes that mean nothing there stay as they are, so
// that no name takes them.
std::string converted(std::string bytes, const char* encoding) {
  std::string text(3 * bytes.size(), '\0');  // no character grows more
  char* in = bytes.data();
  char* out = text.data();
  std::size_t left = bytes.size();
  std::size_t room = text.size();
  const iconv_t converter = iconv_open("UTF-8", encoding);
  while (left > 0 && iconv(converter, &in, &left, &out, &room) == static_cast<std::size_t>(-1)) {
    *out++ = *in++;
    --left;
    --room;
  }
  iconv_close(converter);
  text.resize(text.size() - room);
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
  for (const std::string_view begin : workbooks) {
    if (bytes.starts_with(begin))
      return fail(Errc::input, "line 1: it is a workbook: save the sheet as \"CSV UTF-8\"");
  }
  std::string text(bytes);
  if (const std::string utf16 = utf16_of(bytes); !utf16.empty()) {
    text = converted(text, utf16.c_str());
    if (bytes.size() % 2 != 0 || !is_utf8(text))
      return fail(Errc::input, "line 1: it is damaged text in UTF-16: save it as \"CSV UTF-8\"");
  }
  if (text.starts_with(mark)) text.erase(0, mark.size());
  CsvTable table{.rows = {}, .was_windows_1252 = !is_utf8(text)};
  if (table.was_windows_1252) text = converted(text, "WINDOWS-1252");
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
  if (is_quoted)
    return fail(Errc::input, "line " + std::to_string(row.line) +
                                 ": a quotation mark begins a cell and no other one ends it");
  end_row();
  return table;
}

}  // namespace mirocup::system
