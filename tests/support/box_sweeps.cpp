// SPDX-License-Identifier: MIT
#include "tests/support/box_sweeps.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <vector>

namespace mirocup::test_support {

namespace {

void sweep(const BoxConditions& p, Eigen::VectorXd& x) {
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const double w = p.a.row(i).dot(x) + p.b[i];
    x[i] = std::clamp(x[i] - w / p.a(i, i), p.low[i], p.high[i]);
  }
}

// Solves for the unknowns between their bounds at once; the others keep their values.
Eigen::VectorXd polished(const BoxConditions& p, const Eigen::VectorXd& x) {
  std::vector<Eigen::Index> free;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    if (x[i] > p.low[i] && x[i] < p.high[i]) free.push_back(i);
  }
  if (free.empty()) return x;
  const Eigen::VectorXd residual = p.a * x + p.b;
  const Eigen::VectorXd change =
      p.a(free, free).completeOrthogonalDecomposition().solve(-residual(free));
  Eigen::VectorXd better = x;
  for (std::size_t k = 0; k < free.size(); ++k) {
    const Eigen::Index i = free[k];
    better[i] = std::clamp(x[i] + change[static_cast<Eigen::Index>(k)], p.low[i], p.high[i]);
  }
  return better;
}

}  // namespace

double violation(const BoxConditions& p, const Eigen::VectorXd& x) {
  const Eigen::VectorXd w = p.a * x + p.b;
  double worst = 0.0;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    if (x[i] > p.low[i]) worst = std::max(worst, w[i]);
    if (x[i] < p.high[i]) worst = std::max(worst, -w[i]);
  }
  return worst;
}

void solve_by_sweeps(const BoxConditions& p, Eigen::VectorXd& x) {
  constexpr int rounds = 400;
  constexpr int sweeps_per_round = 10;
  const double enough = 1e-14 * std::max(1e-3, p.b.lpNorm<Eigen::Infinity>());
  for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = std::clamp(x[i], p.low[i], p.high[i]);
  for (int round = 0; round < rounds; ++round) {
    for (int i = 0; i < sweeps_per_round; ++i) sweep(p, x);
    const Eigen::VectorXd better = polished(p, x);
    if (violation(p, better) <= violation(p, x)) x = better;
    if (violation(p, x) <= enough) return;
  }
}

}  // namespace mirocup::test_support
