// SPDX-License-Identifier: MIT
#include "tournaments/handin/queue.hpp"

#include <algorithm>

namespace mirocup::league {

SourceKind source_kind_of(std::string_view file) {
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

void HandInQueue::add(WaitingHandIn handed) {
  const Key key{handed.team, handed.entry};
  put_behind(all_[key] = std::move(handed));
}

void HandInQueue::put_behind(WaitingHandIn& handed) {
  const Key key{handed.team, handed.entry};
  const auto last = last_round_.find(handed.team);
  handed.round = last == last_round_.end() ? round_ : std::max(round_, last->second + 1);
  last_round_[handed.team] = handed.round;
  std::erase(waiting_, key);
  if (!is_final(handed.state)) waiting_.push_back(key);
}

void HandInQueue::answer(const std::string& team, int entry, HandInState state,
                         const std::string& message, int plays) {
  const Key key{team, entry};
  const auto found = all_.find(key);
  if (found == all_.end() || is_final(found->second.state)) return;
  found->second.state = state;
  found->second.message = message;
  found->second.plays = plays;
  round_ = std::max(round_, found->second.round);
  std::erase(waiting_, key);
}

void HandInQueue::begin(const std::string& team, int entry, HandInState state) {
  const auto found = all_.find({team, entry});
  if (found == all_.end()) return;
  found->second.state = state;
  round_ = std::max(round_, found->second.round);
}

void HandInQueue::wait_again(const std::string& team, int entry, NoAnswer why) {
  const auto found = all_.find({team, entry});
  if (found == all_.end() || is_final(found->second.state)) return;
  found->second.state = HandInState::queued;
  ++found->second.unanswered[static_cast<std::size_t>(why)];
  if (why != NoAnswer::host_failed) put_behind(found->second);
}

const WaitingHandIn* HandInQueue::to_stop(const std::vector<RunningCheck>& running) const {
  if (next() == nullptr) return nullptr;
  // The first in the order of turns, so that it stays the same until its end.
  const auto ordered = order();
  const auto left_alone =
      std::find_if(ordered.begin(), ordered.end(), [](const WaitingHandIn* handed) {
        return handed->state != HandInState::queued &&
               handed->times(NoAnswer::gave_way) >= gives_way_at_most;
      });
  const WaitingHandIn* stopped = nullptr;
  double longest = 0.0;
  for (const RunningCheck& check : running) {
    const WaitingHandIn* handed = find(check.team, check.entry);
    const bool is_left_alone = left_alone != ordered.end() && handed == *left_alone;
    const double used = check.processor + check.asleep;
    if (handed == nullptr || is_left_alone || used < turn || used < longest) continue;
    stopped = handed;
    longest = used;
  }
  return stopped;
}

std::vector<const WaitingHandIn*> HandInQueue::order() const {
  std::vector<const WaitingHandIn*> ordered;
  for (const Key& key : waiting_) ordered.push_back(&all_.at(key));
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const auto* a, const auto* b) { return a->round < b->round; });
  return ordered;
}

const WaitingHandIn* HandInQueue::next() const {
  const auto ordered = order();
  const auto is_checked = [&](const std::string& team) {
    return std::any_of(ordered.begin(), ordered.end(), [&](const WaitingHandIn* handed) {
      return handed->team == team && handed->state != HandInState::queued;
    });
  };
  const auto found = std::find_if(ordered.begin(), ordered.end(), [&](const WaitingHandIn* handed) {
    return handed->state == HandInState::queued && !is_checked(handed->team);
  });
  return found == ordered.end() ? nullptr : *found;
}

int HandInQueue::before(const std::string& team, int entry) const {
  const auto ordered = order();
  const auto own = std::find_if(ordered.begin(), ordered.end(), [&](const WaitingHandIn* handed) {
    return handed->team == team && handed->entry == entry;
  });
  return own == ordered.end() ? 0 : static_cast<int>(own - ordered.begin());
}

const WaitingHandIn* HandInQueue::find(const std::string& team, int entry) const {
  const auto found = all_.find({team, entry});
  return found == all_.end() ? nullptr : &found->second;
}

std::vector<const WaitingHandIn*> HandInQueue::latest_of(const std::string& team, std::size_t most,
                                                         int before) const {
  std::vector<const WaitingHandIn*> own;
  for (auto at = all_.lower_bound({team, before}); at != all_.begin() && own.size() < most;) {
    if ((--at)->first.first != team) break;
    own.push_back(&at->second);
  }
  return own;
}

int HandInQueue::unanswered(const std::string& team) const {
  return static_cast<int>(std::count_if(waiting_.begin(), waiting_.end(),
                                        [&](const Key& key) { return key.first == team; }));
}

std::map<std::string, int> HandInQueue::accepted() const {
  std::map<std::string, int> latest;  // a team's entries are in their order
  for (const auto& [key, handed] : all_) {
    if (handed.state == HandInState::accepted) latest[key.first] = key.second;
  }
  return latest;
}

int HandInQueue::last_entry(const std::string& team) const {
  const auto own = latest_of(team, 1);
  return own.empty() ? 0 : own.front()->entry;
}

}  // namespace mirocup::league
