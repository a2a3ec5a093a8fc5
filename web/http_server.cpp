// SPDX-License-Identifier: MIT
#include "web/http_server.hpp"

#include <algorithm>
#include <arpa/inet.h>
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
constexpr int timeout_s = 5;          // for a viewer that sends or reads nothing
constexpr int upload_timeout_s = 20;  // for a student's wireless network
constexpr auto request_time = 10s;
constexpr std::size_t max_request = 64u << 10;  // bytes of line, headers and body
constexpr std::size_t max_body = 4u << 10;      // bytes; no request to these servers needs one
constexpr std::size_t max_drained = 1u << 20;   // bytes that nobody reads
constexpr auto drain_time = 1s;
constexpr int lower_priority = 10;

// Returns the address of the other end, without the zone of IPv6; "" if it is no network address.
std::string address_of(socket_t socket) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  char text[INET6_ADDRSTRLEN] = "";
  if (getpeername(socket, reinterpret_cast<sockaddr*>(&address), &size) != 0) return "";
  if (address.ss_family == AF_INET) {
    inet_ntop(AF_INET, &reinterpret_cast<const sockaddr_in&>(address).sin_addr, text, sizeof text);
  } else if (address.ss_family == AF_INET6) {
    const in6_addr& v6 = reinterpret_cast<const sockaddr_in6&>(address).sin6_addr;
    if (IN6_IS_ADDR_V4MAPPED(&v6)) {
      inet_ntop(AF_INET, &v6.s6_addr[12], text, sizeof text);
    } else {
      inet_ntop(AF_INET6, &v6, text, sizeof text);
    }
  }
  return text;
}

// A connection whose request is bounded. The library reads byte by byte, so this has a buffer.
class Connection final : public httplib::Stream {
 public:
  // `tls` may be null: not encrypted.
  Connection(socket_t socket, system::TlsConnection* tls) : socket_(socket), tls_(tls) {}

  // More is allowed from now on. The client is told to send its body when that is read.
  void allow(std::size_t bytes, int seconds, bool awaits_continue) {
    most_ = received_ + bytes;
    deadline_ = std::chrono::steady_clock::now() + std::chrono::seconds(seconds);
    awaits_continue_ = awaits_continue;
    has_body_ = true;
    patience_s_ = upload_timeout_s;
  }

  bool is_readable() const override {
    if (used_ < filled_ || (tls_ != nullptr && tls_->has_bytes())) return true;
    const auto left = deadline_ - std::chrono::steady_clock::now();
    const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(left).count();
    return ms > 0 && waits_for(POLLIN, static_cast<int>(std::min<long>(ms, 1000L * patience_s_)));
  }

  bool is_writable() const override { return waits_for(POLLOUT, 1000 * timeout_s); }

  ssize_t read(char* bytes, std::size_t size) override {
    if (used_ == filled_) {
      if (awaits_continue_) {
        awaits_continue_ = false;
        constexpr std::string_view go_on = "HTTP/1.1 100 Continue\r\n\r\n";
        if (write(go_on.data(), go_on.size()) < 0) return -1;
      }
      if (received_ >= most_ || !is_readable()) return -1;
      const ssize_t count = receive();
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
    if (tls_ != nullptr) return tls_->write({bytes, size}, 1000 * timeout_s);
    return is_writable() ? send(socket_, bytes, size, MSG_NOSIGNAL) : -1;
  }

  // After the answer: takes what a client of an upload still sends, for a short time. A connection
  // that is closed before that is reset, and the client would not see why it was refused.
  void drain() {
    if (!has_body_) return;
    most_ = received_ + max_drained;
    deadline_ = std::chrono::steady_clock::now() + drain_time;
    awaits_continue_ = false;
    if (tls_ != nullptr) {
      tls_->say_end();
    } else {
      shutdown(socket_, SHUT_WR);
    }
    for (ssize_t count = 1; count > 0; used_ = filled_) {
      char byte = 0;
      count = read(&byte, 1);
    }
  }

  void get_remote_ip_and_port(std::string& ip, int&) const override { ip = address_of(socket_); }
  void get_local_ip_and_port(std::string&, int&) const override {}  // nobody asks for them
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

  ssize_t receive() {
    if (tls_ != nullptr) return tls_->read(buffer_.data(), buffer_.size(), 1000 * patience_s_);
    return recv(socket_, buffer_.data(), buffer_.size(), 0);
  }

  socket_t socket_;
  system::TlsConnection* tls_;
  std::chrono::steady_clock::time_point deadline_ = std::chrono::steady_clock::now() + request_time;
  std::array<char, 16384> buffer_{};
  std::size_t used_ = 0;    // of the buffer
  std::size_t filled_ = 0;  // of the buffer
  std::size_t received_ = 0;
  std::size_t most_ = max_request;
  int patience_s_ = timeout_s;
  bool awaits_continue_ = false;
  bool has_body_ = false;
};

}  // namespace

bool BoundedServer::answer(socket_t connection) {
  std::optional<system::TlsConnection> tls;
  if (tls_) {
    tls = tls_->accept(connection, 1000 * timeout_s);
    if (!tls) return false;
  }
  Connection stream(connection, tls ? &*tls : nullptr);
  const auto prepare = [this, &stream](httplib::Request& request) {
    request.ranges.clear();
    if (max_upload_ == 0 || request.method != "PUT") return;
    const bool awaits = request.get_header_value("Expect") == "100-continue";
    request.headers.erase("Expect");
    stream.allow(max_upload_ + max_request, upload_seconds_, awaits);
  };
  bool is_closed = false;
  // cpp-httplib 0.11 (Debian 12) asks the stream for the addresses, 0.18 (Debian 13) is given them.
  const auto process = [&](auto& server) {
    if constexpr (requires { server.process_request(stream, true, is_closed, prepare); }) {
      return server.process_request(stream, true, is_closed, prepare);
    } else {
      return server.process_request(stream, address_of(connection), 0, "", 0, true, is_closed,
                                    prepare);
    }
  };
  const bool answered = process(*this);
  stream.drain();
  return answered;
}

void BoundedServer::allow_uploads(std::size_t size, int seconds) {
  max_upload_ = size;
  upload_seconds_ = seconds;
  set_payload_max_length(size);
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

namespace {

// Tries the port at all addresses of this host, which tells what the library does not.
std::string why_not_bound(int port) {
  const int socket_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in any{};
  any.sin_family = AF_INET;
  any.sin_port = htons(static_cast<std::uint16_t>(port));
  const bool is_bound = bind(socket_, reinterpret_cast<const sockaddr*>(&any), sizeof any) == 0;
  const int reason = errno;
  close(socket_);
  if (!is_bound && reason == EACCES)
    return "needs the permission of root: take a port from 1024 on, 8080 for example";
  if (!is_bound && reason == EADDRINUSE) return "is in use: take another port";
  return "is not an address of this host, or in use";
}

}  // namespace

HttpServer::HttpServer() {
  server_.new_task_queue = [] { return new httplib::ThreadPool(max_viewers + page_threads); };
  server_.set_payload_max_length(max_body);
  // The library's own choice, SO_REUSEPORT, lets a second server take half of the viewers of the
  // first one.
  server_.set_socket_options([](socket_t listening) {
    const int yes = 1;  // a port whose last connections are just ending may be taken
    setsockopt(listening, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
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
                                       std::to_string(address.port) + " " +
                                       why_not_bound(address.port));
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
  return (server_.is_encrypted() ? "https://" : "http://") +
         (is_v6 ? "[" + address_.host + "]" : address_.host) + ":" + std::to_string(address_.port) +
         "/";
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
