// SPDX-License-Identifier: MIT
//
// The hand-ins of a league in the order in which they came, and which is checked next. The order is
// fair between teams: checks go in rounds, and a team has one in each. Who comes joins the round
// that is being checked, or the one after its own last. A team has one check at a time.
//
// A pure function of the events that it is given. Threads: one at a time.
#pragma once

#include "core/base/names.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mirocup::league {

enum class HandInState {
  queued,     // waits for its check
  compiling,  // its sources are being compiled
  checking,   // is being checked
  accepted,
  refused,
  void_,  // the host could not check it; the team may hand it in again
};

constexpr bool is_final(HandInState state) {
  return state != HandInState::queued && state != HandInState::compiling &&
         state != HandInState::checking;
}

// The kinds of sources, told by the end of a file's name. A project is an archive of sources.
enum class SourceKind { none, c, cpp, project };
SourceKind source_kind_of(std::string_view file);

// Returns what `mirocup compile --language` calls it.
std::string language_of(SourceKind kind);

// One file that a team has handed in over the network.
struct WaitingHandIn {
  std::string team;
  int entry = 0;       // its number in the team's folder of entries
  std::string file;    // its name, as the team gave it
  std::string sha256;  // of its bytes
  std::uint64_t bytes = 0;
  std::int64_t at = 0;  // s since 1970

  HandInState state = HandInState::queued;
  std::string message = {};  // the answer to the team, once there is one
  int round = 0;             // in which it is checked
  int failures = 0;          // checks that the host has spoiled since the server started
};

class HandInQueue {
 public:
  // Adds a hand-in that waits. Precondition: the team has none of this number.
  void add(WaitingHandIn handed);

  // Says what became of a hand-in; of one that has an answer already, nothing changes.
  void answer(const std::string& team, int entry, HandInState state, const std::string& message);

  // Its check begins, or has ended without an answer: then it waits again in its old place.
  void begin(const std::string& team, int entry, HandInState state = HandInState::checking);
  void wait_again(const std::string& team, int entry);

  // Returns the hand-in that is to be checked next; null if none may be.
  const WaitingHandIn* next() const;

  // Returns how many hand-ins are taken before this one, with those that are being checked.
  int before(const std::string& team, int entry) const;

  const WaitingHandIn* find(const std::string& team, int entry) const;
  std::vector<const WaitingHandIn*> of_team(const std::string& team) const;  // oldest first
  int unanswered(const std::string& team) const;
  int unanswered() const { return static_cast<int>(waiting_.size()); }

  // Returns the highest number of the team's hand-ins; 0 if there is none.
  int last_entry(const std::string& team) const;

  // The latest accepted hand-in of each team.
  std::map<std::string, int> accepted() const;

 private:
  using Key = std::pair<std::string, int>;

  // The hand-ins without an answer in the order in which they are taken.
  std::vector<const WaitingHandIn*> order() const;

  int round_ = 0;                          // of the last check that began or was answered
  std::map<std::string, int> last_round_;  // of each team
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
