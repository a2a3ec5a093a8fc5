// SPDX-License-Identifier: MIT
//
// Every number of the physical model, said once. SI units. Equation numbers are those of Klančar et
// al., "Robot Soccer Collision Modelling and Validation in Multi-Agent Simulator"; core/README.md
// derives the model from the paper.
#pragma once

#include <limits>

namespace mirocup::simulator {

inline constexpr double gravity = 9.81;  // m/s^2

// What `grip` is for wheels that cannot slide sideways: equations (1) to (3) exactly.
inline constexpr double infinite_grip = std::numeric_limits<double>::infinity();

// One value for each kind of pair that can touch.
struct PerPair {
  double ball_wall = 0.0;
  double ball_robot = 0.0;
  double robot_wall = 0.0;
  double robot_robot = 0.0;
};

struct Parameters {
  double robot_side = 0.075;          // edge of the square, m
  double robot_mass = 0.50;           // M, kg
  double wheel_distance = 0.068;      // L, m
  double wheel_radius = 0.0225;       // r, m
  double motor_time_constant = 0.06;  // T in (2), s
  double wheel_speed_limit = 80.0;    // |u| at most, rad/s
  double grip = 0.8;                  // sideways force of the wheels at most grip * M * g
  double ball_radius = 0.02135;       // R, m
  double ball_mass = 0.046;           // m, kg
  double rolling_resistance = 0.01;   // K_c in (6)
  double viscous_friction = 0.01;     // f_v in (7), kg/s
  PerPair restitution{.ball_wall = 0.8, .ball_robot = 0.6, .robot_wall = 0.3, .robot_robot = 0.3};

  // A uniform square turns about its centre: I = M a^2 / 6.
  double robot_inertia() const { return robot_mass * robot_side * robot_side / 6.0; }

  // A ball that rolls without slipping moves as if it had this mass: m' = m + J/R^2 = 7m/5.
  double effective_ball_mass() const { return 1.4 * ball_mass; }

  // Speeds that wheel speeds in rad/s ask for, (1) with the wheel radius put back.
  double forward_speed(double left, double right) const {
    return wheel_radius * (right + left) / 2.0;
  }
  double turn_rate(double left, double right) const {
    return wheel_radius * (right - left) / wheel_distance;
  }
};

// How exact the simulator is asked to be.
struct Tolerances {
  double touch = 1e-10;  // m: bodies with a smaller gap are in contact
  double sink = 1e-12;   // m: bodies in contact that come closer by this hit each other anew
  double rest_speed =
      2e-5;  // m/s: an approach slower than this does not bounce, it rests. More than what
             // the motors can gain over `sink`, so that bouncing comes to an end
  // Chattering ends because what counts as rest grows, within a tick, with each bounce of a pair
  // and a little with each event of the whole field.
  double rest_growth_per_bounce = 1.5;
  double rest_growth_per_event = 1.03;
  int events_per_tick = 400;  // beyond, the rest of the tick is done in small steps
  double step = 1e-3;         // s: the longest of those
};

}  // namespace mirocup::simulator
