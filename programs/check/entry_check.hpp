// SPDX-License-Identifier: MIT
//
// Checks whether a library would be accepted as an entry: inspects the file, then plays trial legs
// in the sandbox.
#pragma once

#include "core/base/error.hpp"
#include "core/match/team_parameters.hpp"
#include "core/referee/rules.hpp"
#include "core/replay/recording.hpp"
#include "plugins/host/sandbox/isolation.hpp"
#include "programs/check/strength.hpp"
#include "system/processor.hpp"

#include <optional>

namespace mirocup::app {

// One check and its result.
struct Check {
  std::string name = {};            // for scripts: "file", "complete", ...
  std::optional<bool> passed = {};  // empty: not run, because an earlier check failed
  std::string text = {};            // the finding; after a failure, a sentence with a remedy
  // After a failure: the finding, the place in the file or the leg, and the remedy.
  std::string what = {}, where = {}, cure = {};
  std::string cause = {};  // match::Fault::cause, if the entry's process has failed
};

// Behaviour that is allowed but hardly intended.
struct Note {
  std::string code;  // for scripts: "own_goals", "bad_values", ...
  std::string text;  // a sentence
};

struct EntryReport {
  std::string sha256;  // "" if the file cannot be an entry
  plugins::Isolation isolation = plugins::Isolation::T2;
  std::vector<Check> checks;
  double start_ms = 0.0;                     // processor time to load and create the team
  double mean_tick_ms = 0.0;                 // processor time
  double slowest_tick_ms = 0.0;              // processor time
  double leg_seconds = 0.0;                  // processor time that a leg of full length would take
  double leg_share = 0.0;                    // leg_seconds / the time that a team has in such a leg
  std::size_t peak_memory = 0;               // bytes
  double used_seconds = 0.0;                 // use of the check, as CheckPlan counts
  match::TeamParameters unknown_parameters;  // given parameters for which the team never asked
  std::array<BadSpeeds, 2> bad_speeds;       // of all legs: not finite, and too large
  int moved_placements = 0;                  // requested places that were not legal
  std::vector<LegStory> legs;                // the whole legs against striker, as far as played
  std::vector<LegStory> ladder;              // short legs against each house team, if asked for
  Strength strength;                         // of an entry that passed
  std::vector<Note> notes;
  std::string log;

  // The leg as blue against striker, or the leg as yellow in which the entry failed. Empty if that
  // leg was stopped early or not played.
  std::optional<std::pair<Team, replay::Recording>> gate_leg;

  // Returns the first check that failed; null if no check failed.
  const Check* failure() const;
};

// The kind of legs for which an entry is checked.
struct EntryTerms {
  RobotLeague league = RobotLeague::small;
  referee::Rules rules;  // the rules, with the length of a half in the league
  match::TeamParameters parameters;
  system::Processor processor = system::Processor::v3;  // of the oldest computer that plays
  bool ladder = false;  // true: also plays short legs against each house team
};

// Called with each check as soon as its result is known.
using OnCheck = std::function<void(const Check&)>;
// Called before each check with its number from 1, the number of checks, and its name.
using OnStep = std::function<void(int number, int of, const char* name)>;

// Looks at the file, then lets it play in the sandbox: whole legs against the house team striker in
// both colours, and a knock-out leg. Then the entry repeats the knock-out leg and the leg as blue
// with a heap that watches the entry's memory, at other addresses and at another time. The check
// takes three seconds for a usual team. A team that takes more than 1 ms in a tick plays shorter
// legs, so that the check takes at most 20 s of processor time, of all its processes together, and
// 15 s more to find out why an entry is refused. Only for an entry that takes more than 2 s to
// load, the check takes longer, since each leg loads the entry. An error means that the check has
// no answer: the file cannot be read, or the host failed.
Result<EntryReport> check_entry(const std::string& path, const EntryTerms& terms,
                                const OnCheck& on_check = {}, const OnStep& on_step = {});

}  // namespace mirocup::app
