// SPDX-License-Identifier: MIT
//
// The Delassus operator J M^-1 J' of a set of contacts: its assembly into the matrix of a problem.
#pragma once

#include "core/simulator/collision/contact_constraint.hpp"
#include "core/simulator/solver/box_qp.hpp"

#include <array>
#include <span>

namespace mirocup::simulator::impact {

// The bodies of several contacts, each with its rows: only contacts that share a body are coupled.
class DelassusOperator {
 public:
  DelassusOperator() { newest_.fill(none); }

  void add(int unknown, const solver::ConstraintRow& row) {
    add(unknown, row.a, row.on_a);
    if (row.b != no_body) add(unknown, row.b, row.on_b);
  }
  // Adds J M^-1 J' to the matrix of a problem, or of equations.
  template <class Matrix>
  void couple(std::span<const solver::InverseMass> mass, Matrix& matrix) const {
    for (std::size_t body = 0; body < mass.size(); ++body) {
      const solver::InverseMass& m = mass[body];
      for (int i = newest_[body]; i != none; i = rows_[i].before) {
        const Row& p = rows_[i];
        const solver::JacobianRow moved{p.row[0] * m.forward, p.row[1] * m.left,
                                        p.row[2] * m.omega};
        for (int j = i; j != none; j = rows_[j].before) {
          const Row& q = rows_[j];
          const double by = moved[0] * q.row[0] + moved[1] * q.row[1] + moved[2] * q.row[2];
          matrix.add_to_a(p.unknown, q.unknown, by);
        }
      }
    }
  }

 private:
  static constexpr int none = -1;
  struct Row {
    solver::JacobianRow row;
    int unknown;
    int before;  // the body's row before this one
  };

  void add(int unknown, int body, const solver::JacobianRow& row) {
    rows_[count_] = {row, unknown, newest_[body]};
    newest_[body] = count_++;
  }

  std::array<int, max_bodies> newest_;
  std::array<Row, 2 * solver::max_unknowns> rows_;
  int count_ = 0;
};

// Sets the matrix of a problem that was reset; row_of(i) is the row of unknown i < count.
template <class RowOf>
void assemble_delassus(int count, RowOf row_of, std::span<const solver::InverseMass> mass,
                       solver::BoxQp& problem) {
  DelassusOperator bodies;
  for (int i = 0; i < count; ++i) bodies.add(i, row_of(i));
  bodies.couple(mass, problem);
  if (!problem.is_large()) return;
  solver::RegularizedQp& soft = problem.warm_start(mass);
  for (int i = 0; i < count; ++i) soft.add(row_of(i));
}

}  // namespace mirocup::simulator::impact
