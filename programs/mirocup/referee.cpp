// SPDX-License-Identifier: MIT
//
// mirocup referee TRACE.jsonl: reads one situation a line and prints one verdict a line, in the
// same order.
//
// mirocup referee --record FILE: judges a played match again, with other parameters.
#include "core/replay/rejudge.hpp"
#include "programs/mirocup/commands.hpp"
#include "record/json_fields.hpp"
#include "record/rules_json.hpp"
#include "record/traces/trace_verdict.hpp"

#include <sstream>

namespace mirocup::app {

namespace {

struct RefereeOptions {
  std::string trace_path;
  std::string record_path;
  std::vector<std::string> rule_changes;  // KEY=VALUE
  bool json = false;                      // verdicts on traces are JSON in any case
};

using record::Json;

// The situation's name, for its verdict; "" if it has none.
std::string id_of(const Json& json) {
  std::optional<record::JsonProblem> ignored;
  const auto id = record::JsonReader(json, "", ignored).find("id");
  return id && id->is_string() ? id->text() : "";
}

Result<int> judge_traces(const std::string& path) {
  system::Disk disk;
  MIROCUP_TRY(const auto text, disk.read_named(path, system::size_limit::trace));
  std::istringstream lines(text);
  std::string line;
  bool all_judged = true;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const record::ParsedJson parsed = record::parse_json(line);
    const Json& json = parsed.value;
    // A line with the results of a league is not a situation, but it is not an error either.
    if (json.is_object() && json.contains("results")) {
      print_json(traces::reject_trace(id_of(json), "a table of results is no situation"));
      continue;
    }
    const auto trace =
        parsed.problem ? Result<traces::Trace>(fail(
                             Errc::input, parsed.problem->pointer + ": " + parsed.problem->reason))
                       : traces::trace_from_json(json);
    if (!trace) {
      all_judged = false;
      std::cerr << system::printable(path) << ":" << number << ": "
                << system::printable(trace.error().what) << '\n';
      print_json(traces::reject_trace(id_of(json), trace.error().what));
      continue;
    }
    print_json(traces::judge_trace(*trace));
  }
  return all_judged ? exit_yes : exit_no;
}

Json decision_json(const std::optional<match::LoggedDecision>& logged) {
  if (!logged) return nullptr;
  return {{"decision", to_string(logged->decision.verdict)},
          {"law", to_string(logged->decision.law)},
          {"team", record::fields_json(logged->team)},
          {"reason", logged->decision.reason}};
}

std::string decision_text(const std::optional<match::LoggedDecision>& logged) {
  if (!logged) return "nothing";
  return std::string(to_string(logged->decision.verdict)) + " (" +
         std::string(to_string(logged->decision.law)) + ": " + logged->decision.reason + ")";
}

Result<int> judge_record(const RefereeOptions& options) {
  system::Disk disk;
  MIROCUP_TRY(const auto record, record::load(disk, options.record_path));
  const match::Setup& setup = record.recording.setup;
  MIROCUP_TRY(const auto rules, record::rules_with_changes(record::to_json(setup.rules),
                                                           options.rule_changes, setup.league));
  const auto judged = replay::rejudge(record.recording, rules);
  if (!judged) return not_reproduced(options.record_path, record, judged.error(), "judged");
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
    print_json({{"record", options.record_path},
                {"rules", record::to_json(rules)},
                {"differences", list}});
  } else {
    std::cout
        << system::printable(options.record_path) << ": " << differences.size()
        << " decisions would differ; the course of the match itself is taken from the record\n";
  }
  return differences.empty() ? exit_yes : exit_no;
}

Result<int> run_referee(const RefereeOptions& options) {
  if (!options.record_path.empty()) return judge_record(options);
  if (options.trace_path.empty()) return fail(Errc::input, "TRACE or --record is required");
  return judge_traces(options.trace_path);
}

}  // namespace

void add_referee(system::Commands& commands) {
  const auto [command, o] = commands.add(
      run_referee, "referee", for_engineers,
      "Judge recorded situations, or judge a played match with other parameters",
      {"mirocup referee trace.jsonl", "mirocup referee --record leg.json --rule stalemate_s=5"});
  const system::Option trace =
      command.option("TRACE", o.trace_path, "File of situations, one JSON object on each line");
  const system::Option record =
      command.option("--record RECORD", o.record_path, "Match record to judge again")
          .excludes(trace);
  command
      .option("--rule KEY=VALUE", o.rule_changes,
              "Change a parameter of the record's rules; may be given several times")
      .needs(record);
  command.flag("--json", o.json, "Print the answer as one JSON object");
}

}  // namespace mirocup::app
