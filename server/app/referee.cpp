// SPDX-License-Identifier: MIT
//
// mirocup referee TRACE.jsonl: one situation a line in, one verdict a line out, in the same order.
#include "server/app/commands.hpp"
#include "server/record/files.hpp"
#include "server/record/trace_verdict.hpp"

#include <iostream>
#include <memory>
#include <sstream>

namespace mirocup::app {

namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string path;
  bool json = true;  // a verdict is one object a line, asked for or not
};

std::string id_of(const Json& json) {
  const bool named = json.is_object() && json.contains("id") && json["id"].is_string();
  return named ? json["id"].get<std::string>() : "";
}

Result<int> judge_traces(const std::string& path) {
  record::Disk disk;
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
      std::cout << record::reject_trace(id_of(json), "a table of results is no situation").dump()
                << '\n';
      continue;
    }
    const auto trace = json.is_discarded()
                           ? Result<record::Trace>(fail(Errc::input, "this is not JSON"))
                           : record::trace_from_json(json);
    if (!trace) {
      all_judged = false;
      std::cerr << path << ":" << number << ": " << trace.error().what << '\n';
      std::cout << record::reject_trace(id_of(json), trace.error().what).dump() << '\n';
      continue;
    }
    std::cout << record::judge_trace(*trace).dump() << '\n';
  }
  return all_judged ? exit_yes : exit_no;
}

}  // namespace

void add_referee(CLI::App& app, Run& run) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("referee", "Judge recorded situations");
  command->add_option("TRACE", options->path, "situations, one line of JSON each")->required();
  command->add_flag("--json", options->json,
                    "verdicts are one JSON object a line with or without it");
  command->callback([options, &run] { run = [options] { return judge_traces(options->path); }; });
}

}  // namespace mirocup::app
