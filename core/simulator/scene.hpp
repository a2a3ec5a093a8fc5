// SPDX-License-Identifier: MIT
//
// A scene: bodies, parameters, commands, and nothing of the game. For physics tests, comparisons of
// speed with error, and teaching; the match has no use for it.
#pragma once

#include "core/field/league.hpp"
#include "core/simulator/model/parameters.hpp"
#include "core/simulator/model/state.hpp"
#include "core/simulator/model/tolerances.hpp"
#include "core/simulator/statistics.hpp"

#include <optional>
#include <string>
#include <vector>

namespace mirocup::simulator {

// From `time` (s) on the wheels are asked for these speeds.
struct WheelsFrom {
  double time = 0.0;
  WheelSpeeds speeds;
};

struct SceneRobot {
  std::string name;
  BodyState state;                 // at time 0
  bool wheels_on_ground = true;    // false: a free body without motor and grip
  std::vector<WheelsFrom> wheels;  // by increasing time; before the first one, zero
};

struct Scene {
  League league = League::small;
  Parameters parameters;
  bool has_walls = true;  // false: an infinite plane
  double duration = 0.0;  // s
  std::optional<BallState> ball;
  std::vector<SceneRobot> robots;  // at most max_robots
  std::vector<double> sample_at;   // s, in [0, duration], increasing
};

// The state at one time; at the time of an impact, after it.
struct Sample {
  double time = 0.0;
  std::optional<BallState> ball;
  std::vector<BodyState> robots;
};

struct SceneResult {
  std::vector<Sample> samples;  // at 0, at sample_at, at the end
  RunStatistics statistics;
};

// Something that is solid where something else is, at time 0.
struct Overlap {
  int first = no_body;   // the ball's index is the number of robots
  int second = no_body;  // no_body: the field's surroundings
  double depth = 0.0;    // m
};

// The deepest overlap of more than `tolerance` metres, if there is one. The scene is well formed: a
// number of robots within max_robots, parameters that are positive where they must be.
std::optional<Overlap> find_overlap(const Scene& scene, double tolerance = 1e-9);

// Runs a scene without overlaps.
SceneResult run_scene(const Scene& scene, const Tolerances& tolerances);

}  // namespace mirocup::simulator
