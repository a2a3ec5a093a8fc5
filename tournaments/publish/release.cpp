// SPDX-License-Identifier: MIT
#include "tournaments/publish/release.hpp"

#include "tournaments/publish/snapshot.hpp"

namespace mirocup::league {

bool is_all_released(const LeagueState& state) {
  return state.release.level == ReleaseLevel::all && state.release.through.empty();
}

Result<LeagueState> released_state(const LeagueState& whole, const Journal& journal) {
  if (is_all_released(whole)) return whole;
  constexpr const char* before_all = "r0";
  const std::string& through = whole.release.through;
  return state_through(whole, journal, through.empty() ? before_all : through);
}

}  // namespace mirocup::league
