// SPDX-License-Identifier: MIT
#include "tournaments/table/rating.hpp"

#include "core/base/math.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <utility>

namespace mirocup::league {

namespace {

using Eigen::VectorXd;

// Only the elements of the lower triangle. Without a fill-reducing order and without packets, every
// machine adds in the same order.
using Curvature = Eigen::SparseMatrix<double>;
using Factors = Eigen::SimplicialLDLT<Curvature, Eigen::Lower, Eigen::NaturalOrdering<int>>;

constexpr int max_iterations = 100;
constexpr double converged = 1e-9;  // what a step would still gain, in units of the log-likelihood
constexpr double log_2 = 0.69314718055994531;
constexpr double unit_of_log = 173.71779276130073;  // 400 / ln(10): strength per unit of log(g)
// Wins and losses against the virtual team. With a half the intervals cover best: with a quarter
// too seldom, with one they are drawn to the middle.
constexpr double virtual_legs = 0.5;
// The same of an entry that was replaced. With a half, many weak former entries would be
// drawn to the middle, and with them whoever has beaten them would rise: of two equal entries, the
// one that was handed in earlier.
constexpr double virtual_legs_of_former = 0.01;
// Half a draw and half a leg with a winner, between equal teams, keep v finite and above 0.
constexpr double virtual_draws = 0.5;
// How firmly an entry of a ladder leans on the former entry of its team: 1 over the variance of the
// step between the two in log(g), a standard deviation of 40 in strength.
constexpr double lean = 18.9;
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

  double score() const { return one + 0.5 * draw; }
  double variance() const { return one + 0.25 * draw - score() * score(); }
};

// The first two arguments are logarithms of g, the third is v.
LegOdds odds(double one, double other, double draws) {
  const double root = exp(-0.5 * std::abs(one - other));  // of g, weaker over stronger
  const double sum = 1.0 + root * root + draws * root;
  const double stronger = 1.0 / sum;
  const double weaker = root * root / sum;
  return {one > other ? stronger : weaker, one > other ? weaker : stronger, draws * root / sum};
}

// The logarithm of the sum that odds() divides by.
double log_of_sum(double one, double other, double draws) {
  const double root = exp(-0.5 * std::abs(one - other));
  return std::max(one, other) + log1p(root * (root + draws));
}

// log(1 + exp(x))
double soft_plus(double x) {
  return x > 0.0 ? x + log1p(exp(-x)) : log1p(exp(x));
}

double logistic(double x) {
  return 1.0 / (1.0 + exp(-x));
}

// The players of a fit are teams or, in rate_entries(), entries. They are in the order in which
// their strengths are eliminated: players who do not play any more come first. So the matrix of
// second derivatives fills only between players who played at the same time.
struct Players {
  std::vector<int> former;  // by player: the player on whom this one leans; no_player: none
  int present = 0;          // the last players, whose strengths are asked for

  int count() const { return static_cast<int>(former.size()); }
};
constexpr int no_player = -1;

// The penalised log-likelihood of the unknowns: log(g) of each player, then log(v). It is concave,
// so Newton's method with shortened steps finds its maximum.
class Likelihood {
 public:
  Likelihood(const Players& players, const std::vector<FixtureResults>& fixtures)
      : players_(players),
        count_(players.count()),
        virtual_(VectorXd::Constant(count_, virtual_legs)),
        meetings_(count_) {
    virtual_.head(count_ - players.present).setConstant(virtual_legs_of_former);
    losses_ = virtual_;
    for (const FixtureResults& fixture : fixtures) {
      for (const LegResult& leg : fixture) add(leg);
    }
    for (const auto& [who, results] : pairs_) {
      meetings_[who.first].push_back({who.second, results});
      meetings_[who.second].push_back({who.first, {results.other, results.one, results.draws}});
    }
  }

  double at(const VectorXd& x) const {
    double sum = virtual_draws * (x[count_] - 2.0 * log_of_level_legs(x));
    for (int i = 0; i < count_; ++i) sum += of_player_alone(i, x[i], x);
    const double draws = exp(x[count_]);
    for (const auto& [who, results] : pairs_)
      sum += of_meetings(results, x[who.first], x[who.second], x[count_], draws);
    return sum;
  }

  // Returns the terms in which the strength of a present player occurs, with another value for it.
  double of_player(int player, double value, const VectorXd& x) const {
    double sum = of_player_alone(player, value, x);
    const double draws = exp(x[count_]);
    for (const auto& [opponent, results] : meetings_[player])
      sum += of_meetings(results, value, x[opponent], x[count_], draws);
    return sum;
  }

  // The same for two players.
  double of_two(int one, int other, double value, double other_value, VectorXd x) const {
    x[one] = value;
    double sum = of_player(other, other_value, x) + of_player_alone(one, value, x);
    const double draws = exp(x[count_]);
    for (const auto& [opponent, results] : meetings_[one]) {
      if (opponent != other) sum += of_meetings(results, value, x[opponent], x[count_], draws);
    }
    return sum;
  }

  // Sets the gradient, and returns the negative matrix of second derivatives.
  Curvature derivatives(const VectorXd& x, VectorXd& gradient) const {
    gradient.setZero(count_ + 1);
    std::vector<Eigen::Triplet<double>> terms;
    terms.reserve(6 * pairs_.size() + 4 * static_cast<std::size_t>(count_) + 1);
    const auto add = [&terms](int row, int column, double term) {
      terms.emplace_back(std::max(row, column), std::min(row, column), term);
    };
    const double level = logistic(x[count_] - log_2);
    gradient[count_] = virtual_draws * (1.0 - 2.0 * level);
    add(count_, count_, 2.0 * virtual_draws * level * (1.0 - level));
    for (int i = 0; i < count_; ++i) {
      const double win = logistic(x[i]);
      gradient[i] += virtual_[i] - (virtual_[i] + losses_[i]) * win;
      add(i, i, (virtual_[i] + losses_[i]) * win * (1.0 - win));
      const int former = players_.former[i];
      if (former == no_player) continue;
      gradient[i] -= lean * (x[i] - x[former]);
      gradient[former] += lean * (x[i] - x[former]);
      add(i, i, lean);
      add(former, former, lean);
      add(i, former, -lean);
    }
    const double draws = exp(x[count_]);
    for (const auto& [who, results] : pairs_) {
      const LegOdds p = odds(x[who.first], x[who.second], draws);
      add_derivatives(who.first, who.second, results, p, gradient, add);
    }
    Curvature curvature(count_ + 1, count_ + 1);
    curvature.setFromTriplets(terms.begin(), terms.end());
    return curvature;
  }

  VectorXd maximum() const {
    VectorXd x = VectorXd::Zero(count_ + 1);
    VectorXd gradient;
    double value = at(x);
    for (int i = 0; i < max_iterations; ++i) {
      const Curvature curvature = derivatives(x, gradient);
      VectorXd step = Factors(curvature).solve(gradient);
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

  double log_of_level_legs(const VectorXd& x) const { return log_2 + soft_plus(x[count_] - log_2); }

  // Of the legs against the virtual team, and of the lean.
  double of_player_alone(int player, double value, const VectorXd& x) const {
    const int former = players_.former[player];
    const double apart = former == no_player ? 0.0 : value - x[former];
    return virtual_[player] * value - (virtual_[player] + losses_[player]) * soft_plus(value) -
           0.5 * lean * apart * apart;
  }

  // `log_draws` is the logarithm of `draws`.
  static double of_meetings(const PairResults& results, double one, double other, double log_draws,
                            double draws) {
    return results.one * one + results.other * other +
           results.draws * (log_draws + 0.5 * (one + other)) -
           results.played() * log_of_sum(one, other, draws);
  }

  template <class Add>
  void add_derivatives(int i, int j, const PairResults& results, const LegOdds& p,
                       VectorXd& gradient, const Add& add) const {
    const int v = count_;
    const double played = results.played();
    const double one = p.score();
    const double other = p.other + 0.5 * p.draw;
    gradient[i] += results.one + 0.5 * results.draws - played * one;
    gradient[j] += results.other + 0.5 * results.draws - played * other;
    gradient[v] += results.draws - played * p.draw;
    add(i, i, played * p.variance());
    add(j, j, played * (p.other + 0.25 * p.draw - other * other));
    add(i, j, played * (0.25 * p.draw - one * other));
    add(v, i, played * (0.5 * p.draw - one * p.draw));
    add(v, j, played * (0.5 * p.draw - other * p.draw));
    add(v, v, played * (p.draw - p.draw * p.draw));
  }

  const Players& players_;
  int count_;
  VectorXd virtual_;                                  // wins against the virtual team
  VectorXd losses_;                                   // against the virtual team
  std::map<std::pair<int, int>, PairResults> pairs_;  // by the two players, the lower number first
  std::vector<std::vector<Meeting>> meetings_;        // the same by player
};

// Returns how far a player's value may move up (sign 1) or down (-1), while twice the
// log-likelihood falls by at most `fall`. That function is concave, so there is one such place on
// each side.
double reach(const Likelihood& likelihood, int player, const VectorXd& best, double sign,
             double fall) {
  const double top = likelihood.of_player(player, best[player], best);
  const auto is_within = [&](double distance) {
    const double value = best[player] + sign * distance;
    return 2.0 * (top - likelihood.of_player(player, value, best)) < fall;
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

// A likelihood and its maximum.
struct Fit {
  Fit(Players who, const std::vector<FixtureResults>& fixtures)
      : players(std::move(who)),
        likelihood(players, fixtures),
        best(likelihood.maximum()),
        curvature(likelihood.derivatives(best, gradient)) {
    const Factors factors(curvature);
    for (int i = first(); i < players.count(); ++i) {
      VectorXd column = VectorXd::Unit(players.count() + 1, i);
      factors.matrixL().solveInPlace(column);
      const VectorXd scaled = column.array() / factors.vectorD().array().sqrt();
      errors.push_back(scaled.tail(players.present + 1));
    }
  }

  int first() const { return players.count() - players.present; }
  const VectorXd& error_of(int team) const { return errors[player_of_team[team] - first()]; }

  Players players;
  Likelihood likelihood;
  VectorXd best;
  VectorXd gradient;
  Curvature curvature;
  std::vector<VectorXd> errors;  // of the present players; their products are the covariances
  std::vector<int> player_of_team;
};

namespace {

// Sets the strengths of the teams that have a player.
Ratings ratings_of(std::shared_ptr<Fit> made, std::vector<int> player_of_team) {
  Fit& fit = *made;
  const int present = fit.players.present;
  Ratings ratings{.strengths = std::vector<Strength>(player_of_team.size()),
                  .draws = exp(fit.best[fit.players.count()])};
  VectorXd of_mean = VectorXd::Zero(present + 1);
  double mean = 0.0;
  for (int i = 0; i < present; ++i) {
    of_mean += fit.errors[i] / present;
    mean += fit.best[fit.first() + i] / present;
  }
  const double share = 1.0 - 1.0 / present;  // of a value, by which it moves from the mean
  for (std::size_t team = 0; team < player_of_team.size(); ++team) {
    const int player = player_of_team[team];
    if (player == no_player) continue;
    Strength& strength = ratings.strengths[team];
    strength.value = strength.low = strength.high = unit_of_log * (fit.best[player] - mean);
    if (present == 1) continue;
    const double variance = (fit.errors[player - fit.first()] - of_mean).squaredNorm();
    const double fall =
        z_95 * z_95 * variance * fit.curvature.coeff(player, player) / (share * share);
    strength.low -= unit_of_log * share * reach(fit.likelihood, player, fit.best, -1.0, fall);
    strength.high += unit_of_log * share * reach(fit.likelihood, player, fit.best, 1.0, fall);
  }
  fit.player_of_team = std::move(player_of_team);
  ratings.fit = std::move(made);
  return ratings;
}

}  // namespace

Ratings rate(int teams, const std::vector<FixtureResults>& fixtures) {
  std::vector<int> players(teams);
  std::iota(players.begin(), players.end(), 0);
  return ratings_of(
      std::make_shared<Fit>(Players{std::vector<int>(teams, no_player), teams}, fixtures), players);
}

Ratings rate_entries(const std::vector<int>& present, std::vector<FixtureResults> fixtures,
                     bool leans) {
  using Entry = std::pair<int, int>;  // team and number
  std::map<Entry, std::size_t> last;  // the place of the entry's last fixture
  for (std::size_t i = 0; i < fixtures.size(); ++i) {
    for (const LegResult& leg : fixtures[i])
      last[{leg.home, leg.home_entry}] = last[{leg.away, leg.away_entry}] = i;
  }
  Players players;
  for (int team = 0; team < static_cast<int>(present.size()); ++team) {
    if (present[team] == no_entry) continue;
    ++players.present;
    last[{team, present[team]}] = fixtures.size();
  }
  std::vector<std::pair<std::size_t, Entry>> order;  // as in Players
  for (const auto& [entry, place] : last) order.push_back({place, entry});
  std::ranges::sort(order);
  std::map<Entry, int> player;
  for (const auto& one : order) player.emplace(one.second, static_cast<int>(player.size()));
  players.former.assign(order.size(), no_player);
  Entry before{no_player, 0};
  for (const auto& [entry, number] : player) {
    // If the former entry came back later, it is eliminated after this one, which then leans on
    // none.
    if (leans && entry.first == before.first && player[before] < number)
      players.former[number] = player[before];
    before = entry;
  }
  for (FixtureResults& fixture : fixtures) {
    for (LegResult& leg : fixture) {
      leg.home = player.at({leg.home, leg.home_entry});
      leg.away = player.at({leg.away, leg.away_entry});
    }
  }
  std::vector<int> player_of_team(present.size(), no_player);
  for (std::size_t team = 0; team < present.size(); ++team) {
    if (present[team] != no_entry)
      player_of_team[team] = player.at({static_cast<int>(team), present[team]});
  }
  return ratings_of(std::make_shared<Fit>(std::move(players), fixtures), std::move(player_of_team));
}

// As for the interval of a strength, the other strengths stay, and the permitted fall is multiplied
// by a ratio of two variances.
bool are_apart(const Ratings& ratings, int one, int other) {
  const Fit& fit = *ratings.fit;
  const int i = fit.player_of_team[one];
  const int j = fit.player_of_team[other];
  const VectorXd error = fit.error_of(one) - fit.error_of(other);
  const double variance = error.squaredNorm();
  // The shares of the two in the way to the same strength.
  const double a = fit.error_of(one).dot(error) / variance;
  const double b = 1.0 - a;
  const double curvature = a * a * fit.curvature.coeff(i, i) + b * b * fit.curvature.coeff(j, j) -
                           2.0 * a * b * fit.curvature.coeff(std::max(i, j), std::min(i, j));
  const double same = fit.best[i] - a * (fit.best[i] - fit.best[j]);
  const double fall = 2.0 * (fit.likelihood.of_two(i, j, fit.best[i], fit.best[j], fit.best) -
                             fit.likelihood.of_two(i, j, same, same, fit.best));
  return fall > z_95 * z_95 * variance * curvature;
}

std::optional<ScaleMark> mark_of(const Ratings& ratings, const std::vector<ScaleStep>& scale,
                                 double below, int team) {
  const Fit& fit = *ratings.fit;
  const auto strength = [&](int of) { return fit.best[fit.player_of_team[of]]; };
  for (std::size_t i = 0; i + 1 < scale.size(); ++i) {
    if (!(strength(scale[i].team) < strength(scale[i + 1].team))) return std::nullopt;
  }
  const auto segment = [&](double at) {
    std::size_t i = 0;
    while (i + 2 < scale.size() && at > strength(scale[i + 1].team)) ++i;
    return i;
  };
  const auto share = [&](std::size_t i, double at) {
    const double low = strength(scale[i].team);
    return std::clamp((at - low) / (strength(scale[i + 1].team) - low), 0.0, 1.0);
  };
  const auto mark = [&](double at) {
    if (at < strength(scale[0].team)) return below;
    const std::size_t i = segment(at);
    return scale[i].mark + share(i, at) * (scale[i + 1].mark - scale[i].mark);
  };
  // The error of the team's place between the two steps beside it.
  const double at = strength(team);
  const std::size_t beside = segment(at);
  const double upper = share(beside, at);
  const VectorXd error = fit.error_of(team) - (1.0 - upper) * fit.error_of(scale[beside].team) -
                         upper * fit.error_of(scale[beside + 1].team);
  const double reach = z_95 * error.norm();
  return ScaleMark{mark(at), mark(at - reach), mark(at + reach)};
}

std::optional<int> legs_to_tell(const Ratings& ratings, int one, int other) {
  const LegOdds p = odds(ratings.strengths[one].value / unit_of_log,
                         ratings.strengths[other].value / unit_of_log, ratings.draws);
  const double lead = p.score() - 0.5;
  const double needed = (z_95 + z_80) * (z_95 + z_80) * p.variance();
  if (!(needed <= max_legs_to_tell * lead * lead)) return {};
  return std::max(fewest_legs_to_tell, static_cast<int>(std::ceil(needed / (lead * lead))));
}

}  // namespace mirocup::league
