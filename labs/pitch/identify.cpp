// SPDX-License-Identifier: MIT
#include "labs/pitch/identify.hpp"

#include "core/base/math.hpp"
#include "labs/pitch/cuts.hpp"
#include "labs/pitch/fit.hpp"
#include "labs/pitch/intervals.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <utility>

namespace mirocup::pitch {

namespace {

using Eigen::MatrixXd;

constexpr double median_share = 0.37;  // what a median of n sizes tells, in squares
constexpr int steps_of_profile = 7;    // to each side
constexpr int fewest_windows = 2;      // from which a hit's restitution or a slide's grip is told
constexpr int fewest_of_robots = 3;    // from which that of two robots is told

bool is_between_bodies(int unknown) {
  return unknown == ball_on_robot || unknown == robot_on_robot;
}

// Returns the inverse. What no window tells makes the matrix singular; a little of itself keeps the
// rest readable.
MatrixXd inverse_of(MatrixXd information) {
  information.diagonal().array() += 1e-8;
  return information.ldlt().solve(MatrixXd::Identity(information.rows(), information.cols()));
}

// Returns the covariance of the free unknowns, in their order: as the camera's noise has it, and
// wider where windows differ by more than that (White 1980). They do where a slide or a hit begins
// a little before or after the simulated one. A window that tells much of an unknown pulls the
// estimate to itself, so its own difference counts for more (the leverage of MacKinnon and White
// 1985), but at most twice.
MatrixXd covariance_of(const Fit& fit) {
  const MatrixXd covariance = inverse_of(fit.information());
  Eigen::ArrayXd between = Eigen::ArrayXd::Zero(covariance.rows());
  for (const Fit::Told& told : fit.told()) {
    const Eigen::ArrayXd pull = (covariance * told.gradient).array();
    const Eigen::ArrayXd share = (covariance * told.information * covariance).diagonal().array() /
                                 covariance.diagonal().array();
    between += (pull / (1.0 - share.max(0.0).min(0.5))).square();
  }
  const Eigen::VectorXd widening =
      (between / covariance.diagonal().array()).max(1.0).sqrt().matrix();
  return widening.asDiagonal() * covariance * widening.asDiagonal();
}

int place_of(const std::vector<int>& list, int unknown) {
  return static_cast<int>(std::find(list.begin(), list.end(), unknown) - list.begin());
}

void describe_noise(const Fit& fit, Identified& result) {
  double positions = 0.0, headings = 0.0;
  for (const Piece& piece : fit.pieces()) {
    if (!piece.counts) continue;
    for (std::size_t i = 0; i < piece.window.bodies.size(); ++i) {
      for (int f = piece.window.first; f <= piece.window.last; ++f) {
        if (!piece.footage->sight(piece.window.bodies[i], f).is_seen) continue;
        positions += 2.0;
        headings += piece.is_ball(i) ? 0.0 : 1.0;
      }
    }
  }
  const auto noise = [](double sigma, double n) {
    const double half = n > 1.0 ? z95 / std::sqrt(2.0 * n) : 1.0;
    return Estimate{sigma, sigma / (1.0 + half), sigma * (1.0 + half)};
  };
  result.position_noise = noise(fit.noise().position, median_share * positions);
  result.heading_noise = noise(fit.noise().heading, median_share * headings);
}

void describe_deceleration(const std::vector<int>& free, const MatrixXd& covariance,
                           Identified& result) {
  const int rolling = place_of(free, rolling_resistance),
            viscous = place_of(free, viscous_friction);
  const simulator::Parameters& p = result.guess.parameters;
  const Eigen::Vector2d slope{simulator::gravity / 1.4, 0.5 / (1.4 * p.ball_mass)};
  Eigen::Matrix2d both;
  both << covariance(rolling, rolling), covariance(rolling, viscous), covariance(viscous, rolling),
      covariance(viscous, viscous);
  const double value = slope[0] * p.rolling_resistance + slope[1] * p.viscous_friction;
  const double half = z95 * std::sqrt(std::max(0.0, slope.dot(both * slope)));
  result.has_deceleration = half < std::max(0.1, value);
  result.deceleration = {value, value - half, value + half};
}

// Sets the estimates of the free unknowns, and the counts of windows.
void describe(const Fit& fit, const MatrixXd& covariance, Identified& result) {
  const std::vector<int> free = fit.free_unknowns();
  for (const int u : free) set_value(result.guess, u, value_of(fit.guess(), u));
  for (const Piece& piece : fit.pieces()) ++(piece.counts ? result.windows : result.unexplained);
  for (std::size_t j = 0; j < free.size(); ++j) {
    const Unknown& u = unknowns()[free[j]];
    const double half = z95 * std::sqrt(std::max(0.0, covariance(j, j)));
    const double value = value_of(result.guess, free[j]);
    if (!(half < u.widest)) {
      result.why_not[free[j]] = "the recordings need " + std::string(u.needs);
      continue;
    }
    const auto plain = [&](double v) {
      return std::clamp(u.is_ratio ? std::exp(v) : v, u.least, u.most);
    };
    result.known[free[j]] = Estimate{plain(value), plain(value - half), plain(value + half)};
  }
}

// Values from `low` on, in units of value_of().
std::vector<double> values_from(double low, double step, int count, int unknown) {
  const Unknown& u = unknowns()[unknown];
  const double least = u.is_ratio ? std::log(u.least) : u.least;
  const double most = u.is_ratio ? std::log(u.most) : u.most;
  std::vector<double> values;
  for (int i = 0; i < count; ++i) {
    const double value = low + step * i;
    if (value >= least - 1e-12 && value <= most + 1e-12) values.push_back(value);
  }
  return values;
}

// Looks at all values of an unknown whose cost has several minima: windows with impacts or slides
// have corners, where one more or less of them happens.
void look_around(Fit& fit, int unknown) {
  if (unknown == grip_limit) {
    fit.profile(unknown, values_from(std::log(0.25), 0.2, 10, unknown));
  } else {
    fit.profile(unknown, values_from(0.05, 0.15, 7, unknown));
  }
}

// The same near what was found.
void look_near(Fit& fit, int unknown) {
  const double step = unknown == grip_limit ? 0.03 : 0.015;
  const double middle = value_of(fit.guess(), unknown);
  fit.profile(unknown, values_from(middle - 3.0 * step, step, 7, unknown));
}

// True if the interval reaches beyond the values, where the unknown could be, too.
bool is_open(const Fit::Profile& p, int unknown, double step) {
  const double limit = *std::min_element(p.costs.begin(), p.costs.end()) + 2.0 * rise95;
  const bool is_lowest = values_from(p.values.front() - step, step, 1, unknown).empty();
  const bool is_highest = values_from(p.values.back() + step, step, 1, unknown).empty();
  return (!is_lowest && p.costs.front() < limit) || (!is_highest && p.costs.back() < limit);
}

// Replaces the estimate of an unknown by what its profile tells. `own` is the standard deviation if
// the rest were known, and `others` is what the rest adds, in units of value_of().
void sharpen(Fit& fit, int unknown, double own, double others, Identified& result) {
  const Unknown& u = unknowns()[unknown];
  result.known[unknown].reset();
  result.why_not[unknown] = "the recordings need " + std::string(u.needs);
  double step = std::clamp(own, 0.002, 0.03);
  Fit::Profile profile;
  for (int turn = 0; turn < 4; ++turn) {
    const double middle = value_of(fit.guess(), unknown);
    profile = fit.profile(unknown, values_from(middle - steps_of_profile * step, step,
                                               2 * steps_of_profile + 1, unknown));
    if (profile.windows() < (unknown == robot_on_robot ? fewest_of_robots : fewest_windows)) return;
    const double moved = std::abs(value_of(fit.guess(), unknown) - middle);
    if (is_open(profile, unknown, step)) {
      step *= 2.0;
    } else if (moved < 0.7 * steps_of_profile * step) {
      break;
    }
  }
  const auto [value, low, high] = interval_of(profile, others);
  if (!(high - low < 2.0 * u.widest)) return;
  const auto plain = [&](double v) {
    return std::clamp(u.is_ratio ? std::exp(v) : v, u.least, u.most);
  };
  result.known[unknown] = Estimate{plain(value), plain(low), plain(high)};
  result.why_not[unknown].clear();
  set_value(result.guess, unknown, value);
}

// The same with covariance and information of a fit's free unknowns.
void sharpen(Fit& fit, int unknown, const MatrixXd& information, const MatrixXd& covariance,
             Identified& result) {
  const int j = place_of(fit.free_unknowns(), unknown);
  const double own = 1.0 / std::max(1e-8, information(j, j));
  sharpen(fit, unknown, std::sqrt(own), std::sqrt(std::max(0.0, covariance(j, j) - own)), result);
}

// Counts what cameras miss, and what is left out as an outlier before the fit.
void count_sights(const std::vector<CameraLog>& recordings, const std::vector<Footage>& footages,
                  Identified& result) {
  double all = 0.0, unseen = 0.0, left_out = 0.0;
  for (std::size_t k = 0; k < recordings.size(); ++k) {
    const CameraLog& recording = recordings[k];
    for (int body = 0; body < footages[k].bodies(); ++body) {
      for (int f = 0; f < footages[k].frames(); ++f) {
        const Frame& frame = recording.frames[f];
        const bool was_seen = body == footages[k].ball() ? frame.ball.has_value()
                                                         : recording.robot(frame, body).has_value();
        all += 1.0;
        unseen += was_seen ? 0.0 : 1.0;
        left_out += was_seen && !footages[k].sight(body, f).is_seen ? 1.0 : 0.0;
      }
    }
  }
  result.unseen = unseen / std::max(1.0, all);
  result.outliers = left_out / std::max(1.0, all - unseen);
}

// True if a lag is surely not that of driving forward.
bool differs_from_motor_lag(const Identified& now, int lag) {
  if (!now.known[lag] || !now.known[motor_lag]) return false;
  const Estimate& a = *now.known[lag];
  const Estimate& b = *now.known[motor_lag];
  const double half = std::hypot(std::log(a.high / a.low), std::log(b.high / b.low)) / 2.0;
  return std::abs(std::log(a.value / b.value)) > 1.5 * half;
}

// Bodies that are alone tell everything but what happens between bodies.
Result<Fit> fit_alone(const std::vector<Footage>& footages, const Guess& start,
                      const std::string& path) {
  Fit fit(start, {});
  for (const Footage& footage : footages) {
    for (Window& window : rolls(footage, start.parameters)) fit.add(footage, std::move(window));
    for (Window& window : drives(footage, start.parameters)) fit.add(footage, std::move(window));
  }
  if (fit.is_empty()) {
    return fail(
        Errc::input,
        path +
            ": it has no half second with a rolling ball or with a robot whose commands are known");
  }
  for (int u = 0; u < unknown_count; ++u) fit.set_free(u, !is_between_bodies(u));
  if (start.parameters.grip == simulator::infinite_grip) fit.set_free(grip_limit, false);
  // A few delays of commands and lags of motors: the cost has several minima in them.
  using DelayAndLag = std::pair<double, double>;  // s
  std::vector<Guess> guesses;
  for (const auto& [delay, lag] :
       {DelayAndLag{0.0, 0.05}, DelayAndLag{0.03, 0.05}, DelayAndLag{0.06, 0.05},
        DelayAndLag{0.1, 0.05}, DelayAndLag{0.16, 0.05}, DelayAndLag{0.0, 0.15},
        DelayAndLag{0.04, 0.15}, DelayAndLag{0.1, 0.15}}) {
    guesses.push_back(start);
    guesses.back().command_delay = delay;
    for (const int u : {motor_lag, turn_lag, brake_lag})
      set_value(guesses.back(), u, std::log(lag));
  }
  fit.choose(guesses);
  fit.run(false);
  for (const int u : {grip_limit, robot_on_wall}) {
    if (fit.is_free(u)) look_around(fit, u);
  }
  fit.retry();
  fit.run(true);
  for (const int u : {grip_limit, robot_on_wall}) {
    if (fit.is_free(u)) look_near(fit, u);
  }
  fit.retry();
  fit.run(true);
  return fit;
}

// Returns the covariance of what the fit has found with the rest as it was known before: of its own
// noise, and of what the rest is uncertain by.
MatrixXd covariance_of_second(Fit& fit, const Identified& rest, const std::vector<int>& rest_free,
                              const MatrixXd& rest_covariance) {
  const std::vector<int> own = fit.free_unknowns();
  std::vector<int> others;  // that are known
  for (const int u : rest_free) {
    if (!rest.known[u]) continue;
    others.push_back(u);
    fit.set_free(u, true);
  }
  fit.linearise();
  const std::vector<int> all = fit.free_unknowns();
  for (const int u : others) fit.set_free(u, false);
  const auto part = [&](const std::vector<int>& rows, const std::vector<int>& columns,
                        const std::vector<int>& order, const MatrixXd& whole) {
    MatrixXd m(rows.size(), columns.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (std::size_t j = 0; j < columns.size(); ++j)
        m(static_cast<int>(i), static_cast<int>(j)) =
            whole(place_of(order, rows[i]), place_of(order, columns[j]));
    }
    return m;
  };
  const MatrixXd alone = inverse_of(part(own, own, all, fit.information()));
  const MatrixXd slope = alone * part(own, others, all, fit.information());
  return alone + slope * part(others, others, rest_free, rest_covariance) * slope.transpose();
}

// What happens between bodies, with everything else as it was found: hits multiply small errors, so
// windows with them would spoil the rest more than they tell about it.
void identify_hits(const std::vector<Footage>& footages, const Fit& alone,
                   const MatrixXd& covariance, Identified& result) {
  Fit fit(alone.guess(), alone.noise());
  fit.tie_turn_lag(alone.turn_lag_is_tied());
  fit.tie_brake_lag(alone.brake_lag_is_tied());
  fit.set_noise_known(true);
  for (const Footage& footage : footages) {
    for (Window& window : meetings(footage, alone.guess().parameters))
      fit.add(footage, std::move(window));
  }
  fit.end_after_impacts();
  for (const int u : {ball_on_robot, robot_on_robot}) {
    fit.set_free(u, true);
    look_around(fit, u);
  }
  fit.retry();
  fit.run(true);
  for (const int u : {ball_on_robot, robot_on_robot}) look_near(fit, u);
  fit.retry();
  fit.run(true);
  const MatrixXd information = fit.information();
  const MatrixXd both = covariance_of_second(fit, result, alone.free_unknowns(), covariance);
  describe(fit, both, result);
  for (const int u : {ball_on_robot, robot_on_robot}) sharpen(fit, u, information, both, result);
}

}  // namespace

Result<Identified> identify(const std::vector<CameraLog>& recordings, const Guess& start) {
  std::vector<Footage> footages;
  footages.reserve(recordings.size());
  for (const CameraLog& recording : recordings) footages.emplace_back(recording);
  Guess guess = start;
  guess.parameters.turn_time_constant = guess.parameters.turn_lag();
  guess.parameters.brake_time_constant = guess.parameters.brake_lag();
  MIROCUP_TRY(auto fit, fit_alone(footages, guess, recordings.front().path));
  MatrixXd covariance = covariance_of(fit);
  Identified result;
  result.guess = fit.guess();
  describe(fit, covariance, result);
  const bool one_lag = !differs_from_motor_lag(result, turn_lag);
  const bool no_brake = !differs_from_motor_lag(result, brake_lag);
  if (one_lag || no_brake) {
    fit.tie_turn_lag(one_lag);
    fit.tie_brake_lag(no_brake);
    fit.run(true);
    covariance = covariance_of(fit);
    result = {};
    result.guess = fit.guess();
    describe(fit, covariance, result);
    const char* const same =
        "the recordings show no difference between this time constant and motor_time_constant";
    if (one_lag) result.why_not[turn_lag] = same;
    if (no_brake) result.why_not[brake_lag] = same;
  }
  result.has_one_lag = one_lag;
  result.has_brake = !no_brake;
  describe_noise(fit, result);
  describe_deceleration(fit.free_unknowns(), covariance, result);
  const MatrixXd information = fit.information();
  for (const int u : {grip_limit, robot_on_wall}) {
    if (fit.is_free(u)) sharpen(fit, u, information, covariance, result);
  }
  identify_hits(footages, fit, covariance, result);
  for (int u = 0; u < unknown_count; ++u) {
    if (result.known[u] || !result.why_not[u].empty()) continue;
    result.why_not[u] = fit.is_free(u)
                            ? "the recordings need " + std::string(unknowns()[u].needs)
                            : "the search began with an infinite value (--pitch) and kept it";
  }
  count_sights(recordings, footages, result);
  return result;
}

}  // namespace mirocup::pitch
