// SPDX-License-Identifier: MIT
#include "web/live_server.hpp"

#include "web/http/server.hpp"

#include <chrono>
#include <thread>

namespace mirocup::web {

namespace {

using namespace std::chrono_literals;

constexpr auto close_timeout = 1500ms;  // for the viewers to receive the result
constexpr auto look_interval = 33ms;    // between two checks whether they have it

}  // namespace

struct LiveServer::Impl {
  Impl(const match::Leg& match, std::string text) : feed(match), page(std::move(text)) {}

  Reply answer(const Request& request) {
    const bool is_page = request.path == "/";
    if (!is_page && request.path != "/events") return {.status = 404};
    if (!request.is_reading()) return {.status = 405, .headers = {{"Allow", "GET"}}};
    if (is_page) return {.type = "text/html; charset=utf-8", .bytes = page};
    return {.events = [this, viewer = LiveFeed::Viewer()]() mutable {
      std::string news = feed.news(viewer);
      return EventBatch{std::move(news), viewer.has_ended};
    }};
  }

  LiveFeed feed;
  std::string page;
  // The first to go: its threads use the others.
  HttpServer http{[this](const Request& request, const Body&) { return answer(request); }, {}};
};

LiveServer::LiveServer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Result<std::unique_ptr<LiveServer>> LiveServer::open(const Address& address,
                                                     const match::Leg& match,
                                                     const match::ByTeam<std::string>& names,
                                                     const std::string& about) {
  auto owned = std::make_unique<Impl>(match, live_page(match, {names, about, "events"}));
  MIROCUP_TRY_VOID(owned->http.listen(address, "--watch"));
  return std::unique_ptr<LiveServer>(new LiveServer(std::move(owned)));
}

LiveServer::~LiveServer() = default;

std::string LiveServer::url() const {
  return impl_->http.url();
}

void LiveServer::publish(const match::Leg& match) {
  impl_->feed.publish(match);
}

void LiveServer::close(const match::Leg& match) {
  impl_->feed.close(match);
  const auto end = std::chrono::steady_clock::now() + close_timeout;
  while (impl_->http.viewers() > 0 && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(look_interval);
  }
}

}  // namespace mirocup::web
