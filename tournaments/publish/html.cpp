// SPDX-License-Identifier: MIT
#include "tournaments/publish/html.hpp"

#include "server/record/markup.hpp"

namespace mirocup::league {

using record::escaped;

namespace {

constexpr std::string_view style = R"(
:root { color-scheme: light dark; --line: #8886; --soft: #8881; }
body { font: 16px/1.45 system-ui, sans-serif; max-width: 62rem; margin: 2rem auto; padding: 0 1rem; }
h1 { margin-bottom: 0; } h2 { margin-top: 2.2rem; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { padding: .3rem .7rem; border-bottom: 1px solid var(--line); text-align: left; }
th { font-weight: 600; } tr:nth-child(even) td { background: var(--soft); }
)";

}  // namespace

void Html::begin_page(std::string_view title) {
  text_ += "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
  text_ += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
  cell("title", title);
  text_ += "<style>";
  text_ += style;
  text_ += "</style>\n</head>\n<body>\n";
  cell("h1", title);
}

void Html::end_page() {
  text_ += "</body>\n</html>\n";
}

void Html::open(std::string_view tag) {
  text_.append("<").append(tag).append(">\n");
}

void Html::close(std::string_view tag) {
  text_.append("</").append(tag).append(">\n");
}

void Html::cell(std::string_view tag, std::string_view text) {
  text_.append("<").append(tag).append(">").append(escaped(text));
  text_.append("</").append(tag).append(">\n");
}

void Html::link_cell(std::string_view target, std::string_view text) {
  text_.append("<td><a href=\"").append(escaped(target)).append("\">").append(escaped(text));
  text_ += "</a></td>\n";
}

void Html::row(std::string_view tag, const std::vector<std::string>& cells) {
  open("tr");
  for (const std::string& text : cells) cell(tag, text);
  close("tr");
}

}  // namespace mirocup::league
