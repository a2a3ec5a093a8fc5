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

// How a team takes part that speaks FIRASim's protocol (docs/firasim.md).
struct FirasimProgram {
  // The command of the shell that starts it for a leg, in `folder` (of the league, unless it is
  // absolute). "": people start it, at the addresses of the league's FirasimPlace.
  std::string run;
  std::string folder;
  // Its legs wait for its answers instead of the clock, unless the opponent lives by the clock.
  bool lockstep = false;
};

// A team of the file: where its library comes from, and how it plays.
struct TeamConfig {
  std::string name;
  // As written: "house:NAME", a path, "submitted" (it hands in later), or "firasim:NAME".
  std::string source;
  bool over_dds = false;  // true: it joins over the network (mirocup join); else the server runs it
  match::TeamParameters parameters = {};  // what each of its legs gives its library
  FirasimProgram program = {};            // of "firasim:NAME"
  bool has_joined = false;  // true: by a line of the journal, after the start; not in the file

  bool is_house() const { return source.starts_with("house:"); }
  bool hands_in() const { return source == submitted; }  // the host gives no library
  bool is_firasim() const { return source.starts_with(firasim_prefix); }
  bool is_on_network() const { return over_dds || is_firasim(); }
  bool is_started_by_people() const { return is_firasim() && program.run.empty(); }
  bool lives_by_the_clock() const { return is_firasim() && !program.lockstep; }
  static constexpr std::string_view submitted = "submitted";
  static constexpr std::string_view firasim_prefix = "firasim:";
};

// Where the programs of teams find their match that people start: options of `mirocup match`.
struct FirasimPlace {
  int instance = 0;
  std::string interface = "lo";
  std::string vision, command, referee, placement;  // "": those of the instance
  double join_within = 60.0;                        // s
};

// How results become tables and pairings. A league keeps the rules with which it was made: what was
// played and published must not change by an upgrade.
inline constexpr int former_rules = 1;  // of a league.json without a number
inline constexpr int current_rules = 2;

struct LeagueFile {
  std::string title = "League";
  int rules_version = current_rules;
  Format format;
  League league = League::small;
  referee::Rules rules;
  std::optional<match::Conditions> conditions;  // nothing: `hall` for a league that starts now
  std::optional<match::PitchSpec> pitch;        // nothing: mirosot
  std::uint64_t seed = 1;
  Points points;
  std::vector<TieBreak> tie_breaks{default_tie_breaks.begin(), default_tie_breaks.end()};

  // From this time on no entry is taken: "2026-11-30T18:00:00Z". "": entries are taken until the
  // league starts. The file may have an offset from UTC in place of the Z, or neither: then it is
  // the time of the league's zone.
  std::string freeze;

  // The time zone in which people are told times: "Europe/Berlin". "": UTC.
  std::string zone;
  system::TimeZone time_zone = {};

  // The public pages show no display names: the teams' names are their aliases.
  bool is_anonymous = false;

  // What a team draws in a leg (docs/thoughts.md) is kept, for its own eyes and the staff's.
  bool keeps_thoughts = false;

  // Number of legs in a row, lost by its own faults, that pauses a team; 0: no number does.
  int strikes = 3;
  FirasimPlace firasim;
  std::vector<TeamConfig> teams;

  bool has_former_rules() const { return rules_version == former_rules; }
  TableRules table_rules() const {
    return {
        .points = points, .tie_breaks = tie_breaks, .seed = seed, .evens_out = !has_former_rules()};
  }
};

inline constexpr std::size_t max_teams = 1000;  // whose round robin is half a million fixtures

// Returns the conditions of a league that does not choose any.
match::Conditions default_conditions();

// True if a team may have that name. Names become folders, DDS partitions and pages, so they are
// letters, digits, '-', '_' and '.', at most 40, and begin with neither '.' nor '-'.
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

// Returns what league.json says of a team that speaks FIRASim's protocol. It is kept as the team's
// entry, in the place of a library.
std::string print_firasim_team(const TeamConfig& team);

// Returns the text of the file: every setting, also those that have their default.
std::string print_league_file(const LeagueFile& league);

}  // namespace mirocup::league
