// SPDX-License-Identifier: MIT
#include "core/replay/recording.hpp"

#include <algorithm>
#include <utility>

namespace mirocup::replay {

Recording record(const match::Match& match, Trace trace) {
  return {.setup = match.setup(),
          .ticks = match.log(),
          .asked = match.asked(),
          .decisions = match.decisions(),
          .result = match.result(),
          .state_hash = match.state_hash(),
          .trace = std::move(trace)};
}

std::optional<match::Poses> asked_in(const Recording& recording, std::uint32_t tick, Team team) {
  auto at = std::lower_bound(
      recording.asked.begin(), recording.asked.end(), tick,
      [](const match::LoggedPoses& logged, std::uint32_t t) { return logged.tick < t; });
  for (; at != recording.asked.end() && at->tick == tick; ++at) {
    if (at->team == team) return at->poses;
  }
  return std::nullopt;
}

}  // namespace mirocup::replay
