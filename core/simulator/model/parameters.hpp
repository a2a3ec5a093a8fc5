// SPDX-License-Identifier: MIT
//
// Every number of the physical model, said once. SI units. Equation numbers are those of Klančar et
// al., "Robot Soccer Collision Modelling and Validation in Multi-Agent Simulator"; core/README.md
// derives the model from the paper.
#pragma once

#include "core/base/names.hpp"
#include "core/geometry/outline.hpp"

#include <array>
#include <limits>

namespace mirocup::simulator::inline model {

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

// Along what a rolling ball brakes: its own direction, or, as the paper has it, x and y separately.
enum class RollingFriction { isotropic, per_axis };

struct Parameters {
  double robot_side = 0.075;               // edge of the square, m
  geometry::OutlineCorners robot_corners;  // instead of the square
  double robot_mass = 0.50;                // M, kg
  double wheel_distance = 0.068;           // L, m
  double wheel_radius = 0.0225;            // r, m
  double motor_time_constant = 0.06;       // T in (2), s
  double wheel_speed_limit = 80.0;         // |u| at most, rad/s
  double grip = 0.8;                       // sideways force of the wheels at most grip * M * g
  double ball_radius = 0.02135;            // R, m
  double ball_mass = 0.046;                // m, kg
  double rolling_resistance = 0.01;        // K_c in (6)
  double viscous_friction = 0.01;          // f_v in (7), kg/s
  RollingFriction rolling_friction = RollingFriction::isotropic;
  double k = 1e-3;  // m/s: per axis, rolling resistance falls linearly to zero below this, (9)
  PerPair restitution{.ball_wall = 0.8, .ball_robot = 0.6, .robot_wall = 0.3, .robot_robot = 0.3};

  PerPair contact_friction{};  // Coulomb's coefficient; the paper's contacts have none

  // Of a uniform robot about its centre of mass, kg m^2. The square's is M a^2 / 6.
  double robot_inertia() const;

  // A ball that rolls without slipping moves as if it had this mass: m' = m + J/R^2 = 7m/5.
  double effective_ball_mass() const { return 1.4 * ball_mass; }

  // Speeds that wheel speeds in rad/s ask for, (1) with the wheel radius put back.
  double speed_reference(double left, double right) const {
    return wheel_radius * (right + left) / 2.0;
  }
  double omega_reference(double left, double right) const {
    return wheel_radius * (right - left) / wheel_distance;
  }
};

// The robot of the parameters.
geometry::Outline robot_outline(const Parameters& parameters);

}  // namespace mirocup::simulator::inline model

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 2> enum_names<simulator::RollingFriction>{"isotropic",
                                                                                        "per_axis"};

}  // namespace mirocup
