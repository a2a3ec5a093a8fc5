// SPDX-License-Identifier: MIT
//
// Finds better values for a team's parameters. CMA-ES searches with candidates that play fixtures.
// At the end a test plays fixtures with seeds that the search has not used.
//
// Noise. All candidates of a generation play the same seeds, so the differences between their
// results have less noise than the results. If the differences between candidates are hardly larger
// than chance, the next generation plays more fixtures. If the differences are much larger than
// chance, it plays fewer. The result of a search is the mean of the distribution, not the luckiest
// candidate.
//
// The claim. The team with the found numbers and the team without parameters play the same fresh
// fixtures. The gain is the mean of the differences between the two; its 95 % interval is from
// Student's distribution. A gain is claimed if the whole interval of the gain in points is above 0.
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
  int fixtures = 4;        // of each candidate in the first generation, against each opponent
  int most_fixtures = 32;  // the most of these fixtures in a later generation
  int test_fixtures = 60;  // fixtures of the final test, against each opponent
};

// The result of a fixture: the mean of the results of this fixture against each opponent.
struct Mark {
  double goals = 0.0;   // mean goal difference in a leg
  double points = 0.0;  // share of the points: 1 for a win, 1/2 for a draw
};

// Plays `fixtures` fixtures, each against every opponent, and returns a mark for each fixture.
// `values` are in the order of the parameters; if empty, the team plays without parameters. The
// marks depend only on the arguments.
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
  std::vector<double> deviation;  // standard deviations of the candidates' values
  double goals = 0.0;             // mean goal difference of all candidates
  double error = 0.0;             // standard error of `goals` for one candidate
  int fixtures = 0;               // the number of fixtures of each candidate
  int played = 0;                 // number of fixtures that the search has played so far
};

struct TuningResult {
  std::vector<double> values;
  Gain points;
  Gain goals;
  Mark before;  // result of the test without parameters; `after`: with `values`
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

// Returns the mean of numbers and its 95 % interval by Student's distribution. Equal numbers do not
// show how large chance is; for them the interval reaches from the number to 0.
Gain mean_with_interval(const std::vector<double>& numbers);

}  // namespace mirocup::league
