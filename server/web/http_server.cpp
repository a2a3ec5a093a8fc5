// SPDX-License-Identifier: MIT
#include "server/web/http_server.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <memory>
#include <poll.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

namespace mirocup::web {

namespace {

using namespace std::chrono_literals;

constexpr int max_viewers = 128;
constexpr int page_threads = 8;
constexpr auto poll_interval = 33ms;
constexpr int polls_without_news = 150;  // 5 s
// A comment of server-sent events. Only by sending something is it noticed that a viewer is gone.
constexpr std::string_view sign_of_life = ":\n\n";
constexpr int timeout_s = 5;  // for a viewer that sends or reads nothing
constexpr auto request_time = 10s;
constexpr std::size_t max_request = 64u << 10;  // bytes of line, headers and body
constexpr std::size_t max_body = 4u << 10;      // bytes; no request to these servers needs one
constexpr int lower_priority = 10;

// A connection whose request is bounded. The library reads byte by byte, so this has a buffer.
class Connection final : public httplib::Stream {
 public:
  explicit Connection(socket_t socket) : socket_(socket) {}

  bool is_readable() const override {
    if (used_ < filled_) return true;
    const auto left = deadline_ - std::chrono::steady_clock::now();
    const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(left).count();
    return ms > 0 && waits_for(POLLIN, static_cast<int>(std::min<long>(ms, 1000L * timeout_s)));
  }

  bool is_writable() const override { return waits_for(POLLOUT, 1000 * timeout_s); }

  ssize_t read(char* bytes, std::size_t size) override {
    if (used_ == filled_) {
      if (received_ >= max_request || !is_readable()) return -1;
      const ssize_t count = recv(socket_, buffer_.data(), buffer_.size(), 0);
      if (count <= 0) return count;
      received_ += static_cast<std::size_t>(count);
      used_ = 0;
      filled_ = static_cast<std::size_t>(count);
    }
    const std::size_t count = std::min(size, filled_ - used_);
    std::copy_n(buffer_.begin() + static_cast<std::ptrdiff_t>(used_), count, bytes);
    used_ += count;
    return static_cast<ssize_t>(count);
  }

  ssize_t write(const char* bytes, std::size_t size) override {
    return is_writable() ? send(socket_, bytes, size, MSG_NOSIGNAL) : -1;
  }

  // Nobody asks for them.
  void get_remote_ip_and_port(std::string&, int&) const override {}
  void get_local_ip_and_port(std::string&, int&) const override {}
  socket_t socket() const override { return socket_; }

 private:
  bool waits_for(short event, int ms) const {
    pollfd waiting{.fd = socket_, .events = event, .revents = 0};
    int ready = 0;
    do {
      ready = poll(&waiting, 1, ms);
    } while (ready < 0 && errno == EINTR);
    return ready > 0 && (waiting.revents & event) != 0 && (waiting.revents & POLLERR) == 0;
  }

  socket_t socket_;
  std::chrono::steady_clock::time_point deadline_ = std::chrono::steady_clock::now() + request_time;
  std::array<char, 4096> buffer_{};
  std::size_t used_ = 0;    // of the buffer
  std::size_t filled_ = 0;  // of the buffer
  std::size_t received_ = 0;
};

}  // namespace

bool BoundedServer::answer(socket_t connection) {
  Connection stream(connection);
  bool is_closed = false;
  return process_request(stream, true, is_closed,
                         [](httplib::Request& request) { request.ranges.clear(); });
}

bool BoundedServer::process_and_close_socket(socket_t connection) {
  const bool answered = answer(connection);
  shutdown(connection, SHUT_RDWR);
  close(connection);
  return answered;
}

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
  server_.set_payload_max_length(max_body);
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
    // The threads that this one starts inherit the priority. Matches come first.
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
      [this, next = std::move(next), silent = 0](std::size_t, httplib::DataSink& sink) mutable {
        EventBatch batch = next();
        silent = batch.text.empty() ? silent + 1 : 0;
        if (silent == polls_without_news) {
          batch.text = sign_of_life;
          silent = 0;
        }
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
