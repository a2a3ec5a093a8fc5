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
struct Call {
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
using News = std::variant<Silence, Seated, match::Snapshot, MatchOver, Refused>;

class TeamClient {
 public:
  // Only prepares: the first thing that wait() brings is Seated, once there is a match.
  static Result<std::unique_ptr<TeamClient>> open(const Call& call);

  // The next news, or Silence after `patience` seconds. Ticks come in order, each once; a server
  // that missed the answer to one gets it again by itself.
  News wait(double patience);

  // Once seated.
  const match::Briefing& briefing() const { return told_.briefing; }
  int robots() const { return told_.field.robots_per_team; }

  // Answers the state of `tick`.
  void send(const match::Command& command, std::uint32_t tick);

  // Why there is no seat yet, as far as it can be known.
  std::string trouble() const;

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

  TeamClient(Call call, Domain domain) : call_(std::move(call)), domain_(std::move(domain)) {}
  Result<void> connect();
  Result<void> open_readers_and_writers(Link& link) const;
  std::optional<News> look();
  std::optional<News> take_welcome();
  std::optional<News> take_event();
  std::optional<News> take_state();
  bool is_cut_off() const;
  void look_after_connection();
  void say_hello();

  Call call_;
  Domain domain_;
  Link link_;
  Clock::time_point connected_;
  Clock::time_point said_hello_;
  Clock::time_point heard_;  // of the match, last
  std::uint64_t seated_leg_ = 0;
  Told told_;
  std::optional<mirocup_v2_TeamCommand> answer_;  // the last one
  std::uint64_t heard_commands_ = 0;              // as the server counts them
  Clock::time_point heard_us_;                    // the count has changed, last
  int unheard_ = 0;                               // commands that were sent since then
  std::string not_now_;                           // what the server said
};

}  // namespace mirocup::dds
