// SPDX-License-Identifier: MIT
#include "tournaments/handin/desk_html.hpp"
#include "tournaments/handin/team_desk_page.hpp"

namespace mirocup::league {

namespace {

void checks_table(Html& html, const Json& checks) {
  html.open_table();
  for (const Json& check : checks) {
    const Json passed = check.value("passed", Json());
    const std::string word = !passed.is_boolean() ? "not reached" : passed == true ? "ok" : "no";
    html.row("td", {{word, word == "no"   ? "refused"
                           : word == "ok" ? "accepted"
                                          : "small"},
                    text_in(check, "name"),
                    {text_in(check, "text"), "words"}});
  }
  html.close_table();
}

void timing_table(Html& html, const Json& entry) {
  const Json timing = entry.value("timing", Json::object());
  constexpr double bytes_in_mib = 1 << 20;
  const double memory = entry.value("peak_memory_bytes", 0.0) / bytes_in_mib;
  html.open_table();
  html.row("td", {"Slowest tick", number_text(timing, "slowest_tick_ms", "%.2f ms")});
  html.row("td", {"Mean tick", number_text(timing, "mean_tick_ms", "%.3f ms")});
  html.row("td", {"Start", number_text(timing, "start_ms", "%.1f ms")});
  html.row("td", {"Memory", number_text({{"memory", memory}}, "memory", "%.0f MiB")});
  html.close_table();
}

}  // namespace

std::string entry_page(const Json& entry, const TimeInWords& time_in_words) {
  const std::string number = number_text(entry, "entry", "%.0f");
  Html html;
  html.raw("<p>");
  html.link("/hand-in", "All entries of " + text_in(entry, "team"));
  html.raw("</p>\n");
  const std::string state = text_in(entry, "state");
  const std::string message = text_in(entry, "message");
  html.raw("<p class=\"verdict " + state + "\">");
  html.cell("strong", state);
  html.raw("</p>\n");
  html.cell("p", message.empty() ? text_in(entry, "reason") : message);
  html.raw("<p class=\"small\">");
  html.cell("span", text_in(entry, "file") + ", " + time_in_words(text_in(entry, "handed_in")) +
                        ", SHA-256 " + text_in(entry, "sha256"));
  html.raw("</p>\n");
  if (const std::string replay = text_in(entry, "replay"); !replay.empty()) {
    html.raw("<p>");
    html.link(replay, "Replay of its leg against striker");
    html.raw("</p>\n");
  }
  if (entry.contains("checks")) {
    next_card(html, "Checks");
    checks_table(html, entry["checks"]);
    html.open("ul");
    for (const Json& note : entry.value("notes", Json::array()))
      html.cell("li", text_in(note, "text"));
    html.close("ul");
  }
  if (entry.contains("timing")) {
    next_card(html, "Processor time and memory");
    timing_table(html, entry);
  }
  if (const std::string log = text_in(entry, "log"); !log.empty()) {
    next_card(html, "Log: its first and last lines");
    html.raw("<div class=\"scroll\">");
    html.cell("pre", log);
    html.raw("</div>\n");
  }
  return desk_page("Entry " + number, html);
}

}  // namespace mirocup::league
