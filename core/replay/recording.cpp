// SPDX-License-Identifier: MIT
#include "core/replay/recording.hpp"

#include "core/base/assert.hpp"

#include <algorithm>
#include <utility>

namespace mirocup::replay {

Recording record(const match::Leg& leg, StateTrace trace) {
  MIROCUP_ASSERT(leg.is_over());
  return {.setup = leg.setup(),
          .ticks = leg.log(),
          .placement_requests = leg.placement_requests(),
          .decisions = leg.decisions(),
          .outcome = leg.outcome(),
          .state_hash = leg.state_hash(),
          .trace = std::move(trace)};
}

std::optional<match::PlacementRequest> requested_in(const Recording& recording, std::uint32_t tick,
                                                    Team team) {
  auto at = std::lower_bound(
      recording.placement_requests.begin(), recording.placement_requests.end(), tick,
      [](const match::LoggedPlacementRequest& logged, std::uint32_t t) { return logged.tick < t; });
  for (; at != recording.placement_requests.end() && at->tick == tick; ++at) {
    if (at->team == team) return at->request;
  }
  return std::nullopt;
}

}  // namespace mirocup::replay
