// SPDX-License-Identifier: MIT
//
// Writing HTML so that no text can become markup: every text passes through record::escaped().
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mirocup::league {

class Html {
 public:
  void begin_page(std::string_view title);
  void end_page();

  void open(std::string_view tag);
  void close(std::string_view tag);

  // <tag>text</tag>
  void cell(std::string_view tag, std::string_view text);

  // A table cell with a link.
  void link_cell(std::string_view target, std::string_view text);

  // A table row of cells: "th" or "td".
  void row(std::string_view tag, const std::vector<std::string>& cells);

  // What another Html wrote.
  void raw(std::string_view html) { text_ += html; }

  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace mirocup::league
