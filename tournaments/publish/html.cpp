// SPDX-License-Identifier: MIT
#include "tournaments/publish/html.hpp"

#include "system/markup.hpp"

namespace mirocup::league {

using system::html_escaped;

namespace {

constexpr std::string_view style = R"(
:root { color-scheme: light dark; --line: #8886; --soft: #8881; --won: #1a7f37; --lost: #cf222e; }
@media (prefers-color-scheme: dark) { :root { --won: #57ab5a; --lost: #e5534b; } }
body { font: 16px/1.45 system-ui, sans-serif; max-width: 72rem; )"
                                   R"(margin: 2rem auto; padding: 0 1rem; }
h1 { margin-bottom: 0; } h2 { margin-top: 2.2rem; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { padding: .3rem .7rem; border-bottom: 1px solid var(--line); text-align: left; )"
                                   R"(white-space: nowrap; }
th { font-weight: 600; } tr:nth-child(even) td { background: var(--soft); }
tr:target td { background: #fc05; }
td.number { text-align: right; } td.W { color: var(--won); font-weight: 600; }
td.L { color: var(--lost); } td.small, p.small { font-size: .88rem; }
td.small { white-space: normal; min-width: 11rem; }
svg.bracket { font: 14px system-ui, sans-serif; max-width: none; }
svg.bracket rect { fill: var(--soft); stroke: var(--line); }
svg.bracket path { fill: none; stroke: var(--line); }
svg.bracket text { fill: currentColor; } svg.bracket .won { font-weight: 700; }
svg.bracket .lost { opacity: .6; } svg.bracket .goals { text-anchor: end; }
svg.bracket .round { font-weight: 600; }
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
  text_.append("<").append(tag).append(">").append(html_escaped(text));
  text_.append("</").append(tag).append(">\n");
}

void Html::cell_of(std::string_view style_class, std::string_view text) {
  text_.append("<td class=\"").append(style_class).append("\">").append(html_escaped(text));
  text_ += "</td>\n";
}

void Html::link(std::string_view target, std::string_view text) {
  text_.append("<a href=\"").append(html_escaped(target)).append("\">").append(html_escaped(text));
  text_ += "</a>\n";
}

void Html::link_cell(std::string_view target, std::string_view text) {
  text_.append("<td><a href=\"")
      .append(html_escaped(target))
      .append("\">")
      .append(html_escaped(text));
  text_ += "</a></td>\n";
}

void Html::open_with_id(std::string_view tag, std::string_view id) {
  text_.append("<").append(tag).append(" id=\"").append(html_escaped(id)).append("\">\n");
}

void Html::row(std::string_view tag, const std::vector<std::string>& cells) {
  open("tr");
  for (const std::string& text : cells) cell(tag, text);
  close("tr");
}

void Html::open_table() {
  text_ += "<div class=\"wide\">\n<table>\n";
}

void Html::close_table() {
  text_ += "</table>\n</div>\n";
}

}  // namespace mirocup::league
