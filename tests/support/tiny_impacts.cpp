// SPDX-License-Identifier: MIT
//
// The impacts of a TinyWorld.
#include "tests/support/box_sweeps.hpp"
#include "tests/support/tiny_world.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace mirocup::test_support {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Slower approaches (m/s) do not bounce.
constexpr double rest_speed = 2e-5;

// Approaches below this (m/s) are rounding.
constexpr double no_approach = 1e-10;

}  // namespace

// A contact that is not closed yet when the step ends is no impact yet.
bool TinyWorld::any_impact(const Contacts& contacts, double h) const {
  const Rows rows = rows_of(contacts, bodies_);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (-rate(rows[i], bodies_) > rest_speed + std::max(contacts[i].at.gap, 0.0) / h) return true;
  }
  return false;
}

// Contacts that have no body in common, directly or through others, are resolved independently.
void TinyWorld::resolve_impacts(const Contacts& contacts) {
  ++impacts_;
  std::vector<int> group(bodies_.size());
  std::iota(group.begin(), group.end(), 0);
  for (std::size_t round = 0; round < bodies_.size(); ++round) {
    for (const TinyContact& c : contacts) {
      if (c.b >= 0) group[c.a] = group[c.b] = std::min(group[c.a], group[c.b]);
    }
  }
  const Rows rows = rows_of(contacts, bodies_);
  for (int leader = 0; leader < static_cast<int>(bodies_.size()); ++leader) {
    Rows own;
    std::vector<double> restitution;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      if (group[contacts[i].a] != leader) continue;
      own.push_back(rows[i]);
      restitution.push_back(contacts[i].restitution);
    }
    if (!own.empty()) resolve_cluster(own, restitution);
  }
}

double TinyWorld::kinetic_energy_in_impact() const {
  double sum = kinetic_energy();
  if (p_.grip != simulator::infinite_grip) return sum;
  for (int i = 0; i < robots_; ++i) {
    if (!has_wheels(i)) continue;
    const Vec2 forward{std::cos(bodies_[i].angle), std::sin(bodies_[i].angle)};
    const double left =
        -forward.y() * bodies_[i].velocity[0] + forward.x() * bodies_[i].velocity[1];
    sum -= 0.5 * p_.robot_mass * left * left;
  }
  return sum;
}

// Stops all approaching contacts, multiplies the impulses by 1 + e, and repeats until none
// approaches.
void TinyWorld::resolve_cluster(const Rows& rows, const std::vector<double>& restitution) {
  const Eigen::Index n = static_cast<Eigen::Index>(rows.size());
  const auto add_impulse = [&](const Row& row, double impulse) {
    bodies_[row.a].velocity += impulse * inverse_mass_in_impact(row.a) * row.along_a.transpose();
    if (row.b < 0) return;
    bodies_[row.b].velocity += impulse * inverse_mass_in_impact(row.b) * row.along_b.transpose();
  };
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Bodies before = bodies_;
    for (Body& body : bodies_) body.velocity.setZero();
    add_impulse(rows[j], 1.0);
    for (Eigen::Index i = 0; i < n; ++i) all(i, j) = rate(rows[i], bodies_);
    bodies_ = before;
  }

  constexpr int most_rounds = 64;
  for (int round = 0; round <= most_rounds; ++round) {
    std::vector<Eigen::Index> approaching;
    double fastest = 0.0;
    double least = 1.0;
    for (Eigen::Index i = 0; i < n; ++i) {
      const double approach = -rate(rows[i], bodies_);
      fastest = std::max(fastest, approach);
      if (approach <= no_approach) continue;
      approaching.push_back(i);
      least = std::min(least, restitution[i]);
    }
    if (approaching.empty()) return;
    const bool is_last = round == most_rounds || fastest <= rest_speed;
    if (is_last) {
      approaching.resize(static_cast<std::size_t>(n));
      std::iota(approaching.begin(), approaching.end(), 0);
    }
    const Eigen::Index m = static_cast<Eigen::Index>(approaching.size());
    BoxConditions problem{all(approaching, approaching), Eigen::VectorXd::Zero(m),
                          Eigen::VectorXd::Zero(m), Eigen::VectorXd::Constant(m, infinity)};
    for (Eigen::Index k = 0; k < m; ++k) problem.b[k] = rate(rows[approaching[k]], bodies_);
    Eigen::VectorXd stops = Eigen::VectorXd::Zero(m);
    solve_by_sweeps(problem, stops);

    const Bodies before = bodies_;
    const double energy = kinetic_energy_in_impact();
    const auto throw_back = [&](auto e) {
      for (Eigen::Index k = 0; k < m; ++k) {
        add_impulse(rows[approaching[k]], (1.0 + e(approaching[k])) * stops[k]);
      }
    };
    if (is_last) {
      throw_back([](Eigen::Index) { return 0.0; });
      return;
    }
    throw_back([&](Eigen::Index i) { return restitution[i]; });
    if (kinetic_energy_in_impact() > energy * (1.0 + 1e-12)) {
      bodies_ = before;
      throw_back([&](Eigen::Index) { return least; });
    }
  }
}

}  // namespace mirocup::test_support
