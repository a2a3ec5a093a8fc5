// SPDX-License-Identifier: MIT
//
// Bodies that press on each other for a minute.
#include "tests/physics/bars.hpp"
#include "tests/physics/scene.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::scenes {

using test_support::Outline;

namespace {

constexpr double settling = 5.0;  // s
constexpr double u = 30.0;        // rad/s: 0.675 m/s

struct Push {
  const char* name;
  Start start;
  std::vector<WheelCommand> commands;
  bool rests = true;      // else it goes on at a constant speed, together
  Vec2 moving{0.0, 0.0};  // m/s, after settling
};

struct Measured {
  double overlap = 0.0;
  double speed = 0.0;        // m/s and rad/s, against `moving`
  double drift = 0.0;        // m and rad, against `moving`
  double more_events = 0.0;  // a tick, than in the first second after settling
  bool stepped = false;
};

std::vector<BodyState> robots_of(const World& world) {
  std::vector<BodyState> robots;
  for (int i = 0; i < world.robots(); ++i) robots.push_back(world.robot(i));
  return robots;
}

Measured play(const Push& push, double duration) {
  const auto world = world_of(push.start);
  const auto solids = push.start.field != nullptr ? test_support::solids_around(*push.start.field)
                                                  : std::vector<Outline>{};
  const bool has_ball = !push.start.ball.empty();
  const int settled = static_cast<int>(settling / tick);
  const int ticks = settled + static_cast<int>(duration / tick);
  Measured m;
  std::vector<BodyState> robots;
  BallState ball;
  int first_events = 0;
  for (int i = 0; i < ticks; ++i) {
    const simulator::TickEvents& events = world->advance(push.commands, tick);
    m.overlap = std::max({m.overlap, events.deepest_overlap, deepest_overlap(*world, solids)});
    m.stepped = m.stepped || events.stepped;
    if (i < settled) continue;
    if (i < settled + 30) first_events = std::max(first_events, events.events);
    m.more_events = std::max(m.more_events, static_cast<double>(events.events - first_events));
    if (i == settled) {
      robots = robots_of(*world);
      if (has_ball) ball = world->ball();
    }
    const Vec2 moved = (i - settled) * tick * push.moving;
    for (int k = 0; k < world->robots(); ++k) {
      BodyState now = world->robot(k);
      const Vec2 v = now.heading.to_world({now.twist.forward, now.twist.left});
      m.speed = std::max({m.speed, (v - push.moving).norm(), std::abs(now.twist.omega)});
      now.position -= moved;
      m.drift = std::max(m.drift, difference(now, robots[k]));
    }
    if (!has_ball) continue;
    m.speed = std::max(m.speed, (world->ball().velocity - push.moving).norm());
    m.drift = std::max(m.drift, (world->ball().position - moved - ball.position).norm());
  }
  return m;
}

const WheelCommand ahead = WheelSpeeds{u, u};

Push head_on(double angle, double aside) {
  Push p{.name = "head-on push", .start = {}, .commands = {ahead, ahead}};
  const Heading h = Heading::from_angle(angle);
  p.start.robots = {robot_at(h.to_world({-0.06, 0.0}), angle),
                    robot_at(h.to_world({0.06, aside}), angle + pi)};
  return p;
}

Push pushed_ball(double angle) {
  Push p{.name = "pushed ball", .start = {}, .commands = {ahead}};
  const Heading h = Heading::from_angle(angle);
  p.start.robots = {robot_at({0.0, 0.0}, angle)};
  p.start.ball = {{h.to_world({0.07, 0.0}), {0.0, 0.0}}};
  return p;
}

Push pinched_at_wall(const field::Field& field, double aside, const char* name) {
  Push p{.name = name, .start = {}, .commands = {ahead}};
  p.start.field = &field;
  p.start.robots = {robot_at({0.1, field.half_width - 0.15}, pi / 2)};
  p.start.ball = {{{0.1 + aside, field.half_width - 0.05}, {0.0, 0.0}}};
  return p;
}

Push pinched_by_robots(double angle) {
  Push p = head_on(angle, 0.0);
  p.name = "ball pinched between robots";
  const Heading h = Heading::from_angle(angle);
  p.start.robots[0].position = h.to_world({-0.1, 0.0});
  p.start.robots[1].position = h.to_world({0.1, 0.0});
  p.start.ball = {{{0.0, 0.0}, {0.0, 0.0}}};
  return p;
}

void add_bars(const Push& push, double duration, Bars& bars) {
  const Measured m = play(push, duration);
  const std::string scene = push.name;
  bars.push_back({scene, "overlap, m", m.overlap, 1e-7});
  bars.push_back({scene, "speed, m/s and rad/s", m.speed, 1e-7});
  bars.push_back({scene, "drift, m and rad", m.drift, 1e-7});
  bars.push_back({scene, "more events a tick than in the first second", m.more_events, 0.0});
  bars.push_back({scene, "finished in small steps", m.stepped ? 1.0 : 0.0, 0.0});
}

// A robot that has pushed a ball for a while goes at the speed of its wheels, less what the ball's
// resistance takes.
Vec2 pushing_velocity(const Push& push) {
  const Parameters& p = push.start.parameters;
  const double wheels = p.wheel_radius * u;
  // M (v_ref - v)/T = K_c m g + f_v v
  const double drive = p.robot_mass / p.motor_time_constant;
  const double speed =
      (drive * wheels - p.rolling_resistance * p.ball_mass * 9.81) / (drive + p.viscous_friction);
  return push.start.robots[0].heading.to_world({speed, 0.0});
}

// One pushes another that is told to stand. Both motors act on the mass of two:
// M (v_ref - v)/T - M v/T_brake = 0.
Push against_brake(const Motors& motors) {
  Push p = head_on(0.0, 0.0);
  p.start.parameters = with(motors);
  p.commands[1] = WheelSpeeds{0.0, 0.0};
  const double drives = p.start.parameters.motor_time_constant;
  const double holds = motors.brake > 0.0 ? motors.brake : drives;
  p.moving = {p.start.parameters.wheel_radius * u * holds / (drives + holds), 0.0};
  return p;
}

void add_named(const std::string& name, Push push, double duration, Bars& bars) {
  push.name = name.c_str();
  add_bars(push, duration, bars);
}

}  // namespace

Bars motors_pushing(Size size) {
  const double duration = cases(size, 5, 60);
  Bars bars;
  for (const Motors& motors : other_motors) {
    const std::string name = std::string(motors.name) + ": ";
    Push push = head_on(0.0, 0.0);
    push.start.parameters = with(motors);
    add_named(name + "head-on push", push, duration, bars);
    push = pushed_ball(0.0);
    push.start.parameters = with(motors);
    push.moving = pushing_velocity(push);
    add_named(name + "pushed ball", push, duration, bars);
    add_named(name + "push against one that stands", against_brake(motors), duration, bars);
  }
  return bars;
}

Bars lasting_pushes(Size size) {
  const double duration = cases(size, 10, 60);
  const field::Field field = field::make_field(RobotLeague::small);
  Bars bars;
  std::vector<Push> pushes{head_on(0.0, 0.0),
                           head_on(0.7, 0.0),
                           pushed_ball(0.0),
                           pushed_ball(0.7),
                           pinched_at_wall(field, 0.0, "ball pinched at a wall"),
                           pinched_by_robots(0.0),
                           pinched_by_robots(0.7)};
  for (Push& push : pushes) {
    if (push.name == std::string("pushed ball")) push.moving = pushing_velocity(push);
    if (push.start.robots[0].heading.sin > 0.0 && push.start.robots[0].heading.cos > 0.1) {
      add_named(push.name + std::string(", turned by 0.7 rad"), push, duration, bars);
    } else {
      add_bars(push, duration, bars);
    }
  }
  return bars;
}

}  // namespace mirocup::scenes
