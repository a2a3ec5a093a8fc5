// SPDX-License-Identifier: MIT
//
// The reward of a learner: a sum of named terms, each with a weight.
//
// Terms are measured in the frame of the learner's team, tick by tick while play is on, and summed
// up over the ticks of a step. Changes by the placement at a restart do not count.
#pragma once

#include "core/base/names.hpp"
#include "core/match/leg.hpp"

#include <array>
#include <string_view>

namespace mirocup::training {

// The terms, each with its unit; 1 is a plain number.
enum class Term {
  goal,           // 1: goals of the own team minus goals of the opponents
  ball_to_goal,   // m: by how much the ball came nearer to the middle of the opponents' goal
  robot_to_ball,  // m: by how much the nearest robot of the learner came nearer to the ball
  behind_ball,    // m: by how much the nearest robot came nearer to the place behind the ball
  touch,          // 1: ticks in which a robot of the learner was the last to touch the ball
  foul,           // 1: decisions against the opponents minus decisions against the own team
  energy,         // s: minus the time times the mean |command| / limit of the learner's wheels
  time,           // s: minus the time
  // The terms of rSoccer's VSS environment, with the definitions of that environment, for one step.
  vss_goal,
  vss_ball_grad,
  vss_move,
  vss_energy,
};
inline constexpr int terms = 12;

using Terms = std::array<double, terms>;
using Weights = Terms;

// The default weights: goals alone.
constexpr Weights default_weights() {
  Weights weights{};
  weights[static_cast<int>(Term::goal)] = 1.0;
  return weights;
}

// Returns the unit and the meaning of a term, for the spec.
struct TermText {
  std::string_view unit;
  std::string_view meaning;
};
TermText text_of(Term term);

// The robots of a learner.
struct Learner {
  Team team = Team::blue;
  referee::RobotSet robots;
};

// Measures the terms of one learner through an episode. The class is a plain value.
class RewardMeter {
 public:
  // To be called when an episode starts.
  void start(const match::Leg& leg, const Learner& learner);

  // Adds the tick that the leg has played last. `command` has the wheel speeds that the learner's
  // team drove in the tick, rad/s. `decisions` is the number of decisions of the leg before the
  // tick.
  void add_tick(const match::Leg& leg, const Learner& learner,
                const std::array<simulator::WheelSpeeds, max_robots_per_team>& command,
                std::size_t decisions);

  // Returns the terms of the step that ends now, and begins the next step.
  Terms take_step(const match::Leg& leg, const Learner& learner, double step_s);

 private:
  // Distances between bodies, m, in the frame of the learner's team.
  struct Ways {
    double ball_to_goal = 0.0;
    double robot_to_ball = 0.0;  // from the learner's nearest robot
    double behind_ball = 0.0;    // from the learner's nearest robot to the place behind the ball
  };
  static Ways ways(const match::Leg& leg, const Learner& learner);

  Terms now_{};
  Ways ways_;               // distances at the end of the last tick
  double potential_ = 0.0;  // potential of the ball, as in rSoccer
  bool has_potential_ = false;
  double wheel_sum_ = 0.0;  // sum of wheel speeds of the learner's first robot, rad/s
};

}  // namespace mirocup::training

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 12> enum_names<training::Term>{
    "goal",   "ball_to_goal", "robot_to_ball", "behind_ball",   "touch",    "foul",
    "energy", "time",         "vss_goal",      "vss_ball_grad", "vss_move", "vss_energy"};

}  // namespace mirocup
