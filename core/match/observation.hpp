// SPDX-License-Identifier: MIT
//
// What a team sees of one tick: everything, exactly, in its own frame. It always attacks +x;
// metres, radians counter-clockwise, m/s, rad/s.
#pragma once

#include "core/match/snapshot.hpp"
#include "core/simulator/model/parameters.hpp"

#include <array>
#include <cstdint>

namespace mirocup::match {

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
  bool placing = false;                               // the observer may say where it stands
  int own_score = 0;
  int opponent_score = 0;
  int robots = 0;  // of a team
  // What the referee counts, so that nobody is surprised by a whistle.
  double stalemate_s = 0.0;
  double advantage_s = 0.0;
  referee::TeamCounts own_counts;
  referee::TeamCounts opponent_counts;
  Vec2 ball{0.0, 0.0};
  Vec2 ball_velocity{0.0, 0.0};
  std::array<ObservedRobot, max_robots_per_team> own;
  std::array<ObservedRobot, max_robots_per_team> opponent;
};

// The scene as a team sees it; `robots` of a team on the field.
Observation observe(const Snapshot& scene, Team team, int robots);

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
