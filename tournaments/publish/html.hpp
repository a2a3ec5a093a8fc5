// SPDX-License-Identifier: MIT
//
// Writes a part of a page. Text cannot become markup, because every text passes through
// system::html_escaped(). Whole pages are templates (page/).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mirocup::league {

class Html {
 public:
  void open(std::string_view tag);
  void close(std::string_view tag);

  // <tag>text</tag>
  void cell(std::string_view tag, std::string_view text);

  // Adds a table cell with a style class.
  void cell_of(std::string_view style, std::string_view text);

  // Adds a link, or a table cell with a link. If the target is "", adds the text alone.
  void link(std::string_view target, std::string_view text);
  void link_cell(std::string_view target, std::string_view text);

  // Adds a table row of cells with the tag "th" or "td". A "th" without text becomes a "td".
  void row(std::string_view tag, const std::vector<std::string>& cells);

  // Adds a table that scrolls if it is wider than the page.
  void open_table();
  void close_table();

  // Adds markup from another Html, without escaping.
  void raw(std::string_view html) { text_ += html; }

  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace mirocup::league
