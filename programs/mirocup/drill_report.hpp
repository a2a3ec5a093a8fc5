// SPDX-License-Identifier: MIT
//
// The marks of drills as text, CSV and JSON.
#pragma once

#include "programs/mirocup/drill_run.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace mirocup::app {

// A score of 0 to 100 with the bounds of its interval of 95 %.
struct Score {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
};

// Returns the mean of the tries' marks with Wilson's interval. If tries have marks between 0 and 1,
// the interval is a little too wide.
Score score_of(const std::vector<PlayedTry>& tries);

// Sets "score", "low" and "high" of an object, rounded like all scores that are printed.
double to_a_tenth(double score);
void set_score(nlohmann::ordered_json& json, const Score& score);

// The marks of one team.
struct DrillReport {
  std::string team;
  std::vector<const drills::Drill*> drills;
  std::vector<std::vector<PlayedTry>> tries;  // the tries of each drill

  double score() const;  // the mean score of the drills
};

// Returns the faults of the team, each once.
std::vector<std::string> faults_of(const DrillReport& report);

// Returns {"team", "drills", "score"}.
nlohmann::ordered_json json_of(const DrillReport& report);

// Returns the object of a team for a person; `total` stands before the score of all drills, ""
// leaves it out. `notes` come last, a line each.
std::string report_text(const nlohmann::ordered_json& team, const std::string& total,
                        const std::vector<std::string>& notes);

// Returns the page that lists the failed tries, with links to pages of the tries in the same
// folder.
std::string failed_page(const std::vector<DrillReport>& reports);

// Returns CSV: a line of titles, a line for each team and drill, and a line for all drills of each
// team.
std::string csv_of(const std::vector<DrillReport>& reports);

}  // namespace mirocup::app
