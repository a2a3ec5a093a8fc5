// SPDX-License-Identifier: MIT
//
// A team's side of the network: finds the match, takes a seat in it, receives states, sends
// commands.
//
// The client maintains the connection itself. If the server falls silent, the client joins the
// network again as a new participant, because hostile packets can separate two participants for
// ever. The client also joins a server that was started again. Threads: one.
#pragma once

#include "server/dds/convert.hpp"
#include "server/dds/domain.hpp"
#include "server/dds/wall_time.hpp"

#include <cassert>
#include <memory>
#include <optional>
#include <string>
#include <variant>

namespace mirocup::dds {

// The match that a team wants to join, and the team's own name and colour in it.
struct JoinRequest {
  std::string server = "127.0.0.1";
  std::string match_id;
  Team team = Team::blue;
  std::string name;
  std::string credentials;  // folder of the credentials; "": open mode
  int domain = default_domain;
  std::string interface;  // as in open_team_domain()
};

// The possible results of TeamClient::wait().
struct Silence {};  // nothing happened in the given time
struct Seated {};   // the team has a seat in a new leg, which briefing() describes
struct MatchOver {
  std::string how;  // "full_time", "forfeit", ... as `end` in the match record
  match::ByTeam<int> score{};
};
struct Refused {
  std::string why;  // a sentence with the reason
};
using News = std::variant<Silence, Seated, match::Snapshot, MatchOver, Refused>;

class TeamClient {
 public:
  // Prepares the connection without waiting for a match. When the client has found a match, wait()
  // returns Seated before any other news.
  static Result<std::unique_ptr<TeamClient>> open(const JoinRequest& request);

  // Returns the next news, or Silence after `timeout` seconds. Ticks come in order, each tick once.
  // If the server missed an answer, the client sends the answer again by itself.
  News wait(double timeout);

  // Facts of the leg of the last Seated. Precondition: wait() has returned Seated.
  const match::Briefing& briefing() const {
    assert(briefing_.briefing.field != nullptr);
    return briefing_.briefing;
  }
  int robots() const { return briefing().field->robots_per_team; }  // number of robots of each team

  // Answers the state of `tick`, which must be the last tick that wait() returned.
  void send(const match::Command& command, std::uint32_t tick);

  // Returns a sentence that says why the team has no seat yet, as far as the client knows.
  std::string last_error() const;

 private:
  // One participant on the network with its entities; a new connection gets a new Link.
  struct Link {
    Entity participant;
    Entity match_subscriber, team_publisher, team_subscriber;
    Entity state_topic, event_topic, hello_topic, welcome_topic, command_topic;
    Entity state_reader, event_reader, hello_writer, welcome_reader, command_writer;
    Entity waitset;
    std::uint64_t nonce = 0;
    std::uint64_t leg = 0;  // leg of the last Welcome; 0: no Welcome yet
    bool is_seated = false;
    bool is_settled = false;  // a state has come since it is seated
  };

  explicit TeamClient(JoinRequest request) : request_(std::move(request)) {}
  Result<void> connect();
  Result<void> open_readers_and_writers(Link& link) const;
  std::optional<News> poll();
  std::optional<News> take_welcome();
  std::optional<News> take_event();
  std::optional<News> take_state();
  bool is_of_another_leg(std::uint64_t leg) const;
  bool is_cut_off() const;
  bool has_moved() const;
  std::string type_of_server() const;
  void look_after_connection();
  void send_hello();

  JoinRequest request_;
  Domain domain_;
  Link link_;
  WallClock::time_point connected_at_;
  int breaks_ = 0;                                // of settled connections, since the last calm one
  std::optional<WallClock::time_point> left_at_;  // set while the client is off the network
  WallClock::time_point hello_sent_at_;
  WallClock::time_point last_heard_at_;  // when the last sample of the match came
  std::uint64_t seated_leg_ = 0;
  OwnedBriefing briefing_;
  std::optional<mirocup_v1_TeamCommand> answer_;  // the last answer that was sent
  std::uint32_t acknowledged_commands_ = 0;       // commands that the server has counted
  WallClock::time_point acknowledged_at_;         // when acknowledged_commands_ last changed
  int unacknowledged_ = 0;                        // commands sent since acknowledged_at_
  std::string wait_reason_;                       // why the server said "not now"
};

}  // namespace mirocup::dds
