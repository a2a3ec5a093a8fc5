// SPDX-License-Identifier: MIT
#include "record/statistics/report.hpp"

#include "record/csv_rows.hpp"
#include "record/json_reader.hpp"
#include "record/statistics/advice.hpp"
#include "record/statistics/statistics_json.hpp"
#include "system/printable.hpp"
#include "system/text.hpp"

#include <algorithm>
#include <functional>
#include <map>

namespace mirocup::statistics {

namespace {

constexpr std::size_t max_examples = 3;  // of legs in which a goal fell in some way

// A table for a terminal: the first column to the left, the others to the right.
std::string table_text(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string space(widths[i] - row[i].size(), ' ');
      text += i == 0 ? row[i] + space : "  " + space + row[i];
    }
    text += '\n';
  }
  return text;
}

template <class E>
std::string names_text(const PerName<E>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] == 0) continue;
    text += (text.empty() ? "" : ", ") + std::string(enum_names<E>[i]) + " " +
            std::to_string(numbers[i]);
  }
  return text.empty() ? "none" : text;
}

std::string name_of(const TeamTotals& team) {
  return system::printable(team.name);
}

// True for a team of that name, and for both of its colours in legs against itself.
bool is_named(const TeamTotals& team, const std::string& name) {
  return team.name == name || std::ranges::any_of(both_teams, [&](Team colour) {
           return team.name == name + " (" + std::string(to_string(colour)) + ")";
         });
}

// "leg.json tick 812", to be looked at by `mirocup replay`.
std::string place_of(const LegReport& leg, std::uint32_t tick) {
  return system::printable(leg.record) + " tick " + std::to_string(tick);
}

// What to practise: a line for each drill, to be typed with the team's file in place of TEAM.
std::string advice_text(const std::vector<LegReport>& legs, const TeamTotals& team) {
  std::string text;
  for (const Advice& advice : advice_for(legs, team))
    text += "  mirocup drill " + advice.drill + " TEAM  # " + advice.why +
            (advice.moments.empty() ? "" : ": " + advice.moments) + "\n";
  if (const int goals = team.against.all_goals(); goals > 0)
    text += "  mirocup coach --all RECORD --team TEAM  # until when each of the " +
            std::to_string(goals) + " goals against it could have been prevented\n";
  return text;
}

// Goals that fell in the same way.
struct WayOfGoals {
  int goals = 0;
  double since_restart = 0.0;  // s, the sum
  PerName<Third> lost{};
  int never_lost = 0;
  std::vector<std::string> places;
};

std::string way_of(const Goal& goal) {
  return std::string(to_string(goal.origin)) + ", last restart " +
         std::string(to_string(goal.restart)) + " (" + std::string(to_string(goal.restart_law)) +
         ")";
}

std::string way_text(const std::string& name, const WayOfGoals& way) {
  std::string lost = names_text<Third>(way.lost);
  if (way.never_lost > 0) {
    lost = (lost == "none" ? "" : lost + ", ") + ("not lost " + std::to_string(way.never_lost));
  }
  std::string text = "  " + std::to_string(way.goals) + "  " + name + ", " +
                     system::formatted("%.1f", way.since_restart / way.goals) +
                     " s of play after it; ball lost: " + lost + "\n";
  for (std::size_t i = 0; i < std::min(max_examples, way.places.size()); ++i) {
    text += "       " + way.places[i] + "\n";
  }
  if (way.places.size() > max_examples) {
    text += "       and " + std::to_string(way.places.size() - max_examples) + " more\n";
  }
  return text;
}

// The ways in which goals fell against a team, the most frequent first.
std::vector<std::pair<std::string, WayOfGoals>> ways_against(const std::vector<LegReport>& legs,
                                                             const std::string& name) {
  std::map<std::string, WayOfGoals> ways;
  for (const LegReport& leg : legs) {
    for (const Goal& goal : leg.statistics.goals) {
      if (counted_name(leg, opponent_of(goal.team)) != name) continue;
      WayOfGoals& way = ways[way_of(goal)];
      ++way.goals;
      way.since_restart += goal.since_restart;
      goal.loss ? ++way.lost[at(goal.loss->third)] : ++way.never_lost;
      way.places.push_back(place_of(leg, goal.tick) +
                           (goal.loss ? ", ball lost in tick " + std::to_string(goal.loss->tick) +
                                            " by " + std::string(to_string(goal.loss->kind))
                                      : ""));
    }
  }
  std::vector<std::pair<std::string, WayOfGoals>> sorted(ways.begin(), ways.end());
  std::ranges::stable_sort(sorted, std::greater(),
                           [](const auto& way) { return way.second.goals; });
  return sorted;
}

std::string fouls_of(const std::vector<LegReport>& legs, const TeamTotals& team) {
  std::map<referee::Law, std::vector<std::string>> fouls;
  for (const LegReport& leg : legs) {
    for (const Foul& foul : leg.statistics.fouls) {
      if (counted_name(leg, foul.team) == team.name) {
        fouls[foul.law].push_back(place_of(leg, foul.tick));
      }
    }
  }
  std::string text;
  for (const auto& [law, places] : fouls) {
    text += "  " + std::to_string(places.size()) + "  " + std::string(to_string(law)) +
            ", the first in " + places.front() + "\n";
  }
  return text;
}

}  // namespace

std::string percent(const std::optional<double>& share) {
  return share ? system::formatted("%.0f %%", 100.0 * *share) : "-";
}

static std::string numbers_text(const std::vector<LegReport>& legs) {
  double play = 0.0;
  double dead = 0.0;
  int stoppages = 0;
  for (const LegReport& leg : legs) {
    play += leg.statistics.play_s;
    dead += leg.statistics.dead_ball_s;
    stoppages += leg.statistics.stoppages;
  }
  std::string text = std::to_string(legs.size()) + (legs.size() == 1 ? " leg, " : " legs, ") +
                     system::formatted("%.1f s of play, %.1f s dead ball, %d stoppages\n\n", play,
                                       dead, stoppages);
  std::vector<std::vector<std::string>> rows{{"team", "legs", "goals", "shots", "on goal", "saves",
                                              "passes", "interceptions", "possession", "territory",
                                              "ball lost", "duels won", "fouls"}};
  std::vector<std::vector<std::string>> kinds{{"goals by kind"}};
  for (const auto name : enum_names<GoalOrigin>) kinds[0].emplace_back(name);
  std::string fouls;
  std::string advice;
  const auto number = [](int count) { return std::to_string(count); };
  for (const TeamTotals& team : totals_of(legs)) {
    const std::string lines = advice_text(legs, team);
    if (!lines.empty()) advice += "\n" + name_of(team) + " could practise:\n" + lines;
    const TeamStatistics& own = team.own;
    rows.push_back({name_of(team), number(team.legs),
                    number(own.all_goals()) + " : " + number(team.against.all_goals()),
                    number(own.shots), number(own.shots_on_goal), number(own.saves),
                    number(own.passes), number(own.interceptions),
                    percent(share(own.possession_s, team.against.possession_s)),
                    percent(share(own.opponent_half_s, team.against.opponent_half_s)),
                    number(own.all_losses()), number(own.duels_won) + " of " + number(team.duels),
                    number(own.all_fouls())});
    auto& kind = kinds.emplace_back(1, name_of(team));
    for (const int goals : own.goals) kind.push_back(number(goals));
    fouls += "fouls of " + name_of(team) + ": " + names_text<referee::Law>(own.fouls) + "\n";
  }
  return text + table_text(rows) + "\n" + table_text(kinds) + "\n" + fouls + advice;
}

// A row of a leg and one of its teams.
static Json row_of(const LegReport& leg, Team team) {
  return {{"record", leg.record},
          {"leg", leg.leg},
          {"team", leg.names[index_of(team)]},
          {"colour", to_string(team)},
          {"opponent", leg.names[index_of(opponent_of(team))]}};
}

std::string numbers_csv(const std::vector<LegReport>& legs) {
  std::vector<std::string> columns{
      "record",    "leg",           "team",         "colour",        "opponent",
      "goals",     "against",       "shots",        "shots_on_goal", "saves",
      "passes",    "interceptions", "possession_s", "possession",    "opponent_half_s",
      "territory", "losses",        "duels",        "duels_won",     "distance_m",
      "play_s",    "dead_ball_s",   "stoppages",    "fouls"};
  const auto add = [&columns](const std::string& kind, const char* by, const auto& names) {
    for (const std::string_view name : names)
      columns.push_back(kind + "_" + std::string(name) + "=" + kind + by + std::string(name));
  };
  add("goals", "_by_kind/", enum_names<GoalOrigin>);
  add("losses", "_by_third/", enum_names<Third>);
  add("fouls", "_by_law/", enum_names<referee::Law>);
  Json rows = Json::array();
  for (const LegReport& leg : legs) {
    const Json all = to_json(leg);
    for (const Team team : both_teams) {
      Json& row = rows.emplace_back(all["teams"][std::string(to_string(team))]);
      row.update(row_of(leg, team));
      row["against"] = leg.statistics.teams[index_of(opponent_of(team))].all_goals();
      for (const char* key : {"duels", "play_s", "dead_ball_s", "stoppages"}) row[key] = all[key];
      for (const char* key : {"possession", "territory"})
        if (const double* share = row[key].get_ptr<const double*>())
          row[key] = system::formatted("%.4f", *share);
      for (const auto law : enum_names<referee::Law>) row["fouls_by_law"].emplace(law, 0);
    }
  }
  return record::csv_of(rows, columns);
}

std::string goals_text(const std::vector<LegReport>& legs, const std::string& only) {
  std::string text;
  for (const TeamTotals& team : totals_of(legs)) {
    if (!only.empty() && !is_named(team, only)) continue;
    text += (text.empty() ? "" : "\n") + name_of(team) + ", " + std::to_string(team.legs) +
            (team.legs == 1 ? " leg" : " legs") + ": " + std::to_string(team.against.all_goals()) +
            " goals against it\n";
    for (const auto& [name, way] : ways_against(legs, team.name)) text += way_text(name, way);
    text += "  it lost the ball " + std::to_string(team.own.all_losses()) +
            " times; thirds of the field: " + names_text<Third>(team.own.losses) + "\n";
    const std::string fouls = fouls_of(legs, team);
    text += "  fouls called against it: " + std::to_string(team.own.all_fouls()) + "\n" + fouls;
    const std::string advice = advice_text(legs, team);
    if (!advice.empty()) text += "  it could practise:\n" + advice;
  }
  return text;
}

std::string goals_csv(const std::vector<LegReport>& legs) {
  Json rows = Json::array();
  for (const LegReport& leg : legs) {
    const auto add = [&](const char* event, Team team, std::uint32_t tick) -> Json& {
      Json& row = rows.emplace_back(row_of(leg, team));
      row.update({{"event", event},
                  {"tick", tick},
                  {"seconds", system::formatted("%.3f", tick * leg.control_period)}});
      return row;
    };
    for (const Goal& goal : leg.statistics.goals) {
      Json& row = add("goal", goal.team, goal.tick);
      row.update({{"kind", to_string(goal.origin)},
                  {"restart", to_string(goal.restart)},
                  {"restart_law", to_string(goal.restart_law)},
                  {"since_restart_s", goal.since_restart}});
      if (const auto& loss = goal.loss)
        row.update({{"loss_tick", loss->tick},
                    {"loss_kind", to_string(loss->kind)},
                    {"loss_third", to_string(loss->third)},
                    {"loss_x", system::formatted("%.3f", loss->place.x())},
                    {"loss_y", system::formatted("%.3f", loss->place.y())}});
    }
    for (const Foul& foul : leg.statistics.fouls)
      add("foul", foul.team, foul.tick)
          .update({{"kind", to_string(foul.law)}, {"restart", to_string(foul.restart)}});
  }
  return record::csv_of(rows, {"record", "leg", "tick", "seconds", "event", "team", "colour",
                               "opponent", "kind", "restart", "restart_law", "since_restart_s",
                               "loss_tick", "loss_kind", "loss_third", "loss_x", "loss_y"});
}

void add_options(const system::Command& command, ReportOptions& options,
                 const std::string& about_team) {
  command.flag(
      "--goals", options.goals,
      "Print how goals fell, where the ball was lost before each goal, and which laws were broken");
  command.option("--team NAME", options.team, about_team);
  const system::Option csv = command.flag("--csv", options.csv, "Print comma-separated values");
  command.flag("--json", options.json, "Print everything as one JSON object").excludes(csv);
}

Result<std::string> report(std::vector<LegReport> legs, const ReportOptions& options) {
  const std::string& team = options.team;
  if (!team.empty()) {
    std::erase_if(
        legs, [&](const LegReport& leg) { return leg.names[0] != team && leg.names[1] != team; });
    if (legs.empty())
      return fail(Errc::input,
                  "--team " + system::in_quotes(team) + ": this team has played none of the legs");
  }
  if (options.json) return record::json_text(report_json(legs)) + "\n";
  if (options.goals) return options.csv ? goals_csv(legs) : goals_text(legs, team);
  return options.csv ? numbers_csv(legs) : numbers_text(legs);
}

}  // namespace mirocup::statistics
