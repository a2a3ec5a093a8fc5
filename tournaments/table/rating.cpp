// SPDX-License-Identifier: MIT
#include "tournaments/table/rating.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace mirocup::league {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int max_iterations = 100;
constexpr double converged = 1e-9;  // what a step would still gain, in units of the log-likelihood
const double scale = 400.0 / std::log(10.0);  // strength per unit of log(g)
// Wins and losses against the virtual team. With a half the intervals cover best: with a quarter
// too seldom, with one they are drawn to the middle.
constexpr double virtual_legs = 0.5;
// Half a draw and half a leg with a winner, between equal teams, keep v finite and above 0.
constexpr double virtual_draws = 0.5;
constexpr double z_95 = 1.959964;  // quantiles of the normal distribution
constexpr double z_80 = 0.841621;
constexpr int fewest_legs_to_tell = 6;  // all of them won: 2 * 0.5^6 is below 5 %

// How often one of two teams won against the other.
struct PairResults {
  double one = 0.0;
  double other = 0.0;
  double draws = 0.0;

  double played() const { return one + other + draws; }
};

// The probabilities of a leg between two teams.
struct LegOdds {
  double one = 0.0;
  double other = 0.0;
  double draw = 0.0;
  double log_sum = 0.0;  // logarithm of the three terms' sum

  double score() const { return one + 0.5 * draw; }
  double variance() const { return one + 0.25 * draw - score() * score(); }
};

// The arguments are logarithms of g, g and v.
LegOdds odds(double one, double other, double draws) {
  const double level = draws + 0.5 * (one + other);
  const double top = std::max({one, other, level});
  LegOdds odds{std::exp(one - top), std::exp(other - top), std::exp(level - top), 0.0};
  const double sum = odds.one + odds.other + odds.draw;
  odds.one /= sum;
  odds.other /= sum;
  odds.draw /= sum;
  odds.log_sum = top + std::log(sum);
  return odds;
}

// log(1 + exp(x))
double soft_plus(double x) {
  return x > 0.0 ? x + std::log1p(std::exp(-x)) : std::log1p(std::exp(x));
}

double logistic(double x) {
  return 1.0 / (1.0 + std::exp(-x));
}

// The penalised log-likelihood of the unknowns: log(g) of each team, then log(v). It is concave, so
// Newton's method with shortened steps finds its maximum.
class Likelihood {
 public:
  Likelihood(int teams, const std::vector<FixtureResults>& fixtures)
      : teams_(teams), losses_(VectorXd::Constant(teams, virtual_legs)), meetings_(teams) {
    for (const FixtureResults& fixture : fixtures) {
      for (const LegResult& leg : fixture) add(leg);
    }
    for (const auto& [who, results] : pairs_) {
      meetings_[who.first].push_back({who.second, results});
      meetings_[who.second].push_back({who.first, {results.other, results.one, results.draws}});
    }
  }

  double at(const VectorXd& x) const {
    double sum = virtual_draws * (x[teams_] - 2.0 * log_of_level_legs(x));
    for (int i = 0; i < teams_; ++i) sum += of_virtual_legs(i, x[i]);
    for (const auto& [who, results] : pairs_)
      sum += of_meetings(results, x[who.first], x[who.second], x[teams_]);
    return sum;
  }

  // Returns the terms in which the strength of one team occurs, with another value for it.
  double of_team(int team, double value, const VectorXd& x) const {
    double sum = of_virtual_legs(team, value);
    for (const auto& [opponent, results] : meetings_[team])
      sum += of_meetings(results, value, x[opponent], x[teams_]);
    return sum;
  }

  // Sets the gradient, and the negative matrix of second derivatives.
  void derivatives(const VectorXd& x, VectorXd& gradient, MatrixXd& curvature) const {
    gradient.setZero(teams_ + 1);
    curvature.setZero(teams_ + 1, teams_ + 1);
    const double level = logistic(x[teams_] - std::log(2.0));
    gradient[teams_] = virtual_draws * (1.0 - 2.0 * level);
    curvature(teams_, teams_) = 2.0 * virtual_draws * level * (1.0 - level);
    for (int i = 0; i < teams_; ++i) {
      const double win = logistic(x[i]);
      gradient[i] = virtual_legs - (virtual_legs + losses_[i]) * win;
      curvature(i, i) = (virtual_legs + losses_[i]) * win * (1.0 - win);
    }
    for (const auto& [who, results] : pairs_)
      add_derivatives(who.first, who.second, results, x, gradient, curvature);
  }

  VectorXd maximum() const {
    VectorXd x = VectorXd::Zero(teams_ + 1);
    VectorXd gradient;
    MatrixXd curvature;
    double value = at(x);
    for (int i = 0; i < max_iterations; ++i) {
      derivatives(x, gradient, curvature);
      VectorXd step = curvature.llt().solve(gradient);
      if (step.dot(gradient) < converged) break;
      double next = at(x + step);
      for (int halved = 0; next < value && halved < 40; ++halved) {
        step *= 0.5;
        next = at(x + step);
      }
      x += step;
      value = next;
    }
    return x;
  }

 private:
  struct Meeting {
    int opponent = 0;
    PairResults results;
  };

  void add(const LegResult& leg) {
    if (leg.both_lose) {
      losses_[leg.home] += 1.0;
      losses_[leg.away] += 1.0;
      return;
    }
    PairResults& pair = pairs_[std::minmax(leg.home, leg.away)];
    const int ahead = leg.difference(std::min(leg.home, leg.away));
    (ahead > 0 ? pair.one : ahead < 0 ? pair.other : pair.draws) += 1.0;
  }

  double log_of_level_legs(const VectorXd& x) const {
    return std::log(2.0) + soft_plus(x[teams_] - std::log(2.0));
  }

  double of_virtual_legs(int team, double value) const {
    return virtual_legs * value - (virtual_legs + losses_[team]) * soft_plus(value);
  }

  static double of_meetings(const PairResults& results, double one, double other, double draws) {
    return results.one * one + results.other * other +
           results.draws * (draws + 0.5 * (one + other)) -
           results.played() * odds(one, other, draws).log_sum;
  }

  void add_derivatives(int i, int j, const PairResults& results, const VectorXd& x,
                       VectorXd& gradient, MatrixXd& curvature) const {
    const int v = teams_;
    const double played = results.played();
    const LegOdds p = odds(x[i], x[j], x[v]);
    const double one = p.score();
    const double other = p.other + 0.5 * p.draw;
    gradient[i] += results.one + 0.5 * results.draws - played * one;
    gradient[j] += results.other + 0.5 * results.draws - played * other;
    gradient[v] += results.draws - played * p.draw;
    const auto add = [&](int row, int column, double covariance) {
      curvature(row, column) += played * covariance;
      if (row != column) curvature(column, row) += played * covariance;
    };
    add(i, i, p.variance());
    add(j, j, p.other + 0.25 * p.draw - other * other);
    add(i, j, 0.25 * p.draw - one * other);
    add(v, i, 0.5 * p.draw - one * p.draw);
    add(v, j, 0.5 * p.draw - other * p.draw);
    add(v, v, p.draw - p.draw * p.draw);
  }

  int teams_;
  VectorXd losses_;                                   // against the virtual team
  std::map<std::pair<int, int>, PairResults> pairs_;  // by the two teams, the lower number first
  std::vector<std::vector<Meeting>> meetings_;        // the same by team
};

// Returns how far a team's value may move up (sign 1) or down (-1), while twice the log-likelihood
// falls by at most `fall`. That function is concave, so there is one such place on each side.
double reach(const Likelihood& likelihood, int team, const VectorXd& best, double sign,
             double fall) {
  const double top = likelihood.of_team(team, best[team], best);
  const auto is_within = [&](double distance) {
    return 2.0 * (top - likelihood.of_team(team, best[team] + sign * distance, best)) < fall;
  };
  double low = 0.0;
  double high = 0.1;
  while (is_within(high) && high < 1e3) {
    low = high;
    high *= 2.0;
  }
  while (high - low > 1e-3) {
    const double middle = 0.5 * (low + high);
    (is_within(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace

Ratings rate(int teams, const std::vector<FixtureResults>& fixtures) {
  Ratings ratings;
  ratings.strengths.resize(teams);
  if (teams == 0) return ratings;
  const Likelihood likelihood(teams, fixtures);
  const VectorXd best = likelihood.maximum();
  ratings.draws = std::exp(best[teams]);
  VectorXd gradient;
  MatrixXd curvature;
  likelihood.derivatives(best, gradient, curvature);
  const MatrixXd covariance =
      curvature.llt().solve(MatrixXd::Identity(teams + 1, teams + 1)).topLeftCorner(teams, teams);
  const VectorXd with_mean = covariance.rowwise().mean();  // covariance with the mean of all teams
  const double mean = best.head(teams).mean();
  const double share = 1.0 - 1.0 / teams;  // by which a value rises above the mean with its team
  for (int i = 0; i < teams; ++i) {
    Strength& strength = ratings.strengths[i];
    strength.value = strength.low = strength.high = scale * (best[i] - mean);
    if (teams == 1) continue;
    const double variance = covariance(i, i) - 2.0 * with_mean[i] + with_mean.mean();
    const double fall = z_95 * z_95 * variance * curvature(i, i) / (share * share);
    strength.low -= scale * share * reach(likelihood, i, best, -1.0, fall);
    strength.high += scale * share * reach(likelihood, i, best, 1.0, fall);
  }
  return ratings;
}

std::optional<int> legs_to_tell(const Ratings& ratings, int one, int other) {
  const LegOdds p = odds(ratings.strengths[one].value / scale,
                         ratings.strengths[other].value / scale, std::log(ratings.draws));
  const double lead = p.score() - 0.5;
  const double needed = (z_95 + z_80) * (z_95 + z_80) * p.variance();
  if (!(needed <= max_legs_to_tell * lead * lead)) return {};
  return std::max(fewest_legs_to_tell, static_cast<int>(std::ceil(needed / (lead * lead))));
}

}  // namespace mirocup::league
