// SPDX-License-Identifier: MIT
//
// Sessions of browsers in which a token was typed: each browser has a random number in a cookie.
// This class keeps only the SHA-256 of that number and of the token. When a token is revoked or
// expires, its sessions end.
//
// Threads: one at a time.
#pragma once

#include "core/base/error.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace mirocup::league {

struct Session {
  std::string sha256;        // of the cookie's value
  std::string token_sha256;  // of the token that was typed
  std::int64_t ends = 0;     // s since 1970
};

class Sessions {
 public:
  static constexpr std::int64_t duration = 12 * 3600;  // s
  // The most sessions of a token; a further session ends the oldest.
  static constexpr std::size_t max_of_token = 20;

  // Begins a session and returns the value of its cookie.
  std::string begin(const std::string& token_sha256, std::int64_t now);

  // Returns the SHA-256 of the token of a running session; "" if there is no such session.
  std::string token_of(std::string_view cookie, std::int64_t now) const;

  // Ends the session of the cookie, if there is one.
  void end(std::string_view cookie);

  // Write and read the sessions as JSON, for a server that starts again. Sessions that cannot be
  // read are dropped.
  std::string text() const;
  static Sessions parse(const std::string& text);

  std::size_t size() const { return sessions_.size(); }

 private:
  std::vector<Session> sessions_;  // the oldest first
};

// Returns the value of the cookie of that name in a header "Cookie"; "" if no cookie or two cookies
// have the name.
std::string cookie_in(std::string_view header, std::string_view name);

// Counts wrong tokens of each address, and says how long an address has to wait after several wrong
// tokens. A right token never waits, so one student cannot lock out a class that shares an address.
class WrongTokens {
 public:
  static constexpr int free_tries = 5;                  // wrong tokens before the first wait
  static constexpr std::int64_t max_wait = 60;          // s
  static constexpr std::int64_t forgotten_after = 600;  // s after the last wrong token
  static constexpr std::size_t max_addresses = 10'000;

  // Notes a wrong token. `now` is in s on any clock that only goes forward. Returns how many
  // seconds must pass before the next token of the address is checked; 0: none. Further wrong
  // tokens during the wait do not make it longer.
  std::int64_t note(const std::string& address, std::int64_t now);

  std::size_t size() const { return addresses_.size(); }

 private:
  struct Count {
    int wrong = 0;
    std::int64_t last = 0;   // when the last wrong token was counted
    std::int64_t waits = 0;  // s: end of the wait
  };
  std::map<std::string, Count> addresses_;
  std::int64_t swept_ = 0;  // when forgotten addresses were removed last
};

}  // namespace mirocup::league
