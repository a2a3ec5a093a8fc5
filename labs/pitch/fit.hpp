// SPDX-License-Identifier: MIT
//
// Least squares over windows: the step of identification that moves the numbers of a pitch until
// the simulated bodies move as in the pictures (identify.hpp describes the method).
#pragma once

#include "labs/pitch/unknowns.hpp"
#include "labs/pitch/windows.hpp"

#include <Eigen/Core>

#include <array>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace mirocup::pitch {

// A window in the fit. Its bodies have unknowns at its start: the ball x, y, vx, vy; a robot x, y,
// heading, forward, turn and, if wheels may slide, its sideways speed. If the wheels hold in the
// simulation, nothing depends on the sideways speed, so a separate residual keeps that speed near
// 0.
struct Piece {
  const Footage* footage = nullptr;
  Window window;
  std::vector<simulator::BodyState> start;
  std::array<bool, unknown_count> tells{};  // true: the window depends on this number of the pitch
  int states = 0;                           // number of unknowns in `start`
  // Residuals: 2 for each sight of the ball, 3 for each of a robot, 1 for each sideways speed.
  int rows = 0;
  double square = 0.0;  // weighted sum of the squared residuals
  bool counts = true;   // false: no start fits the pictures of the window
  std::vector<simulator::BodyState> trial;
  Eigen::MatrixXd gain;  // minus the derivatives of `start` by the numbers of the pitch
  Eigen::VectorXd own;   // minus the step of `start` with the pitch fixed

  bool is_ball(std::size_t i) const { return window.bodies[i] == footage->ball(); }
  bool may_slide(std::size_t i) const { return window.may_slide && !is_ball(i); }
};

// Standard deviations of the camera's noise: of a coordinate (m) and of a heading (rad).
struct Noise {
  double position = 0.005;
  double heading = 0.05;
};

class Fit {
 public:
  Fit(const Guess& start, const Noise& noise) : guess_(start), noise_(noise) {}

  // Adds a window, unless too few pictures show its bodies at the start, or a body touches
  // something at the start.
  void add(const Footage& footage, Window window);
  // Ends windows of several bodies a little after their first impact in the simulator, because each
  // further impact multiplies errors. Windows without an impact tell nothing about impacts, and are
  // dropped.
  void end_after_impacts();

  bool is_empty() const { return pieces_.empty(); }
  const std::vector<Piece>& pieces() const { return pieces_; }
  Guess guess() const { return tied(guess_); }
  const Noise& noise() const { return noise_; }
  void set_noise_known(bool known) { noise_is_known_ = known; }

  // Sets whether an unknown is searched. If the lag of turning is tied, it equals the lag of
  // driving.
  void set_free(int unknown, bool free) { is_free_[unknown] = free; }
  bool is_free(int unknown) const { return is_free_[unknown]; }
  void tie_turn_lag(bool tied) { turn_is_tied_ = tied; }
  void tie_brake_lag(bool tied) { brake_is_tied_ = tied; }
  bool turn_lag_is_tied() const { return turn_is_tied_; }
  bool brake_lag_is_tied() const { return brake_is_tied_; }
  std::vector<int> free_unknowns() const;

  // Fits some of the windows from each guess, and keeps the best result, because the cost can have
  // several minima.
  void choose(std::span<const Guess> guesses);
  // Steps until the cost no longer falls. `hard`: outliers are dropped instead of getting less
  // weight.
  void run(bool hard);
  // Tries other starts for windows that their present starts explain badly, because the cost of a
  // window can have several minima: for example one for each edge with which a robot may hit first.
  void retry();
  // Returns the least cost of the windows that depend on an unknown, for each of `values` of the
  // unknown, with the other numbers of the pitch fixed. A sweep upwards and a sweep downwards find
  // the best starts of each window. If the best of these values is better than the present value,
  // profile() sets the unknown to the best value.
  struct Profile {
    std::vector<double> values, costs;
    std::vector<std::vector<double>> parts;  // cost of each window at each value

    int windows() const { return static_cast<int>(parts.size()); }
  };
  Profile profile(int unknown, std::vector<double> values);
  // Computes the equations of all windows at the present guess.
  void linearise();
  // Returns the inverse of the covariance of the free unknowns, in their order.
  const Eigen::MatrixXd& information() const { return information_; }
  // The information of one window about the free unknowns, and the gradient of the window's cost.
  struct Told {
    Eigen::MatrixXd information;
    Eigen::VectorXd gradient;
  };
  const std::vector<Told>& told() const { return told_; }

 private:
  struct Variant {
    Guess guess;
    std::map<const Footage*, std::unique_ptr<Rerun>> reruns;
  };

  Guess tied(Guess guess) const;
  Variant variant(const Guess& guess) const;
  void residuals(Variant& variant, const Piece& piece,
                 const std::vector<simulator::BodyState>& start, Eigen::VectorXd& r) const;
  double weigh(const Piece& piece, const Eigen::VectorXd& r, Eigen::VectorXd& weight) const;
  bool is_explained(const Piece& piece, const Eigen::VectorXd& r,
                    const Eigen::VectorXd& weight) const;
  Eigen::MatrixXd slopes_by_start(Variant& variant, const Piece& piece,
                                  const Eigen::VectorXd& r) const;
  bool depends_on(std::span<Variant> variants, const Piece& piece) const;
  void settle(Variant& variant, Piece& piece);
  double capped_cost(Variant& variant, const Piece& piece);
  void try_other_starts(Variant& variant, Piece& piece);
  bool step(double most);
  Guess stepped(const std::vector<int>& free, Eigen::VectorXd& step, double most) const;
  double cost_of_trial(const Guess& guess, const Eigen::VectorXd& step);
  void estimate_noise();
  void count_rows(Piece& piece) const;

  std::vector<Piece> pieces_;
  Guess guess_;
  Noise noise_;
  std::array<bool, unknown_count> is_free_{};
  bool noise_is_known_ = false;
  bool turn_is_tied_ = false;
  bool brake_is_tied_ = false;
  bool hard_ = false;
  Eigen::MatrixXd information_;
  std::vector<Told> told_;  // an entry for each window that counts
  Eigen::VectorXd gradient_;
  double cost_ = 0.0;
  double damping_ = 1e-3;
};

}  // namespace mirocup::pitch
