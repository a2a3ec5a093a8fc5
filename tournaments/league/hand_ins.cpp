// SPDX-License-Identifier: MIT
#include "tournaments/league/hand_ins.hpp"

#include "system/text.hpp"

#include <algorithm>
#include <cstdlib>

namespace mirocup::league {

namespace {

int in_last_hour(const std::vector<std::int64_t>& times, std::int64_t now) {
  constexpr std::int64_t hour = 3600;  // s
  return static_cast<int>(
      std::ranges::count_if(times, [now](std::int64_t at) { return std::abs(now - at) < hour; }));
}

// Returns the number of the last entry for which `is_one` is true; 0 if there is none.
int last_with(const std::map<int, HandedIn>& entries, bool (HandedIn::*is_one)() const) {
  const auto last = std::find_if(entries.rbegin(), entries.rend(),
                                 [is_one](const auto& one) { return (one.second.*is_one)(); });
  return last == entries.rend() ? 0 : last->first;
}

}  // namespace

SourceKind source_kind_of(std::string_view name) {
  const std::string file = system::lower_case(std::string(name));
  for (const std::string_view end : {".cpp", ".cc", ".cxx"}) {
    if (file.ends_with(end)) return SourceKind::cpp;
  }
  for (const std::string_view end : {".tar", ".tar.gz", ".tgz", ".zip"}) {
    if (file.ends_with(end)) return SourceKind::project;
  }
  return file.ends_with(".c") ? SourceKind::c : SourceKind::none;
}

std::string language_of(SourceKind kind) {
  switch (kind) {
    case SourceKind::c:
      return "c";
    case SourceKind::project:
      return "project";
    case SourceKind::cpp:
    case SourceKind::none:
      break;
  }
  return "c++";
}

const HandIns::Team& HandIns::about(const std::string& team) const {
  static const Team nothing;
  const auto found = teams_.find(team);
  return found == teams_.end() ? nothing : found->second;
}

const HandedIn* HandIns::find(const std::string& team, int entry) const {
  const auto& entries = about(team).entries;
  const auto found = entries.find(entry);
  return found == entries.end() ? nullptr : &found->second;
}

HandedIn* HandIns::known(const std::string& team, int entry) {
  return const_cast<HandedIn*>(find(team, entry));
}

void HandIns::apply(HandedIn handed) {
  Team& team = teams_[handed.team];
  if (!handed.file.empty()) {
    team.tries.push_back(handed.at);
    team.last_try = handed.entry;
  }
  HandedIn& added = team.entries[handed.entry] = std::move(handed);
  if (added.is_network) put_behind(added);
}

void HandIns::put_behind(HandedIn& handed) {
  int& last = teams_[handed.team].last_round;
  handed.round = last = std::max(round_, last + 1);
  std::erase(waiting_, &handed);
  if (!is_final(handed.state)) waiting_.push_back(&handed);
}

void HandIns::apply(const Answered& answer) {
  HandedIn* handed = known(answer.team, answer.entry);
  if (handed == nullptr || is_final(handed->state)) return;
  handed->state = answer.state;
  handed->message = answer.message;
  handed->plays = answer.plays;
  handed->library = answer.library;
  round_ = std::max(round_, handed->round);
  std::erase(waiting_, handed);
}

void HandIns::apply(const Rejected& rejected) {
  Team& team = teams_[rejected.team];
  team.tries.push_back(rejected.at);
  team.last_try = 0;
  team.rejected = {.team = rejected.team,
                   .at = rejected.at,
                   .state = HandInState::refused,
                   .message = rejected.message};
}

void HandIns::apply(const Dropped& dropped) {
  for (const int entry : dropped.entries) {
    if (HandedIn* handed = known(dropped.team, entry)) handed->library.clear();
  }
}

void HandIns::apply(const TakenLate& taken) {
  HandedIn* handed = known(taken.team, taken.entry);
  if (handed == nullptr) return;
  handed->is_late = false;
  handed->message += "; the host has taken it";
}

void HandIns::apply(const Pinned& pinned) {
  Team& team = teams_[pinned.team];
  team.pinned = pinned.entry;
  team.pins.push_back(pinned.at);
}

void HandIns::begin(const std::string& team, int entry, HandInState state) {
  HandedIn* handed = known(team, entry);
  if (handed == nullptr) return;
  handed->state = state;
  round_ = std::max(round_, handed->round);
}

void HandIns::wait_again(const std::string& team, int entry, NoAnswer why) {
  HandedIn* handed = known(team, entry);
  if (handed == nullptr || is_final(handed->state)) return;
  handed->state = HandInState::queued;
  ++handed->unanswered[static_cast<std::size_t>(why)];
  if (why != NoAnswer::host_failed) put_behind(*handed);
}

const HandedIn* HandIns::to_stop(const std::vector<RunningCheck>& running) const {
  if (next() == nullptr) return nullptr;
  // The first in the order of turns, so that it stays the same until its end.
  const auto ordered = waiting();
  const auto left_alone = std::ranges::find_if(ordered, [](const HandedIn* handed) {
    return handed->state != HandInState::queued &&
           handed->times(NoAnswer::gave_way) >= gives_way_at_most;
  });
  const HandedIn* stopped = nullptr;
  double longest = 0.0;
  for (const RunningCheck& check : running) {
    const HandedIn* handed = find(check.team, check.entry);
    const bool is_left_alone = left_alone != ordered.end() && handed == *left_alone;
    const double used = check.processor + check.asleep;
    if (handed == nullptr || is_left_alone || used < turn || used < longest) continue;
    stopped = handed;
    longest = used;
  }
  return stopped;
}

std::vector<const HandedIn*> HandIns::waiting() const {
  std::vector<const HandedIn*> ordered = waiting_;
  std::ranges::stable_sort(ordered, {}, &HandedIn::round);
  return ordered;
}

const HandedIn* HandIns::next() const {
  const auto ordered = waiting();
  const auto is_checked = [&](const std::string& team) {
    return std::ranges::any_of(ordered, [&](const HandedIn* handed) {
      return handed->team == team && handed->state != HandInState::queued;
    });
  };
  const auto found = std::ranges::find_if(ordered, [&](const HandedIn* handed) {
    return handed->state == HandInState::queued && !is_checked(handed->team);
  });
  return found == ordered.end() ? nullptr : *found;
}

int HandIns::before(const std::string& team, int entry) const {
  const auto ordered = waiting();
  const auto own = std::ranges::find(ordered, find(team, entry));
  return own == ordered.end() ? 0 : static_cast<int>(own - ordered.begin());
}

int HandIns::waiting(const std::string& team) const {
  return static_cast<int>(std::ranges::count(waiting_, team, &HandedIn::team));
}

const std::map<int, HandedIn>& HandIns::of_team(const std::string& team) const {
  return about(team).entries;
}

int HandIns::last_number(const std::string& team) const {
  const auto& entries = of_team(team);
  return entries.empty() ? 0 : entries.rbegin()->first;
}

int HandIns::last_kept(const std::string& team) const {
  return last_with(of_team(team), &HandedIn::is_kept);
}

int HandIns::last_accepted(const std::string& team) const {
  return last_with(of_team(team), &HandedIn::may_play);
}

int HandIns::pinned(const std::string& team) const {
  return about(team).pinned;
}

int HandIns::playing(const std::string& team) const {
  const HandedIn* pinned = find(team, about(team).pinned);
  return pinned != nullptr && pinned->may_play() ? pinned->entry : last_accepted(team);
}

const HandedIn* HandIns::last_try(const std::string& team) const {
  const Team& known = about(team);
  if (known.tries.empty()) return nullptr;
  return known.last_try > 0 ? find(team, known.last_try) : &known.rejected;
}

int HandIns::tries_in_last_hour(const std::string& team, std::int64_t now) const {
  return in_last_hour(about(team).tries, now);
}

int HandIns::pins_in_last_hour(const std::string& team, std::int64_t now) const {
  return in_last_hour(about(team).pins, now);
}

std::vector<int> HandIns::to_drop(const std::string& team, const std::set<int>& played,
                                  int versions) const {
  const std::set<int> staying{playing(team), last_accepted(team), last_kept(team)};
  std::vector<int> dropped;
  std::vector<int> accepted;
  int not_played = 0;
  for (const auto& [number, handed] : of_team(team)) {
    if (!handed.is_kept() || played.contains(number)) continue;
    ++not_played;
    if (!staying.contains(number)) (handed.is_accepted() ? accepted : dropped).push_back(number);
  }
  dropped.insert(dropped.end(), accepted.begin(), accepted.end());
  const auto too_many = static_cast<std::size_t>(std::max(0, not_played - versions));
  dropped.resize(std::min(dropped.size(), too_many));
  return dropped;
}

std::vector<std::string> HandIns::teams() const {
  std::vector<std::string> names;
  for (const auto& [name, team] : teams_) names.push_back(name);
  return names;
}

}  // namespace mirocup::league
