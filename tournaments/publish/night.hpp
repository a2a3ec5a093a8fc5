// SPDX-License-Identifier: MIT
//
// The digest of a night: for each team the changes of its rank and strength since the night before,
// the opponents to which it lost, and its worst moments. A pure function of the journal, the state
// and the facts of the legs.
#pragma once

#include "tournaments/journal/journal.hpp"
#include "tournaments/publish/leg_view.hpp"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace mirocup::league {

// A night of the journal: from its line to the line of the next night, or to the end of the
// journal.
struct Night {
  int number = 0;
  std::string at;                 // start of the night, UTC; "" if its line has no time
  LeagueState before;             // the league before the night's line
  std::set<std::string> records;  // paths of the night's records inside the league folder
};

// Returns the last night of a league; nothing if the league has had no night. `shown` is the state
// that pages show; `journal` may have later nights. Errors: Errc::damaged.
Result<std::optional<Night>> last_night(const LeagueState& shown, const Journal& journal);

// A moment that a team should look at.
struct WorstMoment {
  std::string what;  // "own goal of robot 0, 1:2 against tiger"
  const LegView* leg = nullptr;
  double at = -1.0;       // s since the leg began; negative: not known
  std::string when = {};  // "second half 0:10"; "": the end of the leg
  int weight = 0;         // the worst moment has the greatest weight
};

struct TeamDigest {
  int team = 0;
  int rank = 0;
  int rank_before = 0;                      // 0: the team had not played
  std::optional<Strength> strength;         // empty: no leg of its entry counts
  std::optional<Strength> strength_before;  // empty: the team had not played
  int entry = 0;                            // the entry that plays; 0: none
  bool has_new_entry = false;               // true: the entry is new since the night before
  LegTotals legs;                           // of the night
  std::vector<const LegView*> losses;
  std::vector<WorstMoment> moments;  // at most three, the worst first
  // What the team should know of its hand-ins, sentences; only for the team: texts and JSON have
  // them, pages do not.
  std::vector<std::string> hand_ins = {};
};

// Returns the digests of all teams, in the order of the table. `now` has the facts of the legs, and
// must outlive the digests.
std::vector<TeamDigest> digests(const Night& night, const Overview& now);

}  // namespace mirocup::league
