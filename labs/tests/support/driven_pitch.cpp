// SPDX-License-Identifier: MIT
#include "labs/tests/support/driven_pitch.hpp"

#include "core/base/math.hpp"
#include "core/base/random.hpp"
#include "core/simulator/world.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

namespace mirocup::test_support {

namespace {

using simulator::BodyState;

constexpr double hand_every = 4.0;    // s between two pushes of the ball by hand
constexpr double longest_way = 1.0;   // s, to a hit and back
constexpr double after_hit = 0.4;     // s
constexpr double half_side = 0.0375;  // m, of a robot
constexpr double near = 0.01;         // m, from where a hit is certain

// Drives to a point with that side which is nearer to it. Turns gently: robots with a lag of 0.2 s
// and a delay of 0.08 s would circle around it otherwise.
simulator::WheelSpeeds chase(const BodyState& robot, const Vec2& to, double most) {
  const Vec2 way = robot.heading.to_body(to - robot.position).normalized();
  const double forward = 0.7 * most * way.x() * std::abs(way.x());
  const double turn = 0.12 * most * std::copysign(way.y(), way.x() * way.y());
  return {forward - turn, forward + turn};
}

}  // namespace

void Driver::begin(double t, const DrivenStates& robots, Random& random) {
  constexpr std::array<Mode, 11> modes{Mode::rush,  Mode::rush,  Mode::dash, Mode::dash,
                                       Mode::knock, Mode::knock, Mode::duel, Mode::duel,
                                       Mode::chase, Mode::chase, Mode::chase};
  mode_ = modes[random.below(modes.size())];
  lead_ = random.uniform(0.0, 0.08);
  leaves_.fill(std::numeric_limits<double>::infinity());
  until_ = t + longest_way;
  if (mode_ == Mode::rush) until_ = t + random.uniform(0.2, 0.7);
  if (mode_ == Mode::chase) until_ = t + random.uniform(0.5, 1.2);
  const double share_of_back = std::max(0.0, random.uniform(-1.0, 1.0));
  for (int i = 0; i < driven_robots; ++i) {
    const double straight = random.uniform(0.5, 1.0) * fastest_;
    const bool faces_out = robots[i].heading.to_world({1.0, 0.0}).dot(robots[i].position) > 0.0;
    const double way = faces_out == (mode_ == Mode::knock) ? straight : -straight;
    wheels_[i] = {way, way};
    back_[i] = {-share_of_back * way, -share_of_back * way};
    if (mode_ == Mode::rush) {
      wheels_[i] = {random.uniform(-fastest_, fastest_), random.uniform(-fastest_, fastest_)};
    } else if (mode_ == Mode::dash) {
      back_[i] = {0.0, 0.0};
      leaves_[i] = t + random.uniform(0.25, 0.45);
      until_ = t + 0.8;
    } else if (mode_ == Mode::duel) {
      back_[i] = {-share_of_back * straight, -share_of_back * straight};
    }
  }
}

// True if a robot is `lead_` seconds before its hit.
bool Driver::arrives(int i, const DrivenStates& robots) const {
  const BodyState& robot = robots[i];
  const double speed = std::abs(robot.twist.forward);
  if (mode_ == Mode::duel) {
    const BodyState& other = robots[1 - i];
    const double gap = (other.position - robot.position).norm() - 2.0 * half_side;
    return gap < (speed + std::abs(other.twist.forward)) * lead_ + near;
  }
  if (mode_ != Mode::knock) return false;
  static const field::Field field = field::make_field(RobotLeague::small);
  const Vec2 way = robot.heading.to_world({std::copysign(1.0, wheels_[i].left), 0.0});
  const auto room = [](double half, double at, double along) {
    return (half - std::copysign(1.0, along) * at) / std::max(1e-6, std::abs(along));
  };
  const double gap = std::min(room(field.half_length, robot.position.x(), way.x()),
                              room(field.half_width, robot.position.y(), way.y()));
  return gap - half_side < speed * lead_ + near;
}

DrivenWheels Driver::at(double t, const DrivenStates& robots, const Vec2& ball, Random& random) {
  if (t >= until_) begin(t, robots, random);
  DrivenWheels wheels = wheels_;
  for (int i = 0; i < driven_robots; ++i) {
    if (t < leaves_[i] && arrives(i, robots)) {
      leaves_[i] = t;
      if (t >= leaves_[1 - i] || mode_ == Mode::duel) until_ = std::min(until_, t + after_hit);
    }
    if (t >= leaves_[i]) {
      wheels[i] = back_[i];
    } else if (mode_ == Mode::chase) {
      wheels[i] = chase(robots[i], ball, fastest_);
    } else if (mode_ == Mode::duel) {
      wheels[i] = chase(robots[i], robots[1 - i].position, fastest_);
    }
  }
  return wheels;
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

pitch::CameraLog recording_of(const DrivenPitch& driven, simulator::RunStatistics* statistics) {
  const simulator::Parameters& p = driven.truth.parameters;
  Random random(driven.seed);
  const field::Field field = field::make_field(RobotLeague::small);
  simulator::World world(driven.has_walls ? &field : nullptr, p, simulator::Tolerances{},
                         driven_robots, true);
  world.set_statistics(statistics);
  world.set_robot(0, {{-0.3, 0.1}, Heading{}, {}});
  world.set_robot(1, {{0.3, -0.1}, Heading::from_angle(2.0), {}});
  world.set_ball({{0.0, 0.0}, {0.5, 0.3}});
  pitch::CameraLog recording;
  recording.path = "driven";
  recording.league = RobotLeague::small;
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
      const BodyState robot = world.robot(i);
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
      if (statistics != nullptr) statistics->origin = at;
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
      double angle = random.uniform(-pi, pi);
      if (const auto to = random.below(2 * driven_robots); to < driven_robots) {
        const Vec2 way = world.robot(static_cast<int>(to)).position - free;
        angle = std::atan2(way.y(), way.x()) + 0.05 * angle;
      }
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
