// SPDX-License-Identifier: MIT
//
// mirocup referee TRACE.jsonl: one situation a line in, one verdict a line out, in the same order.
// mirocup referee --record FILE: a played match judged with other parameters.
#include "core/replay/rejudge.hpp"
#include "server/app/commands.hpp"
#include "server/record/match_record.hpp"
#include "server/record/rules_json.hpp"
#include "server/traces/trace_verdict.hpp"

#include <nlohmann/json.hpp>

#include <iostream>
#include <sstream>
#include <vector>

namespace mirocup::app {

namespace {

using Json = nlohmann::ordered_json;

std::string id_of(const Json& json) {
  const bool named = json.is_object() && json.contains("id") && json["id"].is_string();
  return named ? json["id"].get<std::string>() : "";
}

Result<int> judge_traces(const std::string& path) {
  system::Disk disk;
  const auto text = disk.read(path);
  if (!text) return tl::unexpected(text.error());
  std::istringstream lines(*text);
  std::string line;
  bool all_judged = true;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const Json json = Json::parse(line, nullptr, false);
    // A line of a league's results is no situation, and no mistake either.
    if (json.is_object() && json.contains("results")) {
      std::cout << traces::reject_trace(id_of(json), "a table of results is no situation").dump()
                << '\n';
      continue;
    }
    const auto trace = json.is_discarded()
                           ? Result<traces::Trace>(fail(Errc::input, "this is not JSON"))
                           : traces::trace_from_json(json);
    if (!trace) {
      all_judged = false;
      std::cerr << path << ":" << number << ": " << trace.error().what << '\n';
      std::cout << traces::reject_trace(id_of(json), trace.error().what).dump() << '\n';
      continue;
    }
    std::cout << traces::judge_trace(*trace).dump() << '\n';
  }
  return all_judged ? exit_yes : exit_no;
}

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

Result<int> judge_record(const RefereeOptions& options) {
  system::Disk disk;
  const auto record = record::load(disk, options.record_path);
  if (!record) return tl::unexpected(record.error());
  const match::Setup& setup = record->recording.setup;
  const auto rules =
      record::rules_with_changes(record::to_json(setup.rules), options.rule_changes, setup.league);
  if (!rules) return tl::unexpected(rules.error());
  const std::vector<replay::Difference> differences = replay::rejudge(record->recording, *rules);

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
    std::cout << Json{{"record", options.record_path},
                      {"rules", record::to_json(*rules)},
                      {"differences", list}}
                     .dump()
              << '\n';
  } else {
    std::cout << options.record_path << ": " << differences.size()
              << " decisions would differ, for the match as it was played\n";
  }
  return differences.empty() ? exit_yes : exit_no;
}

}  // namespace

Result<int> run_referee(const RefereeOptions& options) {
  if (!options.record_path.empty()) return judge_record(options);
  if (options.trace_path.empty()) return fail(Errc::input, "TRACE or --record is required");
  return judge_traces(options.trace_path);
}

}  // namespace mirocup::app
