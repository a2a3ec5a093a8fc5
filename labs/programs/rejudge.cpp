// SPDX-License-Identifier: MIT
//
// mirocup rejudge RECORD: judges a played match again, with other parameters.
#include "labs/rejudge/rejudge.hpp"

#include "labs/programs/commands.hpp"
#include "record/json_reader.hpp"
#include "record/match_record.hpp"
#include "record/rules_json.hpp"
#include "system/printable.hpp"

#include <iostream>
#include <vector>

namespace mirocup::labs {

namespace {

struct RejudgeOptions {
  std::string record_path;
  std::vector<std::string> rule_changes;  // KEY=VALUE
  bool json = false;
};

using record::Json;

Json decision_json(const std::optional<match::LoggedDecision>& logged) {
  if (!logged) return nullptr;
  return {{"decision", to_string(logged->decision.verdict)},
          {"law", to_string(logged->decision.law)},
          {"team", logged->team ? Json(to_string(*logged->team)) : Json()},
          {"reason", logged->decision.reason}};
}

std::string decision_text(const std::optional<match::LoggedDecision>& logged) {
  if (!logged) return "nothing";
  return std::string(to_string(logged->decision.verdict)) + " (" +
         std::string(to_string(logged->decision.law)) + ": " + logged->decision.reason + ")";
}

Result<int> run_rejudge(const RejudgeOptions& options) {
  system::Disk disk;
  MIROCUP_TRY(const auto record, record::load(disk, options.record_path));
  const match::Setup& setup = record.recording.setup;
  MIROCUP_TRY(const auto rules, record::rules_with_changes(record::to_json(setup.rules),
                                                           options.rule_changes, setup.league));
  const auto judged = replay::rejudge(record.recording, rules);
  if (!judged && record::has_other_behaviour(record)) {
    return tl::unexpected(
        record::behaviour_mismatch(options.record_path, record, judged.error().tick));
  }
  if (!judged) {
    std::cerr << "mirocup: " << system::printable(options.record_path)
              << ": cannot be judged, it differs from tick " << judged.error().tick
              << " on: " << system::printable(judged.error().what) << '\n';
    return exit_no;
  }
  const std::vector<replay::Difference>& differences = *judged;

  Json list = Json::array();
  for (const replay::Difference& d : differences) {
    const match::LoggedDecision& any = d.given ? *d.given : *d.would_be;
    if (options.json) {
      list.push_back({{"tick", d.tick},
                      {"clock", any.decision.clock},
                      {"given", decision_json(d.given)},
                      {"would_be", decision_json(d.would_be)}});
    } else {
      std::cout << "tick " << d.tick << ", clock " << any.decision.clock << " s: given "
                << decision_text(d.given) << ", would be " << decision_text(d.would_be) << '\n';
    }
  }
  if (options.json) {
    std::cout << record::json_text({{"record", options.record_path},
                                    {"rules", record::to_json(rules)},
                                    {"differences", list}})
              << '\n';
  } else {
    std::cout
        << system::printable(options.record_path) << ": " << differences.size()
        << " decisions would differ; the course of the match itself is taken from the record\n";
  }
  return differences.empty() ? exit_yes : exit_no;
}

}  // namespace

void add_rejudge(system::Commands& commands) {
  const auto [command, o] =
      commands.add(run_rejudge, "rejudge", for_engineers,
                   "Judge a played match with other parameters, and list the calls that differ",
                   {"mirocup rejudge leg.json --rule stalemate_s=5"});
  command.option("RECORD", o.record_path, "Match record").required();
  command
      .option("--rule", o.rule_changes,
              "Change a parameter of the record's rules; may be given several times")
      .named("KEY=VALUE");
  command.flag("--json", o.json, "Print the answer as one JSON object");
}

}  // namespace mirocup::labs
