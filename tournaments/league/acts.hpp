// SPDX-License-Identifier: MIT
//
// The decisions of a league's staff, from a terminal or from the staff page. Each act becomes lines
// of the journal, or an error with the reason.
#pragma once

#include "core/base/names.hpp"
#include "tournaments/league/league_store.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace mirocup::league {

enum class ActKind { rule, award, void_, withdraw, pause, resume, freeze, release, close, undo };

struct Act {
  ActKind kind = ActKind::rule;
  std::string fixture = {};   // rule, award, void
  int leg = 0;                // rule, award, void; 0: not given, for a fixture of one leg
  bool has_all_legs = false;  // rule, award, void: all legs of the fixture
  std::string team = {};      // award, withdraw, pause, resume
  bool keeps_seed = false;    // void: the leg is played again with the same seed
  std::string score = {};     // rule: "2:1", home before away
  std::string results = {};   // withdraw: "keep" or "annul"
  std::string except = {};    // freeze: the team that alone may hand in longer; "": none
  std::string from = {};      // freeze: a time; "": now. With `except`: until then
  bool is_lifted = false;     // freeze: entries are taken again
  std::string level = {};     // release: "all", "teams" or "hidden"
  std::string through = {};   // release: a round; "": as for Released::through
  std::string final = {};     // close: the format of the closing round; "": none
  int decision = 0;           // undo: the number of a decision in the list
  std::string reason = {};    // the reason of the act; with `except` it is private
  std::string by = {};        // the person who decides; "": not named
  bool is_dry_run = false;    // true: perform() only returns its lines and writes nothing
};

// The most goals that a ruling can give a team in a leg.
inline constexpr int max_ruled_goals = 100;

// Returns why a text cannot be the published reason of a decision; "" if it can. A reason is one
// line of at most 500 bytes with a letter or a digit.
std::string objection_to_reason(const std::string& text);

// Returns why a text cannot be the name of a person who decides; "" if it can. A name is one line
// of at most 60 bytes.
std::string objection_to_person(const std::string& name);

// Performs an act. `files` gives access to league.json, because a freeze before the start writes
// its time there. Returns lines for the person who acts, as the list of decisions has them: "r1-f1
// leg 2, a – b: 2:1 (was 0:3)". After an error, Errc::input, nothing is written.
Result<std::vector<std::string>> perform(system::Files& files, LeagueStore& store, const Act& act,
                                         std::int64_t now);

}  // namespace mirocup::league

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 10> enum_names<league::ActKind>{
    "rule", "award", "void", "withdraw", "pause", "resume", "freeze", "release", "close", "undo"};
static_assert(to_string(league::ActKind::undo) == "undo");

}  // namespace mirocup
