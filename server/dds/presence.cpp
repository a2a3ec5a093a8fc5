// SPDX-License-Identifier: MIT
#include "server/dds/presence.hpp"

namespace mirocup::dds {

namespace {

// True if the team has been there after `moment`.
bool was_seen_after(double moment, const Presence& presence) {
  if (std::holds_alternative<Elsewhere>(presence)) return true;
  if (const auto* present = std::get_if<Present>(&presence)) return present->heard > moment;
  if (const auto* late = std::get_if<Late>(&presence)) return late->heard > moment;
  return false;
}

}  // namespace

Verdict judge_absences(const match::ByTeam<Standing>& teams, double host_was_down, double limit) {
  if (host_was_down > limit) return HostAtFault{};
  Disconnected lost;
  for (const Team team : both_teams) {
    lost.teams[index_of(team)] = teams[index_of(team)].lost_at.has_value();
  }
  if (!lost.teams[0] && !lost.teams[1]) return PlayOn{};
  if (lost.teams[0] && lost.teams[1]) return lost;
  const Standing& loser = teams[lost.teams[0] ? 0 : 1];
  const Standing& other = teams[lost.teams[0] ? 1 : 0];
  if (was_seen_after(*loser.lost_at, other.presence)) return lost;
  return AwaitOther{};
}

}  // namespace mirocup::dds
