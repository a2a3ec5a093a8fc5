// SPDX-License-Identifier: MIT
#include "tournaments/publish/team_page.hpp"

#include "tournaments/publish/html.hpp"
#include "tournaments/publish/replay_pages.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace mirocup::league {

namespace {

constexpr std::size_t form_length = 10;  // legs

// Wins, draws, losses, goals and own faults over some legs of a team.
struct LegTotals {
  int legs = 0;
  int won = 0;
  int drawn = 0;
  int lost = 0;
  int goals = 0;
  int against = 0;
  int faults = 0;

  void add(const LegView& leg, int team, const std::string& name) {
    ++legs;
    const char letter = leg.letter(team);
    ++(letter == 'W' ? won : letter == 'D' ? drawn : lost);
    goals += leg.goals(team);
    against += leg.goals_against(team);
    if (leg.played->fault && leg.played->fault->team == name) ++faults;
  }

  std::vector<std::string> cells(const std::string& what) const {
    char mean[48];
    std::snprintf(mean, sizeof mean, "%.2f : %.2f", double(goals) / std::max(1, legs),
                  double(against) / std::max(1, legs));
    return {what,
            std::to_string(legs),
            std::to_string(won),
            std::to_string(drawn),
            std::to_string(lost),
            std::to_string(goals) + " : " + std::to_string(against),
            mean,
            std::to_string(faults)};
  }
};

// The home team is blue in odd legs.
bool is_blue(const LegView& leg, int team) {
  return (leg.leg % 2 == 1) == (leg.home == team);
}

void results(Html& html, const Overview& o, int team) {
  LegTotals all;
  LegTotals blue;
  LegTotals yellow;
  for (const LegView& leg : o.legs) {
    if (!leg.is_of(team) || leg.played == nullptr) continue;
    all.add(leg, team, o.state.name(team));
    (is_blue(leg, team) ? blue : yellow).add(leg, team, o.state.name(team));
  }
  html.open_table();
  html.row("th", {"", "Legs", "Won", "Drawn", "Lost", "Goals", "Goals a leg", "Own faults"});
  html.row("td", all.cells("All"));
  html.row("td", blue.cells("As blue"));
  html.row("td", yellow.cells("As yellow"));
  html.close_table();
}

std::string form(const Overview& o, int team) {
  std::string letters;
  for (const LegView& leg : o.legs) {
    if (leg.is_of(team) && leg.played != nullptr) letters += leg.letter(team);
  }
  if (letters.size() > form_length) letters = letters.substr(letters.size() - form_length);
  std::string spaced;
  for (const char letter : letters) spaced += (spaced.empty() ? "" : " ") + std::string(1, letter);
  return spaced;
}

void legs(Html& html, const Overview& o, int team) {
  html.open_table();
  html.row("th", {"Fixture", "Round", "Leg", "Opponent", "", "", "How it ended", "", ""});
  for (const LegView& leg : o.legs) {
    if (!leg.is_of(team)) continue;
    const std::string& other = o.state.name(leg.home == team ? leg.away : leg.home);
    html.open("tr");
    html.cell("td", leg.fixture);
    html.cell("td", leg.round);
    html.cell("td", std::to_string(leg.leg));
    html.link_cell("../" + team_page_of(other), other);
    if (leg.played == nullptr) {
      for (int i = 0; i < 5; ++i) html.cell("td", "");
    } else {
      html.cell("td",
                std::to_string(leg.goals(team)) + " : " + std::to_string(leg.goals_against(team)));
      html.cell_of(std::string(1, leg.letter(team)), std::string(1, leg.letter(team)));
      html.cell_of("small", end_in_words(o.state, *leg.played));
      if (leg.played->record.empty()) {
        html.cell("td", "");
        html.cell("td", "");
      } else {
        html.link_cell("../" + replay_page_of(leg.played->record), "replay");
        html.link_cell("../../" + leg.played->record, "record");
      }
    }
    html.close("tr");
  }
  html.close_table();
}

void own_faults(Html& html, const Overview& o, int team) {
  bool any = false;
  for (const LegView& leg : o.legs) {
    if (!leg.is_of(team) || leg.played == nullptr || !leg.played->fault) continue;
    if (leg.played->fault->team != o.state.name(team)) continue;
    if (!any) {
      html.cell("h2", "Faults");
      html.open("ul");
    }
    any = true;
    html.cell("li", leg.fixture + " leg " + std::to_string(leg.leg) + ": " +
                        fault_in_words(*leg.played->fault));
  }
  if (any) html.close("ul");
}

}  // namespace

std::string team_page_of(const std::string& team) {
  return "teams/" + team + ".html";
}

std::string team_html(const Overview& o, const LegReports& reports, int team) {
  const auto row = std::find_if(o.table.begin(), o.table.end(),
                                [team](const TableRow& r) { return r.team == team; });
  const TeamState& now = o.state.teams[team];
  const Strength& strength = o.ratings.strengths[team];
  Html html;
  html.begin_page(o.state.name(team));
  html.open("p");
  html.link("../index.html", o.state.file.title);
  html.close("p");
  html.cell("p", "Rank " + std::to_string(row - o.table.begin() + 1) + " of " +
                     std::to_string(o.table.size()) + ", " + std::to_string(row->points) +
                     " points, strength " + std::to_string(std::lround(strength.value)) + " (" +
                     std::to_string(std::lround(strength.low)) + " to " +
                     std::to_string(std::lround(strength.high)) + ").");
  if (now.status == TeamStatus::paused) html.cell("p", "Paused: " + now.why + ".");
  if (now.status == TeamStatus::withdrawn) html.cell("p", "Withdrawn: " + now.why + ".");
  if (now.entry > 0) {
    html.cell("p", "Plays with entry " + std::to_string(now.entry) + ", SHA-256 " +
                       now.sha256.substr(0, 16) + "…");
  }
  const std::string last = form(o, team);
  if (!last.empty()) html.cell("p", "Form, the latest last: " + last);
  html.cell("h2", "Results");
  results(html, o, team);
  html.raw(team_statistics_html(o, reports, team));
  own_faults(html, o, team);
  html.cell("h2", "Legs");
  legs(html, o, team);
  html.end_page();
  return html.text();
}

}  // namespace mirocup::league
