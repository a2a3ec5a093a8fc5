// SPDX-License-Identifier: MIT
//
// The Delassus operator J M^-1 J' of a set of constraint rows: the change of each row's rate for a
// unit impulse along each row (Delassus 1917; Acary and Brogliato 2008). Rows that share no body
// have a zero entry, so the matrix is assembled body by body. Uses solver and model.
#pragma once

#include "core/simulator/collision/contact_constraint.hpp"
#include "core/simulator/solver/box_qp.hpp"

#include <array>
#include <span>

namespace mirocup::simulator::impact {

// The rows of a problem, listed by body. Each body's rows form a linked list, the newest row first.
// Made for one problem; holds at most solver::max_unknowns rows.
class DelassusOperator {
 public:
  // Adds the row of an unknown. Rows must be added with increasing unknowns.
  void add(int unknown, const solver::ConstraintRow& row) {
    add(unknown, row.a, row.on_a);
    if (row.b != no_body) add(unknown, row.b, row.on_b);
  }

  // Adds J M^-1 J' to a matrix by calls of matrix.add_to_a(i, j, value). The matrix is symmetric,
  // so only entries with j <= i are added. `mass` holds the inverse mass of every body.
  template <class Matrix>
  void couple(std::span<const solver::InverseMass> mass, Matrix& matrix) const {
    for_each_body(bodies_, [&](int body) {
      const solver::InverseMass& m = mass[body];
      for (int i = newest_[body]; i != none; i = rows_[i].previous) {
        const Row& p = rows_[i];
        const solver::Vec3 weighted{p.row[0] * m.forward, p.row[1] * m.left, p.row[2] * m.omega};
        for (int j = i; j != none; j = rows_[j].previous) {
          const Row& q = rows_[j];
          const double value =
              weighted[0] * q.row[0] + weighted[1] * q.row[1] + weighted[2] * q.row[2];
          matrix.add_to_a(p.unknown, q.unknown, value);
        }
      }
    });
  }

 private:
  static constexpr int none = -1;
  static constexpr int bodies_per_row = 2;

  // One body's part of a row.
  struct Row {
    solver::JacobianRow row;
    int unknown;
    int previous;  // the body's row that was added before this one, or none
  };

  void add(int unknown, int body, const solver::JacobianRow& row) {
    rows_[count_] = {row, unknown, bodies_[body] ? newest_[body] : none};
    newest_[body] = count_++;
    bodies_.set(body);
  }

  BodySet bodies_;                      // that have a row
  std::array<int, max_bodies> newest_;  // row of each of bodies_
  std::array<Row, bodies_per_row * solver::max_unknowns> rows_;
  int count_ = 0;
};

// Sets the matrix of a problem after its reset(count), and the rows of its warm start if the
// problem is large. row_of(i) returns the row of unknown i.
template <class RowOf>
void assemble_delassus(int count, RowOf row_of, std::span<const solver::InverseMass> mass,
                       solver::BoxQp& problem) {
  DelassusOperator delassus;
  for (int i = 0; i < count; ++i) delassus.add(i, row_of(i));
  delassus.couple(mass, problem);
  if (!problem.is_large()) return;
  solver::RegularizedQp& warm_start = problem.warm_start(mass);
  for (int i = 0; i < count; ++i) warm_start.add(row_of(i));
}

}  // namespace mirocup::simulator::impact
