// SPDX-License-Identifier: MIT
#include "core/simulator/solver/block_cholesky.hpp"

#include "core/base/assert.hpp"

#include <algorithm>

namespace mirocup::simulator::solver {

namespace {

// Adds weight p^T p to a block on the diagonal. Only its upper triangle is ever read.
void add_square(const Vec3& p, double weight, std::array<Vec3, 3>& to) {
  for (int i = 0; i < 3; ++i) {
    const double by = weight * p[i];
    for (int j = i; j < 3; ++j) to[i][j] += by * p[j];
  }
}

// Adds weight p^T q.
void add_product(const Vec3& p, const Vec3& q, double weight, std::array<Vec3, 3>& to) {
  for (int i = 0; i < 3; ++i) {
    const double by = weight * p[i];
    for (int j = 0; j < 3; ++j) to[i][j] += by * q[j];
  }
}

std::array<Vec3, 3> transposed(const std::array<Vec3, 3>& block) {
  std::array<Vec3, 3> t;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) t[i][j] = block[j][i];
  }
  return t;
}

}  // namespace

BlockCholesky::BlockCholesky() : blocks_(max_bodies * max_bodies), fronts_(max_bodies) {}

void BlockCholesky::reset(const BodySet& bodies, std::span<const InverseMass> mass) {
  spoil(coupled_, coupled_count_, order_);
  spoil_n(blocks_.data(), blocks_.size());
  spoil_n(fronts_.data(), fronts_.size());
  bodies_ = bodies.to_ulong();
  for_each_body(bodies_, [&](int i) {
    coupled_[i] = 0;
    coupled_count_[i] = 0;
    Block& own = block(i, i);
    own = {};
    // An inverse mass of zero gives an infinite pivot, whose inverse is zero again.
    own[0][0] = 1.0 / mass[i].forward;
    own[1][1] = 1.0 / mass[i].left;
    own[2][2] = 1.0 / mass[i].omega;
  });
}

void BlockCholesky::couple(int body, BodyMask others) {
  for_each_body(others & ~coupled_[body], [&](int other) {
    block(std::max(body, other), std::min(body, other)) = {};
    coupled_[body] |= 1UL << other;
    coupled_[other] |= 1UL << body;
    ++coupled_count_[body];
    ++coupled_count_[other];
  });
}

void BlockCholesky::add(const ConstraintRow& row, double weight) {
  MIROCUP_ASSERT(row.a != no_body && row.a != row.b);
  add_square(row.on_a, weight, block(row.a, row.a));
  if (row.b == no_body) return;
  add_square(row.on_b, weight, block(row.b, row.b));
  couple(row.a, 1UL << row.b);
  if (row.a > row.b) {
    add_product(row.on_a, row.on_b, weight, block(row.a, row.b));
  } else {
    add_product(row.on_b, row.on_a, weight, block(row.b, row.a));
  }
}

void BlockCholesky::factorise() {
  count_ = 0;
  for (BodyMask left = bodies_; left != 0;) {
    int next = std::countr_zero(left);  // the body of the smallest degree; on a tie the first
    for_each_body(left, [&](int i) {
      if (coupled_count_[i] < coupled_count_[next]) next = i;
    });
    left &= ~(1UL << next);
    order_[count_++] = next;
    detach(next);
    assemble_front(next, coupled_[next]);
    eliminate(next);
  }
}

void BlockCholesky::detach(int body) {
  for_each_body(coupled_[body], [&](int other) {
    coupled_[other] &= ~(1UL << body);
    --coupled_count_[other];
  });
}

// Collects the rows of `body` from the blocks and eliminates within them: each of its three
// unknowns from its rows below.
void BlockCholesky::assemble_front(int body, BodyMask others) {
  Front& f = fronts_[body];
  f.others = others;
  f.own = block(body, body);
  int count = 0;
  for_each_body(others, [&](int other) {
    f.off_diagonal[count++] = other > body ? transposed(block(other, body)) : block(body, other);
  });
  for (int r = 0; r < 3; ++r) {
    f.inverse_pivot[r] = 1.0 / f.own[r][r];
    for (int below = r + 1; below < 3; ++below) {
      const double by = f.own[r][below] * f.inverse_pivot[r];
      for (int c = below; c < 3; ++c) f.own[below][c] -= by * f.own[r][c];
      for (int k = 0; k < count; ++k) {
        for (int c = 0; c < 3; ++c) f.off_diagonal[k][below][c] -= by * f.off_diagonal[k][r][c];
      }
    }
  }
}

// Eliminates the body from the rows of all others that it is coupled with: subtracts F^T P^-1 F,
// where F are the off-diagonal blocks of its front and P its pivots. The others are thereby coupled
// with each other (the fill-in).
void BlockCholesky::eliminate(int body) {
  const Front& f = fronts_[body];
  int at = 0;
  for_each_body(f.others, [&](int low) {
    couple(low, f.others & ~(1UL << low));
    Block by = f.off_diagonal[at];  // P^-1 F, the part of `low`
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) by[r][c] *= f.inverse_pivot[r];
    }
    int off_diagonal = at;
    for_each_body(f.others & ~((1UL << low) - 1UL), [&](int high) {
      const Block& rows = f.off_diagonal[off_diagonal++];
      Block& to = block(high, low);
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
          to[i][j] -= rows[0][i] * by[0][j] + rows[1][i] * by[1][j] + rows[2][i] * by[2][j];
        }
      }
    });
    ++at;
  });
}

void BlockCholesky::solve(BodyVector& rhs) const {
  // Forward substitution, in the order of elimination.
  for (int k = 0; k < count_; ++k) {
    const Front& f = fronts_[order_[k]];
    Vec3& own = rhs[order_[k]];
    Vec3 by;
    for (int r = 0; r < 3; ++r) {
      by[r] = own[r] * f.inverse_pivot[r];
      for (int below = r + 1; below < 3; ++below) own[below] -= by[r] * f.own[r][below];
    }
    const Block* off_diagonal = f.off_diagonal.data();
    for_each_body(f.others, [&](int other) {
      const Block& rows = *off_diagonal++;
      for (int c = 0; c < 3; ++c) {
        rhs[other][c] -= by[0] * rows[0][c] + by[1] * rows[1][c] + by[2] * rows[2][c];
      }
    });
  }
  // Back substitution, which also divides by the pivots.
  for (int k = count_ - 1; k >= 0; --k) {
    const Front& f = fronts_[order_[k]];
    Vec3& own = rhs[order_[k]];
    const Block* off_diagonal = f.off_diagonal.data();
    for_each_body(f.others, [&](int other) {
      const Block& rows = *off_diagonal++;
      const Vec3& v = rhs[other];
      for (int r = 0; r < 3; ++r) {
        own[r] -= rows[r][0] * v[0] + rows[r][1] * v[1] + rows[r][2] * v[2];
      }
    });
    for (int r = 2; r >= 0; --r) {
      for (int c = r + 1; c < 3; ++c) own[r] -= f.own[r][c] * own[c];
      own[r] *= f.inverse_pivot[r];
    }
  }
}

}  // namespace mirocup::simulator::solver
