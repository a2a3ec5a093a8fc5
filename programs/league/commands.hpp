// SPDX-License-Identifier: MIT
//
// The subcommands of `mirocup league` and their options with defaults. command_line.cpp reads the
// options. Each function returns the exit code of an answer: exit_yes or exit_no. commands.cpp,
// entries.cpp, compare.cpp, keeping.cpp, nightly.cpp, rulings.cpp, serve.cpp, show.cpp, tokens.cpp,
// shards.cpp and credentials.cpp define them.
#pragma once

#include "core/base/error.hpp"
#include "record/statistics/report.hpp"
#include "tournaments/league/acts.hpp"
#include "tournaments/play/comparison_run.hpp"
#include "tournaments/publish/grades.hpp"
#include "tournaments/tune/tuning.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mirocup::league {

// Options of the subcommands that make, play and show a league; comments name the subcommands.
struct LeagueOptions {
  std::string folder;
  std::string config;              // init
  std::vector<std::string> teams;  // init: NAME=ENTRY
  std::string format;              // init
  double half_s = 0.0;             // init; duration of a half, seconds; 0: that of the rules
  std::uint64_t seed = 1;          // init
  std::string engine = "local";    // start
  int jobs = 0;                    // start; legs, then pages, at once; 0: one for each processor
  bool watched = false;            // start
  int dds_domain = 0;              // start; of the legs in which a team plays over DDS
  bool now = false;                // stop
  std::string output;              // export, publish
  std::string drills;              // export, grades: the output of mirocup drill --csv; "": none
  GradesLayout layout = GradesLayout::teams;  // grades
  std::string through;                        // publish: the last round shown; "": all rounds
  bool entries = false;                       // status
  bool another = false;                       // nightly: one more on the same day
  std::string on_night;                // nightly: a program that hears of the night; "": none
  std::string address;                 // nightly: what links of the digests' texts begin with
  bool accepts_other_program = false;  // start, nightly
  bool trusts_programs = false;        // verify
  bool json = false;
};
Result<int> run_init(const LeagueOptions& options);
Result<int> run_start(const LeagueOptions& options);
Result<int> run_stop(const LeagueOptions& options);
Result<int> run_status(const LeagueOptions& options);
Result<int> run_publish(const LeagueOptions& options);
Result<int> run_export(const LeagueOptions& options);
Result<int> run_nightly(const LeagueOptions& options);
Result<int> run_verify_league(const LeagueOptions& options);
Result<int> run_grades(const LeagueOptions& options);

// Options of `stats`, which `mirocup stats` starts for a league.
struct StatsOptions : statistics::ReportOptions {
  std::string folder;
};
Result<int> run_stats(const StatsOptions& options);

// Options of `serve`, which shows a league in browsers while it is played.
struct ServeOptions {
  std::string folder;
  std::string at = "0";  // [HOST:]PORT
  bool hand_in = false;  // take entries from teams with a token

  // With hand_in.
  int jobs = 0;                      // checks at once; 0: one for each processor
  std::vector<std::string> tls;      // files of certificate and key; empty: no encryption
  std::vector<std::string> proxies;  // addresses that are believed whom they speak for
  std::string team_header;           // in which they name a team; "": none is believed
};
Result<int> run_serve(const ServeOptions& options);

// Options of `show`, which plays the recorded legs of a round on a projector.
struct ShowOptions {
  std::string folder;
  std::string round;     // its key, as in "r3"; "": the last one of which a leg was played
  std::string at = "0";  // [HOST:]PORT
  int at_once = 1;       // legs side by side
};
Result<int> run_show(const ShowOptions& options);

// Options of `check-hand-in`, which `serve` starts for each check.
struct CheckHandInOptions {
  std::string folder;
  std::string team;
  int entry = 0;
  std::string file;
  std::int64_t at = 0;       // s since 1970
  int compile_seconds = 60;  // of processor time, for a source
};
Result<int> run_check_hand_in(const CheckHandInOptions& options);

// Options of `play-friendly`, which `serve` starts for each leg that counts for nothing.
struct PlayFriendlyOptions {
  std::string folder;
  std::string team;
  int number = 0;
  int entry = 0;
  std::string opponent;  // a team, or "house:NAME"
  int opponent_entry = 0;
};
Result<int> run_play_friendly(const PlayFriendlyOptions& options);

// Options of `token`, which makes and revokes the tokens by which teams hand in.
struct TokenOptions {
  std::string folder;
  std::string team;
  bool all = false;    // for each team of the league that has none
  bool staff = false;  // for those who run the league
  bool tutor = false;  // for those who only look
  bool csv = false;
  bool revoke = false;
  std::string expires;  // UTC; "": never
};
Result<int> run_token(const TokenOptions& options);

// Certificates for DDS Security.
struct CredentialsOptions {
  std::string folder;
  std::vector<std::string> teams;
  std::vector<std::string> revoked;
  int days = 365;
};
Result<int> run_credentials(const CredentialsOptions& options);

// Options of `plan` and `run-shard`, which play fixtures on other machines.
struct ShardOptions {
  std::string folder;
  std::vector<std::string> fixtures;
};
Result<int> run_plan(const ShardOptions& options);
Result<int> run_shards(const ShardOptions& options);

// Options of `submit`, which hands in entries.
struct SubmitOptions {
  std::string folder;
  std::string team;
  std::string file;
  std::string inbox;
  std::string run;  // the command of a firasim team; "": people start it
  std::string run_folder = ".";
  bool lockstep = false;  // of a firasim team
  bool json = false;
};
Result<int> run_submit(const SubmitOptions& options);

// Options of `owner`, which says whose files in a shared inbox count for a team.
struct OwnerOptions {
  std::string folder;
  std::string team;
  std::string user;      // name or number; "": print who it is
  bool is_free = false;  // the next user whose file is accepted is the owner
};
Result<int> run_owner(const OwnerOptions& options);

// Options of `compare`, which plays teams against each other until it can say which is better.
struct CompareOptions {
  ComparisonRun run;
  std::string league = "small";
  std::string against = "first";
  int most = 0;      // fixtures of a pair; 0: the default
  std::string keep;  // folder for the records; "": they are not kept
  bool json = false;
  bool csv = false;
};
inline constexpr int fixtures_of_a_table = 50;  // of each pair, by default

Result<int> run_compare(const CompareOptions& options);

struct TuneOptions {
  std::string team;                     // as in compare
  std::vector<std::string> parameters;  // KEY=LOW:HIGH
  std::vector<std::string> against;
  std::string league = "small";
  ComparisonRun run;  // half, conditions and jobs; the teams are filled in
  TuningOptions tuning;
  std::string folder = "tune";
  bool json = false;
};
Result<int> run_tune(const TuneOptions& options);

// What the staff decides.
struct ActOptions {
  std::string folder;
  Act act;
};
Result<int> run_act(const ActOptions& options);
Result<int> run_decisions(const LeagueOptions& options);

// Options of `backup`.
struct BackupOptions {
  std::string folder;
  std::string to;
};
Result<int> run_backup(const BackupOptions& options);

// Options of `team`, which says by what names people know the teams.
struct TeamOptions {
  std::string folder;
  std::string team;
  std::optional<std::string> display;
  std::vector<std::string> members;
  std::optional<std::string> colour;  // "#c03a2b"; "": none
  std::string csv;                    // a class list; "": one team
  bool is_removed = false;            // a team that was a mistake
};
Result<int> run_team(const TeamOptions& options);

}  // namespace mirocup::league
