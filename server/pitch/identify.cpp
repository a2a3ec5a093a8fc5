// SPDX-License-Identifier: MIT
#include "server/pitch/identify.hpp"

#include "core/base/math.hpp"
#include "server/pitch/windows.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace mirocup::pitch {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using simulator::BodyState;

constexpr double window_seconds = 0.5;
constexpr double clear_gap = 0.006;  // m, at the start of a window
constexpr int pictures_between_starts = 3;
constexpr int most_bodies = 3;         // of a window
constexpr int pictures_of_start = 8;   // for the first guess of a state
constexpr double median_share = 0.37;  // what a median of n sizes tells, in squares
constexpr int most_rounds = 40;
constexpr std::array<int, 2> between_bodies{9, 11};  // restitutions of ball and robot, of robots
constexpr double huber = 2.5;                        // [standard deviations]
constexpr double outlier_square = 25;                // of two or three coordinates together
constexpr double unexplained = 2.5;  // mean square of a window's residuals, at first
constexpr double most_deviations =
    4.5;                              // the same in the end: standard deviations of a mean square
constexpr double slides_from = 0.12;  // m/s sideways: then that speed is unknown, too
constexpr double z95 = 1.959964;
constexpr double difference_step = 1e-5;

// What a window's bodies have as unknowns: the ball x, y, vx, vy; a robot x, y, heading, forward,
// turn and, if its wheels slide at the start, the speed to the left.
enum class Start { ball, robot, sliding_robot };

int states_of(Start kind) {
  return kind == Start::ball ? 4 : kind == Start::robot ? 5 : 6;
}

void shift(BodyState& state, Start kind, int which, double by) {
  if (which == 0) state.position.x() += by;
  if (which == 1) state.position.y() += by;
  if (kind == Start::ball) {
    if (which == 2) state.twist.forward += by;
    if (which == 3) state.twist.left += by;
    return;
  }
  if (which == 2) state.heading = Heading::from_angle(state.heading.angle() + by);
  if (which == 3) state.twist.forward += by;
  if (which == 4) state.twist.omega += by;
  if (which == 5) state.twist.left += by;
}

// A window in the fit.
struct Piece {
  const Footage* footage = nullptr;
  Window window;
  std::vector<BodyState> start;
  std::vector<Start> kinds;  // of the starts
  int states = 0;            // unknowns of the starts
  int rows = 0;              // residuals: two or three for each sight
  double square = 0.0;       // of its residuals, weighted
  bool counts = true;        // explained by some start
  std::vector<BodyState> trial;
  MatrixXd gain;  // of the starts on the pitch: A^-1 B
  VectorXd own;   // A^-1 a

  bool is_ball(std::size_t i) const { return window.bodies[i] == footage->ball(); }
};

// Sets the first guess of the starts. Returns false if a body is not seen well enough.
bool find_starts(Piece& piece) {
  piece.start.clear();
  piece.kinds.clear();
  for (std::size_t i = 0; i < piece.window.bodies.size(); ++i) {
    const auto fitted =
        piece.footage->state_at(piece.window.bodies[i], piece.window.first, pictures_of_start, 2);
    if (!fitted) return false;
    const bool slides = std::abs(fitted->state.twist.left) > slides_from;
    piece.start.push_back(fitted->state);
    if (!piece.is_ball(i) && !slides) piece.start.back().twist.left = 0.0;
    piece.kinds.push_back(piece.is_ball(i) ? Start::ball
                          : slides         ? Start::sliding_robot
                                           : Start::robot);
  }
  return true;
}

// The fit of all windows.
class Fit {
 public:
  Fit(const std::vector<Footage>& footages, const Guess& start) : guess_(start) {
    for (const Footage& footage : footages) {
      footages_.push_back(&footage);
      for (Window& window : cut(footage, start.parameters, window_seconds, most_bodies)) {
        add(footage, std::move(window));
      }
    }
    is_free_.fill(true);
    if (start.parameters.grip == simulator::infinite_grip) is_free_[grip_limit] = false;
  }

  bool is_empty() const { return pieces_.empty(); }
  const MatrixXd& information() const { return information_; }
  bool is_free(int unknown) const { return is_free_[unknown]; }
  void set_free(int unknown, bool free) { is_free_[unknown] = free; }
  void tie_turn_lag(bool tied) { turn_is_tied_ = tied; }
  void tie_brake_lag(bool tied) { brake_is_tied_ = tied; }
  double position_sigma() const { return position_sigma_; }
  double heading_sigma() const { return heading_sigma_; }

  // Steps until the cost falls no more. `hard`: outliers are left out rather than weighed down.
  void run(int rounds, bool hard);
  // While only bodies that are alone count: they move smoothly, so they have few minima.
  void count_alone_only(bool alone) { alone_ = alone; }
  // Begins from a few delays of commands and lags of motors, and keeps the best: the cost has
  // several minima in them.
  void scan_delay();
  void describe(Identified& result) const;

 private:
  struct Variant {
    Guess guess;
    std::vector<std::unique_ptr<Rerun>> reruns;  // one for each footage
  };

  void add(const Footage& footage, Window window);
  Guess tied(Guess guess) const;
  Variant variant(const Guess& guess) const;
  void residuals(Variant& variant, const Piece& piece, const std::vector<BodyState>& start,
                 VectorXd& r) const;
  double weigh(const Piece& piece, const VectorXd& r, VectorXd& weight) const;
  void linearise();
  Guess stepped(const std::vector<int>& free, VectorXd& step, double most) const;
  double cost_of_trial(const Guess& guess, const VectorXd& step);
  void estimate_noise();
  std::vector<int> free_unknowns() const;
  bool is_left_out(const Piece& piece) const { return alone_ && piece.window.bodies.size() > 1; }
  bool is_explained(const Piece& piece, const VectorXd& r, const VectorXd& weight) const;

  std::vector<const Footage*> footages_;
  std::vector<Piece> pieces_;
  Guess guess_;
  std::array<bool, unknown_count> is_free_{};
  bool turn_is_tied_ = false;
  bool brake_is_tied_ = false;
  bool hard_ = false;
  bool alone_ = false;
  double position_sigma_ = 0.005;
  double heading_sigma_ = 0.05;
  MatrixXd information_;  // of the free unknowns
  VectorXd gradient_;
  double cost_ = 0.0;
  double damping_ = 1e-3;
};

void Fit::add(const Footage& footage, Window window) {
  Piece piece;
  piece.footage = &footage;
  piece.window = std::move(window);
  Window& w = piece.window;
  // It begins where nothing touches.
  const int latest = w.first + (w.last - w.first) / 2;
  for (; w.first <= latest; w.first += pictures_between_starts) {
    if (!find_starts(piece)) return;
    if (stand_clear(footage, guess_.parameters, w, piece.start, clear_gap)) break;
  }
  if (w.first > latest) return;
  for (std::size_t i = 0; i < w.bodies.size(); ++i) {
    piece.states += states_of(piece.kinds[i]);
    for (int f = w.first; f <= w.last; ++f) {
      if (footage.sight(w.bodies[i], f).is_seen) piece.rows += piece.is_ball(i) ? 2 : 3;
    }
  }
  if (piece.rows > piece.states) pieces_.push_back(std::move(piece));
}

Guess Fit::tied(Guess guess) const {
  if (turn_is_tied_) guess.parameters.turn_time_constant = guess.parameters.motor_time_constant;
  if (brake_is_tied_) guess.parameters.brake_time_constant = guess.parameters.motor_time_constant;
  return guess;
}

Fit::Variant Fit::variant(const Guess& guess) const {
  Variant v{tied(guess), {}};
  for (const Footage* footage : footages_) {
    v.reruns.push_back(std::make_unique<Rerun>(*footage, v.guess));
  }
  return v;
}

// Residuals in standard deviations: simulated minus seen.
void Fit::residuals(Variant& v, const Piece& piece, const std::vector<BodyState>& start,
                    VectorXd& r) const {
  const Footage& footage = *piece.footage;
  const auto which = std::find(footages_.begin(), footages_.end(), &footage) - footages_.begin();
  r.resize(piece.rows);
  int row = 0;
  const auto compare = [&](int frame, std::size_t i, const BodyState& state) {
    const Footage::Sight& seen = footage.sight(piece.window.bodies[i], frame);
    if (!seen.is_seen) return;
    r[row++] = (state.position.x() - seen.position.x()) / position_sigma_;
    r[row++] = (state.position.y() - seen.position.y()) / position_sigma_;
    if (piece.is_ball(i)) return;
    const double turned = state.heading.angle() - seen.heading;
    r[row++] = std::remainder(turned, 2.0 * pi) / heading_sigma_;
  };
  for (std::size_t i = 0; i < start.size(); ++i) compare(piece.window.first, i, start[i]);
  v.reruns[static_cast<std::size_t>(which)]->play(piece.window, start, compare);
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
  return sum;
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
  gradient_ = VectorXd::Zero(n);
  cost_ = 0.0;
  VectorXd r, other, weight;
  for (Piece& piece : pieces_) {
    piece.counts = false;
    if (is_left_out(piece)) continue;
    residuals(base, piece, piece.start, r);
    piece.square = weigh(piece, r, weight);
    piece.counts = is_explained(piece, r, weight);
    MatrixXd by_start(r.size(), piece.states), by_pitch(r.size(), n);
    int column = 0;
    for (std::size_t i = 0; i < piece.start.size(); ++i) {
      for (int s = 0; s < states_of(piece.kinds[i]); ++s) {
        std::vector<BodyState> start = piece.start;
        shift(start[i], piece.kinds[i], s, difference_step);
        residuals(base, piece, start, other);
        by_start.col(column++) = (other - r) / difference_step;
      }
    }
    for (int j = 0; j < n; ++j) {
      residuals(changed[j], piece, piece.start, other);
      by_pitch.col(j) = (other - r) / steps[j];
    }
    const MatrixXd weighted = weight.asDiagonal() * by_start;
    MatrixXd a = by_start.transpose() * weighted;
    a.diagonal() *= 1.0 + damping_;
    a.diagonal().array() += 1e-9;
    const MatrixXd b = weighted.transpose() * by_pitch;
    const Eigen::LDLT<MatrixXd> solver(a);
    piece.gain = solver.solve(b);
    piece.own = solver.solve(weighted.transpose() * r);
    cost_ += std::min(piece.square, unexplained * piece.rows);
    if (!piece.counts || !piece.gain.allFinite() || !by_pitch.allFinite()) continue;
    const MatrixXd weighted_pitch = weight.asDiagonal() * by_pitch;
    information_ += by_pitch.transpose() * weighted_pitch - b.transpose() * piece.gain;
    gradient_ += weighted_pitch.transpose() * r - b.transpose() * piece.own;
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
    if (is_left_out(piece)) continue;
    VectorXd move = -piece.own - piece.gain * step;
    if (!move.allFinite()) move.setZero();
    int k = 0;
    for (std::size_t i = 0; i < piece.trial.size(); ++i) {
      for (int s = 0; s < states_of(piece.kinds[i]); ++s)
        shift(piece.trial[i], piece.kinds[i], s, std::clamp(move[k++], -1.0, 1.0));
    }
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
  scale(positions, position_sigma_, 1e-5);
  scale(headings, heading_sigma_, 1e-4);
}

void Fit::run(int rounds, bool hard) {
  hard_ = hard;
  int quiet = 0;
  for (int round = 0; round < rounds && quiet < 2; ++round) {
    if (!hard || round % 4 == 0) estimate_noise();
    linearise();
    const std::vector<int> free = free_unknowns();
    bool is_better = false;
    for (int attempt = 0; attempt < 6 && !is_better; ++attempt) {
      MatrixXd damped = information_;
      damped.diagonal() *= 1.0 + damping_;
      damped.diagonal().array() += 1e-6;  // what no window tells stays where it is
      VectorXd step = damped.ldlt().solve(-gradient_);
      if (!step.allFinite()) step.setZero();
      const Guess trial = stepped(free, step, 0.1);
      const double cost = cost_of_trial(trial, step);
      if (cost < cost_) {
        is_better = true;
        quiet = cost_ - cost < 1e-6 * cost_ + 0.01 ? quiet + 1 : 0;
        guess_ = trial;
        for (Piece& piece : pieces_) piece.start = piece.trial;
        damping_ = std::max(1e-9, damping_ / 10.0);
      } else {
        damping_ = std::min(1e6, damping_ * 10.0 + 1e-6);
      }
    }
    if (!is_better) {
      damping_ = 1e-4;
      ++quiet;
    }
  }
  damping_ = 0.0;
  linearise();
  damping_ = 1e-4;
}

void Fit::scan_delay() {
  const Guess start = guess_;
  const std::vector<Piece> pieces = pieces_;
  double best = std::numeric_limits<double>::infinity();
  Guess best_guess = guess_;
  std::vector<Piece> best_pieces = pieces;
  // A few windows suffice for that.
  const std::size_t every = std::max<std::size_t>(1, pieces.size() / 150);
  using DelayAndLag = std::pair<double, double>;  // s
  for (const auto& [delay, lag] :
       {DelayAndLag{0.0, 0.05}, DelayAndLag{0.03, 0.05}, DelayAndLag{0.06, 0.05},
        DelayAndLag{0.1, 0.05}, DelayAndLag{0.16, 0.05}, DelayAndLag{0.0, 0.15},
        DelayAndLag{0.04, 0.15}, DelayAndLag{0.1, 0.15}}) {
    pieces_.clear();
    for (std::size_t i = 0; i < pieces.size(); i += every) pieces_.push_back(pieces[i]);
    guess_ = start;
    guess_.command_delay = delay;
    for (const int u : {motor_lag, turn_lag, brake_lag}) set_value(guess_, u, std::log(lag));
    position_sigma_ = 0.005;
    heading_sigma_ = 0.05;
    damping_ = 1e-3;
    hard_ = false;
    for (int round = 0; round < 6; ++round) {
      linearise();
      const std::vector<int> free = free_unknowns();
      MatrixXd damped = information_;
      damped.diagonal() *= 1.001;
      damped.diagonal().array() += 1e-3;
      VectorXd step = damped.ldlt().solve(-gradient_);
      const Guess trial = stepped(free, step, 0.03);
      const double cost = cost_of_trial(trial, step);
      if (cost < cost_) {
        guess_ = trial;
        for (Piece& piece : pieces_) piece.start = piece.trial;
        cost_ = cost;
      }
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

void Fit::describe(Identified& result) const {
  result.guess = tied(guess_);
  result.has_one_lag = turn_is_tied_;
  result.has_brake = !brake_is_tied_ && is_free_[brake_lag];
  double positions = 0.0, headings = 0.0;
  for (const Piece& piece : pieces_) {
    if (!piece.counts) {
      ++result.unexplained;
      continue;
    }
    ++result.windows;
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
  result.position_noise = noise(position_sigma_, median_share * positions);
  result.heading_noise = noise(heading_sigma_, median_share * headings);

  const std::vector<int> free = free_unknowns();
  if (free.empty()) return;
  MatrixXd information = information_;
  // What no window tells makes the matrix singular; a little of itself keeps the rest readable.
  for (int j = 0; j < information.rows(); ++j) information(j, j) += 1e-8;
  const MatrixXd covariance =
      information.ldlt().solve(MatrixXd::Identity(information.rows(), information.cols()));
  const auto place = [&](int unknown) {
    return static_cast<int>(std::find(free.begin(), free.end(), unknown) - free.begin());
  };
  for (std::size_t j = 0; j < free.size(); ++j) {
    const Unknown& u = unknowns()[free[j]];
    const double half = z95 * std::sqrt(std::max(0.0, covariance(j, j)));
    const double value = value_of(result.guess, free[j]);
    if (!(half < u.widest)) {
      result.why_not[free[j]] = "it takes " + std::string(u.needs);
      continue;
    }
    const auto plain = [&](double v) {
      return std::clamp(u.is_ratio ? std::exp(v) : v, u.least, u.most);
    };
    result.known[free[j]] = Estimate{plain(value), plain(value - half), plain(value + half)};
  }
  if (!is_free_[6] || !is_free_[7]) return;
  const int rolling = place(6), viscous = place(7);
  const simulator::Parameters& p = result.guess.parameters;
  Eigen::Vector2d slope{simulator::gravity / 1.4, 0.5 / (1.4 * p.ball_mass)};
  Eigen::Matrix2d both;
  both << covariance(rolling, rolling), covariance(rolling, viscous), covariance(viscous, rolling),
      covariance(viscous, viscous);
  const double value = slope[0] * p.rolling_resistance + slope[1] * p.viscous_friction;
  const double half = z95 * std::sqrt(std::max(0.0, slope.dot(both * slope)));
  result.has_deceleration = half < std::max(0.1, value);
  result.deceleration = {value, value - half, value + half};
}

// Counts what cameras miss, and what is left out as an outlier before the fit.
void count_sights(const std::vector<Recording>& recordings, const std::vector<Footage>& footages,
                  Identified& result) {
  double all = 0.0, unseen = 0.0, left_out = 0.0;
  for (std::size_t k = 0; k < recordings.size(); ++k) {
    const Recording& recording = recordings[k];
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

// What happens between bodies, with everything else as it was found: hits multiply small errors, so
// windows with them would spoil the rest more than they tell about it.
void identify_hits(Fit& fit, Identified& result) {
  fit.count_alone_only(false);
  std::array<bool, unknown_count> were_free{};
  for (int u = 0; u < unknown_count; ++u) {
    were_free[u] = fit.is_free(u);
    const bool is_hit =
        std::find(between_bodies.begin(), between_bodies.end(), u) != between_bodies.end();
    fit.set_free(u, is_hit);
  }
  fit.run(most_rounds, false);
  fit.run(most_rounds, true);
  Identified hits;
  fit.describe(hits);
  for (const int u : between_bodies) {
    result.known[u] = hits.known[u];
    result.why_not[u] = hits.why_not[u];
    set_value(result.guess, u, value_of(hits.guess, u));
  }
  result.windows = hits.windows;
  result.unexplained = hits.unexplained;
  for (int u = 0; u < unknown_count; ++u) fit.set_free(u, were_free[u]);
}

}  // namespace

Result<Identified> identify(const std::vector<Recording>& recordings, const Guess& start) {
  std::vector<Footage> footages;
  footages.reserve(recordings.size());
  for (const Recording& recording : recordings) footages.emplace_back(recording);
  Guess guess = start;
  guess.parameters.turn_time_constant = guess.parameters.turn_lag();
  guess.parameters.brake_time_constant = guess.parameters.brake_lag();
  Fit fit(footages, guess);
  if (fit.is_empty()) {
    return fail(Errc::input, recordings.front().path +
                                 ": no half second of it shows a ball that rolls, or a robot whose "
                                 "commands are known");
  }
  // Bodies that are alone first: they tell everything but what happens between bodies.
  fit.count_alone_only(true);
  for (const int u : between_bodies) fit.set_free(u, false);
  fit.scan_delay();
  fit.run(most_rounds, false);
  fit.run(most_rounds, true);
  Identified result;
  fit.describe(result);
  const bool one_lag = !differs_from_motor_lag(result, turn_lag);
  const bool no_brake = !differs_from_motor_lag(result, brake_lag);
  if (one_lag || no_brake) {
    fit.tie_turn_lag(one_lag);
    fit.tie_brake_lag(no_brake);
    fit.run(most_rounds, true);
    result = {};
    fit.describe(result);
    const char* const same = "no difference from motor_time_constant shows";
    if (one_lag) result.why_not[turn_lag] = same;
    if (no_brake) result.why_not[brake_lag] = same;
  }
  identify_hits(fit, result);
  for (int u = 0; u < unknown_count; ++u) {
    if (result.known[u] || !result.why_not[u].empty()) continue;
    result.why_not[u] = fit.is_free(u) ? "it takes " + std::string(unknowns()[u].needs)
                                       : "the pitch from which the search began has none";
  }
  count_sights(recordings, footages, result);
  return result;
}

}  // namespace mirocup::pitch
