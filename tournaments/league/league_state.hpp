// SPDX-License-Identifier: MIT
//
// The state of a league: its league.json and all events of its journal, applied in order
// (apply.hpp). The state is derived and never stored. The schedule of a Swiss tournament, a
// knockout and a ladder grows with the results: fixtures that have begun stay, and later fixtures
// follow from the present results.
#pragma once

#include "record/match_record.hpp"
#include "tournaments/format/knockout.hpp"
#include "tournaments/format/league_file.hpp"
#include "tournaments/format/schedule.hpp"
#include "tournaments/league/event.hpp"
#include "tournaments/table/rating.hpp"

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

namespace mirocup::league {

// The most attempts at a leg that may fail because of the host. Then the leg waits for the next
// start of the program, so that a person can repair the host first.
inline constexpr int max_attempts = 3;

// The result of a decided leg.
struct PlayedLeg {
  LegResult result;
  int winner = no_team;  // by goals or a shoot-out; no_team after a draw
  LegEnd end = LegEnd::full_time;
  std::optional<LegFault> fault;  // the fault that ended the leg early
  std::string record;             // path inside the league folder; "" if the leg was not played
  std::string state_hash;
  std::string ruling;  // the published reason of a person's decision; "" if there is none
};

struct LegState {
  std::shared_ptr<const PlayedLeg> played;  // null: not decided
  int voids = 0;                            // number of attempts that count for nothing
  int host_faults = 0;                      // attempts that the host spoiled since the last ruling
  // Number of the next record, from 1. An attempt that the host spoiled leaves no record to keep,
  // so its number is used again, unless the record was there and differed from its replay.
  int version = 1;
  int new_seeds = 0;                 // how often the leg was voided with a new seed
  bool awaits_confirmation = false;  // a team exceeded a time limit; the next attempt counts
  // Why a person voided the leg; null: no person did.
  std::shared_ptr<const std::string> void_ruling;
};

struct FixtureState {
  Fixture fixture;
  std::array<LegState, max_legs> legs;
  bool is_annulled = false;  // the fixture counts for nothing, because a team has left
  // The outcome of a knockout tie that was decided because a team had left. The outcome stays if
  // the other team also leaves.
  std::optional<TieOutcome> walkover;
  int counted_needed = 0;   // needed() as last added to the league's count
  int counted_decided = 0;  // decided() as last added to the league's count

  // The number of legs that the fixture needs by present results (a level tie needs one more), and
  // the number of its decided legs.
  int needed() const;
  int decided() const;
  bool is_decided() const;
  bool has_begun() const;
  int goals(int team) const;  // of a team in all legs together
};

enum class TeamStatus { playing, paused, withdrawn };

struct TeamState {
  TeamStatus status = TeamStatus::playing;
  int entry = 0;       // the number of the entry that plays; 0: none yet
  std::string sha256;  // of the library of this entry
  std::string why;     // the reason why the team is paused or has withdrawn
  int strikes = 0;     // legs in a row that the team lost by its own faults
};

// A decision of a person: LegVoided, Ruled, Withdrawn, Paused, Resumed, Frozen, Closed, Released or
// Undone.
struct Decision {
  Event event;
  int line = 0;           // number of the decision's line in the journal; 0: not known
  std::string what = {};  // the value before the decision: "was 2:1"; may be ""
  // The later decision that ended this decision's effect, as an index of LeagueState::decisions: a
  // decision on the same leg, a withdrawal that removes the leg, the end of a pause, or Undone.
  std::optional<std::size_t> undone_by;
};

struct LeagueState {
  LeagueFile file;
  std::vector<FixtureState> fixtures;  // in the order of the schedule
  std::vector<TeamState> teams;        // in the order of file.teams; late joiners come last
  std::vector<Decision> decisions;     // decisions of persons, in the order of the journal
  bool is_started = false;
  bool is_closed = false;
  std::string closing_round;     // as Closed::closing_round
  std::string config_sha256;     // of league.json when the league was started
  match::Conditions conditions;  // of the league's legs, once the league has started
  record::Software program;      // the program with which the league was started

  // The round of a Swiss tournament that is not played because every pairing repeats a meeting; 0:
  // none.
  int unpaired_round = 0;

  std::vector<NightBegan> nights;
  std::optional<std::string> freeze;  // from the last event Frozen; empty: as in league.json
  std::map<std::string, std::string> extensions;  // team: until when it may hand in, UTC
  Released release;  // the last event Released; the default shows all rounds

  // The names that pages show, in the order of the teams; empty: the names in league.json.
  std::vector<std::string> shown_names;

  // The nights whose legs no longer have replay pages. Their records stay.
  std::set<int> pruned_nights;

  // The host's notice on the front page, lines of text; "": none.
  std::string notice;

  // The number of legs that the league needs by present results, and the number of decided legs.
  int legs() const { return needed_; }
  int played() const { return decided_; }
  bool is_over() const;

  std::vector<LegResult> results() const;

  // Returns the strengths, from the legs that were played and count. In a league that takes entries
  // they are those of the present entries; absent teams have none. `further` are fixtures between
  // present entries that are not in the table.
  Ratings ratings(const std::vector<FixtureResults>& further = {}) const;

  // Returns the table. `ratings` are those of this state; they rank a league that takes entries.
  std::vector<TableRow> table(const Ratings& ratings) const;
  std::vector<TableRow> table() const;
  // Returns the table of a group, from 0.
  std::vector<TableRow> group_table(int group) const;

  // Returns the index of a fixture or a team; nothing if none has the name.
  std::optional<int> find_fixture(const std::string& id) const;
  std::optional<int> find_team(const std::string& name) const;
  const std::string& name(int team) const { return file.teams[team].name; }

  // Returns the name that pages show for a team.
  const std::string& shown_name(int team) const {
    return shown_names.empty() ? name(team) : shown_names[team];
  }

  // Converts the name of a team in league.json to the name that pages show; any other text stays
  // unchanged.
  std::string shown_name_of(const std::string& team) const;

  // Returns the time from which the league takes no entry, UTC; "": the format alone decides.
  const std::string& frozen_from() const { return freeze ? *freeze : file.freeze; }
  // The same for one team, which may have an extension.
  const std::string& frozen_from(const std::string& team) const;

  // All fixtures before this index are decided.
  int first_open() const { return first_open_; }

 private:
  friend class ScheduleGrowth;
  friend LeagueState unplanned_league(LeagueFile file);

  int needed_ = 0;
  int decided_ = 0;
  int first_open_ = 0;
  int entries_ = 0;  // number of entries booked so far; the present round of a ladder
  std::unordered_map<std::string, int> index_of_fixture_;
  std::unordered_map<std::string, int> index_of_team_;
};

// Returns who won a tie of a knockout: the team with more goals over all its legs, then the winner
// of the shoot-out of the deciding leg, then the winner of a lot, drawn with the seed of the
// fixture. If a tie was not played, a team that has left loses it.
TieOutcome outcome(const LeagueState& state, const FixtureState& tie);

// Returns why the rounds of a Swiss tournament ended early, a sentence; "" if they did not.
std::string unpaired_in_words(const LeagueState& state);

}  // namespace mirocup::league
