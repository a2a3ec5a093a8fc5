// SPDX-License-Identifier: MIT
//
// The subcommands of `mirocup`, one source each, and what each may be told. command_line.cpp reads
// the options; their defaults are here. The value of a run is the exit code of an answer (yes or no).
#pragma once

#include "core/base/error.hpp"
#include "core/match/leg.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mirocup::app {

struct MatchOptions {
  match::ByTeam<std::string> teams;
  match::ByTeam<std::string> names;  // "": the team's own
  std::string league = "small";
  std::string rules = "mirosot";
  std::string stage = "group";
  std::uint64_t seed = 1;
  std::string speed;                 // "": real time if it is watched, else as fast as it goes
  std::optional<std::string> watch;  // where: PORT or HOST:PORT, "" for any port
  std::optional<double> half_s;
  std::vector<std::string> rule_changes;  // KEY=VALUE
  std::string record_path;
  bool trusted = false;
  std::string isolation;  // "": the strongest that there is
  std::string match_id = "1";
  std::string interface = "lo";
  double join_within = 60.0;
  double away_limit = 10.0;
  std::string credentials;
  bool json = false;
};
Result<int> run_match(const MatchOptions& options);

struct CheckOptions {
  std::string path;
  std::string league = "small";
  bool json = false;
};
Result<int> run_check(const CheckOptions& options);

struct JoinOptions {
  std::string match_id;
  std::string team;
  std::string name;
  std::string library;
  std::string server = "127.0.0.1";
  std::string credentials;
  double join_within = 60.0;  // s to wait for the match
};
Result<int> run_join(const JoinOptions& options);

struct NewOptions {
  std::string folder;
};
Result<int> run_new(const NewOptions& options);

struct VerifyOptions {
  std::string path;
  bool json = false;
};
Result<int> run_verify(const VerifyOptions& options);

struct RerunOptions {
  std::string record;
  std::string entries;  // "": those of the league that the record lies in
  bool json = false;
};
Result<int> run_rerun(const RerunOptions& options);

struct ReplayOptions {
  std::string record;
  std::string output;
  std::optional<double> at;  // s since the match began
  bool svg = false;
  bool no_times = false;
};
Result<int> run_replay(const ReplayOptions& options);

struct SceneOptions {
  std::string path;
  std::string accuracy = "standard";
  std::string out;  // "": standard output
  bool json = false;
};
Result<int> run_scene(const SceneOptions& options);

struct RefereeOptions {
  std::string trace_path;
  std::string record_path;
  std::vector<std::string> rule_changes;  // KEY=VALUE
  bool json = false;                      // verdicts on traces are, asked for or not
};
Result<int> run_referee(const RefereeOptions& options);

// `mirocup league …` is the program mirocup-league and `mirocup bench …` is mirocup-bench: runs the
// program of that name in the place of this process, with the arguments behind argv[1]. Returns only
// if it cannot be run.
Result<int> become_sibling_program(const std::string& name, int argc, char** argv);

}  // namespace mirocup::app
