// SPDX-License-Identifier: MIT
//
// Finds better numbers for a team: CMA-ES over its parameters, whose candidates play fixtures, and
// at the end a test on seeds that the search has not seen.
//
// Noise. All candidates of a generation play the same seeds, so their differences have less noise
// than their results. If the differences between candidates are hardly larger than those of chance,
// the next generation plays more fixtures; if they are much larger, it plays fewer. The result is
// the mean of the distribution, not the luckiest candidate.
//
// The claim. The team with the found numbers and the team without parameters play the same fresh
// fixtures. The gain is the mean of the differences; its 95 % interval is Student's. A gain is
// claimed if the interval of the points lies above 0.
#pragma once

#include "core/base/error.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace mirocup::league {

// A parameter of the team and its range.
struct TunedParameter {
  std::string name;
  double low = 0.0;
  double high = 1.0;
};

struct TuningOptions {
  std::vector<TunedParameter> parameters;
  std::uint64_t seed = 1;
  int generations = 12;
  int fixtures = 4;        // of a candidate in the first generation, against each opponent
  int most_fixtures = 32;  // if there is much noise
  int test_fixtures = 60;  // of the test, against each opponent
};

// The result of a fixture, the mean over the opponents.
struct Mark {
  double goals = 0.0;   // difference of a leg
  double points = 0.0;  // share: 1 for a win, 1/2 for a draw
};

// Plays fixtures with these values of the parameters, in their order. If `values` is empty, the
// team plays without parameters. The marks depend on values, seed and number only.
using PlayFixtures = std::function<Result<std::vector<Mark>>(
    const std::optional<std::vector<double>>& values, std::uint64_t seed, int fixtures)>;

// An estimate and its 95 % interval.
struct Gain {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
};

// The result of a generation.
struct Generation {
  std::vector<double> mean;       // values of the parameters
  std::vector<double> deviation;  // of the candidates
  double goals = 0.0;             // mean of all candidates
  double error = 0.0;             // standard error of one candidate
  int fixtures = 0;               // of each candidate
  int played = 0;                 // fixtures of the search so far
};

struct TuningResult {
  std::vector<double> values;
  Gain points;
  Gain goals;
  Mark before;  // of the test
  Mark after;
  int test_fixtures = 0;
  std::vector<Generation> course;

  bool has_gained() const { return points.low > 0.0; }
};

// Called after each generation.
using TellGeneration = std::function<Result<void>(const std::vector<Generation>& course)>;

// Returns the first error of `play` or `tell`. The same options and marks give the same result,
// also if `play` returns marks of an earlier run that was stopped.
Result<TuningResult> tune(const TuningOptions& options, const PlayFixtures& play,
                          const TellGeneration& tell);

// Returns the mean of numbers and its 95 % interval by Student's distribution. If all numbers are
// the same, they say nothing about chance: if that number is 0 the interval is 0, otherwise it
// reaches from that number to 0.
Gain mean_with_interval(const std::vector<double>& numbers);

}  // namespace mirocup::league
