// SPDX-License-Identifier: MIT
#include "core/match/pitch_spec.hpp"

#include "core/geometry/outline.hpp"
#include "core/match/command.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace mirocup::match {

namespace {

// FIRASim's sources and configuration (VSSSLeague/FIRASim). Its motors are velocity motors with a
// limited torque; this model has a lag instead, see docs/pitches.md.
PitchSpec vsss_pitch() {
  PitchSpec pitch;
  pitch.name = "vsss";
  pitch.source = "FIRASim: its sources and its default configuration";
  simulator::Parameters& p = pitch.parameters;
  p.robot_side = 0.075;
  p.robot_mass = 2.4;       // body 2 kg and two wheels of 0.2 kg: the defaults of its code
  p.wheel_distance = 0.08;  // wheel centres at 0.0375 + 0.0025 m from the middle
  p.wheel_radius = 0.02;
  // Two wheels of 0.11 Nm push with 11 N: 4.6 m/s^2, 0.26 s to 1.2 m/s. A lag of half that time
  // leaves the robot as far behind its reference as the ramp does.
  p.motor_time_constant = 0.13;
  p.wheel_speed_limit = 60.0;  // 1.2 m/s; FIRASim has no limit, rSim has 46 rad/s at 0.026 m
  p.grip = 1.0;                // friction across the wheels
  p.ball_radius = 0.0215;
  p.ball_mass = 0.043;
  // The ball slows down by 0.06 x 0.09 x 9.8 = 0.053 m/s^2, at any speed; here (K_c g) / 1.4.
  p.rolling_resistance = 0.00756;
  p.viscous_friction = 0.0;
  p.restitution.ball_wall = 0.5;
  p.restitution.ball_robot = 0.5;
  pitch.control_period = 0.016;  // its step
  return pitch;
}

// A published fit of the SimuroSot program's robots: per tick of 1/60 s, in inches and degrees,
//   v += 0.060 (0.015222 (l + r) / 2 - v), and v *= 1 - 0.662 where both wheels are 0;
//   w += 0.273575 (0.534262 (r - l) / 2 - w)
// for wheels of -125 to 125. It agrees with logs of the program to 5 %.
PitchSpec simurosot_pitch() {
  PitchSpec pitch;
  pitch.name = "simurosot";
  pitch.source = "a published fit of the SimuroSot 5 v 5 program, compared with its match logs";
  simulator::Parameters& p = pitch.parameters;
  p.robot_side = 0.0787;  // 3.1 inches, as its logs show the robots
  p.robot_mass = 0.5;     // of MiroSot: no source has a mass that fits its collisions
  // 0.02320 m/s for each unit of the mean and 0.5595 rad/s for each unit of half the difference.
  // With this wheel a unit is 1 rad/s, so commands mean the same as in the program.
  p.wheel_radius = 0.0232;
  p.wheel_distance = 0.0829;          // 2 x 0.0232 / 0.5595
  p.wheel_speed_limit = 125.0;        // 2.90 m/s
  p.motor_time_constant = 0.269;      // -1/60 / ln(1 - 0.060)
  p.turn_time_constant = 0.0521;      // -1/60 / ln(1 - 0.273575)
  p.brake_time_constant = 0.0145;     // -1/60 / ln((1 - 0.060) (1 - 0.662))
  p.grip = simulator::infinite_grip;  // its robots never drift
  p.ball_radius = 0.0252;             // 5.043 cm across
  p.ball_mass = 0.046;                // of MiroSot, as above
  // Its logs show no slowing below 1.2 m/s, and rebounds at 0.35 to 0.45 of the speed. An open
  // reimplementation has 0.27; no source has the tangential loss in this model's terms. A ball that
  // never stops would be no ball: this one loses 3.5 mm/s in a second, less than a log can show.
  p.rolling_resistance = 0.0005;
  p.viscous_friction = 0.0;
  p.restitution.ball_wall = 0.4;
  pitch.control_period = 1.0 / 60.0;
  return pitch;
}

std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

// A parameter with its limits.
struct Limits {
  const char* name;
  double value, least, most;
  const char* reason;  // why nothing beyond the limits is played
};

}  // namespace

PitchSpec pitch_of(PitchPreset preset) {
  if (preset == PitchPreset::vsss) return vsss_pitch();
  if (preset == PitchPreset::simurosot) return simurosot_pitch();
  PitchSpec pitch;
  pitch.source = "Klancar et al., Robot Soccer Collision Modelling and Validation";
  return pitch;
}

std::string problem_with(const simulator::Parameters& p) {
  const double brake = p.brake_time_constant > 0.0 ? p.brake_time_constant : 0.1;
  const double reach = robot_outline(p).radius;
  const Limits limits[] = {
      {"robot_side", p.robot_side, 0.02, 0.1, "the places at restarts are for robots of that size"},
      {"robot_mass", p.robot_mass, 0.01, 50.0, "a robot has a mass in kg"},
      {"wheel_distance", p.wheel_distance, 0.005, 2.0 * reach,
       "the wheels would stand beyond the robot's corners"},
      {"wheel_radius", p.wheel_radius, 0.002, reach, "the wheels would be larger than the robot"},
      {"motor_time_constant", p.motor_time_constant, 1e-3, 10.0, "a motor has a lag in seconds"},
      {"turn_time_constant", p.turn_lag(), 1e-3, 10.0, "a motor has a lag in seconds"},
      {"brake_time_constant", brake, 1e-3, 10.0, "a motor has a lag in seconds"},
      {"wheel_speed_limit", p.wheel_speed_limit, 1.0, max_wheel_speed,
       "a robot moves, and a record holds no more"},
      {"wheel_speed_limit x wheel_radius", p.wheel_speed_limit * p.wheel_radius, 0.05, 10.0,
       "it is the top speed in m/s"},
      {"grip", std::min(p.grip, 100.0), 0.05, 100.0, "the robot would slide on ice"},
      {"ball_radius", p.ball_radius, 0.005, 0.05, "the ball would not fit into a goal or is dust"},
      {"ball_mass", p.ball_mass, 1e-3, 5.0, "a ball has a mass in kg"},
      {"rolling_resistance", p.rolling_resistance, 0.0, 1.0, "the ball would not roll at all"},
      {"viscous_friction", p.viscous_friction, 0.0, 10.0, "the ball would not roll at all"}};
  for (const Limits& l : limits) {
    if (l.value >= l.least && l.value <= l.most) continue;
    return std::string(l.name) + " is " + number_text(l.value) + ", not within " +
           number_text(l.least) + " to " + number_text(l.most) + ": " + l.reason;
  }
  const double half = 0.5 * p.robot_side * (1.0 + 1e-9);
  for (int i = 0; i < p.robot_corners.corners; ++i) {
    const Vec2 corner = p.robot_corners.corner(i);
    if (std::abs(corner.x()) <= half && std::abs(corner.y()) <= half) continue;
    return "the corner [" + number_text(corner.x()) + ", " + number_text(corner.y()) +
           "] of the outline lies outside the square of robot_side, with which the referee judges";
  }
  return "";
}

}  // namespace mirocup::match
