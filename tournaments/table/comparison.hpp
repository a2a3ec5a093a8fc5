// SPDX-License-Identifier: MIT
//
// Decides between two teams after each fixture: the first team is better, the second team is
// better, or the teams are less than 20 Elo apart. The claims are about the share of the points
// that the first team is expected to take in a fixture of two legs (a win 1, a draw 1/2), over all
// seeds.
//
// The test is a betting confidence sequence (Waudby-Smith and Ramdas 2023, hedged capital). To
// refute that the expected share is m or less, a gambler bets on every fixture at odds that are
// fair for m. The gambler begins with 1 and is never ruined. If m is true, the probability that his
// capital ever reaches 40 is at most 1/40, however long he plays and whenever he stops (Ville's
// inequality). A second gambler bets against a share of m or more. The shares that neither gambler
// has refuted are an interval. The probability that this interval ever loses the true share is at
// most 5 %. A team is better once the whole interval is on one side of 1/2; two teams are equal
// once the whole interval is between the shares of -20 and 20 Elo.
//
// Each gambler divides his capital among fixed bets of many sizes. So the capital depends on how
// often each result occurred and not on the order of the results. docs/comparisons.md has the
// measured errors.
#pragma once

#include "core/base/names.hpp"

#include <array>
#include <string_view>

namespace mirocup::league {

enum class ComparisonVerdict { undecided, first, second, equal };

struct ComparisonOptions {
  double error = 0.05;      // the largest probability of a wrong claim, in (0, 1)
  double equal_elo = 20.0;  // teams that are less than this apart are equal; above 0
};

// An interval of shares or of differences in Elo, and the estimate inside the interval.
struct ComparisonInterval {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
};

// The results of the fixtures so far.
class ScoreSequence {
 public:
  // The most half points of a team in a fixture: each leg gives 2 for a win and 1 for a draw.
  static constexpr int most_points = 4;

  // Adds the half points of the first team, 0 to most_points.
  void add(int points) { ++counts_[points]; }

  int fixtures() const;
  // Returns the number of fixtures in which the first team has this many half points.
  int count(int points) const { return counts_[points]; }

  // Returns the claim after the fixtures so far. The probability that any call makes a wrong claim
  // is at most `error`.
  ComparisonVerdict verdict(const ComparisonOptions& options = {}) const;

  // Returns the difference of the teams in Elo. The estimate counts half a drawn fixture in
  // addition, so it is finite. While no share below the estimate is refuted, `low` is minus
  // infinity; while no share above it is refuted, `high` is infinity.
  ComparisonInterval difference(const ComparisonOptions& options = {}) const;

 private:
  std::array<int, most_points + 1> counts_{};
};

// Returns the share of the points that a team takes if it is stronger by `elo`. elo_of() is the
// inverse function.
double share_of(double elo);
double elo_of(double share);

}  // namespace mirocup::league

namespace mirocup {

// In the texts, A is the first team of the command line and B the second.
template <>
inline constexpr std::array<std::string_view, 4> enum_names<league::ComparisonVerdict>{
    "undecided", "A", "B", "equal"};
static_assert(to_string(league::ComparisonVerdict::equal) == "equal");

}  // namespace mirocup
