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

void Html::cell(std::string_view tag, std::string_view text) {
  text_.append("<").append(tag).append(">").append(html_escaped(text));
  text_.append("</").append(tag).append(">\n");
}

void Html::cell_of(std::string_view style_class, std::string_view text) {
  text_.append("<td class=\"").append(style_class).append("\">").append(html_escaped(text));
  text_ += "</td>\n";
}

void Html::link(std::string_view target, std::string_view text) {
  if (target.empty()) {
    text_ += html_escaped(text);
    return;
  }
  text_.append("<a href=\"").append(html_escaped(target)).append("\">").append(html_escaped(text));
  text_ += "</a>\n";
}

void Html::link_cell(std::string_view target, std::string_view text) {
  if (target.empty()) return cell("td", text);
  text_.append("<td><a href=\"")
      .append(html_escaped(target))
      .append("\">")
      .append(html_escaped(text));
  text_ += "</a></td>\n";
}

void Html::row(std::string_view tag, const std::vector<std::string>& cells) {
  open("tr");
  for (const std::string& text : cells) cell(text.empty() ? "td" : tag, text);
  close("tr");
}

void Html::open_table() {
  text_ += "<div class=\"scroll\" tabindex=\"0\" role=\"group\">\n<table>\n";
}

void Html::close_table() {
  text_ += "</table>\n</div>\n";
}

}  // namespace mirocup::league
