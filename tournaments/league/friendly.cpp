// SPDX-License-Identifier: MIT
#include "tournaments/league/friendly.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace mirocup::league {

bool is_house(std::string_view opponent) {
  return opponent.starts_with("house:");
}

void Friendlies::apply(Friendly friendly) {
  const Key key{friendly.team, friendly.number};
  open_.push_back(key);
  all_[key] = std::move(friendly);
}

void Friendlies::apply(const Burst& burst) {
  std::erase_if(open_, [&](const Key& key) {
    Friendly& one = all_.at(key);
    const bool is_late =
        key.first == burst.team && one.entry < burst.entry && one.state == FriendlyState::waiting;
    if (!is_late) return false;
    one.state = FriendlyState::void_;
    one.end = "a later entry was accepted";
    return true;
  });
  int& last = bursts_[burst.team];
  last = std::max(last, burst.entry);
  for (const Burst::Leg& leg : burst.legs) {
    apply(Friendly{.team = burst.team,
                   .number = last_number(burst.team) + 1,
                   .entry = burst.entry,
                   .opponent = leg.opponent,
                   .opponent_entry = leg.opponent_entry,
                   .at = burst.at,
                   .is_burst = true});
  }
}

void Friendlies::apply(const FriendlyEnded& ended) {
  const auto found = all_.find({ended.team, ended.number});
  if (found == all_.end()) return;
  found->second.state = ended.state;
  found->second.goals = ended.goals;
  found->second.against = ended.against;
  found->second.end = ended.end;
  std::erase(open_, found->first);
}

void Friendlies::begin(const std::string& team, int number) {
  const auto found = all_.find({team, number});
  if (found == all_.end()) return;
  found->second.state = FriendlyState::playing;
  turn_[team] = ++turns_;
}

void Friendlies::wait_again(const std::string& team, int number, bool is_spoiled) {
  const auto found = all_.find({team, number});
  if (found == all_.end() || found->second.state != FriendlyState::playing) return;
  found->second.state = FriendlyState::waiting;
  if (is_spoiled) ++found->second.failures;
}

const Friendly* Friendlies::next() const {
  const Friendly* best = nullptr;
  long best_turn = 0;
  for (const Key& key : open_) {
    const Friendly& one = all_.at(key);
    if (one.state != FriendlyState::waiting) continue;
    const bool is_playing = std::ranges::any_of(open_, [&](const Key& other) {
      return other.first == key.first && all_.at(other).state == FriendlyState::playing;
    });
    const auto turn = turn_.find(key.first);
    const long last = turn == turn_.end() ? 0 : turn->second;
    if (is_playing || (best != nullptr && last >= best_turn)) continue;
    best = &one;
    best_turn = last;
  }
  return best;
}

const Friendly* Friendlies::find(const std::string& team, int number) const {
  const auto found = all_.find({team, number});
  return found == all_.end() ? nullptr : &found->second;
}

int Friendlies::last_number(const std::string& team) const {
  const auto end = all_.upper_bound({team, std::numeric_limits<int>::max()});
  if (end == all_.begin()) return 0;
  const Key& last = std::prev(end)->first;
  return last.first == team ? last.second : 0;
}

std::vector<const Friendly*> Friendlies::of_team(const std::string& team) const {
  std::vector<const Friendly*> own;
  for (const auto& [key, one] : all_) {
    if (key.first == team || (one.opponent == team && !one.is_burst)) own.push_back(&one);
  }
  std::ranges::stable_sort(own, [](const Friendly* a, const Friendly* b) {
    return a->at != b->at ? a->at > b->at : a->number < b->number;
  });
  return own;
}

bool Friendlies::has_burst(const std::string& team, int entry) const {
  const auto found = bursts_.find(team);
  return found != bursts_.end() && found->second >= entry;
}

int Friendlies::asked_in_last_hour(const std::string& team, std::int64_t now) const {
  constexpr std::int64_t hour = 3600;  // s
  int count = 0;
  for (auto at = all_.lower_bound({team, 0}); at != all_.end() && at->first.first == team; ++at) {
    if (!at->second.is_burst && std::abs(now - at->second.at) < hour) ++count;
  }
  return count;
}

}  // namespace mirocup::league
