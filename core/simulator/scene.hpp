// SPDX-License-Identifier: MIT
//
// A scene: bodies, parameters and commands without a game. For physics tests, for comparing speed
// with error, and for teaching; a leg does not use it. As JSON: record/scene.md.
//
// Units: m, s, rad. Threads: none. These functions allocate.
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

// A command that holds from `time` (s) until the next one.
struct WheelsFrom {
  double time = 0.0;
  WheelSpeeds speeds;
};

struct SceneRobot {
  std::string name;
  BodyState state;                 // at time 0
  bool wheels_on_ground = true;    // false: a free body without motors and grip
  std::vector<WheelsFrom> wheels;  // by increasing time; before the first one, speeds are zero
};

struct Scene {
  RobotLeague league = RobotLeague::small;
  Parameters parameters;
  bool has_walls = true;  // false: an infinite plane
  double duration = 0.0;  // s
  std::optional<BallState> ball;
  std::vector<SceneRobot> robots;  // at most max_robots
  std::vector<double> sample_at;   // s, in [0, duration], increasing
};

// The state of all bodies at one time; at the time of an impact, the state after the impact.
struct Sample {
  double time = 0.0;
  std::optional<BallState> ball;
  std::vector<BodyState> robots;
};

// A scene with more impacts is not run to its end: their list could take all memory.
inline constexpr std::size_t max_scene_impacts = 500'000;

struct SceneResult {
  std::vector<Sample> samples;  // at 0, at sample_at, and at the end
  RunStatistics statistics;
  // The time at which the scene was stopped, because it had more than max_scene_impacts; nothing if
  // it was run to its end.
  std::optional<double> stopped_at;
};

// Two things that overlap at time 0.
struct Overlap {
  int first = no_body;   // the ball's index is the number of robots
  int second = no_body;  // no_body: a wall, or the space outside the field
  double depth = 0.0;    // m
};

// Returns the deepest overlap of more than `tolerance` metres, if there is one. The scene is well
// formed: at most max_robots robots, and positive parameters where they must be positive.
std::optional<Overlap> find_overlap(const Scene& scene, double tolerance = 1e-9);

// Runs a well-formed scene without overlaps. Returns its samples and statistics.
SceneResult run_scene(const Scene& scene, const Tolerances& tolerances);

}  // namespace mirocup::simulator
