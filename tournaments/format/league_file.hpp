// SPDX-License-Identifier: MIT
//
// league.json: the decisions of the host. The host may edit the file until the league starts.
#pragma once

#include "core/base/error.hpp"
#include "core/field/league.hpp"
#include "core/match/conditions.hpp"
#include "core/match/pitch_spec.hpp"
#include "core/match/team_parameters.hpp"
#include "core/referee/rules.hpp"
#include "system/clock.hpp"
#include "system/processor.hpp"
#include "tournaments/format/format.hpp"
#include "tournaments/table/table.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mirocup::record {
class JsonReader;
}

namespace mirocup::league {

// How a team that speaks FIRASim's protocol takes part (docs/firasim.md).
struct FirasimProgram {
  // The shell command that starts the team's program for a leg. It runs in `folder`, a path from
  // the league's folder or an absolute path. "": a person starts the program, with the addresses of
  // the league's FirasimPlace.
  std::string run;
  std::string folder;
  // True: legs of the team wait for its answers instead of the clock, unless the opponent plays by
  // the clock.
  bool lockstep = false;
};

// A team of league.json: the source of its library, and the way in which it plays.
struct TeamConfig {
  std::string name;
  // As in the file: "house:NAME", a path, "submitted" (the team hands in later), or "firasim:NAME".
  std::string source;
  bool over_dds = false;  // true: the team joins by mirocup join; false: the server runs it
  match::TeamParameters parameters = {};  // the library gets them in each leg
  FirasimProgram program = {};            // of "firasim:NAME"
  // True: the team joined after the start by a line of the journal, and is not in the file.
  bool has_joined = false;

  bool is_house() const { return source.starts_with(house_prefix); }
  bool hands_in() const { return source == submitted; }  // the team gives its library
  bool is_firasim() const { return source.starts_with(firasim_prefix); }
  bool is_on_network() const { return over_dds || is_firasim(); }
  bool is_started_by_people() const { return is_firasim() && program.run.empty(); }
  bool lives_by_the_clock() const { return is_firasim() && !program.lockstep; }
  static constexpr std::string_view submitted = "submitted";
  static constexpr std::string_view house_prefix = "house:";
  static constexpr std::string_view firasim_prefix = "firasim:";
};

// The addresses at which programs that people start find their match: options of `mirocup match`.
struct FirasimPlace {
  int instance = 0;
  std::string interface = "lo";
  std::string vision, command, referee, placement;  // "": the addresses of `instance`
  double join_within = 60.0;                        // s
};

// The version of the rules by which results become tables and pairings. A league keeps the version
// with which it was made, so that an upgrade does not change played and published results.
inline constexpr int current_rules = 1;

struct LeagueFile {
  std::string title = "League";
  int rules_version = current_rules;
  Format format;
  RobotLeague league = RobotLeague::small;
  referee::Rules rules;
  std::optional<match::Conditions> conditions;  // empty: default_conditions() at the start
  std::optional<match::PitchSpec> pitch;        // empty: mirosot
  std::uint64_t seed = 1;
  Points points;
  std::vector<TieBreak> tie_breaks{default_tie_breaks.begin(), default_tie_breaks.end()};

  // From this time on the league takes no entry: "2026-11-30T18:00:00Z". If "", the league takes
  // entries until it starts. In the file, the time may have an offset from UTC in place of the Z. A
  // time without Z and offset is in the league's zone.
  std::string freeze;

  // Teams that may hand in longer, and until when, in the form of `freeze`.
  std::map<std::string, std::string> extensions;

  // The time zone of the times that people read: "Europe/Berlin". "": UTC.
  std::string zone;
  system::TimeZone time_zone = {};

  // True: public pages show no display names, and each team's name is an alias.
  bool is_anonymous = false;

  // True: the shapes that a team draws in a leg (docs/thoughts.md) are kept, for that team and the
  // staff.
  bool keeps_thoughts = false;

  // True: browsers can prove each leg, so its commands are published beside its replay page. The
  // commands show how a team drives.
  bool has_proofs = true;

  // The folder of the pages, an absolute path; "": site/ in the league's folder. The host may
  // change it at any time.
  std::string site;

  // The oldest computer that plays: an entry with newer instructions is told so.
  system::Processor processor = system::Processor::v3;

  // A team that loses this number of legs in a row by its own faults is paused; 0: never.
  int strikes = 3;
  FirasimPlace firasim;
  std::vector<TeamConfig> teams;

  TableRules table_rules() const {
    return {.points = points, .tie_breaks = tie_breaks, .seed = seed};
  }
};

inline constexpr std::size_t max_teams = 1000;  // a round robin of half a million fixtures

// Returns the conditions of a league that does not choose any.
match::Conditions default_conditions();

// True if a team may have a name: at most 40 letters, digits, '-', '_' and '.', the first neither
// '.' nor '-'. Names become folders, DDS partitions and pages.
bool is_good_name(const std::string& name);

// Returns a time, in seconds since 1970, as text in the form of `freeze` and the journal.
std::string utc_text(std::int64_t at);

// True if a text is a time in the form of utc_text().
bool is_time(const std::string& text);

// Converts a time that a person wrote to the form of utc_text(): "2026-11-30 19:00", perhaps with T
// or seconds. It has a Z or an offset (+01:00, +0100), or is in the league's zone. Errors:
// Errc::input.
Result<std::string> utc_of(const std::string& text, const LeagueFile& file);

// Reads the same from a file. A text in another form is a complaint.
std::string read_time(const record::JsonReader& json, const LeagueFile& file);

// Returns a time of the journal as people read it: "2026-11-30 19:00 CET (18:00 UTC)".
std::string shown_time(const LeagueFile& file, const std::string& utc);

// Reads a league file. The error (Errc::input) names `path`, the JSON pointer and the reason.
Result<LeagueFile> parse_league_file(const std::string& text, const std::string& path);

// Returns the text of league.json without the key `site`, as it was before the host added the key.
// The hash of this text tells whether the decisions of the host are those of the league's start.
std::string without_site(std::string text);

// Returns the text of league.json about a team that speaks FIRASim's protocol. This text is the
// team's entry instead of a library.
std::string print_firasim_team(const TeamConfig& team);

// Returns the text of the file with every setting, also defaults.
std::string print_league_file(const LeagueFile& league);

}  // namespace mirocup::league
