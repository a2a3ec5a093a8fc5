// SPDX-License-Identifier: MIT
#include "tournaments/publish/html.hpp"

#include "system/text.hpp"

namespace mirocup::league {

using system::html_escaped;

void Html::open(std::string_view tag) {
  text_.append("<").append(tag).append(">\n");
}

void Html::close(std::string_view tag) {
  text_.append("</").append(tag).append(">\n");
}

void Html::cell(std::string_view tag, const Cell& cell) {
  if (tag == "th" && cell.text.empty()) tag = "td";
  text_.append("<").append(tag);
  if (!cell.style.empty()) text_.append(" class=\"").append(cell.style).append("\"");
  text_ += ">";
  if (cell.link.empty()) {
    text_ += html_escaped(cell.text);
  } else {
    text_.append("<a href=\"").append(html_escaped(cell.link)).append("\">");
    text_.append(html_escaped(cell.text)).append("</a>");
  }
  text_.append("</").append(tag).append(">\n");
}

void Html::link(std::string_view target, std::string_view text) {
  if (target.empty()) {
    text_ += html_escaped(text);
    return;
  }
  text_.append("<a href=\"").append(html_escaped(target)).append("\">").append(html_escaped(text));
  text_ += "</a>\n";
}

void Html::row(std::string_view tag, const std::vector<Cell>& cells) {
  open("tr");
  for (const Cell& one : cells) cell(tag, one);
  close("tr");
}

void Html::open_table() {
  text_ += "<div class=\"scroll\" tabindex=\"0\" role=\"group\">\n<table>\n";
}

void Html::close_table() {
  text_ += "</table>\n</div>\n";
}

}  // namespace mirocup::league
