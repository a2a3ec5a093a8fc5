// SPDX-License-Identifier: MIT
//
// Every number of the physical model, stated once. SI units; 1: a number without unit.
//
// Equation numbers are those of Klančar, Orqueda, Matko and Karba, "Robot Soccer Collision
// Modelling and Validation in Multi-Agent Simulator". docs/model.md derives the model from the
// paper and lists its errata.
#pragma once

#include "core/base/names.hpp"
#include "core/geometry/outline.hpp"

#include <array>
#include <limits>

namespace mirocup::simulator {
inline namespace model {

inline constexpr double gravity = 9.81;  // m/s^2

// The value of `grip` for wheels that cannot slide sideways: equations (1) to (3) exactly.
inline constexpr double infinite_grip = std::numeric_limits<double>::infinity();

// One value for each kind of pair that can touch.
struct PerPair {
  double ball_wall = 0.0;
  double ball_robot = 0.0;
  double robot_wall = 0.0;
  double robot_robot = 0.0;
};

// The direction in which a rolling ball brakes: against its motion (isotropic), or x and y
// separately, as the paper prints it in (8).
enum class RollingFriction { isotropic, per_axis };

// The parameters of the model; the defaults are those of a match. All robots are alike. A plain
// value: a world copies it, and it does not change while the world runs.
struct Parameters {
  // ---- robot
  double robot_side = 0.075;               // m: edge of the square outline
  geometry::OutlineCorners robot_corners;  // m: a polygon instead of the square, if it has corners
  double robot_mass = 0.50;                // kg: M in (3), (19)
  double wheel_distance = 0.068;           // m: L in (1)
  double wheel_radius = 0.0225;            // m: r, which the paper leaves out of (1)
  double motor_time_constant = 0.06;       // s: T in (2)
  // s: T of the angular velocity. 0: motor_time_constant.
  double turn_time_constant = 0.0;
  // s: T of the forward speed while both wheels are commanded to stand. 0: motor_time_constant.
  double brake_time_constant = 0.0;
  double wheel_speed_limit = 80.0;  // rad/s: wheel speeds beyond +-limit are clamped
  double grip = 0.8;                // 1: lateral force of the wheels <= grip M g; see (3)

  // ---- ball
  double ball_radius = 0.02135;                                   // m: R
  double ball_mass = 0.046;                                       // kg: m in (6)
  double rolling_resistance = 0.01;                               // 1: K_c in (6)
  double viscous_friction = 0.01;                                 // kg/s: f_v in (7)
  RollingFriction rolling_friction = RollingFriction::isotropic;  // (8)
  // m/s: k in (9). Per axis, rolling resistance falls linearly to zero below this speed.
  double k = 1e-3;

  // ---- contacts
  // 1: the restitution coefficient of (21), 0 (plastic) to 1 (elastic).
  PerPair restitution{.ball_wall = 0.8, .ball_robot = 0.6, .robot_wall = 0.3, .robot_robot = 0.3};
  // 1: Coulomb's friction coefficient between bodies; the paper's contacts have none.
  PerPair contact_friction{};

  // Returns the moment of inertia of a uniform robot about its centre of mass, kg m^2: M a^2 / 6
  // for a square of side a.
  double robot_inertia() const;

  // Returns T of the angular velocity, s.
  double turn_lag() const {
    return turn_time_constant > 0.0 ? turn_time_constant : motor_time_constant;
  }

  // Returns T of the forward speed while both wheels are commanded to stand, s.
  double brake_lag() const {
    return brake_time_constant > 0.0 ? brake_time_constant : motor_time_constant;
  }

  // Returns the effective mass of the ball, kg. A ball that rolls without slipping moves as if it
  // had the mass m' = m + J/R^2 = 7m/5.
  double effective_ball_mass() const { return 1.4 * ball_mass; }

  // Return the drive reference of two wheel speeds (rad/s), forward in m/s and angular in rad/s:
  // equation (1) with the wheel radius.
  double speed_reference(double left, double right) const {
    return wheel_radius * (right + left) / 2.0;
  }
  double omega_reference(double left, double right) const {
    return wheel_radius * (right - left) / wheel_distance;
  }
};

// Returns the outline of the robot: robot_corners if there are any, else the square.
geometry::Outline robot_outline(const Parameters& parameters);

}  // namespace model
}  // namespace mirocup::simulator

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 2> enum_names<simulator::RollingFriction>{"isotropic",
                                                                                        "per_axis"};

}  // namespace mirocup
