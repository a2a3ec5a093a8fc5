// SPDX-License-Identifier: MIT
//
// The state of a leg at one instant, in the field's frame and by colour. Spectators receive it, and
// the observations of the teams are made from it.
#pragma once

#include "core/field/team.hpp"
#include "core/match/observed_robot.hpp"
#include "core/referee/referee.hpp"

#include <array>
#include <cstdint>
#include <optional>

namespace mirocup::match {

template <class T>
using ByTeam = std::array<T, 2>;  // one value for each team: [index_of(team)]

enum class State {
  READY,  // bodies are placed for a restart; robots stand still until the whistle
  PLAY,
  END,
};

// Taken at the start of a tick. Metres, seconds, m/s, rad/s.
struct Snapshot {
  std::uint32_t tick = 0;
  double time = 0.0;   // simulated time since the start of the leg
  double clock = 0.0;  // of the current phase
  State state = State::READY;
  referee::Phase phase = referee::Phase::FIRST_HALF;
  referee::Restart restart = referee::Restart::none;
  Team taker = Team::blue;  // of the last restart
  Team left = Team::blue;   // the team that defends x < 0
  // The team whose turn it is to place; its answer to this tick may hold a placement request.
  std::optional<Team> placing;
  ByTeam<int> score{};
  // The referee's pending counts (referee::PendingCounts).
  double stalemate_s = 0.0;
  double advantage_s = 0.0;
  ByTeam<referee::TeamCounts> counts;
  simulator::BallState ball;
  int ball_age = 0;  // ticks since a camera saw the ball like this; 0 without a camera
  ByTeam<std::array<ObservedRobot, max_robots_per_team>> robots;
};

}  // namespace mirocup::match

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 3> enum_names<match::State>{"READY", "PLAY", "END"};
// Messages to teams hold these numbers.
static_assert(is_numbered_in_order<match::State::READY, match::State::PLAY, match::State::END>());

}  // namespace mirocup
