// SPDX-License-Identifier: MIT
#include "server/dds/liveliness.hpp"

namespace mirocup::dds {

namespace {

constexpr std::size_t max_listed = 100;

// True if the team has been there after `moment`.
bool was_seen_after(double moment, const Presence& presence) {
  if (std::holds_alternative<Elsewhere>(presence)) return true;
  if (const auto* present = std::get_if<Present>(&presence)) return present->heard > moment;
  if (const auto* late = std::get_if<Owing>(&presence)) return late->heard > moment;
  return false;
}

}  // namespace

bool Liveliness::answered(std::uint32_t tick, double now) {
  owes_ = false;
  silent_since_ = heard_ = now;
  next_tick_ = tick + 1;
  return end_absence(tick, now);
}

bool Liveliness::answered_late(std::uint32_t tick, std::uint32_t present, double now) {
  silent_since_ = heard_ = now;
  next_tick_ = std::max(next_tick_, tick + 1);
  return end_absence(present, now);
}

bool Liveliness::end_absence(std::uint32_t tick, double now) {
  if (!away_since_) return false;
  lost_at_ = lost_at(now);
  away_ += now - *away_since_;
  away_since_.reset();
  if (is_listed_) absences_.back().back = tick;
  return true;
}

bool Liveliness::silent(std::uint32_t tick, double now, bool has_left) {
  if (away_since_ || !silent_since_) return false;
  if (!has_left && now - *silent_since_ < notice_) return false;
  away_since_ = now;
  present_ = {.tick = std::min(next_tick_, tick),
              .noticed = tick,
              .back = std::nullopt,
              .has_left = has_left};
  is_listed_ = absences_.size() < max_listed;
  if (is_listed_) absences_.push_back(present_);
  return true;
}

std::optional<double> Liveliness::lost_at(double now) const {
  if (lost_at_ || !away_since_ || away(now) <= limit_) return lost_at_;
  return *away_since_ + limit_ - away_;
}

Standing Liveliness::standing(double now) const {
  Presence presence = Present{heard_};
  if (away_since_ && present_.has_left) {
    presence = Left{*away_since_, present_.noticed};
  } else if (away_since_) {
    presence = Away{*away_since_, present_.noticed};
  } else if (owes_) {
    presence = Owing{heard_};
  }
  return {presence, lost_at(now)};
}

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
