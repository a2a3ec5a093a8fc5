// SPDX-License-Identifier: MIT
//
// mirocup validate: how far the simulator is from recordings of a pitch.
#include "labs/pitch/report.hpp"
#include "labs/programs/commands.hpp"

#include <iostream>

namespace mirocup::labs {

namespace {

struct ValidateOptions {
  std::vector<std::string> recordings;
  std::string pitch = "mirosot";
  std::string page;     // "": none
  std::string against;  // another engine; "": none
  bool json = false;
};

// Only mirocup-bench is linked to other engines.
Result<int> validate_against_peer(const ValidateOptions& options) {
  std::vector<std::string> words{"validate", "--against", options.against, "--pitch",
                                 options.pitch};
  if (!options.page.empty()) words.insert(words.end(), {"-o", options.page});
  if (options.json) words.push_back("--json");
  words.push_back("--");
  words.insert(words.end(), options.recordings.begin(), options.recordings.end());
  return tl::unexpected(become_bench(std::move(words)));
}

Result<int> run_validate(const ValidateOptions& options) {
  if (!options.against.empty()) return validate_against_peer(options);
  MIROCUP_TRY(
      const auto report,
      pitch::report_of({options.recordings, options.pitch, options.page, options.json}, nullptr));
  std::cout << report.text;
  return report.is_worse ? exit_no : exit_yes;
}

}  // namespace

void add_validate(system::Commands& commands) {
  const auto [command, o] = commands.add(
      run_validate, "validate", for_engineers,
      "Print how well the simulator predicts recordings 1 to 30 pictures ahead, and how well "
      "simple yardsticks do (exit code 1: a yardstick is better)",
      {"mirocup validate seen.jsonl --pitch ours.json -o validation.html"});
  command.option("RECORDING", o.recordings, "Recordings (mirocup/recording/1, or .csv)").required();
  command.option("--pitch NAME|FILE", o.pitch, "Pitch to simulate with").shows_default();
  command.option("-o,--page FILE", o.page, "File to write a page with pictures to");
  command.option("--against ENGINE", o.against,
                 "Another engine as a further yardstick, if mirocup-bench is built with it: box2d, "
                 "chipmunk or ode");
  command.flag("--json", o.json, "Print one JSON object");
}

}  // namespace mirocup::labs
