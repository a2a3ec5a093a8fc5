// SPDX-License-Identifier: MIT
#include "core/replay/recorded.hpp"

namespace mirocup::replay {

namespace {

match::Command driven(const match::DrivenCommand& recorded, int robots) {
  match::Command command;
  for (int i = 0; i < robots; ++i) command.wheels[i] = recorded.speeds(i);
  return command;
}

match::Answer last_answer(const Recording& recording, Team team) {
  for (const match::TeamFault& fault : recording.result.faults) {
    if (fault.team == team) return fault.fault;
  }
  if (recording.result.end == match::EndKind::void_) {
    return match::HostFailure{recording.result.why_void};
  }
  return match::Command{};
}

}  // namespace

match::ByTeam<match::Answer> recorded_answers(const Recording& recording, std::uint32_t tick) {
  if (tick >= recording.ticks.size()) {
    return {last_answer(recording, Team::blue), last_answer(recording, Team::yellow)};
  }
  const match::ByTeam<match::DrivenCommand>& commands = recording.ticks[tick].commands;
  return {driven(commands[0], max_robots_per_team), driven(commands[1], max_robots_per_team)};
}

}  // namespace mirocup::replay
