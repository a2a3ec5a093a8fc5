// SPDX-License-Identifier: MIT
//
// Scenes that cost time: what they begin with and who steers. A steered scene is played once with
// each contender to write its commands down; the timed rounds play those again, so that no steering
// is timed. Engines that are deterministic then do the same each time.
#pragma once

#include "core/base/random.hpp"
#include "tests/bench/engine.hpp"

namespace mirocup::bench {

enum class SceneKind {
  quiet,    // six robots drive circles, the ball rolls; nothing touches
  game,     // 3 a side, wheels at random within 1 m/s, anew each tick: a contact in some ticks
  game_5,   // the same, 5 a side on the middle field
  game_11,  // the same, 11 a side on the large field
  jam,      // one chaser a side, the others on their way to random places: mostly jams
  scrum,    // six robots drive at the ball
  pinch,    // a robot presses the ball against the wall
};

struct Scene {
  SceneKind kind = SceneKind::quiet;
  int ticks = 0;
  int repeats = 1;  // in a round, of a scene that is short
};

// Each of them, long enough to be timed; shorter if `quick`.
std::vector<Scene> scenes(bool quick);

Start start_of(const Scene& scene);

// A scene as one contender plays it.
struct Play {
  std::vector<Commands> commands;  // of each tick
  double deepest_overlap = 0.0;    // m, at the end of a tick, by the tests' own geometry
  double overlap_p99 = 0.0;        // m, over ticks
  double last_overlap = 0.0;       // m, the deepest in the last five sixths (pinch: the hold)
  bool ball_is_lost = false;       // outside the field and its goals
};
Play play(const Scene& scene, const Contender& contender);

// Processor time of one round of it, in microseconds for each tick.
double time_round(const Scene& scene, const Play& play, const Contender& contender);

}  // namespace mirocup::bench

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 7> enum_names<bench::SceneKind>{
    "quiet", "game", "game_5", "game_11", "jam", "scrum", "pinch"};

}  // namespace mirocup
