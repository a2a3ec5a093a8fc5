// SPDX-License-Identifier: MIT
//
// Every number of the physical model, said once. SI units. Equation numbers are those of Klančar et
// al., "Robot Soccer Collision Modelling and Validation in Multi-Agent Simulator"; core/README.md
// derives the model from the paper.
#pragma once

#include "core/base/names.hpp"
#include "core/base/vec2.hpp"

#include <array>
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

// Along what a rolling ball brakes: its own direction, or, as the paper has it, x and y separately.
enum class RollingFriction { isotropic, per_axis };

// A convex polygon in the robot's frame, counter-clockwise around its centre of mass, m. The wheels'
// axis goes through the centre of mass.
inline constexpr int max_corners = 8;
struct Outline {
  int corners = 0;  // at least 3, or 0: none is given
  std::array<double, max_corners> x{}, y{};

  Vec2 corner(int i) const { return {x[i], y[i]}; }
};

struct Parameters {
  double robot_side = 0.075;          // edge of the square, m
  Outline robot_outline;              // instead of the square
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
  RollingFriction rolling_friction = RollingFriction::isotropic;
  double k = 1e-3;  // m/s: per axis, rolling resistance falls linearly to zero below this, (9)
  PerPair restitution{.ball_wall = 0.8, .ball_robot = 0.6, .robot_wall = 0.3, .robot_robot = 0.3};

  PerPair contact_friction{};  // Coulomb's coefficient; the paper's contacts have none

  // Of a uniform robot about its centre of mass, kg m^2. The square's is M a^2 / 6.
  double robot_inertia() const;

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

// How exact the simulator is asked to be. Free motion and single impacts are exact to rounding at
// every level; what differs is how closely bodies in lasting contact are followed. A match is always
// played with the standard ones.
enum class Accuracy { coarse, standard, reference };

struct Tolerances {
  double touch = 1e-10;  // m: bodies with a smaller gap are in contact
  double sink = 1e-12;   // m: bodies in contact that come closer by this hit each other anew
  // m/s: an approach slower than this does not bounce, it rests. The first is for a body's first
  // touch; the other, for bodies that are in company already, is more than what the motors can gain
  // over `sink`, so that bouncing comes to an end.
  double first_rest_speed = 1e-10;
  double rest_speed = 2e-4;
  // Within a tick patience wears off (patience.hpp). What counts as rest grows with each touch of a
  // body; `sink` with each beyond the patient ones, up to `touch`. A touch is forgotten after a
  // while, s, but where there are so many, bouncing has to end.
  double rest_growth_per_touch = 3.0;
  double touch_forgotten = 2e-3;
  int touches_never_forgotten = 4;
  double sink_growth_per_touch = 4.0;
  int patient_touches = 8;
  // An impact stops wheels that it makes slide no faster than this, m/s: they would grip again
  // within v / grip g.
  double brief_slide = 1e-6;
  double brief_slide_growth_per_touch = 8.0;
  double hold = 1e-8;  // s: the shortest that bodies press and wheels grip
  // Of that and of the slowest rolling in contact, for each event; of the slowest sliding, up to
  // `rest_slide`, m/s, from where on it grows slowly.
  double growth_per_event = 1.3;
  double slide_growth_per_event = 2.0;
  double rest_slide = 1e-7;
  // What a body's events of a tick may cost, summed: of each the square of how many bodies it involves,
  // times the square of how many these have met in the tick. 3 of four, 7 of three or 34 of two that meet
  // nobody else. Beyond, the body and what it touches go on in small steps; five that still touch then do
  // so from the next tick's begin.
  int followed_per_tick = 540;
  double step = 3e-3;                 // s: the longest of those
  double step_touch = 1e-10;          // m: what is left of gaps and overlaps at the end of one,
  double step_overlap = 1e-7;         // m: where contacts nearly contradict each other,
  double overlap_within_step = 8e-7;  // m: and between its ends
};

Tolerances tolerances_of(Accuracy accuracy);

}  // namespace mirocup::simulator

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 2> enum_names<simulator::RollingFriction>{"isotropic",
                                                                                        "per_axis"};
template <>
inline constexpr std::array<std::string_view, 3> enum_names<simulator::Accuracy>{
    "coarse", "standard", "reference"};

}  // namespace mirocup
