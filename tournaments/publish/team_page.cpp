// SPDX-License-Identifier: MIT
#include "system/text.hpp"
#include "tournaments/publish/front_page.hpp"
#include "tournaments/publish/page_values.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace mirocup::league {

namespace {

constexpr std::size_t form_length = 10;  // legs
constexpr std::size_t best_length = 3;   // legs

// What a team did in some of its legs, with its own faults.
struct TotalsRow {
  LegTotals sums;
  int faults = 0;

  void add(const LegView& leg, int team, const std::string& name) {
    sums.add(leg, team);
    if (leg.played->fault && leg.played->fault->team == name) ++faults;
  }

  Json values(const std::string& what) const {
    const double legs = std::max(1, sums.legs);
    const std::string mean =
        system::formatted("%.2f : %.2f", sums.goals / legs, sums.against / legs);
    return {{"what", what},      {"legs", sums.legs},     {"won", sums.won}, {"drawn", sums.drawn},
            {"lost", sums.lost}, {"goals", sums.score()}, {"mean", mean},    {"faults", faults}};
  }
};

using PlayedLegs = std::vector<const LegView*>;

PlayedLegs played_legs(const Overview& o, int team) {
  PlayedLegs legs;
  for (const std::size_t leg : o.decided_legs[team]) legs.push_back(&o.legs[leg]);
  return legs;
}

Json totals_values(const Overview& o, int team, const PlayedLegs& legs) {
  TotalsRow all;
  TotalsRow blue;
  TotalsRow yellow;
  for (const LegView* leg : legs) {
    all.add(*leg, team, o.state.name(team));
    (leg->is_blue(team) ? blue : yellow).add(*leg, team, o.state.name(team));
  }
  return Json::array({all.values("All"), blue.values("As blue"), yellow.values("As yellow")});
}

// How much better than expected a leg went: the goals that the team was ahead, and 1 for each 100
// that the other team is stronger.
double achievement(const Overview& o, const LegView& leg, int team) {
  const double stronger =
      std::round(o.ratings.strengths[leg.other(team)].value - o.ratings.strengths[team].value);
  return leg.goals(team) - leg.goals_against(team) + stronger / 100.0;
}

// The best legs of a team, or its worst ones, as it sees them.
Json extremes(const Overview& o, int team, PlayedLegs legs, bool best) {
  std::erase_if(legs, [&](const LegView* leg) {
    return !leg->has_replay() || leg->letter(team) == (best ? 'L' : 'W');
  });
  std::ranges::stable_sort(legs, [&](const LegView* a, const LegView* b) {
    const double x = achievement(o, *a, team);
    const double y = achievement(o, *b, team);
    return best ? x > y : x < y;
  });
  Json values = Json::array();
  for (std::size_t i = 0; i < std::min(best_length, legs.size()); ++i)
    values.push_back(leg_values(o, *legs[i], "../", ""));
  return values;
}

Json opponents_values(const Overview& o, int team, const PlayedLegs& legs) {
  std::map<int, TotalsRow> against;
  for (const LegView* leg : legs) against[leg->other(team)].add(*leg, team, o.state.name(team));
  Json values = Json::array();
  for (const TableRow& row : o.table) {
    const auto found = against.find(row.team);
    if (found == against.end()) continue;
    const TotalsRow& totals = found->second;
    Json opponent = totals.values("");
    opponent["team"] = team_values(o, row.team, "../");
    opponent["result"] = totals.sums.won > totals.sums.lost   ? "W"
                         : totals.sums.won < totals.sums.lost ? "L"
                                                              : "D";
    values.push_back(opponent);
  }
  return values;
}

Json faults_values(const Overview& o, int team, const PlayedLegs& legs) {
  Json faults = Json::array();
  for (const LegView* leg : legs) {
    if (!leg->played->fault || leg->played->fault->team != o.state.name(team)) continue;
    faults.push_back(name_in_words({leg->fixture, leg->leg}) + ": " +
                     fault_in_words(*leg->played->fault));
  }
  return faults;
}

// All fixtures of the team by round, and the first that has legs to play.
void add_fixtures(Json& values, const SiteContent& c, int team) {
  Json all = Json::array();
  values["next"] = false;
  for (const RoundView& round : c.rounds) {
    for (const FixtureView& f : round.fixtures) {
      if (f.state->fixture.home != team && f.state->fixture.away != team) continue;
      all.push_back(fixture_values(c.overview, f, "../"));
      if (!f.state->is_decided() && values["next"] == false) values["next"] = all.back();
    }
  }
  values["fixtures"] = all;
}

}  // namespace

std::string team_html(const SiteContent& c, int team) {
  const Overview& o = c.overview;
  const auto row = std::ranges::find(o.table, team, &TableRow::team);
  const TeamState& now = o.state.teams[team];
  Json values = page_values(o, "../", o.state.shown_name(team));
  values["rank"] = row->rank > 0 ? Json(row->rank) : Json(false);
  values["teams"] = std::ranges::count_if(o.table, [](const TableRow& r) { return r.rank > 0; });
  values["points"] = row->points;
  values["reason"] = reason_in_words(o, *row, row + 1 == o.table.end() ? nullptr : &*(row + 1));
  values["strength"] = strength_values(o, team);
  values["is_paused"] = now.status == TeamStatus::paused;
  values["is_withdrawn"] = now.status == TeamStatus::withdrawn;
  values["why"] = now.why;
  if (now.entry > 0) {
    values["entry"] = now.entry;
    values["sha256"] = now.sha256.substr(0, 16);
  }
  values["form"] = form_values(o, team, form_length, "../");
  values["chart"] = row->rank > 0 ? strength_picture(o, c.history, team) : "";
  const PlayedLegs legs = played_legs(o, team);
  values["totals"] = totals_values(o, team, legs);
  values["best"] = extremes(o, team, legs, true);
  values["worst"] = extremes(o, team, legs, false);
  values["opponents"] = opponents_values(o, team, legs);
  values["statistics"] = team_statistics_html(o, team, "../");
  values["faults"] = faults_values(o, team, legs);
  add_fixtures(values, c, team);
  return filled_page("team.html", values);
}

}  // namespace mirocup::league
