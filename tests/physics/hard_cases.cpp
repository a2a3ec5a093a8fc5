// SPDX-License-Identifier: MIT
//
// Cases that are hard for a simulator of events: very short and very long ticks, energy over many
// hits, and a heap that rests.
#include "tests/physics/bars.hpp"
#include "tests/physics/scene.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::scenes {

namespace {

using simulator::Accuracy;

// Six robots close to each other and to the ball, each with a command of its own.
struct Crowd {
  Start start;
  std::vector<WheelCommand> commands;
};

Crowd random_crowd(const field::Field& field, Random& random) {
  Crowd crowd;
  Start& s = crowd.start;
  s.field = &field;
  for (int i = 0; i < 6; ++i) {
    s.robots.emplace_back();
    do {
      s.robots.back() = {random_in(random, 0.2, 0.16), random_heading(random), {}};
    } while (overlap(s));
    crowd.commands.push_back(random_wheels(random, 70.0));
  }
  s.ball.emplace_back();
  do {
    const Vec2 way = random_heading(random).forward();
    s.ball.back() = {random_in(random, 0.2, 0.16), random.uniform(0.0, 1.0) * way};
  } while (overlap(s));
  return crowd;
}

}  // namespace

// Catches limits that count impacts within a tick, or begin anew with each: then the tick's length
// decides which bounces are dropped. A crowd in a hundred may be time-stepped in ticks of 33 ms.
Bars tick_lengths(Size size) {
  const field::Field field = field::make_field(RobotLeague::small);
  Random random(21);
  std::vector<double> differences;
  for (int i = 0; i < cases(size, 200, 1000); ++i) {
    const Crowd crowd = random_crowd(field, random);
    const auto play = [&](double step, int steps) {
      auto world = world_of(crowd.start);
      for (int k = 0; k < steps; ++k) world->advance(crowd.commands, step);
      return world;
    };
    const auto whole = play(tick, 7);
    const auto fine = play(tick / 330.0, 7 * 330);
    double worst = 0.0;
    for (int k = 0; k < 6; ++k)
      worst = std::max(worst, (whole->robot(k).position - fine->robot(k).position).norm());
    differences.push_back(worst);
  }
  std::sort(differences.begin(), differences.end());
  const auto at = [&](double share) {
    return differences[static_cast<std::size_t>(share * static_cast<double>(differences.size()))];
  };
  const std::string scene = "crowds, ticks of 0.1 ms and of 33 ms";
  return {{scene, "p90 of the distance after 0.231 s, m", at(0.9), 1e-8},
          {scene, "p99 of the distance after 0.231 s, m", at(0.99), 1e-4}};
}

// Catches a level that drops bounces or steps free bodies, and thresholds that grow in a long tick.
Bars elastic_energy(Size size) {
  const field::Field field = field::make_field(RobotLeague::small);
  Start s;
  s.field = &field;
  s.parameters = without_rolling_friction();
  s.parameters.restitution = {1.0, 1.0, 1.0, 1.0};
  Random random(22);
  for (int i = 0; i < 5; ++i) {
    const simulator::Twist twist{random.uniform(-1.5, 1.5), random.uniform(-1.0, 1.0),
                                 random.uniform(-8.0, 8.0)};
    const Vec2 place{-0.5 + 0.25 * i, 0.2 * (i % 3 - 1) + 0.01};
    s.robots.push_back({place, random_heading(random), twist});
  }
  s.ball.push_back({{0.05, -0.4}, {2.0, 1.3}});
  const std::vector<WheelCommand> lifted(5);
  double worst = 0.0;
  int too_few = 0;
  for (const Accuracy level : levels) {
    for (const double step : {1e-4, 1e-3, tick, 1.0}) {
      if (size == Size::small && step == 1e-4) continue;  // minutes
      const auto world = world_of(s, simulator::tolerances_of(level));
      const double before = kinetic_energy(*world);
      const int wanted = cases(size, 300, 10000);
      int hits = 0;
      const int longest = static_cast<int>(wanted / step);  // ticks: about ten hits come a second
      for (int k = 0; k < longest && hits < wanted; ++k)
        hits += world->advance(lifted, step).impacts;
      too_few += hits < wanted;
      worst = std::max(worst, std::abs(kinetic_energy(*world) / before - 1.0));
    }
  }
  const std::string scene = "elastic hits, each level, ticks of 0.1 ms to 1 s";
  return {{scene, "change of energy, relative", worst, 1e-6},
          {scene, "plays with too few hits", static_cast<double>(too_few), 0.0}};
}

// A row of robots that pushes at a wall, with the budget of `standard`, and with one that its first
// hits exceed. Catches an island that is time-stepped for ever because it was once over its budget.
Bars heap_at_rest(Size /*size*/) {
  const field::Field field = field::make_field(RobotLeague::small);
  int stepped = 0;
  int events = 0;
  double fastest = 0.0;
  int stepped_first = 0;
  const Parameters p;
  for (const int budget : {simulator::Tolerances{}.event_budget, 4}) {
    for (int count = 2; count <= 10; ++count) {
      simulator::Tolerances tolerances;
      tolerances.event_budget = budget;
      World world(&field, p, tolerances, count, false);
      for (int i = 0; i < count; ++i) {
        const double from_wall = (i + 0.5) * (p.robot_side + 0.002);
        world.set_robot(i, {{field.half_length - from_wall, 0.3}, Heading{}, {}});
      }
      const std::vector<WheelCommand> commands(count, WheelSpeeds{30.0, 30.0});
      for (int k = 0; k < 40; ++k) {
        const simulator::TickEvents& now = world.advance(commands, tick);
        (k < 20 ? stepped_first : stepped) += now.stepped;
        if (k >= 20) events = std::max(events, now.events);
      }
      for (int i = 0; i < count; ++i) {
        const simulator::Twist v = world.robot(i).twist;
        fastest = std::max({fastest, std::abs(v.forward), std::abs(v.left), std::abs(v.omega)});
      }
    }
  }
  const std::string scene = "row of two to ten robots that push at a wall";
  return {{scene, "ticks with small steps, from the 20th on", static_cast<double>(stepped), 0.0},
          {scene, "plays without small steps before", stepped_first > 0 ? 0.0 : 1.0, 0.0},
          {scene, "most events in such a tick", static_cast<double>(events), 0.0},
          {scene, "fastest of them at the end, m/s and rad/s", fastest, 1e-9}};
}

// Robots whose whole face is at a wall with friction mu = 0.3, against closed forms, at each level.
//
// One presses by its motors and slides sideways: it brakes by grip g + mu N / M, both constant,
// where N / M is what its motors give at speed zero. One drives along the wall and turns into
// it: its front corner presses with N, the torque of its motors divided by its arm (1 - mu), and
// its speed goes to v_ref - T mu N / M. Wheels and wall hold that one from both sides: the smallest
// forces count. Catches a friction with another normal force or direction, and one that is held
// over a step, and a slide that does not end where friction alone stops it.
Bars sliding_along_a_wall(Size /*size*/) {
  const field::Field field = field::make_field(RobotLeague::small);
  Parameters p;
  p.contact_friction.robot_wall = 0.3;
  const double lag = p.motor_time_constant;
  const double arm = 0.5 * p.robot_side;
  double worst[] = {0.0, 0.0};
  double turned = 0.0;
  const auto play = [&](Accuracy level, const BodyState& start, WheelSpeeds wheels, auto x_at) {
    World world(&field, p, simulator::tolerances_of(level), 1, false);
    world.set_robot(0, start);
    const WheelCommand command = wheels;
    double off = 0.0;
    for (int k = 1; k <= 7; ++k) {
      world.advance({&command, 1}, tick);
      off = std::max(off, std::abs(world.robot(0).position.x() - x_at(k * tick)));
      turned = std::max(turned, std::abs(world.robot(0).twist.omega));
    }
    return off;
  };
  const double at_wall = field.half_width - arm;
  for (const Accuracy level : levels) {
    for (const double speed : {0.3, 1.0}) {
      const WheelSpeeds pressing{20.0, 20.0};
      const double braking = p.grip * simulator::gravity +
                             0.3 * p.speed_reference(pressing.left, pressing.right) / lag;
      const auto braked = [&](double t) {
        const double until = std::min(t, speed / braking);
        return -(speed - 0.5 * braking * until) * until;
      };
      const BodyState sideways{{0.0, at_wall}, Heading{0.0, 1.0}, {0.0, speed, 0.0}};
      worst[0] = std::max(worst[0], play(level, sideways, pressing, braked));

      for (const WheelSpeeds& turning : {WheelSpeeds{40.0, 50.0}, WheelSpeeds{-5.0, 5.0}}) {
        const double torque =
            p.robot_inertia() * p.omega_reference(turning.left, turning.right) / lag;
        const double reached = p.speed_reference(turning.left, turning.right) -
                               lag * 0.3 * torque / (arm * 0.7) / p.robot_mass;
        const double stops = reached < 0.0 ? lag * std::log(1.0 - speed / reached) : 1.0;  // s
        const auto driven = [&](double t) {
          const double until = std::min(t, stops);
          return reached * until + (speed - reached) * lag * (1.0 - std::exp(-until / lag));
        };
        const BodyState along{{0.0, at_wall}, Heading{}, {speed, 0.0, 0.0}};
        worst[1] = std::max(worst[1], play(level, along, turning, driven));
      }
    }
  }
  const std::string scene = "robot that slides along a wall, friction 0.3";
  return {{scene, "sideways, each level, from the closed form, m", worst[0], 1e-12},
          {scene, "turns into it, each level, from the closed form, m", worst[1], 1e-11},
          {scene, "turn rate, rad/s", turned, 1e-8}};
}

}  // namespace mirocup::scenes
