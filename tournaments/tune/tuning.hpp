// SPDX-License-Identifier: MIT
//
// Finds better values for a team's parameters. CMA-ES searches with candidates that play fixtures.
// At the end a test plays on seeds that the search has not used.
//
// Noise. All candidates of a generation play the same seeds, so their differences have less noise
// than their results. If the differences between candidates are hardly larger than chance, the next
// generation plays more fixtures. If the differences are much larger than chance, it plays fewer.
// The result of a search is the mean of the distribution, not the luckiest candidate.
//
// The claim. The team with the found numbers and the team without parameters play the same fresh
// fixtures. The gain is the mean of the differences between the two; its 95 % interval is from
// Student's distribution. A gain is claimed if the interval of the points lies above 0.
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
  int most_fixtures = 32;  // the most fixtures, for much noise
  int test_fixtures = 60;  // fixtures of the final test, against each opponent
};

// The result of a fixture, as a mean over the opponents.
struct Mark {
  double goals = 0.0;   // goal difference of a leg
  double points = 0.0;  // share of the points: 1 for a win, 1/2 for a draw
};

// Plays fixtures with values of the parameters, in the order of the parameters. If `values` is
// empty, the team plays without parameters. The marks depend on values, seed and number only.
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
  double goals = 0.0;             // mean goals of all candidates
  double error = 0.0;             // standard error of one candidate
  int fixtures = 0;               // the number of fixtures of each candidate
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

// Searches, then tests the result. The error is the first error of `play` or `tell`. Equal options
// and marks give an equal result, also if `play` returns marks of an earlier run that was stopped.
Result<TuningResult> tune(const TuningOptions& options, const PlayFixtures& play,
                          const TellGeneration& tell);

// Returns the mean of numbers and its 95 % interval by Student's distribution. Equal numbers say
// nothing about chance: then the interval is from the number to 0.
Gain mean_with_interval(const std::vector<double>& numbers);

}  // namespace mirocup::league
