// SPDX-License-Identifier: MIT
//
// The strengths of the teams, fitted to all results at once by the model of Bradley and Terry
// (1952) with the draws of Davidson (1970). The table decides a league; the strengths and their
// intervals say how certain its order is.
//
// Team i beats team j with probability  g_i / (g_i + g_j + v sqrt(g_i g_j)).  A draw has v sqrt(g_i
// g_j) in the numerator. A strength is 400 log10(g): a team that is 400 stronger wins ten times as
// often as it loses. The mean over all teams is 0. Each team also gets one win and one loss against
// a virtual team of strength 0, so that a team that won all legs has a finite strength.
#pragma once

#include "tournaments/table/table.hpp"

#include <cstdint>
#include <vector>

namespace mirocup::league {

struct Strength {
  double value = 0.0;
  double low = 0.0;   // of the 95 % interval
  double high = 0.0;  // low and high equal value if the interval was not computed
};

struct RatingOptions {
  // Number of bootstrap samples for the interval; 0: no interval. Whole fixtures are drawn with
  // replacement, because the legs of a fixture share a seed.
  int resamples = 200;
  std::uint64_t seed = 1;
};

// The results of one fixture.
using FixtureResults = std::vector<LegResult>;

// Returns the strengths of the teams 0 to teams-1. After a double forfeit both teams lose to the
// virtual team.
std::vector<Strength> strengths(int teams, const std::vector<FixtureResults>& fixtures,
                                const RatingOptions& options = {});

}  // namespace mirocup::league
