// SPDX-License-Identifier: MIT
#include "server/dds/liveliness.hpp"

namespace mirocup::dds {

namespace {

constexpr std::size_t max_listed = 100;

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
  return {.seen = away_since_ ? std::nullopt : std::optional(heard_), .lost_at = lost_at(now)};
}

Verdict judge_absences(const match::ByTeam<Standing>& teams, double host_was_down, double limit) {
  Verdict verdict{.is_hosts_fault = host_was_down > limit};
  const bool blue = teams[0].lost_at.has_value(), yellow = teams[1].lost_at.has_value();
  if (verdict.is_hosts_fault || (!blue && !yellow)) return verdict;
  const Standing& loser = teams[blue ? 0 : 1];
  const Standing& other = teams[blue ? 1 : 0];
  verdict.awaits_other = blue != yellow && !(other.seen && *other.seen > *loser.lost_at);
  if (!verdict.awaits_other) verdict.lost = {blue, yellow};
  return verdict;
}

}  // namespace mirocup::dds
