// SPDX-License-Identifier: MIT
//
// Kicks: changes of velocity around an engine's steps, by which a user of a general engine makes it
// drive robots and roll a ball. A tick has half a kick before the first and after the last step and
// whole kicks between: free motion is then of second order, and they cost next to nothing.
#pragma once

#include "labs/bench/engine.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirocup::bench {

// Velocity in the field's frame, and the heading of the robot.
struct RobotMotion {
  Vec2 velocity;
  double turn;  // rad/s
  Heading heading;
};

// Exact over its duration for the motors and for the rolling ball. The wheels remove as much of the
// sideways velocity as their grip can, so that the robot moves along its heading in the middle of
// the step that follows.
class Kick {
 public:
  // `duration` (s) is the time that the kick stands for; a step of `step` seconds follows it, or no
  // step if that is 0.
  Kick(const simulator::Parameters& p, double duration, double step)
      : approach_(1.0 - std::exp(-duration / p.motor_time_constant)),
        grip_(p.grip * simulator::gravity * duration),
        half_step_(0.5 * step),
        decay_(std::exp(-duration * std::max(p.viscous_friction, least_viscosity) /
                        p.effective_ball_mass())),
        rest_(p.rolling_resistance * p.ball_mass * simulator::gravity /
              std::max(p.viscous_friction, least_viscosity)) {}

  void apply(double forward_aim, double turn_aim, RobotMotion& m) const {
    const Vec2 v = m.heading.to_body(m.velocity);
    const double forward = v.x() + approach_ * (forward_aim - v.x());
    m.turn += approach_ * (turn_aim - m.turn);
    const double left = v.y() + std::clamp(forward * m.turn * half_step_ - v.y(), -grip_, grip_);
    m.velocity = m.heading.to_world({forward, left});
  }

  Vec2 roll(const Vec2& velocity) const {
    const double speed = velocity.norm();
    if (speed == 0.0) return velocity;
    return std::max(0.0, (speed + rest_) * decay_ - rest_) / speed * velocity;
  }

 private:
  static constexpr double least_viscosity = 1e-6;  // kg/s: the formula divides by it

  double approach_;
  double grip_;
  double half_step_;
  double decay_;
  double rest_;
};

// An engine that divides a tick into equal steps. Physics(start, step) is a peer: robot_motion(i),
// set_robot_motion(i, motion), ball_velocity(), set_ball_velocity(v), step(), robot(i), ball().
template <class Physics>
class Stepped final : public Engine {
 public:
  template <class... Options>
  Stepped(const Start& start, int steps, const Options&... options)
      : parameters_(start.parameters),
        robots_(static_cast<int>(start.robots.size())),
        steps_(steps),
        first_(start.parameters, 0.5 * start.period / steps, start.period / steps),
        whole_(start.parameters, start.period / steps, start.period / steps),
        last_(start.parameters, 0.5 * start.period / steps, 0.0),
        physics_(start, start.period / steps, options...) {}

  void advance(std::span<const simulator::WheelCommand> commands) override {
    for (int i = 0; i < robots_; ++i) {
      if (!commands[i]) continue;
      const double limit = parameters_.wheel_speed_limit;
      const double left = std::clamp(commands[i]->left, -limit, limit);
      const double right = std::clamp(commands[i]->right, -limit, limit);
      aims_[i] = {parameters_.speed_reference(left, right),
                  parameters_.omega_reference(left, right)};
    }
    kick(first_, commands);
    for (int step = 1; step <= steps_; ++step) {
      physics_.step();
      kick(step < steps_ ? whole_ : last_, commands);
    }
  }

  simulator::BodyState robot(int i) const override { return physics_.robot(i); }
  simulator::BallState ball() const override { return physics_.ball(); }

 private:
  struct Aim {
    double forward, turn;
  };

  void kick(const Kick& kick, std::span<const simulator::WheelCommand> commands) {
    for (int i = 0; i < robots_; ++i) {
      if (!commands[i]) continue;
      RobotMotion motion = physics_.robot_motion(i);
      kick.apply(aims_[i].forward, aims_[i].turn, motion);
      physics_.set_robot_motion(i, motion);
    }
    physics_.set_ball_velocity(kick.roll(physics_.ball_velocity()));
  }

  simulator::Parameters parameters_;
  int robots_;
  int steps_;
  Kick first_, whole_, last_;
  std::array<Aim, simulator::max_robots> aims_{};
  Physics physics_;
};

inline simulator::BodyState state_of(const Vec2& position, const RobotMotion& m) {
  const Vec2 v = m.heading.to_body(m.velocity);
  return {position, m.heading, {v.x(), v.y(), m.turn}};
}

// Returns a contender for each step size.
template <class Physics, class... Options>
std::vector<Contender> stepped_contenders(const std::string& engine, const std::string& settings,
                                          const Options&... options) {
  std::vector<Contender> all;
  for (const int steps : step_counts) {
    const double ms = 1e3 * tick / steps;
    const std::string point =
        steps > 33 ? "0.5 ms" : std::to_string(static_cast<int>(std::lround(ms))) + " ms";
    all.push_back({engine, settings, point, steps, [=](const Start& start) {
                     return std::make_unique<Stepped<Physics>>(start, steps, options...);
                   }});
  }
  return all;
}

}  // namespace mirocup::bench
