// SPDX-License-Identifier: MIT
//
// The words of a team in C++: the structures of strategy.h under short names, points, angles,
// random numbers. Include strategy.hpp instead of this header.
#pragma once

#include "mirocup/elementary.hpp"
#include "mirocup/strategy.h"

#include <cmath>
#include <cstdint>

namespace mirocup::strategy {

using Setup = mirocup_setup;
using Observation = mirocup_observation;
using Command = mirocup_command;
using Robot = mirocup_robot;
using Wheels = mirocup_wheels;
using Placement = mirocup_placement;

inline constexpr double pi = 3.14159265358979323846;

// A point or a vector, m.
struct Point {
  double x = 0.0;
  double y = 0.0;
};
inline Point operator+(Point a, Point b) {
  return {a.x + b.x, a.y + b.y};
}
inline Point operator-(Point a, Point b) {
  return {a.x - b.x, a.y - b.y};
}
inline Point operator*(double k, Point a) {
  return {k * a.x, k * a.y};
}
inline double dot(Point a, Point b) {
  return a.x * b.x + a.y * b.y;
}
inline double length(Point a) {
  return std::sqrt(dot(a, a));
}
inline Point unit(Point a) {
  const double l = length(a);
  return l > 0.0 ? (1.0 / l) * a : Point{1.0, 0.0};
}

inline Point ball(const Observation& now) {
  return {now.ball_x, now.ball_y};
}
inline Point ball_velocity(const Observation& now) {
  return {now.ball_vx, now.ball_vy};
}
inline Point position(const Robot& robot) {
  return {robot.x, robot.y};
}

// Returns the same angle in (-pi, pi], rad; NaN for an angle that is infinite or NaN.
inline double wrapped(double angle) {
  const double rest = std::remainder(angle, 2.0 * pi);  // exact, in [-pi, pi]
  return rest <= -pi ? pi : rest;
}

// Random numbers (splitmix64). They are the same whenever the leg is played again.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  // Returns a number in [0, 1).
  double uniform() {
    state_ += 0x9e3779b97f4a7c15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1.0p-53;
  }

 private:
  std::uint64_t state_;
};

}  // namespace mirocup::strategy
