// SPDX-License-Identifier: MIT
//
// The verdict on a leg from the absences of both teams. This is the rule alone: the caller passes
// the state of the teams and of the host's network at one moment.
//
// A team whose absences together have lasted longer than the limit has lost. But a team that is
// away cannot win: the opponents win with their first sign of life after that moment. If they are
// away as well, the leg waits for them until their own limit is over; then nobody has won.
//
// Times are seconds of wall time since any moment, the same for all.
#pragma once

#include "core/match/snapshot.hpp"

#include <cstdint>
#include <optional>
#include <variant>

namespace mirocup::dds {

// The presence of a team at one moment.
struct Elsewhere {};  // it does not play over the network; its own controller reports its faults
struct Present {
  double heard = 0.0;  // the time of its last command
};
struct Late {  // it owes an answer, but has not been silent for long enough to be away
  double heard = 0.0;
};
struct Away {  // it has been silent for too long
  double since = 0.0;
  std::uint32_t tick = 0;  // the tick in which the server noticed it
};
struct Left {  // its process has left the network
  double since = 0.0;
  std::uint32_t tick = 0;
};
using Presence = std::variant<Elsewhere, Present, Late, Away, Left>;

struct Standing {
  Presence presence;
  std::optional<double> lost_at;  // when its absences together had lasted longer than the limit
};

// The possible verdicts.
struct PlayOn {};
struct AwaitOther {};  // one team has lost, and no command of the other has come since
struct Disconnected {
  match::ByTeam<bool> teams{};  // true: it has lost
};
struct HostAtFault {};
using Verdict = std::variant<PlayOn, AwaitOther, Disconnected, HostAtFault>;

// `host_was_down`: for how long the host's own network was down in this leg. Such time is no
// absence of a team; if it is longer than `limit`, the leg is void.
Verdict judge_absences(const match::ByTeam<Standing>& teams, double host_was_down, double limit);

}  // namespace mirocup::dds
