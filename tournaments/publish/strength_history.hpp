// SPDX-License-Identifier: MIT
//
// The strengths of the teams after each round, from the results up to that round.
#pragma once

#include "tournaments/publish/rounds.hpp"

#include <string>
#include <vector>

namespace mirocup::league {

struct StrengthHistory {
  std::vector<std::string> rounds;  // titles of the rounds with strengths
  std::vector<Ratings> after;       // the strengths after each of `rounds`
  bool empty() const { return rounds.size() < 2; }
};

// Fits the strengths to the results up to each round. If more than 24 rounds were played, fits only
// every n-th round (n: rounds / 24, rounded up) and the last. The history is empty for more than 64
// teams, because the fit would take too long.
StrengthHistory strength_history(const Overview& overview, const std::vector<RoundView>& rounds);

// Returns an SVG element with a curve for each team. The curve of the team `highlighted` is in
// front, with its interval. If `highlighted` is no_team, every curve has a colour and a name.
std::string strength_picture(const Overview& overview, const StrengthHistory& history,
                             int highlighted);

}  // namespace mirocup::league
