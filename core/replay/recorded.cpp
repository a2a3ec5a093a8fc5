// SPDX-License-Identifier: MIT
#include "core/replay/recorded.hpp"

namespace mirocup::replay {

match::Answer Recorded::collect() {
  if (tick_ < recording_.ticks.size()) return command(tick_);
  for (const match::TeamFault& fault : recording_.result.faults) {
    if (fault.team == team_) return fault.fault;
  }
  if (recording_.result.end == match::EndKind::void_) {
    return match::HostFailure{recording_.result.why_void};
  }
  return match::Command{};
}

match::Command Recorded::command(std::uint32_t tick) const {
  const match::DrivenCommand& driven = recording_.ticks[tick].commands[index_of(team_)];
  match::Command command;
  for (int i = 0; i < max_robots_per_team; ++i) command.wheels[i] = driven.speeds(i);
  command.poses = asked_in(recording_, tick, team_);
  return command;
}

}  // namespace mirocup::replay
