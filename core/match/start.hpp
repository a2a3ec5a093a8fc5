// SPDX-License-Identifier: MIT
//
// The state from which a leg starts, if it does not start with the toss and its kick-off: bodies
// anywhere on the field, in motion or placed for a restart, at any clock and score. As JSON it is a
// situation (docs/situations.md).
//
// Units: m, s, rad; positions and velocities in the field's frame. A start that is turned by 180
// degrees, with the other team on the left, gives the same leg, turned.
#pragma once

#include "core/field/team.hpp"
#include "core/match/snapshot.hpp"
#include "core/referee/placement.hpp"
#include "core/simulator/model/state.hpp"

#include <array>
#include <optional>

namespace mirocup::match {

// One robot at the start.
struct RobotStart {
  std::optional<simulator::BodyState> state;  // empty: at rest in its default place
  // rad/s: the command that the robot drives in the first tick, before an answer takes effect.
  simulator::WheelSpeeds wheels;
  bool is_broken = false;  // true: the robot stands, its team's commands do not move it
};

// The restart for which the bodies are placed. Until the whistle everything stands.
struct RestartStart {
  referee::Restart kind = referee::Restart::KICK_OFF;
  Team taker = Team::blue;
  referee::Quarter quarter;  // of a free ball
};

struct Start {
  Team left = Team::blue;                    // the team that defends x < 0
  std::optional<simulator::BallState> ball;  // empty: at rest in its default place
  ByTeam<std::array<RobotStart, max_robots_per_team>> robots;
  std::optional<RestartStart> restart;  // empty: play is on
  referee::Phase phase = referee::Phase::FIRST_HALF;
  double clock = 0.0;  // of the phase
  ByTeam<int> score{};
};

// Returns the decision that gives the restart. If play is on at the start, the decision has no
// effect.
referee::Decision restart_of(const Start& start);

// Returns where all bodies stand at the start. Those that the start does not give stand in the
// default places of its restart or, if play is on, of a kick-off by the blue team.
referee::Placement placement_of(const referee::JudgedField& pitch, const Start& start);

}  // namespace mirocup::match
