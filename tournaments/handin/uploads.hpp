// SPDX-License-Identifier: MIT
//
// Files that teams send: limits of their number and size, and the way from a file to a hand-in.
//
// Threads: all functions may be called by any thread at any time.
#pragma once

#include "tournaments/handin/desk_state.hpp"
#include "web/http/request.hpp"

namespace mirocup::league {

class Uploads {
 public:
  explicit Uploads(DeskState& state) : state_(state) {}

  // Receives a file from a team and books it as a hand-in.
  web::Reply take(const web::Request& request, const web::Body& body, const std::string& team);

  // Returns the reply to a team that hands in too often or too late; nothing if the team may hand
  // in by `terms`. Requires the mutex of the state.
  std::optional<web::Reply> refused_now(const std::string& team, const HandInTerms& terms);

 private:
  struct Running;

  web::Reply keep(const std::string& team, const std::string& name, system::IncomingFile& file,
                  const std::string& sha256);

  DeskState& state_;
  std::map<std::string, int> running_;  // uploads of each team; guarded by the mutex of the state
};

}  // namespace mirocup::league
