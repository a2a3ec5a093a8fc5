// SPDX-License-Identifier: MIT
#include "server/web/page_json.hpp"

#include "server/record/json_reader.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <numeric>

namespace mirocup::web {

Json moment_json(const match::Snapshot& scene) {
  return {{"state", to_string(scene.state)},
          {"phase", to_string(scene.phase)},
          {"left", to_string(scene.left)},
          {"score", {{"blue", scene.score[0]}, {"yellow", scene.score[1]}}}};
}

Json statistics_json(const Statistics& statistics,
                     const std::vector<match::LoggedDecision>& decisions) {
  Json teams;
  for (const Team team : both_teams) {
    const TeamStatistics& numbers = statistics.of(team);
    // The offender does not take the restart. A team that concedes a goal takes it, without a foul.
    const auto is_foul = [team](const match::LoggedDecision& d) {
      return d.team == team && d.decision.restart != referee::Restart::none && d.taker != team &&
             d.decision.verdict != referee::Verdict::GOAL;
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

std::string event_text(const char* name, const Json& data) {
  // The data is one line, so a name of a team cannot start another event.
  return std::string("event: ") + name + "\ndata: " + record::json_text(data) + "\n\n";
}

}  // namespace mirocup::web
