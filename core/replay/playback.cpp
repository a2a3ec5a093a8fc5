// SPDX-License-Identifier: MIT
#include "core/replay/playback.hpp"

#include <utility>

namespace mirocup::replay {

match::Answer RecordedTeam::collect() {
  match::Command command;
  if (tick_ < recording_.ticks.size()) {
    const match::DrivenCommand& driven = recording_.ticks[tick_].commands[index_of(team_)];
    for (int i = 0; i < max_robots_per_team; ++i) command.wheels[i] = driven.speeds(i);
    command.poses = asked_in(recording_, tick_, team_);
    return command;
  }
  for (const match::TeamFault& fault : recording_.result.faults) {
    if (fault.team == team_) return fault.fault;
  }
  if (recording_.result.end == match::EndKind::void_) {
    return match::HostFailure{recording_.result.why_void};
  }
  return command;
}

Playback::Playback(const Recording& recording)
    : recording_(recording),
      match_(recording.setup),
      blue_(recording, Team::blue),
      yellow_(recording, Team::yellow) {}

bool Playback::differs(std::uint32_t tick, std::string what) {
  divergence_ = Divergence{tick, std::move(what)};
  return false;
}

void Playback::play() {
  match_.advance(blue_, yellow_);
  if (!recording_.trace.ticks.empty()) trace_.add(match_);
}

// The bodies that differ after the tick, and both states of the first of them at the next
// checkpoint.
std::string Playback::what_differs(std::uint32_t tick) {
  const int robots = match_.field().robots_per_team;
  const auto bodies = differing_bodies(recording_.trace, trace_, tick, 2 * robots + 1);
  if (bodies.empty()) return "";
  std::string text;
  for (const int body : bodies) text += (text.empty() ? "; " : ", ") + body_name(body, robots);
  text += bodies.size() == 1 ? " differs" : " differ";

  const std::size_t checkpoint = (tick + checkpoint_ticks - 1) / checkpoint_ticks;
  const auto& recorded = recording_.trace.checkpoints;
  while (trace_.checkpoints.size() <= checkpoint && checkpoint < recorded.size() &&
         !match_.is_over()) {
    play();
  }
  if (checkpoint >= recorded.size() || checkpoint >= trace_.checkpoints.size()) return text;
  const int body = bodies.front();
  return text + ": after tick " + std::to_string(checkpoint * checkpoint_ticks) +
         " the record has " + body_name(body, robots) + " " +
         body_text(recorded[checkpoint], body, robots) + ", the replay " +
         body_text(trace_.checkpoints[checkpoint], body, robots);
}

bool Playback::advance() {
  if (divergence_ || match_.is_over()) return false;
  const std::uint32_t tick = match_.tick();
  play();
  if (match_.log().size() <= tick) {  // a fault ended it before anything moved
    if (tick == recording_.ticks.size()) return false;
    return differs(tick, "the replay ends here, the record goes on");
  }
  if (tick >= recording_.ticks.size()) {
    return differs(tick, "the record ends here, the replay goes on");
  }
  const std::uint64_t expected = recording_.ticks[tick].hash;
  const std::uint64_t again = match_.log()[tick].hash;
  if (again != expected) {
    return differs(tick, "the state differs: the record's hash is " + to_hex(expected) +
                             ", the replay's " + to_hex(again) + what_differs(tick));
  }
  if (match_.is_over() && match_.log().size() != recording_.ticks.size()) {
    return differs(match_.tick(), "the replay ends here, the record goes on");
  }
  return true;
}

}  // namespace mirocup::replay
