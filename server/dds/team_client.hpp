// SPDX-License-Identifier: MIT
//
// A team's side of the network: joins a match, waits for states, sends commands.
#pragma once

#include "server/dds/convert.hpp"
#include "server/dds/domain.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <variant>

namespace mirocup::dds {

// What a wait brought.
struct MatchOver {
  std::string how;  // "full_time", "forfeit", ...
  match::ByTeam<int> score{};
};
struct Silence {};  // nothing for as long as one was ready to wait
using News = std::variant<match::Scene, MatchOver, Silence>;

class TeamClient {
 public:
  // Finds the match and takes its seat; waits up to `patience` seconds for the server, or until
  // `interrupted` says so.
  static Result<std::unique_ptr<TeamClient>> join(const std::string& server,
                                                  const std::string& match_id, Team team,
                                                  const std::string& name, double patience,
                                                  const std::function<bool()>& interrupted);

  const match::Briefing& briefing() const { return told_.briefing; }
  int robots() const { return told_.field.robots_per_team; }

  // The next state, or the end. The same tick may come again if the server missed the answer.
  News wait(double patience);

  void send(const match::Command& command, std::uint32_t tick);

 private:
  TeamClient(Team team, Domain domain) : team_(team), domain_(std::move(domain)) {}
  Result<void> open(const std::string& match_id);
  Result<void> shake_hands(const std::string& name, double patience,
                           const std::function<bool()>& interrupted);

  Team team_;
  Domain domain_;
  Entity match_subscriber_, team_publisher_, team_subscriber_;
  Entity state_topic_, event_topic_, hello_topic_, welcome_topic_, command_topic_;
  Entity state_reader_, event_reader_, hello_writer_, welcome_reader_, command_writer_;
  Entity state_condition_, event_condition_, waitset_;
  std::uint64_t nonce_ = 0;
  Told told_;
};

}  // namespace mirocup::dds
