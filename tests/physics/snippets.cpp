// SPDX-License-Identifier: MIT
//
// Crowded moments of a game against the tiny-step integrator.
#include "tests/physics/bars.hpp"
#include "tests/physics/scene.hpp"
#include "tests/support/tiny_world.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::scenes {

using test_support::TinyWorld;

namespace {

constexpr int ticks = 5;

struct Snippet {
  Start start;
  std::vector<std::vector<WheelCommand>> commands;  // of each tick
};

// Six robots and the ball within 0.6 m, anywhere on the field.
Snippet random_snippet(Random& random, const field::Field& field, const Parameters& parameters) {
  constexpr int robots = 6;
  constexpr double half_crowd = 0.3;
  Snippet s;
  do {
    s.start = {.field = &field, .parameters = parameters, .robots = {}, .ball = {}};
    const Vec2 centre = random_in(random, 0.5, 0.4);
    for (int i = 0; i < robots; ++i) {
      BodyState r{centre + random_in(random, half_crowd, half_crowd), random_heading(random), {}};
      r.twist.forward = random.uniform(-1.0, 1.0);
      r.twist.omega = random.uniform(-7.0, 7.0);
      s.start.robots.push_back(r);
    }
    const Vec2 at = centre + random_in(random, half_crowd, half_crowd);
    s.start.ball.push_back({at, random.uniform(0.0, 2.0) * random_heading(random).forward()});
  } while (overlap(s.start));
  for (int i = 0; i < ticks; ++i) {
    s.commands.emplace_back();
    for (int k = 0; k < robots; ++k) {
      s.commands[i].push_back(random_wheels(random, 80.0, parameters));
    }
  }
  return s;
}

// Positions of all bodies after each tick.
using Positions = std::vector<std::vector<Vec2>>;

template <class AnyWorld>
Positions play(const Snippet& s, AnyWorld& world) {
  Positions positions;
  for (int i = 0; i < ticks; ++i) {
    world.advance(s.commands[i], tick);
    positions.emplace_back();
    for (std::size_t k = 0; k < s.start.robots.size(); ++k) {
      positions[i].push_back(world.robot(static_cast<int>(k)).position);
    }
    positions[i].push_back(world.ball().position);
  }
  return positions;
}

Positions play_in_tiny_steps(const Snippet& s, double step) {
  TinyWorld world(s.start.field, s.start.parameters, static_cast<int>(s.start.robots.size()), true,
                  step);
  for (std::size_t i = 0; i < s.start.robots.size(); ++i) {
    world.set_robot(static_cast<int>(i), s.start.robots[i]);
  }
  world.set_ball(s.start.ball[0]);
  return play(s, world);
}

// The distance of the body that is farthest off.
double largest(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  double worst = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, (a[i] - b[i]).norm());
  return worst;
}

double share(std::vector<double> values, double part) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

void add_crowds(const std::string& scene, const Parameters& parameters, Size size, int count,
                Bars& bars) {
  const double step = size == Size::small ? 2e-5 : 5e-6;
  Random random(5);
  const field::Field field = field::make_field(RobotLeague::small);
  struct Errors {
    std::vector<double> simulator, reference;
  };
  Errors one, five;
  for (int i = 0; i < count; ++i) {
    const Snippet s = random_snippet(random, field, parameters);
    const auto world = world_of(s.start);
    const Positions simulated = play(s, *world);
    const Positions coarse = play_in_tiny_steps(s, 2.0 * step);
    const Positions fine = play_in_tiny_steps(s, step);
    one.simulator.push_back(largest(simulated[0], fine[0]));
    one.reference.push_back(largest(coarse[0], fine[0]));
    five.simulator.push_back(largest(simulated[4], fine[4]));
    five.reference.push_back(largest(coarse[4], fine[4]));
  }
  const double any = HUGE_VAL;
  const Bars measured{
      {scene, "p50 position error after 1 tick, m", share(one.simulator, 0.5), any},
      {scene, "p90 position error after 1 tick, m", share(one.simulator, 0.9), 1e-6},
      {scene, "p90 after 1 tick, tiny steps halved, m", share(one.reference, 0.9), any},
      {scene, "p50 position error after 5 ticks, m", share(five.simulator, 0.5), any},
      {scene, "p90 position error after 5 ticks, m", share(five.simulator, 0.9), 2e-5},
      {scene, "p90 after 5 ticks, tiny steps halved, m", share(five.reference, 0.9), any},
  };
  bars.insert(bars.end(), measured.begin(), measured.end());
}

}  // namespace

Bars snippets(Size size) {
  Bars bars;
  add_crowds("crowded 3-on-3 snippets", {}, size, cases(size, 20, 200), bars);
  return bars;
}

Bars motors_in_crowds(Size size) {
  Bars bars;
  for (const Motors& motors : other_motors) {
    add_crowds(std::string(motors.name) + ", crowded", with(motors), size, cases(size, 6, 60),
               bars);
  }
  return bars;
}

}  // namespace mirocup::scenes
