// SPDX-License-Identifier: MIT
#include "server/web/live_server.hpp"

#include <httplib.h>

#include <charconv>
#include <chrono>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>

namespace mirocup::web {

namespace {

using namespace std::chrono_literals;

constexpr int most_viewers = 128;
constexpr int threads_for_pages = 8;
constexpr auto look_again = 33ms;
constexpr int patience_s = 5;      // with a viewer that takes nothing
constexpr auto farewell = 1500ms;  // for the viewers to hear how it ended
constexpr int lower_priority = 10;

}  // namespace

Result<Address> parse_address(const std::string& text) {
  Address address;
  const std::size_t colon = text.rfind(':');
  std::string port = text;
  if (colon != std::string::npos) {
    address.host = text.substr(0, colon);
    port = text.substr(colon + 1);
    if (address.host.size() > 2 && address.host.front() == '[' && address.host.back() == ']') {
      address.host = address.host.substr(1, address.host.size() - 2);
    }
  }
  const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), address.port);
  if (error != std::errc() || end != port.data() + port.size() || address.host.empty() ||
      address.port < 0 || address.port > 65535) {
    return fail(Errc::input, "--watch " + text + ": PORT or HOST:PORT is expected");
  }
  return address;
}

struct LiveServer::Impl {
  Impl(const match::Match& match, std::string text) : feed(match), page(std::move(text)) {}

  void serve_events(httplib::Response& response) {
    if (viewers.fetch_add(1) >= most_viewers) {
      --viewers;
      response.status = 503;
      return;
    }
    const auto viewer = std::make_shared<LiveFeed::Viewer>();
    response.set_chunked_content_provider(
        "text/event-stream",
        [this, viewer](std::size_t, httplib::DataSink& sink) {
          const std::string news = feed.news(*viewer);
          if (!news.empty() && !sink.write(news.data(), news.size())) return false;
          if (viewer->has_ended || is_closed) {
            sink.done();
          } else {
            std::this_thread::sleep_for(look_again);
          }
          return true;
        },
        [this](bool) { --viewers; });
  }

  LiveFeed feed;
  std::string page;
  Address address;
  std::atomic<int> viewers{0};
  std::atomic<bool> is_closed{false};
  httplib::Server http;
  std::thread thread;
};

LiveServer::LiveServer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Result<std::unique_ptr<LiveServer>> LiveServer::open(const Address& address,
                                                     const match::Match& match,
                                                     const match::ByTeam<std::string>& names,
                                                     const std::string& about) {
  auto owned = std::make_unique<Impl>(match, live_page(match, {names, about, "events"}));
  Impl& impl = *owned;
  impl.http.new_task_queue = [] {
    return new httplib::ThreadPool(most_viewers + threads_for_pages);
  };
  impl.http.set_write_timeout(patience_s);
  impl.http.set_read_timeout(patience_s);
  impl.http.set_keep_alive_max_count(1);
  impl.http.set_default_headers(
      {{"Cache-Control", "no-store"}, {"X-Content-Type-Options", "nosniff"}});
  impl.http.Get("/", [&impl](const httplib::Request&, httplib::Response& response) {
    response.set_content(impl.page, "text/html; charset=utf-8");
  });
  impl.http.Get("/events", [&impl](const httplib::Request&, httplib::Response& response) {
    impl.serve_events(response);
  });
  impl.address = address;
  if (address.port == 0) {
    impl.address.port = impl.http.bind_to_any_port(address.host);
  } else if (!impl.http.bind_to_port(address.host, address.port)) {
    impl.address.port = -1;
  }
  if (impl.address.port < 0) {
    return fail(Errc::unavailable, "--watch: " + address.host + " port " +
                                       std::to_string(address.port) +
                                       " is in use or not an address of this host");
  }
  impl.thread = std::thread([&impl] {
    // The threads that this one starts inherit it: the match comes first.
    setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), lower_priority);
    impl.http.listen_after_bind();
  });
  while (!impl.http.is_running()) std::this_thread::yield();
  return std::unique_ptr<LiveServer>(new LiveServer(std::move(owned)));
}

LiveServer::~LiveServer() {
  impl_->is_closed = true;
  impl_->http.stop();
  impl_->thread.join();
}

std::string LiveServer::url() const {
  const std::string& host = impl_->address.host;
  const bool is_v6 = host.find(':') != std::string::npos;
  return "http://" + (is_v6 ? "[" + host + "]" : host) + ":" + std::to_string(impl_->address.port) +
         "/";
}

void LiveServer::publish(const match::Match& match) {
  impl_->feed.publish(match);
}

void LiveServer::close(const match::Match& match) {
  impl_->feed.close(match);
  const auto end = std::chrono::steady_clock::now() + farewell;
  while (impl_->viewers > 0 && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(look_again);
  }
}

}  // namespace mirocup::web
