// SPDX-License-Identifier: MIT
#include "server/web/page_json.hpp"

#include <algorithm>
#include <numeric>

namespace mirocup::web {

namespace {

// Most decisions name who offended; these name who scored, kicks off or leads.
bool names_who_has_it(referee::Verdict verdict) {
  using enum referee::Verdict;
  return verdict == GOAL || verdict == KICK_OFF || verdict == HALF_END || verdict == MATCH_END;
}

}  // namespace

Json moment_json(const match::Scene& scene) {
  return {{"state", to_string(scene.state)},
          {"phase", to_string(scene.phase)},
          {"left", to_string(scene.left)},
          {"score", {{"blue", scene.score[0]}, {"yellow", scene.score[1]}}}};
}

Json statistics_json(const Statistics& statistics,
                     const std::vector<match::LoggedDecision>& decisions) {
  Json teams;
  for (const Team team : both_teams) {
    const TeamNumbers& numbers = statistics.of(team);
    const auto is_foul = [team](const match::LoggedDecision& d) {
      return d.team == team && !names_who_has_it(d.decision.verdict);
    };
    teams[std::string(to_string(team))] = {
        {"possession", numbers.possession},
        {"shots", numbers.shots},
        {"distance", std::accumulate(numbers.distance.begin(), numbers.distance.end(), 0.0)},
        {"fouls", std::count_if(decisions.begin(), decisions.end(), is_foul)}};
  }
  return {{"teams", teams},
          {"heat", {{"columns", statistics.columns()}, {"cells", statistics.heat()}}}};
}

}  // namespace mirocup::web
