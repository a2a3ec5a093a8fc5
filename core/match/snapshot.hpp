// SPDX-License-Identifier: MIT
//
// The whole of a leg at one instant, in the field's frame and with its colours: what spectators
// get, and what a team's view of it is made of.
#pragma once

#include "core/field/team.hpp"
#include "core/referee/referee.hpp"
#include "core/simulator/model/state.hpp"

#include <array>
#include <cstdint>
#include <optional>

namespace mirocup::match {

template <class T>
using ByTeam = std::array<T, 2>;  // [index_of(Team)]

enum class State {
  READY,  // placed for a restart; robots stand until the whistle
  PLAY,
  END,
};

// At the begin of the tick.
struct Snapshot {
  std::uint32_t tick = 0;
  double time = 0.0;
  double clock = 0.0;
  State state = State::READY;
  referee::Phase phase = referee::Phase::FIRST_HALF;
  referee::Restart restart = referee::Restart::none;
  Team taker = Team::blue;  // of the last restart
  Team left = Team::blue;   // who defends x < 0
  // Whose turn it is to say where its robots stand; its answer to this tick counts.
  std::optional<Team> placing;
  ByTeam<int> score{};
  // What the referee counts (referee.hpp).
  double stalemate_s = 0.0;
  double advantage_s = 0.0;
  ByTeam<referee::TeamCounts> counts;
  simulator::BallState ball;
  ByTeam<std::array<simulator::BodyState, max_robots_per_team>> robots;
};

}  // namespace mirocup::match

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 3> enum_names<match::State>{"READY", "PLAY", "END"};
// Messages to teams hold these numbers.
static_assert(is_numbered_in_order<match::State::READY, match::State::PLAY, match::State::END>());

}  // namespace mirocup
