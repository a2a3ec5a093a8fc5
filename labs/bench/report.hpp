// SPDX-License-Identifier: MIT
//
// The results of a run of the comparison, as JSON, as text and as plots.
#pragma once

#include "labs/bench/errors.hpp"
#include "labs/bench/leagues.hpp"
#include "labs/bench/legs.hpp"
#include "labs/bench/scenes.hpp"

#include <optional>
#include <string>

namespace mirocup::bench {

// One contender in one scene.
struct Timing {
  std::vector<double> rounds_us;  // for each tick, one value a round
  Play play;
};

struct Row {
  Contender contender;
  std::vector<Timing> timings;  // of each scene
  MomentErrors free, crowd;
  Shots shots;
};

struct Report {
  bool quick = false;
  int rounds = 0;
  std::vector<Scene> scenes;
  std::vector<Row> rows;
  Spread yardstick_one, yardstick_five;  // of crowds, against itself
  std::vector<Leg> legs;
  std::optional<LeagueTimes> league;  // only of a whole run

  // Medians over rounds; a ratio is the median of the rounds' ratios.
  double cost(const Row& row, SceneKind kind) const;
  double ratio(const Row& row, SceneKind kind, const Row& other, SceneKind other_kind) const;
  const Timing& timing(const Row& row, SceneKind kind) const;
  // Returns null if there is no such row.
  const Row* find(const std::string& engine, const std::string& point) const;
  // The row that ratios refer to: Box2D at 1 ms, or the next best peer that is installed.
  const Row& base() const;
};

// A figure of error against cost.
struct Plot {
  std::string title;
  std::string error_name;
  double error_unit = 1.0;  // m
  SceneKind scene = SceneKind::quiet;
  double (*error)(const Report&, const Row&) = nullptr;  // m
};
const std::vector<Plot>& plots();

// A requirement on the simulator, and the value that this run measured.
struct Bar {
  std::string name;
  double measured = 0.0;
  double limit = 0.0;
  bool at_least = false;  // the limit is a lower one

  bool met() const { return at_least ? measured >= limit : measured <= limit; }
};
std::vector<Bar> bars(const Report& report);

std::string to_json(const Report& report);
std::string to_text(const Report& report);
std::string to_svg(const Report& report);

// "Intel(R) Xeon(R) ..., g++ 12.2.0"
std::string machine();

}  // namespace mirocup::bench
