// SPDX-License-Identifier: MIT
#include "labs/pitch/fit.hpp"

#include "core/base/math.hpp"
#include "core/base/random.hpp"
#include "core/simulator/collision/collision_queries.hpp"
#include "core/simulator/collision/static_world.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace mirocup::pitch {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using simulator::BodyState;

constexpr double clear_gap = 0.003;   // m, at the start of a window
constexpr double after_impact = 0.2;  // s, until the end of a window with an impact of bodies
constexpr int pictures_of_start = 8;  // for the first guess of a state
constexpr int most_rounds = 40;
constexpr int rounds_of_choice = 6;
constexpr std::size_t pieces_of_choice = 150;
constexpr double huber = 2.5;          // [standard deviations]
constexpr double outlier_square = 25;  // of two or three coordinates together
constexpr double unexplained = 2.5;    // mean square of a window's residuals, at first
constexpr double most_deviations =
    4.5;  // the same in the end: standard deviations of a mean square
constexpr double difference_step = 1e-5;
constexpr int rounds_of_settling = 8;
constexpr double settled = 0.02;  // the cost falls by less than this
constexpr double same = 1e-9;     // of residuals
constexpr int other_starts = 12;  // that are tried
constexpr double badly = 2.0;     // standard deviations of a mean square: other starts are tried
// By how much other starts differ: in x, y, heading, forward, turn, sideways of a robot, and in
// x, y and velocities of the ball; m, rad, m/s, rad/s.
constexpr std::array<double, 6> robot_spread{0.002, 0.002, 0.03, 0.05, 0.6, 0.1};
constexpr std::array<double, 4> ball_spread{0.002, 0.002, 0.05, 0.05};
constexpr double most_rise = 8.0;    // of a window's cost in a profile: no window outvotes many
constexpr double usual_slide = 0.5;  // m/s: standard deviation of a sideways speed beforehand

int states_of(const Piece& piece, std::size_t i) {
  if (piece.is_ball(i)) return 4;
  return piece.may_slide(i) ? 6 : 5;
}

void shift(BodyState& state, bool is_ball, int which, double by) {
  if (which == 0) state.position.x() += by;
  if (which == 1) state.position.y() += by;
  if (is_ball) {
    if (which == 2) state.twist.forward += by;
    if (which == 3) state.twist.left += by;
    return;
  }
  if (which == 2) state.heading = Heading::from_angle(state.heading.angle() + by);
  if (which == 3) state.twist.forward += by;
  if (which == 4) state.twist.omega += by;
  if (which == 5) state.twist.left += by;
}

void move_starts(const Piece& piece, const VectorXd& move, std::vector<BodyState>& starts) {
  int k = 0;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    for (int s = 0; s < states_of(piece, i); ++s)
      shift(starts[i], piece.is_ball(i), s, std::clamp(move[k++], -1.0, 1.0));
  }
}

// Sets the first guess of the starts. Returns false if a body is not seen well enough.
bool find_starts(Piece& piece) {
  for (std::size_t i = 0; i < piece.window.bodies.size(); ++i) {
    const auto fitted =
        piece.footage->state_at(piece.window.bodies[i], piece.window.first, pictures_of_start, 2);
    if (!fitted) return false;
    piece.start.push_back(fitted->state);
    if (!piece.is_ball(i) && !piece.may_slide(i)) piece.start.back().twist.left = 0.0;
  }
  return true;
}

// True if no two bodies, and no body and a wall, are nearer than `clearance`, m, at the start:
// bodies that touch have forces that no state tells.
bool stand_clear(const Piece& piece, const simulator::Parameters& parameters, double clearance) {
  const int count = static_cast<int>(piece.start.size());
  const bool has_ball = piece.is_ball(piece.start.size() - 1);
  const auto world = simulator::collision::make_static_world(&piece.footage->field(), parameters,
                                                             simulator::Tolerances{},
                                                             count - (has_ball ? 1 : 0), has_ball);
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < i; ++j) {
      if (gap(world, {i, j}, piece.start[i], piece.start[j]) < clearance) return false;
    }
    for (int k = 0; k < simulator::plane_walls + simulator::end_walls; ++k) {
      const double to_wall =
          gap(world, simulator::pair_with_obstacle(i, k), piece.start[i], BodyState{});
      if (to_wall < clearance) return false;
    }
  }
  return true;
}

// Returns which numbers the motion of these bodies depends on.
std::array<bool, unknown_count> told_by(const Piece& piece) {
  const bool has_ball = piece.is_ball(piece.start.size() - 1);
  const std::size_t robots = piece.start.size() - (has_ball ? 1 : 0);
  std::array<bool, unknown_count> tells{};
  tells.fill(robots > 0);
  for (const int u : {rolling_resistance, viscous_friction, ball_on_wall}) tells[u] = has_ball;
  tells[ball_on_robot] = has_ball && robots > 0;
  tells[robot_on_robot] = robots > 1;
  return tells;
}

}  // namespace

void Fit::count_rows(Piece& piece) const {
  piece.states = piece.rows = 0;
  for (std::size_t i = 0; i < piece.window.bodies.size(); ++i) {
    piece.states += states_of(piece, i);
    piece.rows += piece.may_slide(i) ? 1 : 0;
    for (int f = piece.window.first; f <= piece.window.last; ++f) {
      if (piece.footage->sight(piece.window.bodies[i], f).is_seen)
        piece.rows += piece.is_ball(i) ? 2 : 3;
    }
  }
}

void Fit::add(const Footage& footage, Window window) {
  Piece piece;
  piece.footage = &footage;
  piece.window = std::move(window);
  if (!find_starts(piece) || !stand_clear(piece, guess_.parameters, clear_gap)) return;
  piece.tells = told_by(piece);
  count_rows(piece);
  if (piece.rows > piece.states) pieces_.push_back(std::move(piece));
}

void Fit::end_after_impacts() {
  Variant now = variant(guess_);
  std::vector<Piece> kept;
  for (Piece& piece : pieces_) {
    simulator::RunStatistics statistics;
    now.reruns.at(piece.footage)
        ->play(
            piece.window, piece.start, [](int, std::size_t, const BodyState&) {}, &statistics);
    const auto impact = std::find_if(
        statistics.impacts.begin(), statistics.impacts.end(), [](const simulator::Impact& i) {
          return i.first != simulator::no_body && i.second != simulator::no_body;
        });
    if (impact == statistics.impacts.end()) continue;
    Window& window = piece.window;
    const double end = piece.footage->time(window.first) + impact->time + after_impact;
    while (window.last > window.first && piece.footage->time(window.last) > end) --window.last;
    count_rows(piece);
    if (piece.rows > piece.states) kept.push_back(std::move(piece));
  }
  pieces_ = std::move(kept);
}

Guess Fit::tied(Guess guess) const {
  if (turn_is_tied_) guess.parameters.turn_time_constant = guess.parameters.motor_time_constant;
  if (brake_is_tied_) guess.parameters.brake_time_constant = guess.parameters.motor_time_constant;
  return guess;
}

Fit::Variant Fit::variant(const Guess& guess) const {
  Variant v{tied(guess), {}};
  for (const Piece& piece : pieces_) {
    auto& rerun = v.reruns[piece.footage];
    if (!rerun) rerun = std::make_unique<Rerun>(*piece.footage, v.guess);
  }
  return v;
}

// Residuals in standard deviations: simulated minus seen.
void Fit::residuals(Variant& v, const Piece& piece, const std::vector<BodyState>& start,
                    VectorXd& r) const {
  const Footage& footage = *piece.footage;
  r.resize(piece.rows);
  int row = 0;
  const auto compare = [&](int frame, std::size_t i, const BodyState& state) {
    const Footage::Sight& seen = footage.sight(piece.window.bodies[i], frame);
    if (!seen.is_seen) return;
    r[row++] = (state.position.x() - seen.position.x()) / noise_.position;
    r[row++] = (state.position.y() - seen.position.y()) / noise_.position;
    if (piece.is_ball(i)) return;
    const double turned = state.heading.angle() - seen.heading;
    r[row++] = std::remainder(turned, 2.0 * pi) / noise_.heading;
  };
  for (std::size_t i = 0; i < start.size(); ++i) compare(piece.window.first, i, start[i]);
  v.reruns.at(&footage)->play(piece.window, start, compare);
  for (std::size_t i = 0; i < start.size(); ++i) {
    if (piece.may_slide(i)) r[row++] = start[i].twist.left / usual_slide;
  }
}

// Returns the weighted square sum, and sets the weight of each residual. The coordinates of one
// sight have the same weight.
double Fit::weigh(const Piece& piece, const VectorXd& r, VectorXd& weight) const {
  weight.resize(r.size());
  double sum = 0.0;
  int row = 0;
  const auto sight = [&](bool is_ball) {
    const int n = is_ball ? 2 : 3;
    const double square = r.segment(row, n).squaredNorm();
    const double size = std::sqrt(square * 2.0 / n);
    double w = size <= huber ? 1.0 : huber / size;
    double counted = size <= huber ? square : (2.0 * huber * size - huber * huber) * n / 2.0;
    if (hard_) {
      w = square > outlier_square ? 0.0 : 1.0;
      counted = std::min(square, outlier_square);
    }
    weight.segment(row, n).setConstant(w);
    sum += counted;
    row += n;
  };
  const Footage& footage = *piece.footage;
  const Window& window = piece.window;
  for (std::size_t i = 0; i < window.bodies.size(); ++i) {
    if (footage.sight(window.bodies[i], window.first).is_seen) sight(piece.is_ball(i));
  }
  for (int f = window.first + 1; f <= window.last; ++f) {
    for (std::size_t i = 0; i < window.bodies.size(); ++i) {
      if (footage.sight(window.bodies[i], f).is_seen) sight(piece.is_ball(i));
    }
  }
  weight.tail(r.size() - row).setOnes();
  return sum + r.tail(r.size() - row).squaredNorm();
}

std::vector<int> Fit::free_unknowns() const {
  std::vector<int> list;
  for (int u = 0; u < unknown_count; ++u) {
    if (!is_free_[u] || (u == turn_lag && turn_is_tied_) || (u == brake_lag && brake_is_tied_))
      continue;
    list.push_back(u);
  }
  return list;
}

// Returns a difference step that stays within the range of the unknown.
double difference_of(const Guess& guess, int unknown) {
  const Unknown& u = unknowns()[unknown];
  const double most = u.is_ratio ? std::log(u.most) : u.most;
  return value_of(guess, unknown) + difference_step > most ? -difference_step : difference_step;
}

// True if the residuals of a window are the camera's noise. At first that is judged leniently.
bool Fit::is_explained(const Piece& piece, const VectorXd& r, const VectorXd& weight) const {
  const double kept = hard_ ? (weight.array() > 0.0).cast<double>().sum() : weight.sum();
  if (kept < (hard_ ? 0.85 : 0.6) * piece.rows) return false;
  if (!hard_) return piece.square < unexplained * std::max(1, piece.rows - piece.states);
  const double freedom = std::max(1.0, kept - piece.states);
  const double mean_square = r.cwiseAbs2().dot(weight) / freedom;
  return mean_square < 1.0 + most_deviations * std::sqrt(2.0 / freedom);
}

// Returns the derivatives of the residuals by the starts.
MatrixXd Fit::slopes_by_start(Variant& v, const Piece& piece, const VectorXd& r) const {
  MatrixXd slopes(r.size(), piece.states);
  VectorXd other;
  int column = 0;
  for (std::size_t i = 0; i < piece.start.size(); ++i) {
    for (int s = 0; s < states_of(piece, i); ++s) {
      std::vector<BodyState> start = piece.start;
      shift(start[i], piece.is_ball(i), s, difference_step);
      residuals(v, piece, start, other);
      slopes.col(column++) = (other - r) / difference_step;
    }
  }
  return slopes;
}

// Computes the equations of all windows at the present guess.
void Fit::linearise() {
  const std::vector<int> free = free_unknowns();
  const int n = static_cast<int>(free.size());
  Variant base = variant(guess_);
  std::vector<Variant> changed;
  std::vector<double> steps;
  for (const int u : free) {
    Guess guess = guess_;
    steps.push_back(difference_of(guess_, u));
    set_value(guess, u, value_of(guess, u) + steps.back());
    changed.push_back(variant(guess));
  }
  information_ = MatrixXd::Zero(n, n);
  told_.clear();
  gradient_ = VectorXd::Zero(n);
  cost_ = 0.0;
  VectorXd r, other, weight;
  for (Piece& piece : pieces_) {
    residuals(base, piece, piece.start, r);
    piece.square = weigh(piece, r, weight);
    piece.counts = is_explained(piece, r, weight);
    const MatrixXd by_start = slopes_by_start(base, piece, r);
    MatrixXd by_pitch(r.size(), n);
    for (int j = 0; j < n; ++j) {
      if (!piece.tells[free[j]]) {
        by_pitch.col(j).setZero();
        continue;
      }
      residuals(changed[j], piece, piece.start, other);
      by_pitch.col(j) = (other - r) / steps[j];
    }
    const MatrixXd weighted = weight.asDiagonal() * by_start;
    MatrixXd a = by_start.transpose() * weighted;
    a.diagonal() *= 1.0 + damping_;
    a.diagonal().array() += 1e-9;
    const MatrixXd b = weighted.transpose() * by_pitch;
    const Eigen::LDLT<MatrixXd> solver(a);
    // Eigen's solver reads beyond a matrix without columns: all numbers are known.
    if (n > 0) {
      piece.gain = solver.solve(b);
    } else {
      piece.gain.resize(piece.states, 0);
    }
    piece.own = solver.solve(weighted.transpose() * r);
    cost_ += std::min(piece.square, unexplained * piece.rows);
    if (!piece.counts || !piece.gain.allFinite() || !by_pitch.allFinite()) continue;
    const MatrixXd weighted_pitch = weight.asDiagonal() * by_pitch;
    Told told{by_pitch.transpose() * weighted_pitch - b.transpose() * piece.gain,
              weighted_pitch.transpose() * r - b.transpose() * piece.own};
    information_ += told.information;
    gradient_ += told.gradient;
    told_.push_back(std::move(told));
  }
}

// Returns the guess after a step of the free unknowns. A ratio moves by 0.5 at most, the others by
// `most`; `step` becomes what was really gone.
Guess Fit::stepped(const std::vector<int>& free, VectorXd& step, double most) const {
  Guess trial = guess_;
  for (std::size_t j = 0; j < free.size(); ++j) {
    const double bound = unknowns()[free[j]].is_ratio ? 0.5 : most;
    const double before = value_of(trial, free[j]);
    set_value(trial, free[j], before + std::clamp(step[j], -bound, bound));
    step[j] = value_of(trial, free[j]) - before;
  }
  return trial;
}

// Sets the trial starts of a step of the pitch, and returns the cost there.
double Fit::cost_of_trial(const Guess& guess, const VectorXd& step) {
  Variant v = variant(guess);
  double cost = 0.0;
  VectorXd r, weight;
  for (Piece& piece : pieces_) {
    piece.trial = piece.start;
    VectorXd move = -piece.own - piece.gain * step;
    if (!move.allFinite()) move.setZero();
    move_starts(piece, move, piece.trial);
    residuals(v, piece, piece.trial, r);
    double square = weigh(piece, r, weight);
    // A start that explains less than before is not taken, whatever the pitch.
    if (!(square < 4.0 * piece.square + 10.0 * static_cast<double>(r.size()))) {
      piece.trial = piece.start;
      residuals(v, piece, piece.trial, r);
      square = weigh(piece, r, weight);
    }
    cost += std::min(square, unexplained * static_cast<double>(r.size()));
  }
  return cost;
}

// Robustly: from the medians of the residuals' sizes, corrected for the unknowns of the starts.
void Fit::estimate_noise() {
  Variant base = variant(guess_);
  std::vector<double> positions, headings;
  double rows = 0.0, states = 0.0;
  VectorXd r, weight;
  for (const Piece& piece : pieces_) {
    if (!piece.counts) continue;
    residuals(base, piece, piece.start, r);
    rows += static_cast<double>(r.size());
    states += piece.states;
    int row = 0;
    const auto collect = [&](int f) {
      for (std::size_t i = 0; i < piece.window.bodies.size(); ++i) {
        if (!piece.footage->sight(piece.window.bodies[i], f).is_seen) continue;
        positions.push_back(std::abs(r[row++]));
        positions.push_back(std::abs(r[row++]));
        if (!piece.is_ball(i)) headings.push_back(std::abs(r[row++]));
      }
    };
    for (int f = piece.window.first; f <= piece.window.last; ++f) collect(f);
  }
  const auto scale = [&](std::vector<double>& sizes, double& sigma, double least) {
    if (sizes.size() < 20) return;
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    const double correction = std::sqrt(rows / std::max(1.0, rows - states));
    sigma = std::max(least, sigma * 1.4826 * *middle * correction);
  };
  scale(positions, noise_.position, 1e-5);
  scale(headings, noise_.heading, 1e-4);
}

// One step of the pitch and the starts. Returns false if no length of it lowers the cost.
bool Fit::step(double most) {
  const std::vector<int> free = free_unknowns();
  for (int attempt = 0; attempt < 6; ++attempt) {
    MatrixXd damped = information_;
    damped.diagonal() *= 1.0 + damping_;
    damped.diagonal().array() += 1e-6;  // what no window tells stays where it is
    VectorXd step = damped.ldlt().solve(-gradient_);
    if (!step.allFinite()) step.setZero();
    const Guess trial = stepped(free, step, most);
    const double cost = cost_of_trial(trial, step);
    if (cost < cost_) {
      guess_ = trial;
      for (Piece& piece : pieces_) piece.start = piece.trial;
      damping_ = std::max(1e-9, damping_ / 10.0);
      cost_ = cost;
      return true;
    }
    damping_ = std::min(1e6, damping_ * 10.0 + 1e-6);
  }
  damping_ = 1e-4;
  return false;
}

void Fit::run(bool hard) {
  hard_ = hard;
  int quiet = 0;
  for (int round = 0; round < most_rounds && quiet < 2; ++round) {
    if (!noise_is_known_ && (!hard || round % 4 == 0)) estimate_noise();
    linearise();
    const double before = cost_;
    if (!step(0.1)) {
      ++quiet;
    } else {
      quiet = before - cost_ < 1e-6 * before + 0.01 ? quiet + 1 : 0;
    }
  }
  damping_ = 0.0;
  linearise();
  damping_ = 1e-4;
}

// Steps of a window's starts alone.
void Fit::settle(Variant& v, Piece& piece) {
  VectorXd r, weight, other, other_weight;
  residuals(v, piece, piece.start, r);
  double cost = weigh(piece, r, weight);
  double damping = 1e-4;
  for (int round = 0; round < rounds_of_settling; ++round) {
    const MatrixXd slopes = slopes_by_start(v, piece, r);
    const MatrixXd weighted = weight.asDiagonal() * slopes;
    MatrixXd a = slopes.transpose() * weighted;
    a.diagonal() *= 1.0 + damping;
    a.diagonal().array() += 1e-9;
    const VectorXd move = -a.ldlt().solve(weighted.transpose() * r);
    if (!move.allFinite()) return;
    std::vector<BodyState> trial = piece.start;
    move_starts(piece, move, trial);
    residuals(v, piece, trial, other);
    const double reached = weigh(piece, other, other_weight);
    if (!(reached < cost)) {
      damping = damping * 30.0 + 1e-4;
      continue;
    }
    const bool is_settled = cost - reached < settled;
    piece.start = std::move(trial);
    std::swap(r, other);
    std::swap(weight, other_weight);
    cost = reached;
    damping /= 10.0;
    if (is_settled) return;
  }
}

// Returns the cost of a window, no more than that of one which is just not explained.
double Fit::capped_cost(Variant& v, const Piece& piece) {
  VectorXd r, weight;
  residuals(v, piece, piece.start, r);
  const double freedom = std::max(1, piece.rows - piece.states);
  return std::min(weigh(piece, r, weight), freedom + most_deviations * std::sqrt(2.0 * freedom));
}

// Settles a window that is explained badly from other starts, too, and keeps the best. Nothing is
// drawn from outside, so the same recording gives the same result.
void Fit::try_other_starts(Variant& v, Piece& piece) {
  const double freedom = std::max(1, piece.rows - piece.states);
  double least = capped_cost(v, piece);
  if (least < freedom + badly * std::sqrt(2.0 * freedom)) return;
  Random random(static_cast<std::uint64_t>(piece.window.first) + 1);
  Piece other = piece;
  other.start.clear();
  if (!find_starts(other)) return;
  const std::vector<BodyState> seen = other.start;
  for (int turn = 0; turn < other_starts; ++turn) {
    const std::vector<BodyState>& from = turn % 2 == 0 ? seen : piece.start;
    other.start = from;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      for (int s = 0; s < states_of(piece, i); ++s) {
        const double spread = piece.is_ball(i) ? ball_spread[s] : robot_spread[s];
        shift(other.start[i], piece.is_ball(i), s, random.uniform(-spread, spread));
      }
    }
    settle(v, other);
    const double cost = capped_cost(v, other);
    if (!(cost < least)) continue;
    least = cost;
    piece.start = other.start;
  }
}

void Fit::retry() {
  Variant now = variant(guess_);
  hard_ = false;
  for (Piece& piece : pieces_) {
    settle(now, piece);
    try_other_starts(now, piece);
  }
}

// True if a window's motion is not the same under all variants.
bool Fit::depends_on(std::span<Variant> variants, const Piece& piece) const {
  VectorXd first, r;
  residuals(variants.front(), piece, piece.start, first);
  return std::any_of(variants.begin() + 1, variants.end(), [&](Variant& v) {
    residuals(v, piece, piece.start, r);
    return !((r - first).cwiseAbs().maxCoeff() < same);
  });
}

Fit::Profile Fit::profile(int unknown, std::vector<double> values) {
  const int count = static_cast<int>(values.size());
  std::vector<Variant> variants;
  for (const double value : values) {
    Guess guess = guess_;
    set_value(guess, unknown, value);
    variants.push_back(variant(guess));
  }
  Variant now = variant(guess_);
  Profile profile{std::move(values), std::vector<double>(static_cast<std::size_t>(count), 0.0), {}};
  double present = 0.0;
  std::vector<std::pair<Piece*, std::vector<std::vector<BodyState>>>> best_starts;
  hard_ = false;
  for (Piece& original : pieces_) {
    if (!original.tells[unknown] || !depends_on(variants, original)) continue;
    std::vector<double> least(static_cast<std::size_t>(count),
                              std::numeric_limits<double>::infinity());
    auto& best = best_starts.emplace_back(&original, std::vector<std::vector<BodyState>>{}).second;
    best.resize(static_cast<std::size_t>(count));
    Piece piece = original;
    for (int turn = 0; turn < 2 * count; ++turn) {
      const int i = turn < count ? turn : 2 * count - 1 - turn;
      settle(variants[i], piece);
      if (turn == count / 2) try_other_starts(variants[i], piece);
      const double cost = capped_cost(variants[i], piece);
      if (cost < least[i]) {
        least[i] = cost;
        best[i] = piece.start;
      } else {
        piece.start = best[i];
      }
    }
    const double highest = *std::min_element(least.begin(), least.end()) + most_rise;
    for (double& cost : least) cost = std::min(cost, highest);
    for (int i = 0; i < count; ++i) profile.costs[i] += least[i];
    profile.parts.push_back(std::move(least));
    piece.start = original.start;
    settle(now, piece);
    present += std::min(capped_cost(now, piece), highest);
  }
  const auto lowest = std::min_element(profile.costs.begin(), profile.costs.end());
  if (profile.windows() == 0 || !(*lowest < present)) return profile;
  const std::size_t at = static_cast<std::size_t>(lowest - profile.costs.begin());
  set_value(guess_, unknown, profile.values[at]);
  for (auto& [piece, starts] : best_starts) piece->start = starts[at];
  return profile;
}

void Fit::choose(std::span<const Guess> guesses) {
  const std::vector<Piece> pieces = pieces_;
  double best = std::numeric_limits<double>::infinity();
  Guess best_guess = guess_;
  const std::size_t every = std::max<std::size_t>(1, pieces.size() / pieces_of_choice);
  hard_ = false;
  for (const Guess& guess : guesses) {
    pieces_.clear();
    for (std::size_t i = 0; i < pieces.size(); i += every) pieces_.push_back(pieces[i]);
    guess_ = guess;
    damping_ = 1e-3;
    for (int round = 0; round < rounds_of_choice; ++round) {
      linearise();
      if (!step(0.03)) break;
    }
    if (cost_ < best) {
      best = cost_;
      best_guess = guess_;
    }
  }
  pieces_ = pieces;
  guess_ = best_guess;
  damping_ = 1e-3;
}

}  // namespace mirocup::pitch
