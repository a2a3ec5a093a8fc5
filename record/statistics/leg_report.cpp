// SPDX-License-Identifier: MIT
#include "record/statistics/leg_report.hpp"

#include "core/replay/verification.hpp"
#include "record/statistics/counter.hpp"

#include <algorithm>
#include <utility>

namespace mirocup::statistics {

LegReport report_of(const std::string& path, const record::MatchRecord& record,
                    LegStatistics statistics) {
  return {.record = path,
          .leg = "",
          .names = {record.teams[0].name, record.teams[1].name},
          .played = record.recording.outcome.played,
          .control_period = record.recording.setup.control_period,
          .state_hash = record.recording.state_hash,
          .statistics = std::move(statistics)};
}

tl::expected<LegReport, replay::Divergence> count_leg(const std::string& path,
                                                      const record::MatchRecord& record) {
  replay::Playback playback(record.recording);
  LegCounter counter(playback.leg());
  while (playback.advance()) counter.add(playback.leg());
  if (playback.divergence()) return tl::unexpected(*playback.divergence());
  LegReport report = report_of(path, record, counter.statistics());
  report.differs = replay::compare_results(record.recording, playback.leg());
  return report;
}

Result<LegReport> count_record(system::Files& files, const std::string& path) {
  MIROCUP_TRY(const auto record, record::load(files, path));
  auto report = count_leg(path, record);
  const bool differs = report && report->differs;
  if (report && !(differs && record::has_other_behaviour(record))) return *std::move(report);
  const replay::Divergence& first = differs ? *report->differs : report.error();
  if (record::has_other_behaviour(record)) {
    return tl::unexpected(record::behaviour_mismatch(path, record, first.tick));
  }
  return fail(Errc::damaged, path + ": has no statistics, since it is not reproduced from tick " +
                                 std::to_string(first.tick) + " on: " + first.what);
}

void TeamTotals::add(const LegStatistics& leg, Team team) {
  ++legs;
  own += leg.teams[index_of(team)];
  against += leg.teams[index_of(opponent_of(team))];
  play_s += leg.play_s;
  dead_ball_s += leg.dead_ball_s;
  duels += leg.duels;
}

std::string counted_name(const LegReport& leg, Team team) {
  const std::string& name = leg.names[index_of(team)];
  if (leg.names[0] != leg.names[1]) return name;
  return name + " (" + std::string(to_string(team)) + ")";
}

std::vector<TeamTotals> totals_of(const std::vector<LegReport>& legs) {
  std::vector<TeamTotals> totals;
  for (const LegReport& leg : legs) {
    for (const Team team : both_teams) {
      const std::string name = counted_name(leg, team);
      auto found = std::ranges::find(totals, name, &TeamTotals::name);
      if (found == totals.end()) {
        totals.emplace_back().name = name;
        found = totals.end() - 1;
      }
      found->add(leg.statistics, team);
    }
  }
  return totals;
}

}  // namespace mirocup::statistics
