// SPDX-License-Identifier: MIT
#include "tests/support/driven_pitch.hpp"

#include "core/base/math.hpp"
#include "core/base/random.hpp"
#include "core/simulator/world.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

namespace mirocup::test_support {

namespace {

constexpr double hand_every = 4.0;  // s between two pushes of the ball by hand

simulator::WheelSpeeds chase(const simulator::BodyState& robot, const Vec2& ball, double most) {
  const Vec2 way = robot.heading.to_body(ball - robot.position);
  const double angle = std::atan2(way.y(), way.x());
  const double forward = 0.7 * most * std::cos(angle);
  const double turn = 0.5 * most * std::sin(angle);
  return {forward - turn, forward + turn};
}

}  // namespace

DrivenWheels Driver::at(double t, const DrivenStates& robots, const Vec2& ball, Random& random) {
  if (t >= until_) {
    const auto mode = random.below(4);
    until_ = t + random.uniform(0.2, 0.7);
    for (simulator::WheelSpeeds& wheels : wheels_) {
      wheels = {random.uniform(-fastest_, fastest_), random.uniform(-fastest_, fastest_)};
      if (mode == 1) wheels = {0.0, 0.0};
    }
    is_chase_ = mode >= 2;
  }
  if (is_chase_) {
    for (int i = 0; i < driven_robots; ++i) wheels_[i] = chase(robots[i], ball, fastest_);
  }
  return wheels_;
}

pitch::Guess random_pitch(std::uint64_t seed) {
  Random random(seed * 7919 + 17);
  pitch::Guess truth;
  simulator::Parameters& p = truth.parameters;
  p.wheel_radius = random.uniform(0.018, 0.027);
  p.wheel_distance = random.uniform(0.055, 0.085);
  p.motor_time_constant = random.uniform(0.03, 0.2);
  if (seed % 2 == 0) p.turn_time_constant = p.motor_time_constant * random.uniform(0.3, 0.7);
  if (seed % 3 == 0) p.brake_time_constant = p.motor_time_constant * random.uniform(0.2, 0.5);
  p.grip = random.uniform(0.4, 1.0);
  p.rolling_resistance = random.uniform(0.005, 0.03);
  p.viscous_friction = random.uniform(0.002, 0.02);
  p.restitution = {.ball_wall = random.uniform(0.3, 0.9),
                   .ball_robot = random.uniform(0.2, 0.8),
                   .robot_wall = random.uniform(0.1, 0.5),
                   .robot_robot = random.uniform(0.1, 0.5)};
  truth.command_delay = random.uniform(0.0, 0.08);
  return truth;
}

pitch::Recording recording_of(const DrivenPitch& driven) {
  const simulator::Parameters& p = driven.truth.parameters;
  Random random(driven.seed);
  const field::Field field = field::make_field(League::small);
  simulator::World world(driven.has_walls ? &field : nullptr, p, simulator::Tolerances{},
                         driven_robots, true);
  world.set_robot(0, {{-0.3, 0.1}, Heading{}, {}});
  world.set_robot(1, {{0.3, -0.1}, Heading::from_angle(2.0), {}});
  world.set_ball({{0.0, 0.0}, {0.5, 0.3}});
  pitch::Recording recording;
  recording.path = "driven";
  recording.league = League::small;
  recording.robots = 1;
  recording.period = driven.period;

  struct Sent {
    double t;
    DrivenWheels wheels;
  };
  std::deque<Sent> sent;
  Sent now{};
  double next_hand = hand_every;
  Driver driver(std::min(70.0, p.wheel_speed_limit));
  for (double t = 0.0; t < driven.seconds; t += driven.period) {
    now.t = t;
    now.wheels = driver.at(t, {world.robot(0), world.robot(1)}, world.ball().position, random);
    sent.push_back(now);
    pitch::Frame frame;
    frame.t = t;
    frame.ball = world.ball().position;
    for (int i = 0; i < driven_robots; ++i) {
      const simulator::BodyState robot = world.robot(i);
      frame.robots[i].push_back(pitch::SeenPose{robot.position, robot.heading.angle()});
      frame.commands[i].push_back(now.wheels[i]);
    }
    recording.frames.push_back(frame);
    // From one picture to the next, in pieces between the times at which commands arrive.
    double at = t;
    const double end = t + driven.period;
    while (at < end - 1e-12) {
      double piece = end;
      std::array<simulator::WheelCommand, driven_robots> wheels;
      wheels.fill(simulator::WheelSpeeds{});
      for (const Sent& command : sent) {
        const double arrives = command.t + driven.truth.command_delay;
        if (arrives > at + 1e-12) {
          piece = std::min(piece, arrives);
          break;
        }
        for (int i = 0; i < driven_robots; ++i) wheels[i] = command.wheels[i];
      }
      world.advance(wheels, piece - at);
      at = piece;
    }
    if (t >= next_hand) {
      next_hand += hand_every;
      Vec2 free{0.0, 0.0};
      do {
        free = {random.uniform(-0.6, 0.6), random.uniform(-0.5, 0.5)};
      } while ((free - world.robot(0).position).norm() < 0.15 ||
               (free - world.robot(1).position).norm() < 0.15);
      const double angle = random.uniform(-pi, pi);
      const double speed = random.uniform(0.3, 1.8);
      world.set_ball({free, {speed * std::cos(angle), speed * std::sin(angle)}});
    }
  }
  pitch::CameraNoise noise = driven.noise;
  noise.seed = driven.seed + 1000;
  pitch::look_through(noise, recording);
  return recording;
}

}  // namespace mirocup::test_support
