// SPDX-License-Identifier: MIT
#include "core/simulator/scene.hpp"

#include "core/simulator/model/solver_settings.hpp"
#include "core/simulator/world.hpp"

#include <algorithm>
#include <iterator>

namespace mirocup::simulator {

namespace {

void place(const Scene& scene, World& world) {
  for (std::size_t i = 0; i < scene.robots.size(); ++i) {
    world.set_robot(static_cast<int>(i), scene.robots[i].state);
  }
  if (scene.ball) world.set_ball(*scene.ball);
}

// Returns the times at which a tick ends: commands, the end of the scene, and times between them so
// that no tick is longer than the control period.
std::vector<double> tick_ends(const Scene& scene) {
  std::vector<double> times;
  for (const SceneRobot& robot : scene.robots) {
    for (const WheelsFrom& w : robot.wheels) times.push_back(w.time);
  }
  for (int i = 1; i * settings::scene.max_tick < scene.duration; ++i)
    times.push_back(i * settings::scene.max_tick);
  times.push_back(scene.duration);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  std::erase_if(times, [&](double t) { return t <= 0.0 || t > scene.duration; });
  return times;
}

std::vector<WheelCommand> commands_at(const Scene& scene, double t) {
  std::vector<WheelCommand> commands;
  for (const SceneRobot& robot : scene.robots) {
    if (!robot.wheels_on_ground) {
      commands.emplace_back();
      continue;
    }
    const auto later =
        std::upper_bound(robot.wheels.begin(), robot.wheels.end(), t,
                         [](double time, const WheelsFrom& w) { return time < w.time; });
    commands.emplace_back(later == robot.wheels.begin() ? WheelSpeeds() : std::prev(later)->speeds);
  }
  return commands;
}

Sample sample_of(const Scene& scene, const World& world, double t) {
  Sample sample;
  sample.time = t;
  if (scene.ball) sample.ball = world.ball();
  for (int i = 0; i < world.robots(); ++i) sample.robots.push_back(world.robot(i));
  return sample;
}

}  // namespace

SceneResult run_scene(const Scene& scene, const Tolerances& tolerances) {
  const field::Field field = field::make_field(scene.league);
  const field::Field* walls = scene.has_walls ? &field : nullptr;
  World world(walls, scene.parameters, tolerances, static_cast<int>(scene.robots.size()),
              scene.ball.has_value());
  SceneResult result;
  world.set_statistics(&result.statistics);
  place(scene, world);

  std::vector<double> samples = scene.sample_at;
  samples.push_back(0.0);
  samples.push_back(scene.duration);
  std::sort(samples.begin(), samples.end());
  samples.erase(std::unique(samples.begin(), samples.end()), samples.end());
  std::size_t next_sample = 0;
  // Looking changes nothing: a sample is taken of a copy.
  World copy(walls, scene.parameters, tolerances, world.robots(), scene.ball.has_value());
  World::State now;
  const auto take_samples = [&](double t, double end, bool is_last) {
    for (; next_sample < samples.size(); ++next_sample) {
      const double at = samples[next_sample];
      if (is_last ? at > end : at >= end) return;
      world.save(now);
      copy.load(now);
      copy.advance(commands_at(scene, t), at - t);
      if (at > t) copy.advance(commands_at(scene, at), 0.0);  // resolves impacts at this very time
      result.samples.push_back(sample_of(scene, copy, at));
    }
  };

  double t = 0.0;
  for (const double end : tick_ends(scene)) {
    result.statistics.origin = t;
    take_samples(t, end, false);
    world.advance(commands_at(scene, t), end - t);
    t = end;
    if (result.statistics.impacts.size() > max_scene_impacts) {
      result.stopped_at = t;
      return result;
    }
  }
  take_samples(t, t, true);
  return result;
}

std::optional<Overlap> find_overlap(const Scene& scene, double tolerance) {
  const field::Field field = field::make_field(scene.league);
  const int robots = static_cast<int>(scene.robots.size());
  const collision::StaticWorld world =
      collision::make_static_world(scene.has_walls ? &field : nullptr, scene.parameters,
                                   Tolerances{}, robots, scene.ball.has_value());
  std::vector<BodyState> bodies;
  for (const SceneRobot& robot : scene.robots) {
    bodies.push_back({robot.state.position, robot.state.heading, {}});
  }
  if (scene.ball) bodies.push_back({scene.ball->position, Heading{}, {}});

  std::optional<Overlap> deepest;
  const auto check = [&](int a, int b, double depth) {
    if (depth > (deepest ? deepest->depth : tolerance)) deepest = Overlap{a, b, depth};
  };
  for (int i = 0; i < world.bodies(); ++i) {
    for (int j = 0; j < i; ++j) check(i, j, -gap(world, {i, j}, bodies[i], bodies[j]));
    if (!scene.has_walls) continue;
    check(i, no_body, -field.clearance(bodies[i].position));
    for (int k = 0; k < plane_walls + end_walls; ++k) {
      check(i, no_body, -gap(world, pair_with_obstacle(i, k), bodies[i], BodyState{}));
    }
  }
  return deepest;
}

}  // namespace mirocup::simulator
