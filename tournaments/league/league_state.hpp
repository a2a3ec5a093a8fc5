// SPDX-License-Identifier: MIT
//
// The state of a league, computed from league.json and the journal line by line; it is never
// stored. The schedule of a Swiss tournament, a knockout and a ladder grows with the results.
// Fixtures that have begun stay as they are; the others follow from the present results.
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

// The result of a decided leg, from its journal lines.
struct PlayedLeg {
  LegResult result;
  int winner = no_team;  // by goals, or by a shoot-out, which adds no goals
  LegEnd end = LegEnd::full_time;
  std::optional<LegFault> fault;  // the fault that ended it early
  std::string record;             // path inside the league folder; "" if it was not played
  std::string state_hash;
  std::string ruling;  // a person's decision with its reason; "" if there was none
};

struct LegState {
  std::shared_ptr<const PlayedLeg> played;  // null: not decided
  int voids = 0;                            // attempts that count for nothing
  int host_faults = 0;                      // those by a fault of the host since the last ruling
  int version = 1;  // number in its record's name: one more after each void not caused by the host
  bool awaits_confirmation = false;  // a team exceeded a time limit once; the next attempt counts
  std::shared_ptr<const std::string> void_ruling;  // a person's reason to replay it; null if none
};

struct FixtureState {
  Fixture fixture;
  std::array<LegState, max_legs> legs;
  bool is_annulled = false;  // true: it counts for nothing, because a team has left
  int counted_needed = 0;    // its share of LeagueState::legs()
  int counted_decided = 0;   // its share of LeagueState::played()

  // Returns the number of legs that this fixture needs by present results: a level tie needs one
  // more.
  int needed() const;
  int decided() const;
  bool is_decided() const;
  bool has_begun() const;
  int goals(int team) const;  // sum over all legs
};

// Whether the legs of a team are played.
enum class TeamStatus { playing, paused, withdrawn };

struct TeamState {
  TeamStatus status = TeamStatus::playing;
  int entry = 0;       // number of the entry that plays; 0: none yet
  std::string sha256;  // of that entry's library
  std::string why;     // reason for the pause or the withdrawal
  int strikes = 0;     // legs in a row that it lost by own faults
};

struct LeagueState {
  LeagueFile file;
  std::vector<FixtureState> fixtures;  // in the order of the schedule
  std::vector<TeamState> teams;        // as in the file
  bool is_started = false;
  std::string config_sha256;  // SHA-256 of league.json at the start

  // Numbers of the legs that the league needs by present results, and of those that are decided.
  int legs() const { return needed_; }
  int played() const { return decided_; }
  bool is_over() const;

  std::vector<LegResult> results() const;
  std::vector<TableRow> table() const;

  // Return the index of a fixture or a team; empty if there is none.
  std::optional<int> find_fixture(const std::string& id) const;
  std::optional<int> find_team(const std::string& name) const;
  const std::string& name(int team) const { return file.teams[team].name; }

  // Returns an index below which all fixtures are decided.
  int first_open() const { return first_open_; }

 private:
  friend class ScheduleGrowth;
  friend LeagueState new_league(LeagueFile file);

  int needed_ = 0;
  int decided_ = 0;
  int first_open_ = 0;
  int entries_ = 0;  // number of booked entries, which are the rounds of a ladder
  std::unordered_map<std::string, int> index_of_fixture_;
  std::unordered_map<std::string, int> index_of_team_;
};

// Returns the winner and the loser of a tie of a knockout. It is decided by goals over its legs,
// then by the extra leg, then by lot.
TieOutcome outcome(const LeagueState& state, const FixtureState& tie);

// Returns the team that is blue in a leg: the home team in the first, the away team in the second.
int blue_team(const Fixture& fixture, int leg);

}  // namespace mirocup::league
