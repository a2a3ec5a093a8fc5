// SPDX-License-Identifier: MIT
//
// Writes a part of a page. Text cannot become markup, because every text passes through
// system::html_escaped(). Whole pages are templates (page/).
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mirocup::league {

// A text in a table cell or another element.
struct Cell {
  Cell(std::string words, std::string style_class = "", std::string target = "")
      : text(std::move(words)), style(std::move(style_class)), link(std::move(target)) {}
  Cell(const char* words) : text(words) {}

  std::string text;
  std::string style;  // class; "": none
  std::string link;   // target; "": none
};

class Html {
 public:
  void open(std::string_view tag);
  void close(std::string_view tag);

  // <tag>text</tag>, with the style and the link of the cell. A "th" without text becomes a "td".
  void cell(std::string_view tag, const Cell& cell);

  // Adds a link. If the target is "", adds the text alone.
  void link(std::string_view target, std::string_view text);

  // Adds a table row of cells with the tag "th" or "td".
  void row(std::string_view tag, const std::vector<Cell>& cells);

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
