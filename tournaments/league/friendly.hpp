// SPDX-License-Identifier: MIT
//
// Friendlies: single legs that count for nothing. A team asks for a friendly against a team that it
// chooses. Each accepted entry plays a burst of friendlies against the team's former entry, the
// house teams and the neighbours in the table, and tries all drills. The server plays friendlies
// while no hand-in waits for its check, and teams take turns.
//
// The state is a pure function of the lines that it is given (book.hpp). Threads: one at a time.
#pragma once

#include "core/base/names.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mirocup::league {

enum class FriendlyState {
  waiting,
  playing,
  played,
  void_,  // the leg will never be played
};

// A line of the book: a leg that a team asks for, and in which it plays in blue. The members below
// the empty line are not in the line.
struct Friendly {
  static constexpr std::string_view kind = "friendly";

  std::string team;
  int number = 0;             // number among the team's friendlies, from 1; 0: no leg, but drills
  int entry = 0;              // the team's entry that plays
  std::string opponent = {};  // a team of the league, or "house:NAME"; the team itself: a former
                              // entry of it
  int opponent_entry = 0;     // number of the opponent's entry; 0: a house team
  std::int64_t at = 0;        // s since 1970

  bool is_burst = false;  // belongs to the burst of an accepted entry
  FriendlyState state = FriendlyState::waiting;
  int goals = 0;
  int against = 0;
  std::string end = {};  // as in a record: "full_time"; if the leg is void, the reason

  int failures = 0;  // faults of the host in this leg since the server started
};

// A line of the book: the legs of an accepted entry, which get the team's next numbers. The waiting
// legs of the team's older entries are void from now on.
struct Burst {
  static constexpr std::string_view kind = "burst";

  struct Leg {
    std::string opponent;
    int opponent_entry = 0;
  };

  std::string team;
  int entry = 0;
  std::vector<Leg> legs = {};
  std::int64_t at = 0;  // s since 1970
};

// A line of the book: how a leg ended.
struct FriendlyEnded {
  static constexpr std::string_view kind = "ended";

  std::string team;
  int number = 0;
  FriendlyState state = FriendlyState::void_;
  int goals = 0;
  int against = 0;
  std::string end;      // as in Friendly
  std::int64_t at = 0;  // s since 1970
};

// True for the name of a house team, "house:NAME".
bool is_house(std::string_view opponent);

class Friendlies {
 public:
  static constexpr int per_hour = 10;  // the most legs that a team may ask for in an hour
  static constexpr int kept = 60;      // number of each team's latest legs whose records stay

  // Precondition: the leg has the team's next number.
  void apply(Friendly friendly);
  void apply(const Burst& burst);
  void apply(const FriendlyEnded& ended);

  // The book does not keep these changes, because they end with the server.
  void begin(const std::string& team, int number);
  // Lets a leg wait again. If `is_spoiled`, the host has spoiled the leg; otherwise the runner
  // stopped the leg for a check.
  void wait_again(const std::string& team, int number, bool is_spoiled);

  // Returns the leg to play next: a leg of the team that has waited longest for its turn. A team
  // plays one leg at a time. Null if no leg may be played now.
  const Friendly* next() const;

  const Friendly* find(const std::string& team, int number) const;
  int last_number(const std::string& team) const;

  // Returns all legs of a team except those of other teams' bursts, the latest first.
  std::vector<const Friendly*> of_team(const std::string& team) const;

  bool has_burst(const std::string& team, int entry) const;
  // Returns, for each team, the last entry that had a burst.
  const std::map<std::string, int>& bursts() const { return bursts_; }

  // Returns how many legs the team has asked for in the hour before `now`.
  int asked_in_last_hour(const std::string& team, std::int64_t now) const;

 private:
  using Key = std::pair<std::string, int>;

  std::map<Key, Friendly> all_;
  std::vector<Key> open_;             // waiting or playing, in the order in which they came
  std::map<std::string, long> turn_;  // when each team had its last turn
  long turns_ = 0;
  std::map<std::string, int> bursts_;  // for each team, the last entry that had a burst
};

}  // namespace mirocup::league

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 4> enum_names<league::FriendlyState>{
    "waiting", "playing", "played", "void"};
static_assert(to_string(league::FriendlyState::void_) == "void");

}  // namespace mirocup
