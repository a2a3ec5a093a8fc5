// SPDX-License-Identifier: MIT
#include "tournaments/handin/friendly_runner.hpp"

#include "system/locations.hpp"

#include <csignal>

namespace mirocup::league {

namespace {

using namespace std::chrono_literals;

constexpr auto turn = 3s;                // on the clock; then it may have to give way to a check
constexpr auto most_time_of_leg = 600s;  // on the clock; a leg of the longest half takes minutes

}  // namespace

bool FriendlyRunner::start_next(int tag) {
  const auto next = desk_.begin_next();
  if (!next) return false;
  const std::string record = next->number == 0 ? folder_.drill_marks(next->team, next->entry)
                                               : folder_.friendly(next->team, next->number);
  const auto pid = processes_.start(
      {system::sibling_program("mirocup-league"), "play-friendly", folder_.path, next->team,
       std::to_string(next->number), "--entry=" + std::to_string(next->entry),
       "--opponent=" + next->opponent, "--opponent-entry=" + std::to_string(next->opponent_entry)},
      tag, -1, record + ".out");
  if (!pid) {
    (void)desk_.failed(*next);
    return false;
  }
  running_[tag] = {*next, *pid, std::chrono::steady_clock::now()};
  return true;
}

bool FriendlyRunner::book(const system::Exit& exit) {
  const auto found = running_.find(exit.tag);
  if (found == running_.end()) return false;
  const Friendly friendly = std::move(found->second.friendly);
  const bool is_spoiled = !found->second.gives_way || exit.signal == 0;
  running_.erase(found);
  (void)(exit.signal == 0 && exit.code == exit_yes ? desk_.played(friendly)
                                                   : desk_.failed(friendly, is_spoiled));
  return true;
}

void FriendlyRunner::look_at_time() {
  const auto now = std::chrono::steady_clock::now();
  for (const auto& [tag, leg] : running_) {
    if (now - leg.begun > most_time_of_leg) ::kill(leg.pid, SIGKILL);
  }
}

bool FriendlyRunner::give_way() {
  const auto now = std::chrono::steady_clock::now();
  for (auto& [tag, leg] : running_) {
    if (now - leg.begun < turn) continue;
    ::kill(leg.pid, SIGKILL);
    leg.gives_way = true;
    return true;
  }
  return false;
}

}  // namespace mirocup::league
