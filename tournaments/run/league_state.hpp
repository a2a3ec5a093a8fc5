// SPDX-License-Identifier: MIT
//
// Where a league stands: its file and its journal, put together. Derived, never written.
#pragma once

#include "tournaments/format/league_file.hpp"
#include "tournaments/format/schedule.hpp"
#include "tournaments/journal/journal.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace mirocup::league {

// A leg that was played, from its journal line.
struct PlayedLeg {
  LegResult result;
  std::string end;     // as in the record: "full_time", "forfeit", ...
  std::string fault;   // "team: code: text" or ""
  std::string record;  // path inside the league folder
  std::string state_hash;
};

struct FixtureState {
  Fixture fixture;
  std::array<std::optional<PlayedLeg>, legs_per_fixture> legs;
  std::array<int, legs_per_fixture> voids{};  // attempts that the host lost
};

struct LeagueState {
  LeagueFile file;
  std::vector<FixtureState> fixtures;  // in the order of the schedule
  bool is_started = false;
  std::string config_sha256;  // as the league was started

  int legs() const { return legs_per_fixture * static_cast<int>(fixtures.size()); }
  int played() const;
  std::vector<LegResult> results() const;
  std::vector<Row> table() const;
};

// Errors: Errc::damaged if the journal names what the schedule does not have.
Result<LeagueState> league_state(LeagueFile file, const Journal& journal);

// A leg's journal line, from its two teams and what its record says.
Json leg_line(const LeagueFile& file, const Fixture& fixture, int leg, int attempt,
              const Json& record, const std::string& record_path);

// Which team is blue in a leg: the home team in the first.
int blue_team(const Fixture& fixture, int leg);

}  // namespace mirocup::league
