// SPDX-License-Identifier: MIT
//
// The verdict on a leg from the absences of both teams. The function has only the rule: the caller
// passes the state of the teams and of the host's network at one moment.
//
// A team whose absences together have lasted longer than the limit has lost. But a team that is
// away cannot win: the opponents win with their first sign of life after the loss. If the opponents
// are also away, the leg waits for them until their own limit is over; then neither team has won.
//
// Times are seconds of wall time since a common moment.
#pragma once

#include "core/match/snapshot.hpp"

#include <cstdint>
#include <optional>
#include <variant>

namespace mirocup::dds {

// The presence of a team at one moment.
struct Elsewhere {};  // the team does not play over the network; its controller reports its faults
struct Present {
  double heard = 0.0;  // the time of the team's last command
};
struct Late {  // the team owes an answer, but is not yet away
  double heard = 0.0;
};
struct Away {  // the team has been silent for too long
  double since = 0.0;
  std::uint32_t tick = 0;  // the tick in which the server noticed the absence
};
struct Left {  // the team's process has left the network
  double since = 0.0;
  std::uint32_t tick = 0;
};
using Presence = std::variant<Elsewhere, Present, Late, Away, Left>;

struct Standing {
  Presence presence;
  std::optional<double> lost_at;  // when the team's absences together exceeded the limit
};

// The possible verdicts.
struct PlayOn {};
struct AwaitOther {};  // one team has lost, but no command of the opponents has come since
struct Disconnected {
  match::ByTeam<bool> teams{};  // true: the team has lost
};
struct HostAtFault {};
using Verdict = std::variant<PlayOn, AwaitOther, Disconnected, HostAtFault>;

// `host_was_down` is the time for which the host's own network was down in this leg. Such time does
// not count as absence of a team. If the network was down for longer than `limit`, the leg is void.
Verdict judge_absences(const match::ByTeam<Standing>& teams, double host_was_down, double limit);

}  // namespace mirocup::dds
