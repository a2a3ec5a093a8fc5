// SPDX-License-Identifier: MIT
#include "tournaments/publish/release.hpp"

#include "tournaments/publish/snapshot.hpp"

namespace mirocup::league {

bool is_all_released(const LeagueState& state) {
  return state.release.level == ReleaseLevel::all && state.release.through.empty();
}

Result<LeagueState> released_state(const LeagueState& whole, const Journal& journal) {
  if (is_all_released(whole)) return whole;
  if (whole.release.through.empty()) return state_before_rounds(whole, journal);
  return state_through(whole, journal, whole.release.through);
}

}  // namespace mirocup::league
