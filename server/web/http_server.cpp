// SPDX-License-Identifier: MIT
#include "server/web/http_server.hpp"

#include <charconv>
#include <chrono>
#include <memory>
#include <sys/resource.h>
#include <unistd.h>

namespace mirocup::web {

namespace {

using namespace std::chrono_literals;

constexpr int max_viewers = 128;
constexpr int page_threads = 8;
constexpr auto poll_interval = 33ms;
constexpr int timeout_s = 5;  // with a viewer that takes nothing
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

HttpServer::HttpServer() {
  server_.new_task_queue = [] { return new httplib::ThreadPool(max_viewers + page_threads); };
  server_.set_write_timeout(timeout_s);
  server_.set_read_timeout(timeout_s);
  server_.set_keep_alive_max_count(1);
  server_.set_default_headers(
      {{"Cache-Control", "no-store"}, {"X-Content-Type-Options", "nosniff"}});
}

HttpServer::~HttpServer() {
  is_closed_ = true;
  server_.stop();
  if (thread_.joinable()) thread_.join();
}

Result<void> HttpServer::listen(const Address& address, const std::string& option) {
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

std::string HttpServer::url() const {
  const bool is_v6 = address_.host.find(':') != std::string::npos;
  return "http://" + (is_v6 ? "[" + address_.host + "]" : address_.host) + ":" +
         std::to_string(address_.port) + "/";
}

void HttpServer::send_events(httplib::Response& response, std::function<EventBatch()> next) {
  if (viewers_.fetch_add(1) >= max_viewers) {
    --viewers_;
    response.status = 503;
    return;
  }
  response.set_chunked_content_provider(
      "text/event-stream",
      [this, next = std::move(next)](std::size_t, httplib::DataSink& sink) {
        const EventBatch batch = next();
        if (!batch.text.empty() && !sink.write(batch.text.data(), batch.text.size())) return false;
        if (batch.is_last || is_closed_) {
          sink.done();
        } else {
          std::this_thread::sleep_for(poll_interval);
        }
        return true;
      },
      [this](bool) { --viewers_; });
}

}  // namespace mirocup::web
