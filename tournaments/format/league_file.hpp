// SPDX-License-Identifier: MIT
//
// league.json: the decisions of the host. It may be edited until the league starts.
#pragma once

#include "core/base/error.hpp"
#include "core/field/league.hpp"
#include "core/match/conditions.hpp"
#include "core/match/pitch_spec.hpp"
#include "core/match/team_parameters.hpp"
#include "core/referee/rules.hpp"
#include "system/clock.hpp"
#include "tournaments/format/format.hpp"
#include "tournaments/table/table.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mirocup::league {

// How a team that speaks FIRASim's protocol takes part (docs/firasim.md).
struct FirasimProgram {
  // The command of the shell that starts it for a leg, in `folder` (of the league, unless it is
  // absolute). "": people start it, at the addresses of the league's FirasimPlace.
  std::string run;
  std::string folder;
  // True: its legs wait for its answers instead of the clock, unless the opponent is played by the
  // clock.
  bool lockstep = false;
};

// A team of the file: where its library comes from, and how it plays.
struct TeamConfig {
  std::string name;
  // As written: "house:NAME", a path, "submitted" (it hands in later), or "firasim:NAME".
  std::string source;
  bool over_dds = false;  // true: it joins by mirocup join; false: the server runs it
  match::TeamParameters parameters = {};  // its library gets them in each leg
  FirasimProgram program = {};            // of "firasim:NAME"
  bool has_joined = false;  // true: by a line of the journal, after the start; not in the file

  bool is_house() const { return source.starts_with("house:"); }
  bool hands_in() const { return source == submitted; }  // the team gives its library, not the host
  bool is_firasim() const { return source.starts_with(firasim_prefix); }
  bool is_on_network() const { return over_dds || is_firasim(); }
  bool is_started_by_people() const { return is_firasim() && program.run.empty(); }
  bool lives_by_the_clock() const { return is_firasim() && !program.lockstep; }
  static constexpr std::string_view submitted = "submitted";
  static constexpr std::string_view firasim_prefix = "firasim:";
};

// The addresses at which programs that people start find their match: options of `mirocup match`.
struct FirasimPlace {
  int instance = 0;
  std::string interface = "lo";
  std::string vision, command, referee, placement;  // "": those of the instance
  double join_within = 60.0;                        // s
};

// How results become tables and pairings. A league keeps the rules with which it was made, so that
// an upgrade does not change played and published results.
inline constexpr int former_rules = 1;     // of a league.json without a number: tables take sums
inline constexpr int bye_goals_rules = 3;  // from here on a bye counts in tie-breaks of goals
inline constexpr int current_rules = 3;

struct LeagueFile {
  std::string title = "League";
  int rules_version = current_rules;
  Format format;
  League league = League::small;
  referee::Rules rules;
  std::optional<match::Conditions> conditions;  // empty: `hall` for a league that starts now
  std::optional<match::PitchSpec> pitch;        // empty: mirosot
  std::uint64_t seed = 1;
  Points points;
  std::vector<TieBreak> tie_breaks{default_tie_breaks.begin(), default_tie_breaks.end()};

  // From this time on the league takes no entry: "2026-11-30T18:00:00Z". If "", it takes entries
  // until it starts. In the file, an offset from UTC may stand in place of the Z. Without either,
  // the time is that of the league's zone.
  std::string freeze;

  // The time zone of the times that people read: "Europe/Berlin". "": UTC.
  std::string zone;
  system::TimeZone time_zone = {};

  // True: the public pages show no display names, and the teams' names are their aliases.
  bool is_anonymous = false;

  // True: the shapes that a team draws in a leg (docs/thoughts.md) are kept, for itself and the
  // staff.
  bool keeps_thoughts = false;

  // Replay pages can be proved by their readers' browsers, so the commands of each leg are beside
  // its page: they show how a team drives.
  bool has_proofs = true;

  // After this number of legs in a row that a team loses by its own faults, it is paused; 0: never.
  int strikes = 3;
  FirasimPlace firasim;
  std::vector<TeamConfig> teams;

  bool has_former_rules() const { return rules_version == former_rules; }
  TableRules table_rules() const {
    return {.points = points,
            .tie_breaks = tie_breaks,
            .seed = seed,
            .evens_out = !has_former_rules(),
            .counts_bye_goals = rules_version >= bye_goals_rules};
  }
};

inline constexpr std::size_t max_teams = 1000;  // a round robin of half a million fixtures

// Returns the conditions of a league that does not choose any.
match::Conditions default_conditions();

// True if a team may have that name: at most 40 letters, digits, '-', '_' and '.', of which the
// first is neither '.' nor '-'. Names become folders, DDS partitions and pages.
bool is_good_name(const std::string& name);

// Returns a time, in seconds since 1970, as `freeze` and the journal have it.
std::string utc_text(std::int64_t at);

// True for a time as utc_text() writes it.
bool is_time(const std::string& text);

// Returns a time that a person wrote as utc_text() writes it: with a Z, with an offset, or as the
// clocks of the league's zone show it. Errors: Errc::input.
Result<std::string> utc_of(const std::string& text, const LeagueFile& file);

// Returns a time of the journal as people read it: "2026-11-30 19:00 CET (18:00 UTC)".
std::string shown_time(const LeagueFile& file, const std::string& utc);

// Reads a league file. The error (Errc::input) names `path`, the JSON pointer and the reason.
// `rules_version` holds if the file names none.
Result<LeagueFile> parse_league_file(const std::string& text, const std::string& path,
                                     int rules_version = former_rules);

// Returns the text of league.json about a team that speaks FIRASim's protocol. The text is the
// team's entry, in the place of a library.
std::string print_firasim_team(const TeamConfig& team);

// Returns the text of the file with every setting, also defaults.
std::string print_league_file(const LeagueFile& league);

}  // namespace mirocup::league
