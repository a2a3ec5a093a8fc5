// SPDX-License-Identifier: MIT
//
// A team's side of the network: finds the match, takes its seat, gets states, sends commands.
//
// It looks after the connection itself. A server that falls silent is looked for again as a new
// process of the network (hostile packets can cut two processes off from each other for good); a
// server that was started again is joined again.
#pragma once

#include "server/dds/convert.hpp"
#include "server/dds/domain.hpp"
#include "server/dds/wall_time.hpp"

#include <memory>
#include <optional>
#include <string>
#include <variant>

namespace mirocup::dds {

// Whom a team calls, and what it calls itself.
struct JoinRequest {
  std::string server = "127.0.0.1";
  std::string match_id;
  Team team = Team::blue;
  std::string name;
  std::string credentials;  // a folder; "": open mode
};

// What a wait brought.
struct Silence {};  // nothing for as long as one was ready to wait
struct Seated {};   // the team has a seat in a leg that is new to it: briefing() is about this one
struct MatchOver {
  std::string how;  // "full_time", "forfeit", ...
  match::ByTeam<int> score{};
};
struct Refused {
  std::string why;
};
using News = std::variant<Silence, Seated, match::Scene, MatchOver, Refused>;

class TeamClient {
 public:
  // Only prepares: the first thing that wait() brings is Seated, once there is a match.
  static Result<std::unique_ptr<TeamClient>> open(const JoinRequest& request);

  // The next news, or Silence after `patience` seconds. Ticks come in order, each once; a server
  // that missed the answer to one gets it again by itself.
  News wait(double patience);

  // Once seated.
  const match::Briefing& briefing() const { return briefing_.briefing; }
  int robots() const { return briefing_.field.robots_per_team; }

  // Answers the state of `tick`.
  void send(const match::Command& command, std::uint32_t tick);

  // Why there is no seat yet, as far as it can be known.
  std::string last_error() const;

 private:
  // Everything that belongs to one appearance on the network.
  struct Link {
    Entity participant;
    Entity match_subscriber, team_publisher, team_subscriber;
    Entity state_topic, event_topic, hello_topic, welcome_topic, command_topic;
    Entity state_reader, event_reader, hello_writer, welcome_reader, command_writer;
    Entity waitset;
    std::uint64_t nonce = 0;
    std::uint64_t leg = 0;  // that the server answered for, 0: it has not
    bool is_seated = false;
  };

  TeamClient(JoinRequest request, Domain domain)
      : request_(std::move(request)), domain_(std::move(domain)) {}
  Result<void> connect();
  Result<void> open_readers_and_writers(Link& link) const;
  std::optional<News> poll();
  std::optional<News> take_welcome();
  std::optional<News> take_event();
  std::optional<News> take_state();
  bool is_cut_off() const;
  void look_after_connection();
  void send_hello();

  JoinRequest request_;
  Domain domain_;
  Link link_;
  WallClock::time_point connected_at_;
  WallClock::time_point hello_sent_at_;
  WallClock::time_point last_heard_at_;  // of the match, last
  std::uint64_t seated_leg_ = 0;
  OwnedBriefing briefing_;
  std::optional<mirocup_v2_TeamCommand> answer_;  // the last one
  std::uint64_t acknowledged_commands_ = 0;       // as the server counts them
  WallClock::time_point acknowledged_at_;         // the count has changed, last
  int unacknowledged_ = 0;                        // commands that were sent since then
  std::string wait_reason_;                       // what the server said
};

}  // namespace mirocup::dds
