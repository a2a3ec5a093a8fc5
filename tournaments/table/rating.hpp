// SPDX-License-Identifier: MIT
//
// How strong each team is, from all results at once: the model of Bradley and Terry (1952) with
// draws as Davidson (1970) has them. The table decides a league; this says how sure it is.
//
// Team i beats j with probability  g_i / (g_i + g_j + v sqrt(g_i g_j)),  a draw has
// v sqrt(g_i g_j) in the numerator. A strength is 400 log10(g), so 400 more means to win ten times as
// often as to lose; the mean of all is 0. Each team also has one win and one loss against a team of
// strength 0 that nobody sees: who won everything is strong, not infinitely so.
#pragma once

#include "tournaments/table/table.hpp"

#include <cstdint>
#include <vector>

namespace mirocup::league {

struct Strength {
  double value = 0.0;
  double low = 0.0;   // of the 95 % interval
  double high = 0.0;  // low = high = value: it was not computed
};

struct RatingOptions {
  // Fixtures are drawn with replacement so often for the interval: whole fixtures, since the legs of
  // one share a seed. 0: no interval.
  int resamples = 200;
  std::uint64_t seed = 1;
};

// The results of one fixture.
using FixtureResults = std::vector<LegResult>;

// Strengths of the teams 0 .. teams-1. Of a double forfeit both lose to the unseen team.
std::vector<Strength> strengths(int teams, const std::vector<FixtureResults>& fixtures,
                                const RatingOptions& options = {});

}  // namespace mirocup::league
