// SPDX-License-Identifier: MIT
//
// The core is compiled into a team's library under another name, which the build defines
// `mirocup` to be: a program that has the core already may load or link such a library.
#include "core/field/field.hpp"
#include "core/match/command.hpp"
#include "core/match/copy_fields.hpp"
#include "core/match/observed_robot.hpp"
#include "core/simulator/trajectory/closed_form.hpp"
#include "core/simulator/world.hpp"

namespace core = mirocup;
#undef mirocup

#include "mirocup/predict.hpp"

#include <type_traits>

namespace mirocup::strategy {

namespace {

namespace simulator = core::simulator;
using core::Vec2;
using simulator::BodyState;

// m/s: slower to the left is rounding of the observation, not a slide.
constexpr double no_slide = 1e-9;

BodyState to_state(const Body& body) {
  return {{body.at.x, body.at.y}, {body.cos, body.sin}, {body.forward, body.left, body.turn}};
}

Body from_state(const BodyState& state) {
  return {.at = {state.position.x(), state.position.y()},
          .cos = state.heading.cos,
          .sin = state.heading.sin,
          .forward = state.twist.forward,
          .left = state.twist.left,
          .turn = state.twist.omega};
}

Robot from_observed(const core::match::ObservedRobot& robot) {
  return {.x = robot.position.x(),
          .y = robot.position.y(),
          .heading = robot.heading,
          .vx = robot.velocity.x(),
          .vy = robot.velocity.y(),
          .turn = robot.turn};
}

// Returns the robot in the frame of the other team.
Robot turned(const Body& body) {
  return from_observed(
      core::match::team_frame(core::End::right, core::match::observed(to_state(body))));
}

// The model of a match, with the numbers of this leg.
simulator::Parameters parameters_of(const Setup& setup) {
  simulator::Parameters p;
  core::match::copy_bodies(setup, p);
  p.turn_time_constant = setup.turn_time_constant;
  p.brake_time_constant = setup.brake_time_constant;
  p.rolling_resistance = setup.rolling_resistance;
  p.viscous_friction = setup.viscous_friction;
  p.restitution = {.ball_wall = setup.ball_wall_restitution,
                   .ball_robot = setup.ball_robot_restitution,
                   .robot_wall = setup.robot_wall_restitution,
                   .robot_robot = setup.robot_robot_restitution};
  p.contact_friction = {.ball_wall = setup.ball_wall_friction,
                        .ball_robot = setup.ball_robot_friction,
                        .robot_wall = setup.robot_wall_friction,
                        .robot_robot = setup.robot_robot_friction};
  p.robot_corners.corners = std::min<int>(setup.corners, core::geometry::max_corners);
  std::copy_n(setup.corner_x, core::geometry::max_corners, p.robot_corners.x.begin());
  std::copy_n(setup.corner_y, core::geometry::max_corners, p.robot_corners.y.begin());
  return p;
}

// Puts the ball into an observation; a sign of -1 turns it into the frame of the other team.
void put(const MovingBall& ball, double sign, Observation& now) {
  now.ball_x = sign * ball.at.x;
  now.ball_y = sign * ball.at.y;
  now.ball_vx = sign * ball.velocity.x;
  now.ball_vy = sign * ball.velocity.y;
}

core::match::DrivenCommand driven(const Setup& setup, const Command& command) {
  core::match::Command asked;
  for (int i = 0; i < setup.robots; ++i)
    asked.wheels[i] = {command.wheels[i].left, command.wheels[i].right};
  return core::match::check(asked, setup.robots, setup.wheel_speed_limit).command;
}

}  // namespace

Body body_of(const Robot& robot) {
  const core::Heading heading = core::Heading::from_angle(robot.heading);
  const Vec2 velocity = heading.to_body({robot.vx, robot.vy});
  return {.at = {robot.x, robot.y},
          .cos = heading.cos,
          .sin = heading.sin,
          .forward = velocity.x(),
          .left = std::abs(velocity.y()) < no_slide ? 0.0 : velocity.y(),
          .turn = robot.turn};
}

Robot robot_of(const Body& body) {
  return from_observed(core::match::observed(to_state(body)));
}

Scene scene_of(const Observation& now) {
  Scene scene;
  scene.robots = now.robots;
  scene.ball = moving_ball(now);
  for (int i = 0; i < now.robots; ++i) {
    scene.own[i] = body_of(now.own[i]);
    scene.opponent[i] = body_of(now.opponent[i]);
  }
  return scene;
}

void show(const Scene& scene, Observation& now) {
  put(scene.ball, 1.0, now);
  for (int i = 0; i < scene.robots; ++i) {
    now.own[i] = robot_of(scene.own[i]);
    now.opponent[i] = robot_of(scene.opponent[i]);
  }
}

void show_to_opponents(const Scene& scene, Observation& now) {
  put(scene.ball, -1.0, now);
  for (int i = 0; i < scene.robots; ++i) {
    now.own[i] = turned(scene.opponent[i]);
    now.opponent[i] = turned(scene.own[i]);
  }
}

Wheels sent_wheels(const Setup& setup, Wheels wheels) {
  core::match::Command one;
  one.wheels[0] = {wheels.left, wheels.right};
  const simulator::WheelSpeeds sent =
      core::match::check(one, 1, setup.wheel_speed_limit).command.speeds(0);
  return {sent.left, sent.right};
}

Body robot_after(const Setup& setup, const Body& robot, Wheels wheels, double seconds) {
  namespace trajectory = simulator::trajectory;
  const simulator::Parameters parameters = parameters_of(setup);
  const Wheels sent = sent_wheels(setup, wheels);
  const trajectory::DriveReference drive =
      trajectory::drive_reference(parameters, simulator::WheelSpeeds{sent.left, sent.right});
  BodyState state = to_state(robot);
  for (double t = 0.0; t < seconds;) {
    // As long as the ticks for which the simulator uses its closed form.
    const double end = std::min(seconds, t + setup.control_period);
    if (has_closed_form(parameters, state, drive, end - t)) {
      state = closed_form_state(state, drive, end - t);
      t = end;
    } else {
      const trajectory::Segment segment =
          trajectory::drive(parameters, state, drive, t, end, trajectory::never);
      t = segment.end;
      state = body_at(segment, t);
    }
  }
  return from_state(state);
}

Wheels driven_wheels(const Setup& setup, const Robot& before, const Robot& after) {
  const Body a = body_of(before);
  const Body b = body_of(after);
  const double left = core::exp(-setup.control_period / setup.motor_time_constant);
  const double turn_lag = parameters_of(setup).turn_lag();
  const double turn_left = core::exp(-setup.control_period / turn_lag);
  const double forward = (b.forward - left * a.forward) / (1.0 - left);
  const double side =
      (b.turn - turn_left * a.turn) / (1.0 - turn_left) * setup.wheel_distance / 2.0;
  const double limit = setup.wheel_speed_limit;
  return {std::clamp((forward - side) / setup.wheel_radius, -limit, limit),
          std::clamp((forward + side) / setup.wheel_radius, -limit, limit)};
}

void Tracker::saw(const Observation& now) {
  const bool goes_on = has_before_ && now.state == MIROCUP_PLAY && before_.state == MIROCUP_PLAY &&
                       now.tick == before_.tick + 1;
  opponents_ = {};
  for (int i = 0; goes_on && i < now.robots; ++i)
    opponents_.wheels[i] = driven_wheels(setup_, before_.opponent[i], now.opponent[i]);
  before_ = now;
  has_before_ = true;
}

// The field, the bodies on it, and room for what they remember.
struct Simulator::Physics {
  Physics(const Setup& from, Precision precision)
      : setup(from),
        field(core::field::make_field(static_cast<core::RobotLeague>(setup.league))),
        world(&field, parameters_of(setup),
              simulator::tolerances_of(precision == Precision::match ? simulator::Accuracy::standard
                                                                     : simulator::Accuracy::coarse),
              2 * setup.robots, true) {}

  // The indices of the robots in the world: those of blue come first, as in a match.
  int own(int i) const { return setup.team == MIROCUP_BLUE ? i : setup.robots + i; }
  int opponent(int i) const { return setup.team == MIROCUP_BLUE ? setup.robots + i : i; }

  Setup setup;
  core::field::Field field;
  simulator::World world;
  simulator::World::Memory memory;
};

Simulator::Simulator(const Setup& setup, Precision precision)
    : physics_(std::make_unique<Physics>(setup, precision)) {}

Simulator::~Simulator() = default;

PredictedTick Simulator::advance(Scene& scene, const Command& own, const Command& opponent,
                                 int ticks) {
  static_assert(sizeof(simulator::World::Memory) <= sizeof scene.memory.bytes_ &&
                std::is_trivially_copyable_v<simulator::World::Memory>);
  Physics& p = *physics_;
  simulator::World& world = p.world;
  const int robots = p.setup.robots;
  for (int i = 0; i < robots; ++i) {
    world.set_robot(p.own(i), to_state(scene.own[i]));
    world.set_robot(p.opponent(i), to_state(scene.opponent[i]));
  }
  world.set_ball(
      {{scene.ball.at.x, scene.ball.at.y}, {scene.ball.velocity.x, scene.ball.velocity.y}});
  if (scene.memory.used_ > 0) {
    std::memcpy(&p.memory, scene.memory.bytes_, scene.memory.used_);
    world.recall(p.memory);
  }

  const core::match::DrivenCommand own_driven = driven(p.setup, own);
  const core::match::DrivenCommand opponent_driven = driven(p.setup, opponent);
  std::array<simulator::WheelCommand, simulator::max_robots> wheels;
  for (int i = 0; i < robots; ++i) {
    wheels[p.own(i)] = own_driven.speeds(i);
    wheels[p.opponent(i)] = opponent_driven.speeds(i);
  }
  const simulator::TickEvents& events = world.advance(wheels, ticks * p.setup.control_period);

  const simulator::BallState ball = world.ball();
  scene.ball = {{ball.position.x(), ball.position.y()}, {ball.velocity.x(), ball.velocity.y()}};
  PredictedTick tick;
  tick.events = events.events;
  const simulator::BodySet& touched_ball = events.touched[2 * robots];
  for (int i = 0; i < robots; ++i) {
    scene.own[i] = from_state(world.robot(p.own(i)));
    scene.opponent[i] = from_state(world.robot(p.opponent(i)));
    if (touched_ball[p.own(i)]) tick.own_touched_ball |= 1u << i;
    if (touched_ball[p.opponent(i)]) tick.opponent_touched_ball |= 1u << i;
    if (events.last_to_touch_ball == p.own(i)) tick.last_touch = i + 1;
    if (events.last_to_touch_ball == p.opponent(i)) tick.last_touch = -i - 1;
    for (int j = 0; j < robots; ++j) {
      if (events.touched[p.own(i)][p.opponent(j)]) tick.touched_opponent[i] |= 1u << j;
    }
  }
  world.save(p.memory);
  scene.memory.used_ = simulator::World::size_of(p.memory);
  std::memcpy(scene.memory.bytes_, &p.memory, scene.memory.used_);
  return tick;
}

}  // namespace mirocup::strategy
