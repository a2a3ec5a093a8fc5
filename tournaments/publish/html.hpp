// SPDX-License-Identifier: MIT
//
// Writing HTML so that no text can become markup: every text passes through system::html_escaped().
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

  // A table cell with a style class.
  void cell_of(std::string_view style, std::string_view text);

  // A link, and a link in a table cell.
  void link(std::string_view target, std::string_view text);
  void link_cell(std::string_view target, std::string_view text);

  // <tag id="...">, for links to "#id".
  void open_with_id(std::string_view tag, std::string_view id);

  // A table row of cells: "th" or "td".
  void row(std::string_view tag, const std::vector<std::string>& cells);

  // A table that scrolls if it is wider than the page.
  void open_table();
  void close_table();

  // Appends HTML that another Html object wrote, without escaping it.
  void raw(std::string_view html) { text_ += html; }

  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace mirocup::league
