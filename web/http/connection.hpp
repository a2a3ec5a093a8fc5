// SPDX-License-Identifier: MIT
//
// One connection with limits of bytes and time. The class knows sockets and TLS, but not HTTP.
#pragma once

#include "system/tls.hpp"

#include <chrono>
#include <cstddef>
#include <optional>
#include <string_view>

namespace mirocup::web {

class Connection {
 public:
  // The caller owns the socket and `tls`. `tls` is empty if the connection is not encrypted.
  Connection(int socket, std::optional<system::TlsConnection>& tls) : socket_(socket), tls_(tls) {}

  // Sets new limits from now on: the most bytes to receive in all, the time for all of them, and
  // the longest silence of the other end.
  void allow(std::size_t bytes, std::chrono::seconds time, std::chrono::seconds patience);

  // Sets the longest time for which the other end may take nothing (otherwise 5 s), and the moment
  // at which sending ends (otherwise never).
  void allow_sending(std::chrono::seconds patience, std::chrono::steady_clock::time_point end);

  // True if no byte may come any more, because of the limits of allow().
  bool is_at_limit() const;

  // Returns the number of bytes received, at least one; 0 at the end of the connection, after an
  // error, or at a limit.
  std::size_t receive(char* bytes, std::size_t size);

  // Sends all bytes. Returns false after an error, or at a limit.
  bool send(std::string_view bytes);

  // Tells the other end that nothing more is sent, and receives its remaining bytes for at most 1
  // s. Otherwise closing would reset the connection, and a client that is still sending its file
  // would not see why it was refused.
  void drain();

 private:
  std::chrono::milliseconds send_time() const;
  bool waits_for(short event, std::chrono::milliseconds most) const;
  bool is_taking() const;

  int socket_;
  std::optional<system::TlsConnection>& tls_;
  std::size_t left_ = 0;  // bytes that may still come
  std::chrono::steady_clock::time_point deadline_{};
  std::chrono::milliseconds patience_{};
  std::chrono::milliseconds send_patience_{5000};
  std::chrono::steady_clock::time_point send_end_ = std::chrono::steady_clock::time_point::max();
};

}  // namespace mirocup::web
