// SPDX-License-Identifier: MIT
#include "record/statistics/totals.hpp"

#include <algorithm>

namespace mirocup::statistics {

void TeamTotals::add(const LegStatistics& leg, Team team) {
  ++legs;
  own += leg.teams[index_of(team)];
  against += leg.teams[index_of(opponent_of(team))];
  play_s += leg.play_s;
  dead_ball_s += leg.dead_ball_s;
  duels += leg.duels;
}

std::string counted_name(const LegReport& leg, Team team) {
  const std::string& name = leg.names[index_of(team)];
  if (leg.names[0] != leg.names[1]) return name;
  return name + " (" + std::string(to_string(team)) + ")";
}

std::vector<TeamTotals> totals_of(const std::vector<LegReport>& legs) {
  std::vector<TeamTotals> totals;
  for (const LegReport& leg : legs) {
    for (const Team team : both_teams) {
      const std::string name = counted_name(leg, team);
      auto found = std::find_if(totals.begin(), totals.end(),
                                [&](const TeamTotals& t) { return t.name == name; });
      if (found == totals.end()) {
        totals.emplace_back().name = name;
        found = totals.end() - 1;
      }
      found->add(leg.statistics, team);
    }
  }
  return totals;
}

}  // namespace mirocup::statistics
