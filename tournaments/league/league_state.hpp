// SPDX-License-Identifier: MIT
//
// Where a league stands: its file and its journal, put together line by line. Derived, never
// written. The schedule of a Swiss tournament, a knockout and a ladder grows with the results; what
// has begun stays as it is, what has not follows from the results as they are now.
#pragma once

#include "tournaments/format/league_file.hpp"
#include "tournaments/format/schedule.hpp"
#include "tournaments/league/event.hpp"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace mirocup::league {

// A leg that is decided, from its journal lines.
struct PlayedLeg {
  LegResult result;
  int winner = no_team;  // also of a shoot-out, which is no goals
  LegEnd end = LegEnd::full_time;
  std::optional<LegFault> fault;  // that ended it early
  std::string record;             // path inside the league folder; "" if it was not played
  std::string state_hash;
  std::string ruling;  // what a person decided and why; ""
};

struct LegState {
  std::shared_ptr<const PlayedLeg> played;  // null: not decided
  int voids = 0;                            // attempts that count for nothing
  int host_faults = 0;                      // of these, that the host spoiled since the last ruling
  int version = 1;  // of its record: one more after each that was decided to count for nothing
  bool awaits_confirmation = false;  // a loss by a clock was seen; the next attempt counts
  std::shared_ptr<const std::string> void_ruling;  // why a person had it played again; null
};

struct FixtureState {
  Fixture fixture;
  std::array<LegState, max_legs> legs;
  bool is_annulled = false;  // counts for nothing: a team has left
  int counted_needed = 0;    // its part in the league's sums
  int counted_decided = 0;

  // Legs that this fixture needs, as far as is known: a level tie needs one more.
  int needed() const;
  int decided() const;
  bool is_decided() const;
  bool has_begun() const;
  int goals(int team) const;  // over all legs
};

// What a team is allowed.
enum class TeamStatus { playing, paused, withdrawn };

struct TeamState {
  TeamStatus status = TeamStatus::playing;
  int entry = 0;       // that plays; 0: none yet
  std::string sha256;  // of it
  std::string why;     // paused or withdrawn
  int strikes = 0;     // legs in a row lost by own faults
};

struct LeagueState {
  LeagueFile file;
  std::vector<FixtureState> fixtures;  // in the order of the schedule
  std::vector<TeamState> teams;        // as in the file
  bool is_started = false;
  std::string config_sha256;  // as the league was started

  int legs() const { return needed_; }
  int played() const { return decided_; }
  bool is_over() const;

  std::vector<LegResult> results() const;
  std::vector<TableRow> table() const;

  // Index of a fixture or a team, or nothing.
  std::optional<int> find_fixture(const std::string& id) const;
  std::optional<int> find_team(const std::string& name) const;
  const std::string& name(int team) const { return file.teams[team].name; }

  // The first fixture that may have something left to play.
  int first_open() const { return first_open_; }

 private:
  friend class ScheduleGrowth;
  friend LeagueState new_league(LeagueFile file);

  int needed_ = 0;
  int decided_ = 0;
  int first_open_ = 0;
  int entries_ = 0;  // booked so far: rounds of a ladder
  std::unordered_map<std::string, int> index_of_fixture_;
  std::unordered_map<std::string, int> index_of_team_;
};

// Who won a tie of a knockout: more goals over its legs; then the leg that decides; then a lot.
TieOutcome outcome(const LeagueState& state, const FixtureState& tie);

// Which team is blue in a leg: the home team in the first, the away team in the second.
int blue_team(const Fixture& fixture, int leg);

}  // namespace mirocup::league
