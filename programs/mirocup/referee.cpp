// SPDX-License-Identifier: MIT
//
// mirocup referee TRACE.jsonl: reads one situation a line and prints one verdict a line, in the
// same order.
#include "programs/mirocup/commands.hpp"
#include "record/json_reader.hpp"
#include "record/traces/trace_verdict.hpp"
#include "system/printable.hpp"

#include <iostream>
#include <sstream>

namespace mirocup::app {

namespace {

struct RefereeOptions {
  std::string trace_path;
  bool json = false;  // verdicts are JSON in any case
};

using Json = nlohmann::ordered_json;

// The situation's name, for its verdict; "" if it has none.
std::string id_of(const Json& json) {
  std::optional<record::JsonProblem> ignored;
  const auto id = record::JsonReader(json, "", ignored).find("id");
  return id && id->is_string() ? id->text() : "";
}

void print(const Json& json) {
  std::cout << record::json_text(json) << '\n';
}

Result<int> run_referee(const RefereeOptions& options) {
  const std::string& path = options.trace_path;
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
      print(traces::reject_trace(id_of(json), "a table of results is no situation"));
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
      print(traces::reject_trace(id_of(json), trace.error().what));
      continue;
    }
    print(traces::judge_trace(*trace));
  }
  return all_judged ? exit_yes : exit_no;
}

}  // namespace

void add_referee(system::Commands& commands) {
  const auto [command, o] =
      commands.add(run_referee, "referee", for_engineers, "Judge recorded situations",
                   {"mirocup referee trace.jsonl"});
  command.option("TRACE", o.trace_path, "File of situations, one JSON object on each line")
      .required();
  command.flag("--json", o.json, "Print the answer as one JSON object");
}

}  // namespace mirocup::app
