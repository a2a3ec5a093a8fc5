// SPDX-License-Identifier: MIT
//
// The hand-ins of a league: who has handed in what, what waits for a check, which entries are kept,
// and which entry plays. They follow from the lines of the book (book.hpp).
//
// Files that came over the network are checked one after the other, in an order that is fair
// between teams: checks go in rounds, and a team has one check in each round. A new hand-in joins
// the present round or the round after its team's last round, whichever is later. A team has one
// check at a time.
//
// A check that takes long gives way to the check of another team that waits: it is stopped, and its
// hand-in comes in a later round, as a new hand-in would. A check that has given way often enough
// may run to its end, so that each check ends; only one such check runs at a time. All other checks
// still give way, so on two processors a short check never waits for two long checks.
//
// The state is a pure function of the lines that it is given. Threads: one at a time.
#pragma once

#include "core/base/names.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace mirocup::league {

// The limits of hand-ins. The size of an entry is system::size_limit::entry.
struct Quota {
  int tries_per_hour = 20;  // files of a team, accepted or not
  // The most kept entries of each team, besides all entries that were booked to play.
  int versions = 20;
};

enum class HandInState {
  queued,     // waits for its check
  compiling,  // the sources of the hand-in are being compiled
  checking,   // is being checked
  accepted,
  refused,
  void_,  // the host could not check the file; the team may hand it in again
};

constexpr bool is_final(HandInState state) {
  return state != HandInState::queued && state != HandInState::compiling &&
         state != HandInState::checking;
}

// The kinds of sources. The end of a file's name gives the kind. A project is an archive of
// sources.
enum class SourceKind { none, c, cpp, project };
SourceKind source_kind_of(std::string_view file);

// Returns the name of a kind of source in `mirocup compile --language`.
std::string language_of(SourceKind kind);

// The reason why a check has ended without an answer: the host has spoiled the check, the check
// gave way to another team's check, or it has used up its processor time.
enum class NoAnswer { host_failed, gave_way, spent };

// A line of the book: a file that was handed in, or that the host gave to a team. The members
// below the empty line are not in the line; they follow from later lines.
struct HandedIn {
  static constexpr std::string_view kind = "hand_in";

  std::string team = {};
  int entry = 0;            // number in the team's folder of entries
  std::string file = {};    // name of the file, as it was handed in; "": the host gave the library
  std::string sha256 = {};  // of the file's bytes
  std::uint64_t bytes = 0;
  std::int64_t at = 0;      // s since 1970
  bool is_network = false;  // it came over the network, and waits for a check by the server
  bool is_late = false;     // it came after the deadline: it plays when the host has taken it

  HandInState state = HandInState::queued;
  std::string message = {};  // the answer to the team; "": none yet
  int plays = 0;             // the entry that plays after a refusal; 0: none
  std::string library = {};  // SHA-256 of the library; "": nothing of the entry is kept
  int round = 0;             // the round in which the hand-in is checked
  // The number of checks without an answer since the server started, by NoAnswer.
  std::array<int, 3> unanswered = {};

  int times(NoAnswer why) const { return unanswered[static_cast<std::size_t>(why)]; }
  bool is_kept() const { return !library.empty(); }
  bool is_accepted() const { return is_kept() && state == HandInState::accepted; }
  bool may_play() const { return is_accepted() && !is_late; }
};

// A line of the book: the answer to a hand-in.
struct Answered {
  static constexpr std::string_view kind = "answer";

  std::string team;
  int entry = 0;
  HandInState state = HandInState::void_;
  std::string message = {};
  int plays = 0;             // as in HandedIn
  std::string library = {};  // as in HandedIn
  std::int64_t at = 0;       // s since 1970
};

// A line of the book: a file that counts as a try and cannot be an entry, such as a link.
struct Rejected {
  static constexpr std::string_view kind = "rejected";

  std::string team;
  std::string message;
  std::int64_t at = 0;  // s since 1970
};

// A line of the book: these entries are more than the team may keep.
struct Dropped {
  static constexpr std::string_view kind = "drop";

  std::string team;
  std::vector<int> entries;
};

// A line of the book: the host takes an entry that came after the deadline.
struct TakenLate {
  static constexpr std::string_view kind = "take";

  std::string team;
  int entry = 0;
  std::int64_t at = 0;  // s since 1970
};

// A line of the book: the entry with which a team wants to play, also if a later one is accepted.
struct Pinned {
  static constexpr std::string_view kind = "pin";

  std::string team;
  int entry = 0;        // 0: the latest accepted entry plays
  std::int64_t at = 0;  // s since 1970
};

// A check that runs, and the times that it has used so far, s.
struct RunningCheck {
  std::string team;
  int entry = 0;
  double processor = 0.0;  // of all processes of the check together
  double asleep = 0.0;     // time in which no process of the check wanted a processor
};

class HandIns {
 public:
  // After this time, s, a check may have to give way. The time includes sleep, but not waiting for
  // a processor.
  static constexpr double turn = 3.0;
  static constexpr int gives_way_at_most = 2;  // times; then the check may run to its end

  HandIns() = default;
  HandIns(HandIns&&) = default;
  HandIns& operator=(HandIns&&) = default;

  // Precondition: the team has no hand-in of this number.
  void apply(HandedIn handed);
  // Does nothing if the hand-in has an answer already.
  void apply(const Answered& answer);
  void apply(const Rejected& rejected);
  void apply(const Dropped& dropped);
  void apply(const TakenLate& taken);
  void apply(const Pinned& pinned);

  // begin() is to be called when the check of a hand-in begins, wait_again() when the check has
  // ended without an answer. After wait_again() the hand-in waits in its old place or, if its check
  // took long, behind the other teams. The book does not keep these changes, because they end with
  // the server.
  void begin(const std::string& team, int entry, HandInState state = HandInState::checking);
  void wait_again(const std::string& team, int entry, NoAnswer why = NoAnswer::host_failed);

  // Returns the check to stop when no processor is free and the next check has to begin; null if no
  // check has to stop. `running` has all checks that run.
  const HandedIn* to_stop(const std::vector<RunningCheck>& running) const;

  // Returns the hand-in to check next; null if no check may begin.
  const HandedIn* next() const;

  // Returns the hand-ins over the network without an answer, in the order of their checks.
  std::vector<const HandedIn*> waiting() const;
  int waiting(const std::string& team) const;
  // Returns how many hand-ins are checked before the given hand-in, running checks included.
  int before(const std::string& team, int entry) const;

  // The functions below return null or 0 if the team has no such entry.
  const HandedIn* find(const std::string& team, int entry) const;
  int last_number(const std::string& team) const;  // also of an entry that is not kept
  int last_kept(const std::string& team) const;
  int last_accepted(const std::string& team) const;
  // Returns the entry that plays from now on: the pinned entry if it is kept, otherwise the last
  // accepted entry.
  int playing(const std::string& team) const;
  int pinned(const std::string& team) const;

  // Returns the last file that counted as a try; its entry is 0 if it was rejected.
  const HandedIn* last_try(const std::string& team) const;
  // Return the numbers in the hour before `now`. A jump of the clock by more than an hour does not
  // lock a team out.
  int tries_in_last_hour(const std::string& team, std::int64_t now) const;
  int pins_in_last_hour(const std::string& team, std::int64_t now) const;

  // Returns the kept entries of a team beyond `versions`, refused entries first. The entries in
  // `played` do not count, and stay; so do the pinned, the last accepted and the newest entry.
  std::vector<int> to_drop(const std::string& team, const std::set<int>& played,
                           int versions) const;

  // The entries of a team by their numbers.
  const std::map<int, HandedIn>& of_team(const std::string& team) const;
  // The teams of which the book has a line.
  std::vector<std::string> teams() const;

 private:
  // What the lines say of a team.
  struct Team {
    std::map<int, HandedIn> entries;
    HandedIn rejected;                // the last of the files that cannot be an entry
    int last_try = 0;                 // entry; 0: `rejected`, if there is one
    std::vector<std::int64_t> tries;  // times, s since 1970
    int pinned = 0;
    std::vector<std::int64_t> pins;  // times, s since 1970
    int last_round = -1;             // the round of the last hand-in over the network; -1: none
  };

  const Team& about(const std::string& team) const;
  HandedIn* known(const std::string& team, int entry);
  // Gives a hand-in the round that a new hand-in of its team would get.
  void put_behind(HandedIn& handed);

  int round_ = 0;  // the round of the last check that began or was answered
  std::map<std::string, Team> teams_;
  // Without an answer, in the order in which they came; elements of `teams_`.
  std::vector<const HandedIn*> waiting_;
};

}  // namespace mirocup::league

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 6> enum_names<league::HandInState>{
    "queued", "compiling", "checking", "accepted", "refused", "void"};
static_assert(to_string(league::HandInState::void_) == "void");

}  // namespace mirocup
