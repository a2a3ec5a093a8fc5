// SPDX-License-Identifier: MIT
#include "tournaments/publish/site.hpp"

#include "tournaments/publish/html.hpp"
#include "tournaments/publish/replay_pages.hpp"

#include <iomanip>
#include <sstream>

namespace mirocup::league {

namespace {

std::string score_text(const PlayedLeg& leg) {
  return std::to_string(leg.result.home_goals) + " : " + std::to_string(leg.result.away_goals);
}

// The legs that two teams played, from the row's point of view.
std::vector<std::string> meetings(const LeagueState& state, int row, int column) {
  std::vector<std::string> scores;
  for (const FixtureState& f : state.fixtures) {
    const bool home = f.fixture.home == row && f.fixture.away == column;
    const bool away = f.fixture.home == column && f.fixture.away == row;
    if (!home && !away) continue;
    for (const auto& leg : f.legs) {
      if (!leg) continue;
      const int own = home ? leg->result.home_goals : leg->result.away_goals;
      const int other = home ? leg->result.away_goals : leg->result.home_goals;
      scores.push_back(std::to_string(own) + ":" + std::to_string(other));
    }
  }
  return scores;
}

Json crosstable_json(const LeagueState& state) {
  const int n = static_cast<int>(state.file.teams.size());
  Json teams = Json::array();
  Json rows = Json::array();
  for (int i = 0; i < n; ++i) {
    teams.push_back(state.file.teams[i].name);
    Json row = Json::array();
    for (int j = 0; j < n; ++j) row.push_back(i == j ? Json() : Json(meetings(state, i, j)));
    rows.push_back(row);
  }
  return {{"teams", teams}, {"results", rows}};
}

// The tables of brackets-model: every row has an id and its parents' ids.
Json bracket_json(const LeagueState& state) {
  // Status of a match there: 2 ready, 4 completed.
  constexpr int ready = 2;
  constexpr int completed = 4;
  Json participants = Json::array();
  for (std::size_t i = 0; i < state.file.teams.size(); ++i) {
    participants.push_back({{"id", i}, {"tournament_id", 0}, {"name", state.file.teams[i].name}});
  }
  Json rounds = Json::array();
  Json matches = Json::array();
  Json games = Json::array();
  for (const FixtureState& f : state.fixtures) {
    const int round = f.fixture.round - 1;
    if (static_cast<int>(rounds.size()) <= round) {
      rounds.push_back({{"id", round}, {"stage_id", 0}, {"group_id", 0}, {"number", round + 1}});
    }
    const std::size_t match = matches.size();
    int played = 0;
    int home_wins = 0;
    int away_wins = 0;
    for (int leg = 0; leg < legs_per_fixture; ++leg) {
      Json game{{"id", games.size()}, {"stage_id", 0}, {"parent_id", match}, {"number", leg + 1}};
      game["status"] = f.legs[leg] ? completed : ready;
      Json home{{"id", f.fixture.home}};
      Json away{{"id", f.fixture.away}};
      if (f.legs[leg]) {
        const LegResult& r = f.legs[leg]->result;
        home["score"] = r.home_goals;
        away["score"] = r.away_goals;
        ++played;
        home_wins += r.home_goals > r.away_goals ? 1 : 0;
        away_wins += r.away_goals > r.home_goals ? 1 : 0;
      }
      game["opponent1"] = home;
      game["opponent2"] = away;
      games.push_back(game);
    }
    matches.push_back({{"id", match},
                       {"stage_id", 0},
                       {"group_id", 0},
                       {"round_id", round},
                       {"number", f.fixture.number},
                       {"child_count", legs_per_fixture},
                       {"status", played == legs_per_fixture ? completed : ready},
                       {"opponent1", {{"id", f.fixture.home}, {"score", home_wins}}},
                       {"opponent2", {{"id", f.fixture.away}, {"score", away_wins}}}});
  }
  return {{"participant", participants},
          {"stage",
           {{{"id", 0},
             {"tournament_id", 0},
             {"name", state.file.title},
             {"type", "round_robin"},
             {"number", 1}}}},
          {"group", {{{"id", 0}, {"stage_id", 0}, {"number", 1}}}},
          {"round", rounds},
          {"match", matches},
          {"match_game", games}};
}

std::string table_html(const LeagueState& state) {
  Html html;
  html.open("table");
  html.row("th", {"", "Team", "Legs", "Won", "Drawn", "Lost", "Goals", "Diff.", "Points",
                  "Ahead of the next by"});
  int rank = 1;
  for (const Row& row : state.table()) {
    html.row("td",
             {std::to_string(rank++), state.file.teams[row.team].name, std::to_string(row.played),
              std::to_string(row.won), std::to_string(row.drawn), std::to_string(row.lost),
              std::to_string(row.goals_for) + " : " + std::to_string(row.goals_against),
              std::to_string(row.difference()), std::to_string(row.points), row.separated_by});
  }
  html.close("table");
  return html.text();
}

std::string crosstable_html(const LeagueState& state) {
  const int n = static_cast<int>(state.file.teams.size());
  Html html;
  html.open("table");
  std::vector<std::string> head{""};
  for (const TeamEntry& team : state.file.teams) head.push_back(team.name);
  html.row("th", head);
  for (int i = 0; i < n; ++i) {
    std::vector<std::string> cells{state.file.teams[i].name};
    for (int j = 0; j < n; ++j) {
      std::string cell = i == j ? "–" : "";
      for (const std::string& score : meetings(state, i, j))
        cell += (cell.empty() ? "" : ", ") + score;
      cells.push_back(cell);
    }
    html.row("td", cells);
  }
  html.close("table");
  return html.text();
}

std::string fixtures_html(const LeagueState& state) {
  Html html;
  html.open("table");
  html.row("th", {"Round", "Leg", "Home", "", "Away", "How it ended", "Replay", "Record"});
  for (const FixtureState& f : state.fixtures) {
    for (int leg = 0; leg < legs_per_fixture; ++leg) {
      const auto& played = f.legs[leg];
      html.open("tr");
      html.cell("td", std::to_string(f.fixture.round));
      html.cell("td", std::to_string(leg + 1));
      html.cell("td", state.file.teams[f.fixture.home].name);
      html.cell("td", played ? score_text(*played) : "");
      html.cell("td", state.file.teams[f.fixture.away].name);
      html.cell("td",
                played ? played->end + (played->fault.empty() ? "" : ": " + played->fault) : "");
      if (played) {
        html.link_cell(replay_page_of(played->record), "replay");
        html.link_cell("../" + played->record, "record");
      } else {
        html.cell("td", "");
        html.cell("td", "");
      }
      html.close("tr");
    }
  }
  html.close("table");
  return html.text();
}

std::string index_html(const LeagueState& state) {
  const std::string progress =
      std::to_string(state.played()) + " of " + std::to_string(state.legs()) + " legs played.";
  Html html;
  html.begin_page(state.file.title);
  html.cell("p", progress);
  html.cell("h2", "Table");
  html.raw(table_html(state));
  html.cell("h2", "Crosstable");
  html.cell("p", "Scores from the point of view of the team on the left.");
  html.raw(crosstable_html(state));
  html.cell("h2", "Fixtures");
  html.raw(fixtures_html(state));
  html.end_page();
  return html.text();
}

}  // namespace

Json table_json(const LeagueState& state) {
  Json rows = Json::array();
  int rank = 1;
  for (const Row& row : state.table()) {
    rows.push_back({{"rank", rank++},
                    {"team", state.file.teams[row.team].name},
                    {"played", row.played},
                    {"won", row.won},
                    {"drawn", row.drawn},
                    {"lost", row.lost},
                    {"goals_for", row.goals_for},
                    {"goals_against", row.goals_against},
                    {"goal_difference", row.difference()},
                    {"points", row.points},
                    {"penalties", row.penalties},
                    {"separated_by", row.separated_by.empty() ? Json() : Json(row.separated_by)}});
  }
  return {{"title", state.file.title},
          {"played", state.played()},
          {"legs", state.legs()},
          {"table", rows}};
}

std::string table_text(const LeagueState& state) {
  std::ostringstream out;
  const auto line = [&out](const std::string& rank, const std::string& team,
                           const std::string& numbers, const std::string& goals,
                           const std::string& points, const std::string& by) {
    out << std::setw(3) << rank << "  " << std::left << std::setw(20) << team << std::right
        << std::setw(20) << numbers << std::setw(12) << goals << std::setw(8) << points
        << (by.empty() ? "" : "   ") << by << '\n';
  };
  line("", "Team", "legs  won drawn lost", "goals", "points", "ahead by");
  int rank = 1;
  for (const Row& row : state.table()) {
    std::ostringstream numbers;
    numbers << std::setw(4) << row.played << std::setw(5) << row.won << std::setw(6) << row.drawn
            << std::setw(5) << row.lost;
    line(std::to_string(rank++), state.file.teams[row.team].name, numbers.str(),
         std::to_string(row.goals_for) + ":" + std::to_string(row.goals_against),
         std::to_string(row.points), row.separated_by);
  }
  return out.str();
}

std::vector<SiteFile> make_site(const LeagueState& state) {
  return {{"index.html", index_html(state)},
          {"table.json", table_json(state).dump(1) + "\n"},
          {"crosstable.json", crosstable_json(state).dump(1) + "\n"},
          {"bracket.json", bracket_json(state).dump(1) + "\n"}};
}

}  // namespace mirocup::league
