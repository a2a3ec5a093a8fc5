// SPDX-License-Identifier: MIT
#include "server/web/http.hpp"

#include <charconv>
#include <chrono>
#include <memory>
#include <sys/resource.h>
#include <unistd.h>

namespace mirocup::web {

namespace {

using namespace std::chrono_literals;

constexpr int most_viewers = 128;
constexpr int threads_for_pages = 8;
constexpr auto look_again = 33ms;
constexpr int patience_s = 5;  // with a viewer that takes nothing
constexpr int lower_priority = 10;

}  // namespace

Result<Address> parse_address(const std::string& text, const std::string& option) {
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
    return fail(Errc::input, option + " " + text + ": PORT or HOST:PORT is expected");
  }
  return address;
}

Http::Http() {
  server_.new_task_queue = [] { return new httplib::ThreadPool(most_viewers + threads_for_pages); };
  server_.set_write_timeout(patience_s);
  server_.set_read_timeout(patience_s);
  server_.set_keep_alive_max_count(1);
  server_.set_default_headers(
      {{"Cache-Control", "no-store"}, {"X-Content-Type-Options", "nosniff"}});
}

Http::~Http() {
  is_closed_ = true;
  server_.stop();
  if (thread_.joinable()) thread_.join();
}

Result<void> Http::listen(const Address& address, const std::string& option) {
  address_ = address;
  if (address.port == 0) {
    address_.port = server_.bind_to_any_port(address.host);
  } else if (!server_.bind_to_port(address.host, address.port)) {
    address_.port = -1;
  }
  if (address_.port < 0) {
    return fail(Errc::unavailable, option + ": " + address.host + " port " +
                                       std::to_string(address.port) +
                                       " is in use or not an address of this host");
  }
  thread_ = std::thread([this] {
    // The threads that this one starts inherit it: matches come first.
    setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), lower_priority);
    server_.listen_after_bind();
  });
  while (!server_.is_running()) std::this_thread::yield();
  return {};
}

std::string Http::url() const {
  const bool is_v6 = address_.host.find(':') != std::string::npos;
  return "http://" + (is_v6 ? "[" + address_.host + "]" : address_.host) + ":" +
         std::to_string(address_.port) + "/";
}

void Http::send_events(httplib::Response& response, std::function<News()> next) {
  if (viewers_.fetch_add(1) >= most_viewers) {
    --viewers_;
    response.status = 503;
    return;
  }
  response.set_chunked_content_provider(
      "text/event-stream",
      [this, next = std::move(next)](std::size_t, httplib::DataSink& sink) {
        const News news = next();
        if (!news.text.empty() && !sink.write(news.text.data(), news.text.size())) return false;
        if (news.is_last || is_closed_) {
          sink.done();
        } else {
          std::this_thread::sleep_for(look_again);
        }
        return true;
      },
      [this](bool) { --viewers_; });
}

}  // namespace mirocup::web
