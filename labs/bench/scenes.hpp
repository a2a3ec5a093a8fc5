// SPDX-License-Identifier: MIT
//
// Scenes that cost time: their starts and their steering. A steered scene is played once with each
// contender to record its commands; the timed rounds play these commands again, so that no steering
// is timed. Deterministic engines then do the same each time.
#pragma once

#include "core/base/random.hpp"
#include "labs/bench/engine.hpp"

namespace mirocup::bench {

enum class SceneKind {
  quiet,    // six robots drive circles, the ball rolls; nothing touches
  game,     // 3 a side, new random wheel speeds within 1 m/s each tick: a contact in some ticks
  game_5,   // the same, 5 a side on the middle field
  game_11,  // the same, 11 a side on the large field
  jam,      // one chaser a side, the others on their way to random places: mostly jams
  scrum,    // six robots drive at the ball
  pinch,    // a robot presses the ball against the wall
};

struct Scene {
  SceneKind kind = SceneKind::quiet;
  int ticks = 0;
  int repeats = 1;  // in a round; more for a short scene
};

// Returns all scenes, long enough to be timed; shorter ones if `quick`.
std::vector<Scene> scenes(bool quick);

Start start_of(const Scene& scene);

// A scene that one contender has played.
struct Play {
  std::vector<Commands> commands;  // of each tick
  double deepest_overlap = 0.0;    // m, at the end of a tick, by the tests' own geometry
  double overlap_p99 = 0.0;        // m, over ticks
  double last_overlap = 0.0;       // m, the deepest in the last five sixths (pinch: the hold)
  bool ball_is_lost = false;       // outside the field and its goals
};
Play play(const Scene& scene, const Contender& contender);

// Plays one round of a scene and returns its processor time in microseconds a tick.
double time_round(const Scene& scene, const Play& play, const Contender& contender);

}  // namespace mirocup::bench

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 7> enum_names<bench::SceneKind>{
    "quiet", "game", "game_5", "game_11", "jam", "scrum", "pinch"};

}  // namespace mirocup
