// SPDX-License-Identifier: MIT
//
// The options of the commands that compare teams.
#include "programs/league/commands.hpp"
#include "record/rules_json.hpp"
#include "tournaments/play/comparison_run.hpp"

namespace mirocup::league {

void add_terms(const system::Command& command, std::string& league, ComparisonRun& run) {
  command
      .option("--league", league,
              "Field and number of robots: small (3 a side), middle (5), large (11)")
      .one_of({"small", "middle", "large"})
      .shows_default();
  command.option("--half", run.half_s, "Length of a half in seconds")
      .between(record::min_half_s, record::max_half_s);
  command
      .option("--conditions", run.conditions,
              "Conditions: exact, hall or camera (default: as in a match)")
      .one_of({"exact", "hall", "camera"});
}

}  // namespace mirocup::league
