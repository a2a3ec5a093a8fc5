// SPDX-License-Identifier: MIT
#include "tournaments/handin/team_desk_page.hpp"

#include "system/text.hpp"
#include "tournaments/handin/desk_html.hpp"
#include "tournaments/handin/progress.hpp"

#include <algorithm>
#include <set>

namespace mirocup::league {

namespace {

// What is not folded of a list whose latest lines come first.
constexpr std::ptrdiff_t shown_friendlies = 10;
constexpr std::ptrdiff_t shown_legs = 20;

constexpr std::string_view log_in_form =
    R"(<form class="desk" method="post" action="/hand-in/log-in">
<p><label for="token">Token of your team</label></p>
<p><input id="token" name="token" type="password" autocomplete="current-password" required
size="30" autofocus> <button>Log in</button></p>
</form>
<p class="small">Your lecturer gives each team its token: 26 letters and digits. You stay logged in
for 12 hours, or until you log out.</p>
)";

// Shown by the script, without which it would do nothing.
constexpr std::string_view hand_in_form =
    R"(<form id="hand-in" class="desk" hidden>
<p><label for="file">Your library (team.so), its source (team.cpp), team.py, or your
project (.tar.gz, .zip)</label></p>
<p><input id="file" type="file" required> <button>Hand in</button></p>
<p><progress id="sent" max="1" value="0" hidden></progress></p>
</form>
<p id="answer" role="status" aria-live="polite"></p>
<div class="scroll"><pre id="log" hidden></pre></div>
<noscript><p>The form needs JavaScript. From a terminal: <code>curl -T team.so -H "Authorization:
Bearer TOKEN" ADDRESS/api/v1/entries</code></p></noscript>
)";

constexpr std::string_view desk_script = R"(<script type="module" src="/hand_in.js"></script>
)";

struct DeskColumn {
  const char* name;
  const char* style = "";  // "wide" and "mid" are left out on narrow windows
};

// A column without a name is headed by an empty cell, as readers of a screen expect.
void table_head(Html& html, const std::vector<DeskColumn>& columns) {
  html.raw("<tr>");
  for (const DeskColumn& column : columns) {
    const std::string style = std::string(" class=\"") + column.style + "\">";
    html.raw(*column.name == '\0'
                 ? "<td" + style + "</td>"
                 : "<th scope=\"col\"" + style + system::html_escaped(column.name) + "</th>");
  }
  html.raw("</tr>\n");
}

// Returns the answer to an entry in a sentence, without the team and the number, which are beside.
std::string answer_in_words(const Json& entry) {
  std::string message = text_in(entry, "message");
  if (message.empty()) return text_in(entry, "reason");
  const std::string before =
      text_in(entry, "team") + ": entry " + number_text(entry, "entry", "%.0f") + " ";
  if (message.starts_with(before)) message.erase(0, before.size());
  return message;
}

// What the buttons of a version do: page/hand_in.js reads data-pin.
void pin_cell(Html& html, const TeamDesk& desk, const Json& entry) {
  const int number = entry.value("entry", 0);
  html.raw("<td>");
  if (number == desk.playing) html.cell("strong", desk.is_pinned ? "pinned " : "plays ");
  if (number == desk.playing && desk.is_pinned) {
    html.raw("<button data-pin=\"latest\">unpin</button>");
  } else if (text_in(entry, "state") == "accepted") {
    html.raw("<button data-pin=\"" + std::to_string(number) + "\">pin</button>");
  }
  html.raw("</td>\n");
}

void answer_cell(Html& html, const Json& entry) {
  const Json told = entry.value("told", Json::array());
  if (told.empty()) return html.cell("td", {answer_in_words(entry), "small words"});
  html.raw("<td class=\"small words\">");
  for (const Json& line : told) html.cell("div", line.get<std::string>());
  html.raw("</td>\n");
}

void entries_table(Html& html, const TeamDesk& desk) {
  html.open_table();
  table_head(html, {{"Entry"}, {"State"}, {""}, {"Answer"}, {"File", "mid"}, {"Handed in", "mid"}});
  for (const Json& entry : desk.entries) {
    const std::string number = std::to_string(entry.value("entry", 0));
    const std::string state = text_in(entry, "state");
    html.raw("<tr id=\"entry-" + number + "\">\n");
    html.cell("td", {number, "", "/hand-in/entries/" + number});
    html.cell("td", {state, state});
    pin_cell(html, desk, entry);
    answer_cell(html, entry);
    html.cell("td", {text_in(entry, "file"), "file mid"});
    html.cell("td", {desk.time_in_words(text_in(entry, "handed_in")), "mid"});
    html.close("tr");
  }
  html.close_table();
}

// How many legs have their slowest tick in each range, so that a team sees how near it comes to its
// limits.
void processor_time(Html& html, const Json& legs) {
  struct Range {
    const char* name;
    double up_to;  // ms
  };
  constexpr Range ranges[] = {{"up to 0.1 ms", 0.1}, {"0.1 to 0.3 ms", 0.3},
                              {"0.3 to 1 ms", 1.0},  {"1 to 3 ms", 3.0},
                              {"3 to 10 ms", 10.0},  {"above 10 ms", 1e300}};
  std::vector<int> counts;
  double above = -1.0;
  for (const Range& range : ranges) {
    counts.push_back(static_cast<int>(std::count_if(legs.begin(), legs.end(), [&](const Json& leg) {
      const double slowest = leg.value("slowest_tick_ms", -1.0);
      return slowest >= 0.0 && slowest > above && slowest <= range.up_to;
    })));
    above = range.up_to;
  }
  const int most = *std::max_element(counts.begin(), counts.end());
  if (most == 0) return;
  html.cell("h3", "Number of legs by the processor time of their slowest tick");
  html.open_table();
  for (std::size_t i = 0; i < counts.size(); ++i) {
    html.open("tr");
    html.cell("td", ranges[i].name);
    html.cell("td", {std::to_string(counts[i]), "number"});
    html.raw(
        "<td><svg class=\"bar\" width=\"160\" height=\"12\" aria-hidden=\"true\"><rect width=\"" +
        std::to_string(160 * counts[i] / most) + "\" height=\"12\"/></svg></td>\n");
    html.close("tr");
  }
  html.close_table();
}

std::string score_of(const Json& leg) {
  return number_text(leg, "goals", "%.0f") + " : " + number_text(leg, "against", "%.0f");
}

// Adds the row of a leg: the cells before and after those of its cost, its replay and its log.
void leg_row(Html& html, const Json& leg, std::vector<Cell> cells, const Cell& last) {
  const std::string bank = number_text(leg, "bank_seconds", "%.1f");
  const std::string cpu = number_text(leg, "cpu_seconds", "%.2f");
  cells.emplace_back(cpu.empty() ? "" : cpu + " of " + bank, "number wide");
  cells.emplace_back(number_text(leg, "slowest_tick_ms", "%.2f"), "number mid");
  if (leg.contains("replay")) {
    const std::string log = text_in(leg, "log");
    cells.emplace_back("replay", "",
                       text_in(leg, leg.contains("thoughts") ? "thoughts" : "replay"));
    cells.emplace_back(log.empty() ? "" : "log", "", log);
  } else {
    cells.insert(cells.end(), 2, "");
  }
  cells.push_back(last);
  html.row("td", cells);
}

void legs_table(Html& html, const TeamDesk& desk, const Json& legs) {
  const bool shows_thoughts = std::any_of(legs.begin(), legs.end(),
                                          [](const Json& leg) { return leg.contains("thoughts"); });
  if (shows_thoughts) {
    html.raw(
        "<p class=\"small\">The replays here show what your team drew and printed, to you and "
        "the staff only.</p>\n");
  }
  html.open_table();
  table_head(html, {{"Fixture", "mid"},
                    {"Opponent"},
                    {"Result"},
                    {""},
                    {"Processor time, s", "wide"},
                    {"Slowest tick, ms", "mid"},
                    {""},
                    {""},
                    {"Own fault"}});
  for (const Json& leg : legs) {
    const std::string result = text_in(leg, "result");
    leg_row(html, leg,
            {{text_in(leg, "fixture") + ", leg " + number_text(leg, "leg", "%.0f"), "mid"},
             desk.shown_name(text_in(leg, "opponent")),
             score_of(leg),
             {result, result}},
            {text_in(leg, "fault"), "small words"});
  }
  html.close_table();
}

// Shows the first legs, which are the latest, and folds the others.
void latest_first(Html& html, const TeamDesk& desk, const Json& legs, std::ptrdiff_t shown,
                  void (*table)(Html&, const TeamDesk&, const Json&)) {
  const auto older = legs.begin() + std::min<std::ptrdiff_t>(shown, legs.end() - legs.begin());
  if (legs.begin() != older) table(html, desk, Json(legs.begin(), older));
  if (older == legs.end()) return;
  html.raw("<details>\n");
  html.cell("summary", "Older legs");
  table(html, desk, Json(older, legs.end()));
  html.raw("</details>\n");
}

void friendly_form(Html& html, const TeamDesk& desk) {
  html.raw(
      "<form id=\"friendly\" class=\"desk\" hidden>\n<p><label for=\"opponent\">Play a leg that "
      "does not count against</label> <select id=\"opponent\">\n");
  for (const std::string& name : desk.opponents)
    html.raw("<option value=\"" + system::html_escaped(name) + "\">" +
             system::html_escaped(desk.shown_name(name)) + "</option>\n");
  html.raw(
      "</select> <button>Play</button></p>\n</form>\n<p id=\"friendly-answer\" "
      "role=\"status\" aria-live=\"polite\"></p>\n");
}

void friendlies_table(Html& html, const TeamDesk& desk, const Json& friendlies) {
  html.open_table();
  table_head(html, {{"Entry"},
                    {"Opponent"},
                    {"Result"},
                    {"", "mid"},
                    {"Processor time, s", "wide"},
                    {"Slowest tick, ms", "mid"},
                    {""},
                    {""},
                    {"End", "mid"}});
  for (const Json& leg : friendlies) {
    const std::string state = text_in(leg, "state");
    const bool is_played = state == "played";
    const int difference = is_played ? leg.value("goals", 0) - leg.value("against", 0) : 0;
    const std::string letter = !is_played ? "" : difference > 0 ? "W" : difference < 0 ? "L" : "D";
    const std::string end = text_in(leg, "end");
    leg_row(html, leg,
            {{number_text(leg, "entry", "%.0f"), "number"},
             desk.shown_name(text_in(leg, "opponent")),
             is_played ? score_of(leg) : state,
             {letter, "mid " + letter}},
            {end == "full_time" ? "" : end, "small words mid"});
  }
  html.close_table();
}

constexpr std::size_t shown_progress = 5;  // entries

void progress_table(Html& html, const Json& progress) {
  std::set<std::string> houses;
  for (const Json& entry : progress) {
    for (const auto& met : entry["against"].items()) houses.insert(met.key());
  }
  html.open_table();
  std::vector<Cell> words{"Entry", "Rating"};
  words.insert(words.end(), houses.begin(), houses.end());
  words.insert(words.end(), {"Drills", "Fouls a leg", "Slowest tick, ms"});
  html.row("th", words);
  for (std::size_t i = 0; i < std::min(progress.size(), shown_progress); ++i) {
    const Json& entry = progress[i];
    std::vector<Cell> cells{number_text(entry, "entry", "%.0f"),
                            number_text(entry, "rating", "%+.0f") + " (" +
                                number_text(entry, "low", "%+.0f") + " to " +
                                number_text(entry, "high", "%+.0f") + ")"};
    for (const std::string& name : houses) {
      const auto met = entry["against"].find(name);
      cells.emplace_back(met == entry["against"].end() ? "" : score_of(*met));
    }
    cells.emplace_back(number_text(entry.value("drills", Json()), "score", "%.1f"));
    cells.emplace_back(number_text(entry, "fouls", "%.1f"));
    cells.emplace_back(number_text(entry, "slowest_tick_ms", "%.2f"));
    html.row("td", cells);
  }
  html.close_table();
}

// What friendlies against house teams say of the versions.
void progress_card(Html& html, const TeamDesk& desk) {
  const Json& progress = desk.progress;
  if (progress.empty()) return;
  next_card(html, "Progress");
  const std::string change = change_in_words(progress);
  if (!change.empty()) html.cell("p", change);
  progress_table(html, progress);
  html.raw(
      "<p class=\"small\">Goals in friendlies against each house team. The rating is the strength "
      "above the mean of the house teams, with its interval of 95 %; each of these legs changes "
      "it. Drills: the mean score of all drills, each tried three times with the same "
      "seeds.</p>\n");
}

void friendlies_card(Html& html, const TeamDesk& desk) {
  next_card(html, "Friendlies");
  html.raw(
      "<p class=\"small\">Each accepted entry plays one leg against each house team, and against "
      "its neighbours once there is a table. You can start ten more an hour against a team of your "
      "choice, which also sees their results and replays.</p>\n");
  if (desk.playing > 0) friendly_form(html, desk);
  html.raw("<div id=\"friendlies\">\n");
  latest_first(html, desk, desk.friendlies, shown_friendlies, friendlies_table);
  html.raw("</div>\n");
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

std::string team_desk_page(const TeamDesk& desk) {
  Html html;
  log_out_button(html);
  html.cell("h2", "Hand in");
  html.raw(hand_in_form);
  next_card(html, "Versions");
  html.raw("<div id=\"entries\">\n");
  if (desk.entries.empty()) {
    html.cell("p", "Your team has not handed in an entry yet.");
  } else {
    entries_table(html, desk);
  }
  html.raw("</div>\n");
  if (!desk.digest.empty()) {
    html.raw("</section>\n<section class=\"card\">\n");
    html.raw(desk.digest);
  }
  progress_card(html, desk);
  friendlies_card(html, desk);
  next_card(html, "Own legs");
  if (desk.legs.empty()) html.cell("p", "Your team has not played a leg of the league yet.");
  Json all = desk.legs;
  all.insert(all.end(), desk.friendlies.begin(), desk.friendlies.end());
  processor_time(html, all);
  latest_first(html, desk, desk.legs, shown_legs, legs_table);
  html.raw(desk.statistics);
  html.raw(desk_script);
  return desk_page(desk.shown_name(desk.team), html);
}

}  // namespace mirocup::league
