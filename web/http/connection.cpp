// SPDX-License-Identifier: MIT
#include "web/http/connection.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <linux/sockios.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

namespace mirocup::web {

namespace {

using namespace std::chrono_literals;
using std::chrono::duration_cast;
using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr std::size_t max_drained = 1u << 20;  // bytes that nobody reads
constexpr std::size_t tls_record = 16u << 10;  // bytes

int in_ms(milliseconds time) {
  return static_cast<int>(time.count());
}

}  // namespace

void Connection::allow(std::size_t bytes, std::chrono::seconds time,
                       std::chrono::seconds patience) {
  left_ = bytes;
  deadline_ = steady_clock::now() + time;
  patience_ = patience;
}

void Connection::allow_sending(std::chrono::seconds patience, steady_clock::time_point end) {
  send_patience_ = patience;
  send_end_ = end;
}

bool Connection::is_at_limit() const {
  return left_ == 0 || duration_cast<milliseconds>(deadline_ - steady_clock::now()) <= 0ms;
}

milliseconds Connection::send_time() const {
  return std::clamp(duration_cast<milliseconds>(send_end_ - steady_clock::now()), 0ms,
                    send_patience_);
}

bool Connection::waits_for(short event, milliseconds most) const {
  pollfd waiting{.fd = socket_, .events = event, .revents = 0};
  int ready = 0;
  do {
    ready = poll(&waiting, 1, in_ms(most));
  } while (ready < 0 && errno == EINTR);
  return ready > 0 && (waiting.revents & event) != 0 && (waiting.revents & POLLERR) == 0;
}

// A socket is ready for more when a good part of what it holds has left, which a slow viewer takes
// long for.
bool Connection::is_taking() const {
  int before = 0;
  if (ioctl(socket_, SIOCOUTQ, &before) != 0) return false;
  while (!waits_for(POLLOUT, send_time())) {
    int held = 0;
    if (ioctl(socket_, SIOCOUTQ, &held) != 0 || held >= before || send_time() == 0ms) return false;
    before = held;
  }
  return true;
}

std::size_t Connection::receive(char* bytes, std::size_t size) {
  const auto time =
      std::min(patience_, duration_cast<milliseconds>(deadline_ - steady_clock::now()));
  size = std::min(size, left_);
  if (size == 0 || time <= 0ms) return 0;
  ssize_t count = -1;
  if (tls_) {
    count = tls_->read(bytes, size, in_ms(time));
  } else if (waits_for(POLLIN, time)) {
    count = recv(socket_, bytes, size, MSG_DONTWAIT);
  }
  if (count <= 0) return 0;
  left_ -= static_cast<std::size_t>(count);
  return static_cast<std::size_t>(count);
}

bool Connection::send(std::string_view bytes) {
  while (!bytes.empty()) {
    if (!is_taking()) return false;
    const ssize_t count =
        tls_ ? tls_->write(bytes.substr(0, tls_record), in_ms(send_time()))
             : ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

void Connection::drain() {
  allow(max_drained, 1s, 1s);
  if (tls_) {
    tls_->say_end();
  } else {
    shutdown(socket_, SHUT_WR);
  }
  std::array<char, 16384> unread{};
  while (receive(unread.data(), unread.size()) > 0) {
  }
}

}  // namespace mirocup::web
