// SPDX-License-Identifier: MIT
//
// Counts wrong tokens of each address, and says how long an address has to wait after several wrong
// tokens. A right token never waits, so one student cannot lock out a class that shares an address.
//
// Threads: one at a time.
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace mirocup::league {

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

// Returns the part of an address that stands for one person: of IPv6 the first 64 bits.
std::string network_of(const std::string& address);

}  // namespace mirocup::league
