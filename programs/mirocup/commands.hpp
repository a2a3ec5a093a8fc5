// SPDX-License-Identifier: MIT
//
// The subcommands of `mirocup`, one source each, and their options. command_line.cpp fills the
// options; their defaults are here. A run returns the exit code of an answer, exit_yes or exit_no,
// or an error.
#pragma once

#include "core/base/error.hpp"
#include "core/match/leg.hpp"
#include "record/statistics/report.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mirocup::app {

struct MatchOptions {
  match::ByTeam<std::string> teams;
  match::ByTeam<std::string> names;  // in the record; "": the team's own name
  std::string league;                // "": small, or that of the situation
  std::string rules = "mirosot";
  std::string stage = "group";
  std::uint64_t seed = 1;
  std::string speed;  // "": real time if it is watched, otherwise "max"
  std::optional<std::string>
      watch;               // address of the live page: PORT, HOST:PORT, or "" for any port
  std::string start_path;  // of a situation; "": the leg starts with its kick-off
  std::string from_path;   // of the record to play on from; "": none
  std::optional<std::uint32_t> tick;  // of that record
  bool calls = false;                 // print them
  std::optional<double> half_s;
  std::vector<std::string> rule_changes;       // KEY=VALUE
  std::string conditions;                      // a preset; "": those of the pitch, or the default
  std::string pitch;                           // --pitch; "": mirosot
  std::vector<std::string> condition_changes;  // KEY=VALUE
  std::vector<std::string> parameters;         // of both teams, KEY=VALUE
  match::ByTeam<std::vector<std::string>> own_parameters;  // of one team; they win
  std::string record_path;
  bool thoughts = false;  // keep what the teams draw
  bool trusted = false;
  std::string isolation;  // "": the strongest that this system allows
  std::string match_id = "1";
  std::string interface = "lo";
  int dds_domain = 0;
  double join_within = 60.0;         // s that a DDS team has to join
  std::optional<double> away_limit;  // s that a team on the network may be absent
  std::string credentials;
  bool hash = false;  // print the state hash, too
  // Addresses of firasim teams; "": those of the instance.
  std::string firasim_vision, firasim_command, firasim_referee, firasim_placement;
  std::string firasim_instance = "0";   // a number, or "auto"
  match::ByTeam<std::string> programs;  // commands that start firasim teams; "": people do
  bool lockstep = false;  // firasim teams are waited for even where real time is asked for
  bool json = false;
};
Result<int> run_match(const MatchOptions& options);

struct DrillOptions {
  std::string drill;                    // "list", "all", a name, or the path of a file or a folder
  std::vector<std::string> teams;       // as --blue
  std::optional<int> tries;             // nothing: as each drill says
  std::uint64_t seed = 1;               // of the first try
  int jobs = 0;                         // tries at once; 0: one for each processor
  std::vector<std::string> parameters;  // of the teams, KEY=VALUE
  std::string replay_folder;            // for records and pages of failed tries; "": none
  std::optional<double> at_least;       // the score that is asked for; less: the answer is no
  bool csv = false;
  bool json = false;
};
Result<int> run_drill(const DrillOptions& options);

struct CheckOptions {
  std::string path;
  std::string league = "small";
  std::string rules = "mirosot";
  std::optional<double> half_s;         // of the legs that the entry is for
  std::vector<std::string> parameters;  // KEY=VALUE
  std::string record_path;              // of a leg against striker; "": none is written
  bool json = false;
  bool steps = false;  // print each check on standard error before it runs
};
Result<int> run_check(const CheckOptions& options);

struct CompileOptions {
  std::string path;
  std::string output;
  std::string language;   // "c", "c++", "project"; "": by the name of the file
  double seconds = 60.0;  // of processor time
  bool json = false;
};
Result<int> run_compile(const CompileOptions& options);

struct HandInOptions {
  std::string url;  // of the league
  std::string path;
  std::string token_file;
  std::string pin;        // "N" or "latest": no file is sent, and that entry plays; "": a file is
  std::string authority;  // file of the certificate that signs for the server; "": the system's
  bool json = false;
};
Result<int> run_hand_in(const HandInOptions& options);

struct JoinOptions {
  std::string match_id;
  std::string team;
  std::string name;
  std::string library;
  std::string server = "127.0.0.1";
  int dds_domain = 0;
  std::string credentials;
  double join_within = 60.0;            // s to wait for the match
  std::vector<std::string> parameters;  // KEY=VALUE
};
Result<int> run_join(const JoinOptions& options);

struct CompletionOptions {
  std::string shell;
};
Result<int> run_completion(const CompletionOptions& options);

struct ExportOptions {
  std::string policy;  // the path of a mirocup/policy/1
  std::string output;  // of the source
};
Result<int> run_export(const ExportOptions& options);

struct NewOptions {
  std::string simurosot;  // folder with the sources of an old team; "": a new team
  std::string folder;
  std::string language = "c++";
};
Result<int> run_new(const NewOptions& options);

struct VerifyOptions {
  std::string path;
  bool json = false;
};
Result<int> run_verify(const VerifyOptions& options);

struct RerunOptions {
  std::string record;
  std::string entries;  // folder of libraries; "": the entries of the league of the record
  bool json = false;
};
Result<int> run_rerun(const RerunOptions& options);

struct ReplayOptions {
  std::string record;
  std::string output;
  std::optional<double> at;  // s since the match began
  bool svg = false;
  std::string clip;  // "12:18", seconds since the match began; "": none
  bool no_times = false;
  bool public_page = false;  // without what only the teams may see
  std::string statistics;    // file for the statistics of the leg; "": none
  bool open = false;         // in a browser
};
Result<int> run_replay(const ReplayOptions& options);

struct StatsOptions : statistics::ReportOptions {
  std::vector<std::string> paths;  // records, or the folder of a league
};
Result<int> run_stats(const StatsOptions& options);

struct RecordAsSeenOptions {
  std::string record;
  std::string output;
  double noise_mm = 2.0;
  double noise_deg = 1.0;
  double gaps = 0.02;  // shares
  double outliers = 0.01;
  std::uint64_t seed = 1;
};
Result<int> run_record_as_seen(const RecordAsSeenOptions& options);

struct IdentifyOptions {
  std::vector<std::string> recordings;
  std::string pitch = "mirosot";  // from which the search begins
  std::string output;
  std::string page;  // "": none
  bool json = false;
};
Result<int> run_identify(const IdentifyOptions& options);

struct ValidateOptions {
  std::vector<std::string> recordings;
  std::string pitch = "mirosot";
  std::string page;     // "": none
  std::string against;  // another engine; "": none
  bool json = false;
};
Result<int> run_validate(const ValidateOptions& options);

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
  bool json = false;                      // verdicts on traces are JSON in any case
};
Result<int> run_referee(const RefereeOptions& options);

// `mirocup league …` and `mirocup tune …` are the program mirocup-league, and `mirocup bench …` and
// `mirocup validate --against …` are mirocup-bench: runs the program of that name in the place of
// this process, with the arguments from argv[first] on. Returns only if it cannot be run.
Result<int> become_sibling_program(const std::string& name, int argc, char** argv, int first = 2);

}  // namespace mirocup::app
