// SPDX-License-Identifier: MIT
#include "labs/tune/cma_es.hpp"

#include "core/base/math.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mirocup::league {

using Eigen::MatrixXd;
using Eigen::VectorXd;

CmaEs::CmaEs(VectorXd mean, double step, std::uint64_t seed)
    : n_(static_cast<int>(mean.size())), random_(seed), mean_(std::move(mean)), step_(step) {
  const double n = n_;
  population_ = 4 + static_cast<int>(3.0 * std::log(n));
  // Noise ranks few candidates wrongly and many rightly on average.
  population_ = std::max(population_, 6);
  const int parents = population_ / 2;
  weights_ = VectorXd(parents);
  for (int i = 0; i < parents; ++i) {
    weights_[i] = std::log((population_ + 1.0) / 2.0) - std::log(i + 1.0);
  }
  weights_ /= weights_.sum();
  mu_eff_ = 1.0 / weights_.squaredNorm();
  c_sigma_ = (mu_eff_ + 2.0) / (n + mu_eff_ + 5.0);
  d_sigma_ = 1.0 + 2.0 * std::max(0.0, std::sqrt((mu_eff_ - 1.0) / (n + 1.0)) - 1.0) + c_sigma_;
  c_c_ = (4.0 + mu_eff_ / n) / (n + 4.0 + 2.0 * mu_eff_ / n);
  c_1_ = 2.0 / ((n + 1.3) * (n + 1.3) + mu_eff_);
  c_mu_ = std::min(1.0 - c_1_,
                   2.0 * (mu_eff_ - 2.0 + 1.0 / mu_eff_) / ((n + 2.0) * (n + 2.0) + mu_eff_));
  chi_ = std::sqrt(n) * (1.0 - 1.0 / (4.0 * n) + 1.0 / (21.0 * n * n));
  covariance_ = MatrixXd::Identity(n_, n_);
  path_sigma_ = path_c_ = VectorXd::Zero(n_);
}

// Marsaglia's polar method.
double CmaEs::normal() {
  for (;;) {
    const double u = random_.uniform(-1.0, 1.0);
    const double v = random_.uniform(-1.0, 1.0);
    const double s = u * u + v * v;
    if (s > 0.0 && s < 1.0) return u * std::sqrt(-2.0 * log1p(s - 1.0) / s);
  }
}

std::vector<VectorXd> CmaEs::ask() {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(covariance_);
  const VectorXd lengths = eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  std::vector<VectorXd> candidates;
  for (int k = 0; k < population_; ++k) {
    VectorXd z(n_);
    for (double& value : z) value = normal();
    candidates.emplace_back(mean_ + step_ * (eigen.eigenvectors() * lengths.cwiseProduct(z)));
  }
  return candidates;
}

void CmaEs::tell(const std::vector<VectorXd>& candidates, const std::vector<double>& values) {
  ++generation_;
  std::vector<int> order(candidates.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return values[a] > values[b]; });

  const VectorXd old = mean_;
  mean_ = VectorXd::Zero(n_);
  for (int i = 0; i < weights_.size(); ++i) mean_ += weights_[i] * candidates[order[i]];
  const VectorXd move = (mean_ - old) / step_;

  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(covariance_);
  const VectorXd lengths = eigen.eigenvalues().cwiseMax(1e-20).cwiseSqrt();
  const VectorXd white =
      eigen.eigenvectors() * (eigen.eigenvectors().transpose() * move).cwiseQuotient(lengths);
  path_sigma_ =
      (1.0 - c_sigma_) * path_sigma_ + std::sqrt(c_sigma_ * (2.0 - c_sigma_) * mu_eff_) * white;
  const double grown = 1.0 - std::pow(1.0 - c_sigma_, 2.0 * generation_);
  const bool is_steady = path_sigma_.norm() / std::sqrt(grown) < (1.4 + 2.0 / (n_ + 1.0)) * chi_;
  const double h = is_steady ? 1.0 : 0.0;
  path_c_ = (1.0 - c_c_) * path_c_ + h * std::sqrt(c_c_ * (2.0 - c_c_) * mu_eff_) * move;

  MatrixXd of_parents = MatrixXd::Zero(n_, n_);
  for (int i = 0; i < weights_.size(); ++i) {
    const VectorXd y = (candidates[order[i]] - old) / step_;
    of_parents += weights_[i] * y * y.transpose();
  }
  const double lost = (1.0 - h) * c_c_ * (2.0 - c_c_);
  covariance_ = (1.0 - c_1_ - c_mu_ + c_1_ * lost) * covariance_ +
                c_1_ * path_c_ * path_c_.transpose() + c_mu_ * of_parents;
  step_ *= std::exp(std::min(1.0, c_sigma_ / d_sigma_ * (path_sigma_.norm() / chi_ - 1.0)));
}

VectorXd CmaEs::deviations() const {
  return step_ * covariance_.diagonal().cwiseMax(0.0).cwiseSqrt();
}

}  // namespace mirocup::league
