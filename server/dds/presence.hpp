// SPDX-License-Identifier: MIT
//
// What the absences of both teams mean for the leg. The rule alone: it is told what is known of the
// teams and of the host's network at one moment, and knows neither a network nor a clock.
//
// A team whose absences together have lasted longer than the limit has lost. Nobody wins who is not
// there: the opponents win with their first sign of life after that moment. If they are away as
// well, the leg waits for them as long as their own limit lasts, and then nobody has won.
//
// Times are seconds of wall time since any moment, the same for all.
#pragma once

#include "core/match/snapshot.hpp"

#include <cstdint>
#include <optional>
#include <variant>

namespace mirocup::dds {

// What is known of a team at one moment.
struct Elsewhere {};  // it does not play over the network; its own controller knows of its faults
struct Present {
  double heard = 0.0;  // the time of its last command
};
struct Late {  // it owes the answer to a tick, but not for long enough to be away
  double heard = 0.0;
};
struct Away {  // it has been silent for too long
  double since = 0.0;
  std::uint32_t tick = 0;  // in which that was noticed
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

// What follows from it.
struct PlayOn {};
struct AwaitOther {};  // one team has lost, and the other one has not been seen since
struct Disconnected {
  match::ByTeam<bool> teams{};  // true: it has lost
};
struct HostAtFault {};
using Verdict = std::variant<PlayOn, AwaitOther, Disconnected, HostAtFault>;

// `host_was_down`: for how long the host's own network was down in this leg. Such time is no
// absence of a team; longer than `limit` it makes the leg void.
Verdict judge_absences(const match::ByTeam<Standing>& teams, double host_was_down, double limit);

}  // namespace mirocup::dds
