// SPDX-License-Identifier: MIT
#include "tournaments/publish/front_page.hpp"

#include "tournaments/league/decisions.hpp"
#include "tournaments/publish/page_values.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

namespace mirocup::league {

namespace {

// A longer list of fixtures is folded, so that the table stands first.
constexpr std::size_t max_open_fixtures = 8;

// A larger crosstable is of no use on a page; crosstable.json has all teams.
constexpr std::size_t max_crosstable_teams = 64;

// Up to this size the front page has everything; a larger league has pages for the parts.
constexpr std::size_t max_front_crosstable_teams = 16;
constexpr int max_front_legs = 240;

constexpr std::size_t front_form_length = 5;    // legs
constexpr std::size_t most_scores_in_cell = 6;  // of the crosstable

std::string_view status_of(const TeamState& team) {
  if (team.status == TeamStatus::paused) return "paused";
  return team.status == TeamStatus::withdrawn ? "withdrawn" : "";
}

Json row_values(const Overview& o, const TableRow& row, const TableRow* next) {
  return {{"rank", rank_in_words(row)},
          {"team", team_values(o, row.team, "")},
          {"status", status_of(o.state.teams[row.team])},
          {"points", row.points},
          {"points_per_leg", row.rank > 0 ? points_per_leg(row) : "–"},
          {"played", row.played},
          {"won", row.won},
          {"drawn", row.drawn},
          {"lost", row.lost},
          {"goals", std::to_string(row.goals_for) + ":" + std::to_string(row.goals_against)},
          {"difference", with_sign(row.difference())},
          {"is_open", is_decided(o.state, o.ratings, row, next) == false},
          {"reason", reason_in_words(o, row, next)},
          {"form", form_values(o, row.team, front_form_length, "")},
          {"strength", row.played > 0 ? strength_values(o, row.team) : Json(false)},
          {"legs_to_tell", legs_to_tell_in_words(o, row, next)}};
}

Json rows_values(const Overview& o, const std::vector<TableRow>& table) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < table.size(); ++i)
    rows.push_back(row_values(o, table[i], i + 1 < table.size() ? &table[i + 1] : nullptr));
  return rows;
}

Json groups_values(const Overview& o) {
  Json values = Json::array();
  if (o.state.file.format.kind != FormatKind::groups) return values;
  for (int group = 0; group < o.state.file.format.groups; ++group) {
    values.push_back({{"number", group + 1}, {"rows", rows_values(o, o.state.group_table(group))}});
  }
  return values;
}

// "4 fixtures, 12 goals", "1 of 8 legs played".
std::string about(const RoundView& round) {
  if (round.fixtures.empty()) return "teams not known yet";
  if (round.decided == 0) return "to be played";
  if (round.decided < round.legs)
    return std::to_string(round.decided) + " of " + std::to_string(round.legs) + " legs played";
  return std::to_string(round.fixtures.size()) +
         (round.fixtures.size() == 1 ? " fixture, " : " fixtures, ") + std::to_string(round.goals) +
         (round.goals == 1 ? " goal" : " goals");
}

Json round_values(const Overview& o, const RoundView& round, const std::string& root,
                  bool has_fixtures) {
  return {{"title", round.title},
          {"about", about(round)},
          {"page", root + round.page()},
          {"fixtures", has_fixtures ? fixtures_values(o, round, root) : Json::array()}};
}

// A round that has a list of its own on the front page; `id` is that of its heading.
Json shown_round(const Overview& o, const RoundView& round, const char* id, const char* when) {
  Json values = round_values(o, round, "", true);
  values["id"] = id;
  values["when"] = when;
  values["is_short"] = round.fixtures.size() <= max_open_fixtures;
  return values;
}

Json last_round(const SiteContent& c) {
  for (std::size_t i = c.rounds.size(); i-- > 0;) {
    if (c.rounds[i].decided > 0) return shown_round(c.overview, c.rounds[i], "last", "last played");
  }
  return false;
}

// The first round that has legs to play; the fixtures that are over are left out.
Json next_round(const SiteContent& c) {
  for (const RoundView& round : c.rounds) {
    if (round.decided == round.legs) continue;
    RoundView open = round;
    std::erase_if(open.fixtures, [](const FixtureView& f) { return f.state->is_decided(); });
    return shown_round(c.overview, open, "next", "next");
  }
  return false;
}

Json bests_values(const Overview& o, const LegReports& reports) {
  Json bests = bests_of(o);
  if (Json keeper = best_goalkeeper(o, reports); !keeper.is_null()) bests.push_back(keeper);
  return bests;
}

// The sums of many legs, as "12–8–1" and "34:17"; without links, which the rounds have.
Json sums_of(const std::vector<const LegView*>& legs, int team) {
  LegTotals sums;
  for (const LegView* leg : legs) {
    if (leg->played != nullptr) sums.add(*leg, team);
  }
  const std::string won =
      std::to_string(sums.won) + "–" + std::to_string(sums.drawn) + "–" + std::to_string(sums.lost);
  return {{{"score", won}, {"page", ""}}, {{"score", sums.score()}, {"page", ""}}};
}

Json cell_values(const std::vector<const LegView*>& legs, int team, const std::string& root) {
  Json scores = Json::array();
  int ahead = 0;
  for (const LegView* leg : legs) {
    if (leg->played == nullptr) continue;
    ahead += leg->goals(team) - leg->goals_against(team);
    scores.push_back({{"score", score_text(*leg, team)}, {"page", leg->page(root)}});
  }
  const bool is_summed = scores.size() > most_scores_in_cell;
  return {{"scores", is_summed ? sums_of(legs, team) : scores},
          {"is_summed", is_summed},
          {"result", scores.empty() ? ""
                     : ahead > 0    ? "W"
                     : ahead < 0    ? "L"
                                    : "D"}};
}

Json crosstable_values(const Overview& o, const std::string& root) {
  const std::size_t n = o.table.size();
  std::vector<std::vector<const LegView*>> met(n * n);
  std::set<int> teams;  // those that meet nobody, as before their first night, have no row
  for (const LegView& leg : o.legs) {
    teams.insert({leg.home, leg.away});
    met[static_cast<std::size_t>(leg.home) * n + leg.away].push_back(&leg);
    met[static_cast<std::size_t>(leg.away) * n + leg.home].push_back(&leg);
  }
  Json heads = Json::array();
  Json rows = Json::array();
  bool has_sums = false;
  for (const TableRow& row : o.table) {
    if (!teams.contains(row.team)) continue;
    Json team = team_values(o, row.team, root);
    team["rank"] = rank_in_words(row);
    heads.push_back(team);
    Json cells = Json::array();
    for (const TableRow& column : o.table) {
      if (!teams.contains(column.team)) continue;
      if (column.team == row.team) {
        cells.push_back({{"scores", Json::array()}, {"result", "self"}});
        continue;
      }
      cells.push_back(
          cell_values(met[static_cast<std::size_t>(row.team) * n + column.team], row.team, root));
      has_sums = has_sums || cells.back()["is_summed"];
    }
    rows.push_back({{"team", team}, {"cells", cells}});
  }
  return {{"heads", heads}, {"rows", rows}, {"has_sums", has_sums}};
}

}  // namespace

Json decisions_values(const LeagueState& state) {
  Json decisions = Json::array();
  for (const DecisionView& d : decision_views(state)) {
    decisions.push_back({{"number", d.number},
                         {"at", shown_time(state.file, d.signature.at)},
                         {"by", d.signature.by},
                         {"what", d.what},
                         {"why", d.signature.why},
                         {"undoing", d.undoing}});
  }
  return decisions;
}

Json champion_values(const Overview& o) {
  if (!o.state.is_over() || o.table.size() < 2 || o.state.played() == 0) return false;
  const TableRow& first = o.table[0];
  const TableRow& second = o.table[1];
  Json values = team_values(o, first.team, "");
  values["why"] = reason_in_words(o, first, &second);
  values["second"] = team_values(o, second.team, "");
  if (o.table.size() > 2) values["third"] = team_values(o, o.table[2].team, "");
  const auto legs = legs_to_tell(o.ratings, first.team, second.team);
  if (legs && second.rank > 0) values["legs_to_tell"] = std::to_string(*legs);
  return values;
}

std::string front_html(const SiteContent& c) {
  const Overview& o = c.overview;
  Json values = page_values(o, "", "");
  values["is_front"] = true;
  values["notice"] = o.state.notice;
  const std::string frozen = o.state.frozen_from();
  values["frozen"] = frozen.empty() ? "" : shown_time(o.state.file, frozen);
  if (!o.state.closing_round.empty()) values["closing_page"] = c.closing_page;
  values["champion"] = o.state.closing_round.empty() ? champion_values(o) : Json(false);
  values["unpaired"] = unpaired_in_words(o.state);
  values["last"] = last_round(c);
  values["next"] = next_round(c);
  values["table"] = rows_values(o, o.table);
  values["is_any_open"] = std::any_of(values["table"].begin(), values["table"].end(),
                                      [](const Json& row) { return row["is_open"]; });
  values["bracket"] = bracket_svg(o);
  values["groups"] = groups_values(o);
  values["per_leg"] = o.state.file.format.is_open_ended();
  values["chart"] = strength_picture(o, c.history, no_team);
  values["worth"] = worth_watching(o);
  values["statistics"] = statistics_html(o, c.reports);
  values["bests"] = bests_values(o, c.reports);
  values["filter"] = filter_values(o);
  const bool has_all = o.state.legs() <= max_front_legs;
  Json rounds = Json::array();
  for (const RoundView& round : c.rounds) rounds.push_back(round_values(o, round, "", has_all));
  values[has_all ? "folded_rounds" : "linked_rounds"] = rounds;
  const std::size_t teams = o.table.size();
  if (teams <= max_front_crosstable_teams) values["crosstable"] = crosstable_values(o, "");
  values["has_crosstable_page"] =
      teams > max_front_crosstable_teams && teams <= max_crosstable_teams;
  values["decisions"] = decisions_values(o.state);
  values["night"] = c.has_night;
  if (c.has_playground) values["playground"] = playground_name;
  return filled_page("index.html", values);
}

std::string round_html(const SiteContent& c, std::size_t index) {
  const RoundView& round = c.rounds[index];
  Json values = page_values(c.overview, "../", round.title);
  values["has_ids"] = true;
  values["round"] = round_values(c.overview, round, "../", true);
  const auto neighbour = [&](std::size_t i) {
    return i < c.rounds.size()
               ? Json{{"title", c.rounds[i].title}, {"page", "../" + c.rounds[i].page()}}
               : Json(false);
  };
  values["before"] = neighbour(index - 1);
  values["after"] = neighbour(index + 1);
  values["filter"] = filter_values(c.overview);
  return filled_page("round.html", values);
}

bool has_crosstable(const SiteContent& c) {
  return c.overview.table.size() <= max_crosstable_teams;
}

std::string crosstable_html(const SiteContent& c) {
  Json values = page_values(c.overview, "", "Crosstable");
  values["crosstable"] = crosstable_values(c.overview, "");
  values["filter"] = filter_values(c.overview);
  return filled_page("crosstable.html", values);
}

}  // namespace mirocup::league
