// SPDX-License-Identifier: MIT
//
// The strength of each team, fitted to all results at once by the model of Bradley and Terry (1952)
// with Davidson's (1970) treatment of draws. The table decides a league; strengths and their
// intervals show how certain its order is.
//
// Team i beats j with probability  g_i / (g_i + g_j + v sqrt(g_i g_j)),  a draw has v sqrt(g_i g_j)
// in the numerator. A strength is 400 log10(g): a team that is 400 stronger wins ten times as often
// as it loses. The mean of all strengths is 0. The fit adds one win and one loss of each team
// against a fictitious team of strength 0, so that a team that won everything gets a finite
// strength.
#pragma once

#include "tournaments/table/table.hpp"

#include <cstdint>
#include <vector>

namespace mirocup::league {

struct Strength {
  double value = 0.0;
  double low = 0.0;   // limits of the 95 % interval;
  double high = 0.0;  // low = high = value if it was not computed
};

struct RatingOptions {
  // Number of bootstrap samples for the interval; 0: no interval. Whole fixtures are drawn with
  // replacement, because the legs of a fixture share a seed.
  int resamples = 200;
  std::uint64_t seed = 1;
};

// The results of one fixture.
using FixtureResults = std::vector<LegResult>;

// Returns the strengths of the teams 0 .. teams-1. In a double forfeit both teams lose to the
// fictitious team.
std::vector<Strength> strengths(int teams, const std::vector<FixtureResults>& fixtures,
                                const RatingOptions& options = {});

}  // namespace mirocup::league
