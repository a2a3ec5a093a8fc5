// SPDX-License-Identifier: MIT
//
// What a team sees of one tick: everything, exactly, in its own frame. It always attacks +x;
// metres, radians counter-clockwise, m/s, rad/s.
#pragma once

#include "core/referee/referee.hpp"
#include "core/simulator/parameters.hpp"

#include <array>
#include <cstdint>

namespace mirocup::match {

enum class State {
  READY,  // placed for a restart; robots stand until the whistle
  PLAY,
  END,
};

struct ObservedRobot {
  Vec2 position{0.0, 0.0};
  double heading = 0.0;
  Vec2 velocity{0.0, 0.0};
  double turn = 0.0;
};

struct Observation {
  std::uint32_t tick = 0;
  double time = 0.0;   // simulated time since the match began, s
  double clock = 0.0;  // of the half, s
  State state = State::READY;
  referee::Phase phase = referee::Phase::FIRST_HALF;
  referee::Restart restart = referee::Restart::none;  // the last one
  bool own_restart = false;                           // it is the observer's
  int own_score = 0;
  int opponent_score = 0;
  int robots = 0;  // of a team
  Vec2 ball{0.0, 0.0};
  Vec2 ball_velocity{0.0, 0.0};
  std::array<ObservedRobot, max_robots_per_team> own;
  std::array<ObservedRobot, max_robots_per_team> opponent;
};

// What a team is told once, before the first observation.
struct Briefing {
  const field::Field* field = nullptr;
  const simulator::Parameters* parameters = nullptr;
  const referee::Rules* rules = nullptr;
  double control_period = 0.0;  // s
  Team team = Team::blue;
  std::uint64_t seed = 0;  // of the team's own random numbers; differs between the two teams
};

}  // namespace mirocup::match

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 3> enum_names<match::State>{"READY", "PLAY", "END"};

}  // namespace mirocup
