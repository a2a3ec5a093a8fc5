// SPDX-License-Identifier: MIT
#include "core/replay/recorded.hpp"

namespace mirocup::replay {

namespace {

match::Command answer(const Recording& recording, std::uint32_t tick, Team team) {
  const match::DrivenCommand& driven = recording.ticks[tick].commands[index_of(team)];
  match::Command command;
  for (int i = 0; i < max_robots_per_team; ++i) command.wheels[i] = driven.speeds(i);
  command.placement = requested_in(recording, tick, team);
  return command;
}

match::Answer last_answer(const Recording& recording, Team team) {
  for (const match::TeamFault& fault : recording.outcome.faults) {
    if (fault.team == team) return fault.fault;
  }
  if (recording.outcome.kind == match::OutcomeKind::void_) {
    return match::HostFailure{recording.outcome.why_void};
  }
  return match::Command{};
}

}  // namespace

match::ByTeam<match::Answer> recorded_answers(const Recording& recording, std::uint32_t tick) {
  if (tick >= recording.ticks.size()) {
    return {last_answer(recording, Team::blue), last_answer(recording, Team::yellow)};
  }
  return {answer(recording, tick, Team::blue), answer(recording, tick, Team::yellow)};
}

}  // namespace mirocup::replay
