// SPDX-License-Identifier: MIT
//
// libmirocup_team in C++: a connection that closes itself.
//
//   mirocup::team::Connection match({.match = "final", .team = MIROCUP_BLUE, .name = "mine"});
//   while (match.is_open()) {
//     switch (match.wait(1.0)) {
//       case MIROCUP_TEAM_TICK: {
//         const mirocup_observation& now = match.observation();
//         match.send(answer_to(now));
//         break;
//       }
//       case MIROCUP_TEAM_OVER:
//       case MIROCUP_TEAM_REFUSED:
//         return;
//     }
//   }
//
// team.h describes every call.
#pragma once

#include "mirocup/team.h"

#include <cerrno>
#include <cstdint>
#include <memory>
#include <string>

namespace mirocup::team {

// The match to join; an empty text means the default.
struct Call {
  std::string match;
  int team = MIROCUP_BLUE;
  std::string name;
  std::string server = {};       // "": this host
  int domain = 0;                // DDS domain
  std::string credentials = {};  // "": open mode
  std::string interface = {};    // "": as the routing table says
};

class Connection {
 public:
  explicit Connection(const Call& call) {
    mirocup_team_call c{};
    c.size = sizeof c;
    c.team = call.team;
    c.server = call.server.empty() ? nullptr : call.server.c_str();
    c.match = call.match.c_str();
    c.name = call.name.c_str();
    c.domain = call.domain;
    c.credentials = call.credentials.empty() ? nullptr : call.credentials.c_str();
    c.interface = call.interface.empty() ? nullptr : call.interface.c_str();
    char why[512] = "";
    connection_.reset(mirocup_team_open(&c, why, sizeof why));
    why_ = why;
    is_wrong_ = connection_ == nullptr && errno == EINVAL;
  }

  // False if the match could not be opened. In this case why() has the reason, and no other
  // function but is_wrong() may be called.
  bool is_open() const { return connection_ != nullptr; }
  const std::string& why() const { return why_; }
  // True if the Call or the credentials are wrong, so that another try is of no use.
  bool is_wrong() const { return is_wrong_; }

  int wait(double seconds) { return mirocup_team_wait(connection_.get(), seconds); }
  const mirocup_setup& setup() const { return *mirocup_team_setup(connection_.get()); }
  const mirocup_observation& observation() const {
    return *mirocup_team_observation(connection_.get());
  }
  // Return false if the call has no effect: place() without `placing`, send() after the end.
  bool place(const mirocup_placement& placement) {
    return mirocup_team_place(connection_.get(), &placement) == 0;
  }
  bool send(const mirocup_command& command) {
    return mirocup_team_send(connection_.get(), &command) == 0;
  }

  std::string text() const { return mirocup_team_text(connection_.get()); }
  const std::int32_t* score() const { return mirocup_team_score(connection_.get()); }

 private:
  struct Close {
    void operator()(mirocup_connection* connection) const { mirocup_team_close(connection); }
  };
  std::unique_ptr<mirocup_connection, Close> connection_;
  std::string why_;
  bool is_wrong_ = false;
};

}  // namespace mirocup::team
