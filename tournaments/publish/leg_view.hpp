// SPDX-License-Identifier: MIT
//
// The content of pages and exports: legs in the order of the schedule, table and strengths.
// Functions give the words for the end of a leg, for a fault and for the order of two teams.
#pragma once

#include "tournaments/league/league_state.hpp"
#include "tournaments/publish/leg_facts.hpp"
#include "tournaments/table/rating.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mirocup::league {

struct LegView {
  std::string fixture;  // the id of the fixture
  std::string round;    // "Round 3", "Group 2, round 1", "Semi-final"
  int leg = 1;          // from 1
  int home = 0;
  int away = 0;
  const PlayedLeg* played = nullptr;  // null: not decided
  const LegFacts* facts = nullptr;    // null: not known
  // The football statistics of a leg that counts; null: not known, or of another leg than the
  // journal has.
  const statistics::LegReport* report = nullptr;
  bool is_annulled = false;  // the leg counts for nothing, because a team has left
  bool is_pruned = false;    // the replay page was removed to save room

  // Returns the path of the leg's replay page: `root`, then the path from the top of the site; ""
  // if the leg has no page. With `at`, the link to the seconds before that moment, s since the leg
  // began, written with so many digits.
  std::string page(const std::string& root = "", double at = -1.0, int digits = 1) const;

  bool has_replay() const { return played != nullptr && !played->record.empty(); }
  // True if the leg's shoot-out was level, so that a lot chose its winner.
  bool is_by_lot() const;
  bool is_of(int team) const { return home == team || away == team; }
  // True if the leg counts for a team of it: the team plays with the entry that played.
  bool counts_for(int team) const;
  int other(int team) const { return team == home ? away : home; }
  bool is_blue(int team) const { return Fixture::is_home_blue(leg) == (team == home); }
  int goals(int team) const;
  int goals_against(int team) const { return goals(other(team)); }
  // Returns 'W', 'D' or 'L' for a team of a decided leg.
  char letter(int team) const;
};

// Wins, draws, losses and goals over some decided legs of a team.
struct LegTotals {
  int legs = 0;
  int won = 0;
  int drawn = 0;
  int lost = 0;
  int goals = 0;
  int against = 0;

  void add(const LegView& leg, int team);
  std::string score() const { return std::to_string(goals) + ":" + std::to_string(against); }
};

// The data from which a site is made, computed once. The state and the known legs must outlive the
// overview.
inline const KnownLegs no_known_legs;

struct Overview {
  const LeagueState& state;
  std::vector<TableRow> table;
  Ratings ratings;
  std::vector<LegView> legs;  // of the fixtures whose teams are known

  // For each team, the indexes of its decided legs in the order of the schedule.
  std::vector<std::vector<std::size_t>> decided_legs;
};
Overview overview(const LeagueState& state, const KnownLegs& known = no_known_legs);

// True if the statistics are of the leg that the journal has.
bool is_of(const statistics::LegReport& report, const PlayedLeg& leg);

// Returns the name of a fixture's round: "Final", "Semi-final", "Group 2, round 1", "Round 3".
std::string round_in_words(const LeagueState& state, const Fixture& fixture);

// Returns the end of a decided leg with its fault and its ruling: "forfeit: a: crash: ...; ruling:
// ...".
std::string end_in_words(const LeagueState& state, const LegView& leg);

// True if a lot decided a tie of a knockout: after a level shoot-out, or because no leg told the
// two teams apart.
bool is_by_lot(const Overview& overview, const FixtureState& tie);

// Returns a sentence for a fault, without its team.
std::string fault_in_words(const LegFault& fault);

// Returns "+3", "0" or "-3".
std::string with_sign(std::int64_t number);

// Returns a team's points per leg, such as "2.15"; "0.00" before the team's first leg.
std::string points_per_leg(const TableRow& row);

// Returns the rank of a row, "–" for an absent team.
std::string rank_in_words(const TableRow& row);

// Returns the reason why a row of the table is above the next row: "goal difference, +5 to +2"; ""
// for the last row, or if either team has not played. `next` is null for the last row.
std::string reason_in_words(const Overview& overview, const TableRow& row, const TableRow* next);
std::string reason_in_words(const Ratings& ratings, const TableRow& row, const TableRow* next);

// In a league that strengths rank: returns whether the strengths of a row and the next row differ
// beyond chance. Returns nothing in other leagues, for the last row, or if the next team is absent
// or has left.
std::optional<bool> is_decided(const LeagueState& state, const Ratings& ratings,
                               const TableRow& row, const TableRow* next);

// Returns how many legs between the teams of two neighbouring rows would tell the teams apart
// (legs_to_tell()): "120"; "—" for more than max_legs_to_tell; "" for the last row, or if the next
// team is absent.
std::string legs_to_tell_in_words(const Overview& o, const TableRow& row, const TableRow* next);

}  // namespace mirocup::league
