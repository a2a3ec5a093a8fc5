// SPDX-License-Identifier: MIT
#include "server/dds/liveliness.hpp"

namespace mirocup::dds {

namespace {

constexpr std::size_t max_listed = 100;

}  // namespace

bool Liveliness::answered(std::uint32_t tick, double now) {
  asked_at_.reset();
  next_tick_ = tick + 1;
  if (!away_since_) return false;
  away_ += now - *away_since_;
  away_since_.reset();
  if (is_listed_) absences_.back().back = tick;
  return true;
}

bool Liveliness::silent(std::uint32_t tick, double now, bool has_left) {
  if (away_since_ || !asked_at_) return false;
  if (!has_left && now - *asked_at_ < notice_) return false;
  away_since_ = now;
  is_listed_ = absences_.size() < max_listed;
  if (is_listed_) {
    absences_.push_back(
        {.tick = next_tick_, .noticed = tick, .back = std::nullopt, .has_left = has_left});
  }
  return true;
}

}  // namespace mirocup::dds
