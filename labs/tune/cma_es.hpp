// SPDX-License-Identifier: MIT
//
// CMA-ES: searches for the maximum of a function of a few numbers, of which only noisy samples are
// known. The search draws candidates from a normal distribution, ranks them, and moves mean and
// covariance towards the better half.
//
// The algorithm is that of N. Hansen, "The CMA Evolution Strategy: A Tutorial", arXiv:1604.00772,
// with the constants of table 1 there and without negative weights.
#pragma once

#include "core/base/random.hpp"

#include <Eigen/Core>

#include <vector>

namespace mirocup::league {

class CmaEs {
 public:
  // Starts at `mean` with the standard deviation `step` in all directions.
  CmaEs(Eigen::VectorXd mean, double step, std::uint64_t seed);

  // Draws the candidates of a generation.
  std::vector<Eigen::VectorXd> ask();

  // Updates the distribution from the values of the candidates, in the order of ask(). Greater
  // values are better.
  void tell(const std::vector<Eigen::VectorXd>& candidates, const std::vector<double>& values);

  const Eigen::VectorXd& mean() const { return mean_; }
  // Returns the standard deviation along each axis.
  Eigen::VectorXd deviations() const;

 private:
  double normal();

  int n_ = 1;
  int population_ = 0;       // lambda
  Eigen::VectorXd weights_;  // weights of the better half, the best candidate first; their sum is 1
  double mu_eff_ = 1.0;
  double c_sigma_ = 0.0, d_sigma_ = 1.0;       // control of the step
  double c_c_ = 0.0, c_1_ = 0.0, c_mu_ = 0.0;  // control of the covariance
  double chi_ = 1.0;                           // expected length of a normal vector
  Random random_;
  Eigen::VectorXd mean_;
  double step_ = 1.0;  // sigma
  Eigen::MatrixXd covariance_;
  Eigen::VectorXd path_sigma_, path_c_;
  int generation_ = 0;
};

}  // namespace mirocup::league
