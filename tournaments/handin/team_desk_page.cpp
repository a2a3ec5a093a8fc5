// SPDX-License-Identifier: MIT
#include "tournaments/handin/team_desk_page.hpp"

#include "system/markup.hpp"
#include "tournaments/publish/html.hpp"
#include "tournaments/publish/page_values.hpp"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <vector>

namespace mirocup::league {

namespace {

constexpr std::string_view log_in_form =
    R"(<form method="post" action="/hand-in/log-in">
<p><label for="token">Token of your team</label></p>
<p><input id="token" name="token" type="password" autocomplete="current-password" required
size="30" autofocus> <button>Log in</button></p>
</form>
<p class="small">Your lecturer gives each team its token: 26 letters and digits. You stay logged in
for 12 hours, or until you log out.</p>
)";

constexpr std::string_view log_out_form =
    R"(<form method="post" action="/hand-in/log-out"><p><button>Log out</button></p></form>
)";

// Shown by the script, without which it would do nothing.
constexpr std::string_view hand_in_form =
    R"(<form id="hand-in" hidden>
<p><label for="file">Your library (team.so) or its source (team.cpp)</label></p>
<p><input id="file" type="file" required> <button>Hand in</button></p>
<p><progress id="sent" max="1" value="0" hidden></progress></p>
</form>
<p id="answer" role="status" aria-live="polite"></p>
<div class="scroll"><pre id="log" hidden></pre></div>
<noscript><p>The form needs JavaScript. From a terminal: <code>curl -T team.so -H "Authorization:
Bearer TOKEN" ADDRESS/api/v1/entries</code></p></noscript>
)";

constexpr std::string_view script = R"(<script type="module" src="/hand_in.js"></script>
)";

std::string text_in(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

// Returns the answer to an entry in a sentence.
std::string answer_in_words(const Json& entry) {
  const std::string message = text_in(entry, "message");
  if (!message.empty()) return message;
  return text_in(entry, "reason");
}

void entries_table(Html& html, const Json& entries) {
  html.open_table();
  html.row("th", {"Entry", "Handed in (UTC)", "File", "State", "Answer"});
  for (const Json& entry : entries) {
    html.raw("<tr id=\"entry-" + std::to_string(entry.value("entry", 0)) + "\">\n");
    html.cell_of("number", std::to_string(entry.value("entry", 0)));
    std::string at = text_in(entry, "handed_in");
    if (const std::size_t t = at.find('T'); t != std::string::npos) at.replace(t, 1, " ");
    if (at.ends_with('Z')) at.pop_back();
    html.cell("td", at);
    html.cell("td", text_in(entry, "file"));
    html.cell_of(text_in(entry, "state"), text_in(entry, "state"));
    html.cell_of("small", answer_in_words(entry));
    html.close("tr");
  }
  html.close_table();
}

std::string number_text(const Json& object, const char* key, const char* format) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number()) return "";
  char text[32];
  std::snprintf(text, sizeof text, format, found->get<double>());
  return text;
}

// The slowest ticks of the legs, so that a team sees how near it comes to its limits.
void processor_time(Html& html, const Json& legs) {
  struct Column {
    const char* name;
    double up_to;  // ms
  };
  constexpr Column columns[] = {{"up to 0.1 ms", 0.1}, {"0.3 ms", 0.3}, {"1 ms", 1.0},
                                {"3 ms", 3.0},         {"10 ms", 10.0}, {"more", 1e300}};
  std::vector<std::string> head;
  std::vector<std::string> counts;
  for (const Column& column : columns) {
    const double above = head.empty() ? -1.0 : columns[head.size() - 1].up_to;
    int count = 0;
    for (const Json& leg : legs) {
      const double slowest = leg.value("slowest_tick_ms", -1.0);
      if (slowest > above && slowest <= column.up_to && slowest >= 0.0) ++count;
    }
    head.emplace_back(column.name);
    counts.push_back(std::to_string(count));
  }
  html.cell("h3", "Legs by their slowest tick");
  html.open_table();
  html.row("th", head);
  html.row("td", counts);
  html.close_table();
}

void legs_table(Html& html, const Json& legs) {
  html.open_table();
  html.row("th", {"Fixture", "Leg", "Opponent", "", "", "Processor time, s", "of",
                  "Slowest tick, ms", "Own fault", "", ""});
  for (const Json& leg : legs) {
    const std::string result = text_in(leg, "result");
    html.open("tr");
    html.cell("td", text_in(leg, "fixture"));
    html.cell_of("number", std::to_string(leg.value("leg", 0)));
    html.cell("td", text_in(leg, "opponent"));
    html.cell("td", std::to_string(leg.value("goals", 0)) + " : " +
                        std::to_string(leg.value("against", 0)));
    html.cell_of(result, result);
    html.cell_of("number", number_text(leg, "cpu_seconds", "%.2f"));
    html.cell_of("number", number_text(leg, "bank_seconds", "%.2f"));
    html.cell_of("number", number_text(leg, "slowest_tick_ms", "%.2f"));
    html.cell_of("small", text_in(leg, "fault"));
    if (leg.contains("replay")) {
      html.link_cell(text_in(leg, "replay"), "replay");
      html.link_cell(text_in(leg, "log"), "own log");
    } else {
      html.cell("td", "");
      html.cell("td", "");
    }
    html.close("tr");
  }
  html.close_table();
}

// The page around the content, in the design of all pages.
std::string desk_page(const std::string& title, const Html& content) {
  return filled_page("desk.html",
                     {{"root", "/"}, {"page_title", title}, {"content", content.text()}});
}

}  // namespace

std::string log_in_page(const std::string& why) {
  Html html;
  if (!why.empty()) {
    html.raw("<p role=\"alert\">" + system::html_escaped(why) + "</p>\n");
  }
  html.raw(log_in_form);
  return desk_page("Hand in", html);
}

std::string team_desk_page(const std::string& team, const Json& entries, const Json& legs) {
  Html html;
  html.raw(log_out_form);
  html.cell("h2", "Hand in");
  html.raw(hand_in_form);
  html.cell("h2", "Entries");
  html.raw("<div id=\"entries\">\n");
  if (entries.empty()) {
    html.cell("p", "Nothing was handed in yet.");
  } else {
    entries_table(html, entries);
  }
  html.raw("</div>\n");
  if (!legs.empty()) {
    html.cell("h2", "Own legs");
    processor_time(html, legs);
    legs_table(html, legs);
  }
  html.raw(script);
  return desk_page(team, html);
}

}  // namespace mirocup::league
