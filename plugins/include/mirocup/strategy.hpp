// SPDX-License-Identifier: MIT
//
// A team in C++: derive from Team, and export it.
//
//   class Mine : public mirocup::strategy::Team {
//    public:
//     using Team::Team;
//     void decide(const Observation& now, Command& command) override {
//       for (int i = 0; i < now.robots; ++i) {
//         command.wheels[i] = drive_to(setup(), now.own[i], {now.ball_x, now.ball_y});
//       }
//     }
//   };
//   MIROCUP_EXPORT_TEAM(Mine, "mine")
//
// Frames, units, delays and limits are those of strategy.h, which says all of them. This header has
// no other dependency; everything in it is inline.
#pragma once

#include "mirocup/strategy.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace mirocup::strategy {

using Setup = mirocup_setup;
using Observation = mirocup_observation;
using Command = mirocup_command;
using Robot = mirocup_robot;
using Wheels = mirocup_wheels;

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

// The same angle in (-pi, pi].
inline double wrapped(double angle) {
  while (angle > pi) angle -= 2.0 * pi;
  while (angle <= -pi) angle += 2.0 * pi;
  return angle;
}

// Wheel speeds for a forward speed (m/s) and a turn rate (rad/s). If a wheel would be too fast both
// are slowed alike, so the robot keeps to its curve.
inline Wheels wheels_for(const Setup& setup, double forward, double turn) {
  const double side = turn * setup.wheel_distance / 2.0;
  Wheels w{(forward - side) / setup.wheel_radius, (forward + side) / setup.wheel_radius};
  const double fastest = std::max(std::abs(w.left), std::abs(w.right));
  if (fastest > setup.wheel_speed_limit) {
    const double k = setup.wheel_speed_limit / fastest;
    w.left *= k;
    w.right *= k;
  }
  return w;
}

// Turns on the spot towards a heading.
inline Wheels turn_to(const Setup& setup, const Robot& robot, double heading) {
  return wheels_for(setup, 0.0, 8.0 * wrapped(heading - robot.heading));
}

// Drives to a point, front or back first, whichever is nearer, and passes it at `arrival` m/s (0:
// stops there).
inline Wheels drive_to(const Setup& setup, const Robot& robot, Point target, double arrival = 0.0,
                       double fastest = 1.5) {
  const Point to = target - position(robot);
  const double distance = length(to);
  if (distance < 0.005 && arrival == 0.0) return {0.0, 0.0};
  double error = wrapped(std::atan2(to.y, to.x) - robot.heading);
  double direction = 1.0;
  if (std::abs(error) > pi / 2.0) {
    error = wrapped(error + pi);
    direction = -1.0;
  }
  // As fast as the distance allows, slower while it still has to turn.
  const double wanted = std::min(fastest, arrival + 5.0 * distance);
  const double turn = 9.0 * error;
  double speed = wanted * std::max(0.0, std::cos(error));
  // Wheels that slide do not steer.
  const double steady = 0.8 * setup.grip * 9.81;
  if (std::abs(speed * turn) > steady) speed = steady / std::abs(turn);
  return wheels_for(setup, direction * speed, turn);
}

// Random numbers that a leg can be repeated with (splitmix64).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  // In [0, 1).
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

class Team {
 public:
  explicit Team(const Setup& setup) : setup_(setup), random_(setup.seed) {}
  virtual ~Team() = default;

  virtual void decide(const Observation& now, Command& command) = 0;

 protected:
  const Setup& setup() const { return setup_; }
  Random& random() { return random_; }

 private:
  Setup setup_;
  Random random_;
};

}  // namespace mirocup::strategy

// Makes a class the library's team. Its constructor takes the setup.
#define MIROCUP_EXPORT_TEAM(Class, Name)                                           \
  extern "C" MIROCUP_PUBLIC const mirocup_strategy* mirocup_entry(void) {          \
    static const mirocup_strategy entry = {                                        \
        MIROCUP_ABI_VERSION,                                                       \
        sizeof(mirocup_strategy),                                                  \
        Name,                                                                      \
        [](const mirocup_setup* setup) -> void* { return new Class(*setup); },     \
        [](void* team, const mirocup_observation* now, mirocup_command* command) { \
          static_cast<Class*>(team)->decide(*now, *command);                       \
        },                                                                         \
        [](void* team) { delete static_cast<Class*>(team); }};                     \
    return &entry;                                                                 \
  }
