// SPDX-License-Identifier: MIT
//
// libmirocup_team in C++: a connection that closes itself.
//
//   mirocup::team::Connection match({.match = "final", .team = MIROCUP_BLUE, .name = "mine"});
//   while (match.is_open()) {
//     switch (match.wait(1.0)) {
//       case MIROCUP_TEAM_TICK: {
//         const mirocup_observation& now = match.observation();
//         match.draw_line("plan", 0xff8000ff, now.own[1].x, now.own[1].y, now.ball_x, now.ball_y);
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
#include <vector>

namespace mirocup::team {

// The match to join; an empty text means the default.
struct Call {
  std::string match;
  int team = MIROCUP_BLUE;
  std::string name;
  std::string server = {};       // "": this host
  int domain = 0;                // DDS domain
  std::string credentials = {};  // "": open mode
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

  // Draw a shape into the replay of `mirocup match --thoughts`; see "Thoughts" in strategy.h. Call
  // these functions after MIROCUP_TEAM_SEATED, and before the answer to a tick. The points of
  // a polygon are x, y of each corner.
  void draw_line(const char* layer, std::uint32_t colour, double x1, double y1, double x2,
                 double y2) {
    setup().draw_line(setup().host, layer, colour, x1, y1, x2, y2);
  }
  void draw_circle(const char* layer, std::uint32_t colour, double x, double y, double radius) {
    setup().draw_circle(setup().host, layer, colour, x, y, radius);
  }
  void draw_polygon(const char* layer, std::uint32_t colour, const std::vector<double>& points) {
    setup().draw_polygon(setup().host, layer, colour, points.data(),
                         static_cast<std::int32_t>(points.size() / 2));
  }
  void draw_text(const char* layer, std::uint32_t colour, double x, double y, const char* text) {
    setup().draw_text(setup().host, layer, colour, x, y, text);
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
