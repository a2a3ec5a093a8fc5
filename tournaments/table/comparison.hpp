// SPDX-License-Identifier: MIT
//
// Decides between two teams after each fixture: the first is better, the second is better, or they
// are less than 20 Elo apart. The claims are about the share of the points that the first team is
// expected to take in a fixture of two legs (a win 1, a draw 1/2), over all seeds.
//
// The test is a betting confidence sequence (Waudby-Smith and Ramdas 2023, hedged capital). To
// refute that the expected share is m or less, a gambler bets on every fixture at odds that are
// fair for m. He begins with 1 and is never ruined. If m is true, his capital ever reaches 40 with
// a probability of at most 1/40, however long he plays and whenever he stops (Ville's inequality).
// A second gambler bets against m or more. The shares that neither has refuted are an interval; the
// probability that it ever loses the truth is at most 5 %. A team is better once the whole interval
// is on one side of 1/2; two teams are equal once the whole interval is between the shares of -20
// and 20 Elo.
//
// Each gambler divides his capital among fixed bets of many sizes. So his capital depends on how
// often each result occurred and not on its order. docs/comparisons.md has the measured errors.
#pragma once

#include "core/base/names.hpp"

#include <array>
#include <string_view>

namespace mirocup::league {

enum class ComparisonVerdict { undecided, first, second, equal };

struct ComparisonOptions {
  double error = 0.05;      // probability of a wrong claim, in (0, 1)
  double equal_elo = 20.0;  // teams that are less apart are equal; above 0
};

// An interval of shares or of differences in Elo, and the estimate in it.
struct ComparisonInterval {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
};

// The results of the fixtures so far.
class ScoreSequence {
 public:
  // Half points of a team in a fixture: of each leg 2 for a win and 1 for a draw.
  static constexpr int most_points = 4;

  // Adds the half points of the first team, 0 to most_points.
  void add(int points) { ++counts_[points]; }

  int fixtures() const;
  // The fixtures in which the first team has this many half points.
  int count(int points) const { return counts_[points]; }

  // Returns the claim after the fixtures so far. The probability of a wrong claim is at most
  // `error` over all calls together.
  ComparisonVerdict verdict(const ComparisonOptions& options = {}) const;

  // The difference in Elo. The estimate includes half a point for half a fixture, so it is finite.
  // If nothing is refuted on a side, `low` is minus infinity or `high` is infinity.
  ComparisonInterval difference(const ComparisonOptions& options = {}) const;

 private:
  std::array<int, most_points + 1> counts_{};
};

// Returns the share of the points that a team takes if it is stronger by `elo`; elo_of() is the
// inverse.
double share_of(double elo);
double elo_of(double share);

}  // namespace mirocup::league

namespace mirocup {

// A and B are the teams in the order of the command.
template <>
inline constexpr std::array<std::string_view, 4> enum_names<league::ComparisonVerdict>{
    "undecided", "A", "B", "equal"};
static_assert(to_string(league::ComparisonVerdict::equal) == "equal");

}  // namespace mirocup
