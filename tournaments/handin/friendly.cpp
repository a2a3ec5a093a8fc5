// SPDX-License-Identifier: MIT
#include "tournaments/handin/friendly.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace mirocup::league {

bool is_house(std::string_view opponent) {
  return opponent.starts_with("house:");
}

void Friendlies::add(Friendly friendly) {
  const Key key{friendly.team, friendly.number};
  if (friendly.is_burst) {
    int& last = bursts_[friendly.team];
    last = std::max(last, friendly.entry);
  }
  open_.push_back(key);
  all_[key] = std::move(friendly);
}

void Friendlies::finish(const std::string& team, int number, FriendlyState state, int goals,
                        int against, const std::string& end) {
  const auto found = all_.find({team, number});
  if (found == all_.end()) return;
  found->second.state = state;
  found->second.goals = goals;
  found->second.against = against;
  found->second.end = end;
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
    const bool is_playing = std::any_of(open_.begin(), open_.end(), [&](const Key& other) {
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
  std::stable_sort(own.begin(), own.end(), [](const Friendly* a, const Friendly* b) {
    return a->at != b->at ? a->at > b->at : a->number < b->number;
  });
  return own;
}

std::vector<int> Friendlies::waiting_of_older(const std::string& team, int entry) const {
  std::vector<int> numbers;
  for (const Key& key : open_) {
    const Friendly& one = all_.at(key);
    if (key.first == team && one.entry < entry && one.state == FriendlyState::waiting)
      numbers.push_back(key.second);
  }
  return numbers;
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
