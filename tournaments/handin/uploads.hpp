// SPDX-License-Identifier: MIT
//
// Files that teams send: limits of their number and size, and the way from a file to a hand-in.
//
// Threads: all functions may be called by any thread at any time.
#pragma once

#include "tournaments/handin/desk_state.hpp"
#include "tournaments/handin/replies.hpp"

namespace mirocup::league {

class Uploads {
 public:
  explicit Uploads(DeskState& state) : state_(state) {}

  // Receives a file from a team and books it as a hand-in.
  ReplyOrRefusal take(const web::Request& request, const web::Body& body, const std::string& team);

  // Refuses a team that hands in too often, or too late by `terms`. Requires the mutex of the
  // state.
  tl::expected<void, Refusal> expect_allowed(const std::string& team, const HandInTerms& terms);

 private:
  struct Running;

  ReplyOrRefusal keep(const std::string& team, const std::string& name, system::IncomingFile& file,
                      const std::string& sha256);

  DeskState& state_;
  std::map<std::string, int> running_;  // uploads of each team; guarded by the mutex of the state
};

}  // namespace mirocup::league
