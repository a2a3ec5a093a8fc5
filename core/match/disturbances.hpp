// SPDX-License-Identifier: MIT
//
// The disturbances of one leg, drawn from its seed.
//
// Every robot has its own draws, which depend on its team's colour and its number and are in its
// team's own frame; the ball's draws are in the frame of the blue team. So neither the end that a
// team defends nor the order of the calls changes a draw: a leg that is turned by 180 degrees has
// the same numbers, negated. The two legs of a fixture have one seed and swapped colours, so in the
// second leg each team has the luck that the other team had in the first.
#pragma once

#include "core/base/random.hpp"
#include "core/base/vec2.hpp"
#include "core/field/league.hpp"
#include "core/match/conditions.hpp"
#include "core/match/snapshot.hpp"
#include "core/simulator/model/state.hpp"

#include <array>

namespace mirocup::match {

// Draws from a normal distribution of mean 0 and sigma 1 that is cut off at -2 and 2: a draw beyond
// these limits is repeated. Its standard deviation is 0.88.
double cut_normal(Random& random);

// The kinds of draws. Each has a stream of random numbers of its own, so a disturbance that is
// switched off changes no draw of the others.
enum class Draw { placing, gain, jitter, rolling, radio, sight, loss_of_sight };

// Returns the generator for one kind of draw and one robot of a team, or for the ball.
Random draws_of_robot(std::uint64_t seed, Draw kind, Team team, int robot);
Random draws_of_ball(std::uint64_t seed, Draw kind);

// How far a robot stands from the place where it was meant to stand, in its team's own frame.
struct PlacingError {
  Vec2 offset{0.0, 0.0};  // m
  double turn = 0.0;      // rad, counter-clockwise
};

class Disturbances {
 public:
  // `robots` is the number of robots of a team.
  Disturbances(const Conditions& conditions, std::uint64_t seed, int robots);

  // Draws from another seed from now on. What the leg has drawn for all its ticks stays: the gains
  // of the wheels and the floor.
  void redraw(std::uint64_t seed);

  // Returns the factor of the ball's rolling resistance in this leg.
  double rolling_factor() const { return rolling_factor_; }

  // Returns the errors with which a robot and the ball are put down next; each call draws anew. The
  // ball's error is in the frame of the blue team, m.
  PlacingError put_down_robot(Team team, int robot);
  Vec2 put_down_ball();

  // Returns the wheel speeds, rad/s, that a robot drives when it is sent `command`. To be called
  // once a tick for every robot whose commands count.
  simulator::WheelSpeeds drive(Team team, int robot, const simulator::WheelSpeeds& command);

  // Makes `command`, rad/s, the one that the robot received last.
  void receive(Team team, int robot, const simulator::WheelSpeeds& command) {
    robots_[index_of(team)][robot].received = command;
  }

  // Forgets the commands that the robots received last: each robot stands until it receives one.
  void stop_robots();

 private:
  struct Robot {
    Random placing, jitter, radio;
    double left_gain = 1.0, right_gain = 1.0;
    simulator::WheelSpeeds received{};  // the command that arrived last
  };

  Conditions conditions_;
  int robots_in_team_;
  Random ball_placing_;
  double rolling_factor_ = 1.0;
  ByTeam<std::array<Robot, max_robots_per_team>> robots_;
};

}  // namespace mirocup::match
