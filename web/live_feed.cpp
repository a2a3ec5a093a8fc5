// SPDX-License-Identifier: MIT
#include "web/live_feed.hpp"

#include "record/match_record.hpp"
#include "web/page_parts.hpp"

#include <nlohmann/json.hpp>

#include <cassert>

namespace mirocup::web {

namespace {

constexpr std::uint64_t statistics_every = 30;  // states

Json decisions_json(const std::vector<match::LoggedDecision>& decisions, std::size_t from) {
  Json calls = Json::array();
  for (std::size_t i = from; i < decisions.size(); ++i) {
    calls.push_back(record::to_json(decisions[i]));
  }
  return calls;
}

}  // namespace

LiveFeed::LiveFeed(const match::Leg& match)
    : robots_(match.field().robots_per_team), counted_(match), statistics_(match) {
  copy(match);
}

void LiveFeed::copy(const match::Leg& match) {
  ++version_;
  scene_ = match.snapshot();
  const auto& decisions = match.decisions();
  decisions_.insert(decisions_.end(),
                    decisions.begin() + static_cast<std::ptrdiff_t>(decisions_.size()),
                    decisions.end());
  statistics_ = counted_;
}

void LiveFeed::publish(const match::Leg& match) {
  counted_.add(match);
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (lock.owns_lock()) copy(match);
}

void LiveFeed::close(const match::Leg& match) {
  const std::lock_guard lock(mutex_);
  copy(match);
  assert(match.is_over());
  result_ = match.outcome();
}

std::string LiveFeed::news(Viewer& viewer) const {
  std::unique_lock lock(mutex_);
  if (viewer.version == version_ || viewer.has_ended) return "";
  const match::Snapshot scene = scene_;
  const std::vector<match::LoggedDecision> decisions(
      decisions_.begin() + static_cast<std::ptrdiff_t>(viewer.decisions), decisions_.end());
  const std::optional<match::Outcome> result = result_;
  std::optional<Json> numbers;
  if (!viewer.has_started || result || version_ - viewer.statistics >= statistics_every) {
    numbers = statistics_json(statistics_.statistics());
    viewer.statistics = version_;
  }
  viewer.version = version_;
  lock.unlock();

  std::string text;
  if (!viewer.has_started) {
    text += event_text("start", {{"decisions", decisions_json(decisions, 0)}});
  } else {
    for (const Json& call : decisions_json(decisions, 0)) text += event_text("call", call);
  }
  viewer.has_started = true;
  viewer.decisions += decisions.size();
  viewer.frame = frame_of(scene, robots_, viewer.frame);
  text += event_text("frame", {{"tick", scene.tick},
                               {"frame", viewer.frame},
                               {"moment", moment_json(scene)},
                               {"keepers", keepers_json(scene)}});
  if (numbers) text += event_text("statistics", *numbers);
  if (result) {
    text += event_text("end", record::to_json(*result));
    viewer.has_ended = true;
  }
  return text;
}

}  // namespace mirocup::web
