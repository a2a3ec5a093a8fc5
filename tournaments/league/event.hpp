// SPDX-License-Identifier: MIT
//
// The events of a league: one type for each kind of journal line, and their variant, Event.
// read_event() decodes a line once, so that the league's decisions are made on typed values;
// fields_of() encodes an event for Journal::append(). journal/format.md describes the lines.
//
// An event has exactly the content of its line: teams and fixtures are names and ids. validate() in
// apply.hpp checks whether a league has them.
#pragma once

#include "core/base/error.hpp"
#include "core/base/names.hpp"
#include "core/match/conditions.hpp"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace mirocup::league {

using Json = nlohmann::ordered_json;

// The largest number of goals or penalties of a leg that a reader accepts.
inline constexpr int max_count = 1'000'000;

// The reason of a decision and, if they are known, the person who made it and the time.
struct Signature {
  std::string why = {};
  std::string by = {};
  std::string at = {};  // UTC: "2026-11-30T18:00:00Z"
};

// One number for each of the two teams of a fixture: goals, or penalties given against them.
struct HomeAway {
  int home = 0;
  int away = 0;
};

// How a leg got its score. The match server ends a leg for one of the first six reasons; the last
// two reasons are for legs that were not played.
enum class LegEnd {
  full_time,
  golden_goal,
  shoot_out,
  forfeit,
  double_forfeit,
  mercy,
  awarded,    // by a ruling
  withdrawn,  // walkover after a team has left; follows from Withdrawn, never in the journal
};

// The fault that ended a leg early, as in a match record.
struct LegFault {
  std::string team;
  std::string code;  // name of a match::FaultCode
  std::string text;  // for people

  // Returns "TEAM: CODE: TEXT", as pages and exports print a fault.
  std::string summary() const { return team + ": " + code + ": " + text; }
};

// The league started; from then on league.json must have this SHA-256.
struct Started {
  static constexpr std::string_view kind = "start";

  std::string config_sha256;
  std::string version;                // of the program
  match::Conditions conditions = {};  // of all legs
  std::string build = {};             // of the program
  std::string game = {};              // the hash of the program's behaviour
};

// From this event on the team plays with this entry.
struct EntryBooked {
  static constexpr std::string_view kind = "entry";

  std::string team;
  int entry = 1;       // the number of the entry, from 1
  std::string sha256;  // of the entry's library
};

// A team joined a league that takes entries after its start. The team plays from its first entry
// on.
struct TeamJoined {
  static constexpr std::string_view kind = "join";

  std::string team;
  std::string source;  // as TeamConfig::source: "submitted" or "house:NAME"
};

// A leg was played, and its result counts.
struct LegPlayed {
  static constexpr std::string_view kind = "leg";

  std::string fixture;  // its id
  int leg = 1;          // from 1
  int attempt = 1;      // from 1; the earlier attempts were void
  std::string home;
  std::string away;
  std::string blue;  // the team that played in blue
  HomeAway score;
  std::optional<std::string> winner;  // by goals or a shoot-out; none after a draw
  LegEnd end = LegEnd::full_time;
  std::optional<LegFault> fault;
  HomeAway penalties;  // given against each team
  std::string record;  // path of the match record inside the league folder
  std::string state_hash;
};

// The reason why an attempt counts for nothing.
enum class VoidCause {
  host,     // the machine failed
  confirm,  // a team exceeded a time limit for the first time; the next attempt decides
  ruling,   // a person decided to void the attempt
};

// An attempt counts for nothing; the leg is played again.
struct LegVoided {
  static constexpr std::string_view kind = "void";

  std::string fixture;
  int leg = 1;
  int attempt = 1;
  VoidCause cause = VoidCause::host;
  Signature signature = {};
  bool has_new_seed = false;  // false: the same libraries play the same leg again
};

// A person decided the score of a leg, played or not.
struct Ruled {
  static constexpr std::string_view kind = "ruling";

  std::string fixture;
  int leg = 1;
  HomeAway score;
  Signature signature = {};
};

// The effect of a withdrawal on the results of the team.
enum class WithdrawnResults {
  keep,   // results stay, and opponents win the legs that are not played
  annul,  // legs outside a knockout count for nothing
};

// A team left the league.
struct Withdrawn {
  static constexpr std::string_view kind = "withdraw";

  std::string team;
  WithdrawnResults results = WithdrawnResults::keep;
  Signature signature = {};
};

// No leg of the team is started until the team is resumed. The program also pauses teams: then `by`
// is empty and `is_by_program` is true.
struct Paused {
  static constexpr std::string_view kind = "pause";

  std::string team;
  Signature signature = {};
  bool is_by_program = false;
};

struct Resumed {
  static constexpr std::string_view kind = "resume";

  std::string team;
  Signature signature = {};
};

// A night begins. In a nightly league the event lists the last accepted entry of each team with a
// new entry; the team plays with this entry from now on, and fixtures follow. In other formats the
// event lists no entries, and marks the time from which a digest counts news.
struct NightBegan {
  static constexpr std::string_view kind = "night";

  int number = 1;  // from 1
  std::vector<EntryBooked> entries = {};
  std::string at = {};
};

// The league takes no entry from a time on.
struct Frozen {
  static constexpr std::string_view kind = "freeze";

  std::string from;  // UTC; "": the league takes entries again
  Signature signature = {};
};

// One team may hand in longer than the others. The reason is private: the host keeps it, and the
// journal has its hash, so that nobody can change it later.
struct Extended {
  static constexpr std::string_view kind = "extension";

  std::string team;
  std::string until;          // UTC
  std::string reason_sha256;  // of the reason and its salt, in reasons.txt
  Signature signature = {};
};

// The league is over: no night follows, and the league takes no entry.
struct Closed {
  static constexpr std::string_view kind = "close";

  // The format of the closing round in the folder final/, which decides the season; "": none.
  std::string closing_round = {};
  Signature signature = {};
};

// The people who may read the rounds after the released round.
enum class ReleaseLevel {
  all,     // everybody
  teams,   // the pages end with the released round; each team reads its own digest
  hidden,  // nobody; the pages end with the released round
};

// The rounds that the pages show.
struct Released {
  static constexpr std::string_view kind = "release";

  ReleaseLevel level = ReleaseLevel::all;
  std::string through;  // the last round, "r3"; "": every round if `level` is `all`, otherwise none
  Signature signature = {};
};

// A decision of a person is taken back: the league is as if it had never been made.
struct Undone {
  static constexpr std::string_view kind = "undo";

  int line = 0;  // the number of the journal's line with the decision that is taken back
  Signature signature = {};
};

using Event =
    std::variant<Started, EntryBooked, LegPlayed, LegVoided, Ruled, Withdrawn, Paused, Resumed,
                 NightBegan, Frozen, Extended, Closed, Released, Undone, TeamJoined>;

// Decodes a line of a journal. Keys that a later version may have added are ignored. The error
// (Errc::damaged) names the line's number, the key and the reason: "line 7: /score/home: missing".
Result<Event> read_event(const Json& line);

// Returns the value of the key "kind" of the event's line.
std::string_view kind_of(const Event& event);

// Returns all fields of the event's line but "kind", in the order of the journal.
Json fields_of(const Event& event);

// Returns the id of the event's fixture; null if the event has no fixture. The id is valid as long
// as the event.
const std::string* fixture_of(const Event& event);

}  // namespace mirocup::league

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 8> enum_names<league::LegEnd>{
    "full_time",      "golden_goal", "shoot_out", "forfeit",
    "double_forfeit", "mercy",       "awarded",   "withdrawn"};
static_assert(to_string(league::LegEnd::withdrawn) == "withdrawn");

template <>
inline constexpr std::array<std::string_view, 3> enum_names<league::VoidCause>{"host", "confirm",
                                                                               "ruling"};
static_assert(to_string(league::VoidCause::ruling) == "ruling");

template <>
inline constexpr std::array<std::string_view, 3> enum_names<league::ReleaseLevel>{"all", "teams",
                                                                                  "hidden"};
static_assert(to_string(league::ReleaseLevel::hidden) == "hidden");

template <>
inline constexpr std::array<std::string_view, 2> enum_names<league::WithdrawnResults>{"keep",
                                                                                      "annul"};
static_assert(to_string(league::WithdrawnResults::annul) == "annul");

}  // namespace mirocup
