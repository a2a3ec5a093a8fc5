// SPDX-License-Identifier: MIT
//
// The statistics of recorded legs. A record holds no positions, so the leg is simulated again from
// its commands.
#pragma once

#include "core/replay/playback.hpp"
#include "record/match_record.hpp"
#include "record/statistics/statistics.hpp"

#include <optional>
#include <string>
#include <vector>

namespace mirocup::statistics {

// A leg and its statistics.
struct LegReport {
  std::string record;  // path of the record
  std::string leg;     // "r3-f1 leg 2" in a league; "" otherwise
  ByTeam<std::string> names{};
  ByTeam<int> played{};  // goals scored on the field, not changed by a forfeit or a ruling
  double control_period = 0.033;
  std::uint64_t state_hash = 0;
  LegStatistics statistics{};
  // The first difference of the record's decisions and outcome from the leg that was counted.
  std::optional<replay::Divergence> differs = {};
};

// Returns the report of a leg whose statistics are known.
LegReport report_of(const std::string& path, const record::MatchRecord& record,
                    LegStatistics statistics);

// Plays the leg again and counts its statistics. The error names the first tick that differs.
tl::expected<LegReport, replay::Divergence> count_leg(const std::string& path,
                                                      const record::MatchRecord& record);

// Reads the record, plays it again and counts. Errors are those of record::load(), and
// Errc::damaged, with the first different tick, for a record that is not reproduced.
Result<LegReport> count_record(system::Files& files, const std::string& path);

// Counts several records, on all processors, and returns the reports in the order of `paths`. The
// error is that of the first record with an error. Several threads use `files`.
Result<std::vector<LegReport>> count_records(system::Files& files,
                                             const std::vector<std::string>& paths);

// The sums over the legs of one team. A value that both teams of a leg share counts in the sums of
// both teams.
struct TeamTotals {
  std::string name;
  int legs = 0;
  TeamStatistics own;
  TeamStatistics against;  // the sums of the opponents in these legs
  double play_s = 0.0;
  double dead_ball_s = 0.0;
  int duels = 0;

  void add(const LegStatistics& leg, Team team);
};

// Returns the name under which a team of a leg is counted: its own name, with its colour if both
// teams have the same name.
std::string counted_name(const LegReport& leg, Team team);

// Returns the sums of all teams, in the order in which they first appear, blue first.
std::vector<TeamTotals> totals_of(const std::vector<LegReport>& legs);

}  // namespace mirocup::statistics
