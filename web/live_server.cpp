// SPDX-License-Identifier: MIT
#include "web/live_server.hpp"

#include "record/match_record.hpp"
#include "web/page_parts.hpp"

#include <nlohmann/json.hpp>

#include <cassert>
#include <chrono>
#include <thread>

namespace mirocup::web {

namespace {

using namespace std::chrono_literals;

constexpr std::uint64_t statistics_every = 30;  // states
constexpr auto close_timeout = 1500ms;          // for the viewers to receive the result
constexpr auto look_interval = 33ms;            // between two checks whether they have it

Json decisions_json(const std::vector<match::LoggedDecision>& decisions) {
  Json calls = Json::array();
  for (const auto& decision : decisions) calls.push_back(record::to_json(decision));
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
    text += event_text("start", {{"decisions", decisions_json(decisions)}});
  } else {
    for (const Json& call : decisions_json(decisions)) text += event_text("call", call);
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

Reply LiveServer::answer(const Request& request) {
  const bool is_page = request.path == "/";
  if (!is_page && request.path != "/events") return {.status = 404};
  if (!request.is_reading()) return {.status = 405, .headers = {{"Allow", "GET"}}};
  if (is_page) return {.type = "text/html; charset=utf-8", .bytes = page_};
  return {.events = [this, viewer = LiveFeed::Viewer()]() mutable {
    std::string news = feed_.news(viewer);
    return EventBatch{std::move(news), viewer.has_ended};
  }};
}

Result<std::unique_ptr<LiveServer>> LiveServer::open(const Address& address,
                                                     const match::Leg& match,
                                                     const match::ByTeam<std::string>& names,
                                                     const std::string& about) {
  std::unique_ptr<LiveServer> server(new LiveServer(match, live_page(match, names, about)));
  MIROCUP_TRY_VOID(server->http_.listen(address, "--watch"));
  return server;
}

void LiveServer::close(const match::Leg& match) {
  feed_.close(match);
  const auto end = std::chrono::steady_clock::now() + close_timeout;
  while (http_.viewers() > 0 && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(look_interval);
  }
}

}  // namespace mirocup::web
