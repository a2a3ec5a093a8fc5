// SPDX-License-Identifier: MIT
//
// The strengths of the teams, fitted to all results at once by the model of Bradley and Terry
// (1952) with the draws of Davidson (1970). In leagues that take entries while they are played, the
// strengths decide the table; in other leagues the strengths and their intervals say how certain
// the order of the table is.
//
// Team i beats team j with probability  g_i / (g_i + g_j + v sqrt(g_i g_j)).  For a draw the
// numerator is v sqrt(g_i g_j). A strength is 400 log10(g): a team that is 400 stronger wins ten
// times as often as it loses. The mean strength of all teams is 0. In the likelihood each team also
// gets half a win and half a loss against a virtual team of strength 0, so that a team that won all
// legs has a finite strength. An entry that its team has replaced gets a hundredth.
//
// An interval holds the strengths of one team that the results do not contradict: the strengths for
// which twice the logarithm of the likelihood is at most 3.84 below its maximum, the 95 % point of
// chi squared with one degree of freedom. For this interval the strengths of the other teams are
// fixed at their fitted values. To include their uncertainty, the permitted fall is multiplied by a
// ratio of two variances of the strength, from the curvature of the likelihood at its maximum: the
// variance with all strengths unknown, divided by the variance with the other strengths known. The
// legs of a fixture count as independent. docs/comparisons.md says how often such intervals hold
// the true strength.
#pragma once

#include "tournaments/table/table.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace mirocup::league {

struct Strength {
  double value = 0.0;
  double low = 0.0;  // lower end of the 95 % interval
  double high = 0.0;
};

struct Fit;

struct Ratings {
  std::vector<Strength> strengths;      // by team
  double draws = 1.0;                   // v: draws per win between two equal teams
  std::shared_ptr<const Fit> fit = {};  // for are_apart(); null if no function here made it
};

// The results of one fixture.
using FixtureResults = std::vector<LegResult>;

// Returns the strengths of the teams 0 to teams-1. After a double forfeit both teams lose to the
// virtual team. The computing time grows with the cube of the number of teams; a thousand teams
// take seconds. Every machine computes the same bits.
Ratings rate(int teams, const std::vector<FixtureResults>& fixtures);

// Like rate(), but each entry of a team is a player of its own, so that a result counts against the
// entry that played. Returns the strengths of the entries `present`, by team: the number of the
// entry with which the team plays now, or no_entry for a team that gets no strength. `fixtures` are
// in the order in which they were played. The mean strength of the present entries is 0. If
// `leans`, the strength of an entry is drawn to that of the former entry of its team, so that few
// legs change little. The computing time grows with the number of entries, and with the cube of the
// number of teams.
inline constexpr int no_entry = -1;
Ratings rate_entries(const std::vector<int>& present, std::vector<FixtureResults> fixtures,
                     bool leans);

// True if the 95 % interval of the difference of two strengths excludes 0. Both teams must have a
// strength.
bool are_apart(const Ratings& ratings, int one, int other);

// The mark of a team that is as strong as a team of the ratings.
struct ScaleStep {
  double mark = 0.0;
  int team = 0;
};

struct ScaleMark {
  double value = 0.0;
  double low = 0.0;  // the ends of the 95 % interval, of which `low` belongs to the weaker end
  double high = 0.0;
  // mark_of() leaves the following members to the caller. True: it is decided for each step which
  // is better.
  bool is_decided = false;
  int legs = 0;  // the legs of the team's present entry on which its strength rests
};

// Returns the mark of a team on a scale of at least two steps, the weakest first. Between two steps
// the mark is linear in strength, so the other teams of a league do not change it. Above the last
// step the mark is that of the step, below the first step it is `below`. Returns nothing if the
// strengths of the steps do not grow.
std::optional<ScaleMark> mark_of(const Ratings& ratings, const std::vector<ScaleStep>& scale,
                                 double below, int team);

// Returns how many legs two teams must play against each other until a 95 % interval of their
// difference in strength excludes 0 with a probability of 80 %, if the fitted difference is true.
// Returns nothing for more than max_legs_to_tell legs.
std::optional<int> legs_to_tell(const Ratings& ratings, int one, int other);
inline constexpr int max_legs_to_tell = 1'000'000;

}  // namespace mirocup::league
