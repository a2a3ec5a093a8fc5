// SPDX-License-Identifier: MIT
//
// The hand-ins of a league in the order in which they came, and the choice of the next check. The
// order is fair between teams: checks go in rounds, and a team has one check in each round. A new
// hand-in joins the present round or the round after its team's last round, whichever is later. A
// team has one check at a time.
//
// A check that takes long gives way to the check of another team that waits: it is stopped, and its
// hand-in comes in a later round, as a new hand-in would. A check that has given way often enough
// may run to its end, so that each check ends; only one such check runs at a time. All other checks
// still give way, so on two processors a short check never waits for two long checks.
//
// The state is a pure function of the events that it is given. Threads: one at a time.
#pragma once

#include "core/base/names.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mirocup::league {

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

// One file that a team has handed in over the network.
struct WaitingHandIn {
  std::string team;
  int entry = 0;       // number in the team's folder of entries
  std::string file;    // the file's name, as the team gave it
  std::string sha256;  // of the file's bytes
  std::uint64_t bytes = 0;
  std::int64_t at = 0;  // s since 1970

  HandInState state = HandInState::queued;
  std::string message = {};  // the answer to the team; "": none yet
  int plays = 0;             // the entry that plays after a refusal; 0: none
  int round = 0;             // the round in which the hand-in is checked
  // The number of checks without an answer since the server started, by NoAnswer.
  std::array<int, 3> unanswered = {};

  int times(NoAnswer why) const { return unanswered[static_cast<std::size_t>(why)]; }
};

// A check that runs, and the times that it has used so far, s.
struct RunningCheck {
  std::string team;
  int entry = 0;
  double processor = 0.0;  // of all processes of the check together
  double asleep = 0.0;     // time in which no process of the check wanted a processor
};

// The limit of processor time for compiling a source of a team, s. If a source of the team was not
// compiled within `after_slow_one`, the team's sources get only this time until one of them is
// compiled.
class CompileTime {
 public:
  static constexpr int usual = 60;
  static constexpr int after_slow_one = 20;

  int of(const std::string& team) const { return slow_.contains(team) ? after_slow_one : usual; }

  // Notes whether a source was compiled, and the processor time that its compiler used.
  void note(const std::string& team, bool is_compiled, double used) {
    if (is_compiled) {
      slow_.erase(team);
    } else if (used >= 0.9 * after_slow_one) {
      slow_.insert(team);
    }
  }

 private:
  std::set<std::string> slow_;  // teams whose sources get only `after_slow_one`
};

class HandInQueue {
 public:
  // After this time, s, a check may have to give way. The time includes sleep, but not waiting for
  // a processor.
  static constexpr double turn = 3.0;
  static constexpr int gives_way_at_most = 2;  // times; then the check may run to its end

  // Adds a hand-in that waits. Precondition: the team has no hand-in of this number.
  void add(WaitingHandIn handed);

  // Sets the answer of a hand-in. Does nothing if the hand-in has an answer already.
  void answer(const std::string& team, int entry, HandInState state, const std::string& message,
              int plays = 0);

  // begin() is to be called when the check of a hand-in begins, wait_again() when the check has
  // ended without an answer. After wait_again() the hand-in waits in its old place or, if its check
  // took long, behind the other teams.
  void begin(const std::string& team, int entry, HandInState state = HandInState::checking);
  void wait_again(const std::string& team, int entry, NoAnswer why = NoAnswer::host_failed);

  // Returns the check to stop when no processor is free and the next check has to begin; null if no
  // check has to stop. `running` has all checks that run.
  const WaitingHandIn* to_stop(const std::vector<RunningCheck>& running) const;

  // Returns the hand-in to check next; null if no check may begin.
  const WaitingHandIn* next() const;

  // Returns how many hand-ins are checked before the given hand-in, running checks included.
  int before(const std::string& team, int entry) const;

  const WaitingHandIn* find(const std::string& team, int entry) const;
  // Returns at most `most` hand-ins of a team with numbers below `before`, the latest first.
  std::vector<const WaitingHandIn*> latest_of(const std::string& team, std::size_t most,
                                              int before = std::numeric_limits<int>::max()) const;
  int unanswered(const std::string& team) const;
  int unanswered() const { return static_cast<int>(waiting_.size()); }

  // Returns the highest number of the team's hand-ins; 0 if the team has no hand-in.
  int last_entry(const std::string& team) const;

  // The latest accepted hand-in of each team.
  std::map<std::string, int> accepted() const;

 private:
  using Key = std::pair<std::string, int>;

  // The hand-ins without an answer in the order of their checks.
  std::vector<const WaitingHandIn*> order() const;
  // Gives a hand-in the round that a new hand-in of its team would get.
  void put_behind(WaitingHandIn& handed);

  int round_ = 0;                          // the round of the last check that began or was answered
  std::map<std::string, int> last_round_;  // the last round of each team
  std::map<Key, WaitingHandIn> all_;
  std::vector<Key> waiting_;  // without an answer, in the order in which they came
};

}  // namespace mirocup::league

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 6> enum_names<league::HandInState>{
    "queued", "compiling", "checking", "accepted", "refused", "void"};
static_assert(to_string(league::HandInState::void_) == "void");

}  // namespace mirocup
