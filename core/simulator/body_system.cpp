// SPDX-License-Identifier: MIT
#include "core/simulator/body_system.hpp"

#include <algorithm>
#include <bit>

namespace mirocup::simulator {

namespace {

// Calls visit(body) for each bit, in increasing order.
template <class Visit>
void for_each_body(unsigned long bodies, Visit visit) {
  for (; bodies != 0; bodies &= bodies - 1UL) visit(std::countr_zero(bodies));
}

void add_product(const JacobianRow& p, const JacobianRow& q, double weight,
                 std::array<JacobianRow, 3>& to) {
  for (int i = 0; i < 3; ++i) {
    const double by = weight * p[i];
    for (int j = 0; j < 3; ++j) to[i][j] += by * q[j];
  }
}

}  // namespace

BodySystem::BodySystem() : blocks_(max_bodies * max_bodies), fronts_(max_bodies) {}

void BodySystem::reset(const BodySet& bodies, std::span<const InverseMass> mass) {
  bodies_ = bodies.to_ulong();
  for_each_body(bodies_, [&](int i) {
    coupled_[i] = 0;
    coupled_count_[i] = 0;
    Block& own = block(i, i);
    own = {};
    // Infinite for an inverse of zero; that pivot's inverse will be zero again.
    own[0][0] = 1.0 / mass[i].forward;
    own[1][1] = 1.0 / mass[i].left;
    own[2][2] = 1.0 / mass[i].turn;
  });
}

void BodySystem::couple(int body, unsigned long others) {
  for_each_body(others & ~coupled_[body], [&](int other) {
    block(std::max(body, other), std::min(body, other)) = {};
    coupled_[body] |= 1UL << other;
    coupled_[other] |= 1UL << body;
    ++coupled_count_[body];
    ++coupled_count_[other];
  });
}

void BodySystem::add(const CoupledRow& row, double weight) {
  add_product(row.on_a, row.on_a, weight, block(row.a, row.a));
  if (row.b == no_body) return;
  add_product(row.on_b, row.on_b, weight, block(row.b, row.b));
  couple(row.a, 1UL << row.b);
  if (row.a > row.b) {
    add_product(row.on_a, row.on_b, weight, block(row.a, row.b));
  } else {
    add_product(row.on_b, row.on_a, weight, block(row.b, row.a));
  }
}

void BodySystem::factorise() {
  count_ = 0;
  for (unsigned long left = bodies_; left != 0;) {
    int next = std::countr_zero(left);
    for_each_body(left, [&](int i) {
      if (coupled_count_[i] < coupled_count_[next]) next = i;
    });
    left &= ~(1UL << next);
    order_[count_++] = next;
    leave(next);
    gather(next, coupled_[next]);
    eliminate(next);
  }
}

void BodySystem::leave(int body) {
  for_each_body(coupled_[body], [&](int other) {
    coupled_[other] &= ~(1UL << body);
    --coupled_count_[other];
  });
}

void BodySystem::gather(int body, unsigned long others) {
  Front& f = fronts_[body];
  f.others = others;
  for (int r = 0; r < 3; ++r) std::copy_n(block(body, body)[r].begin(), 3, f.row[r].begin());
  int column = 3;
  for_each_body(others, [&](int other) {
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) {
        f.row[r][column + c] = other > body ? block(other, body)[c][r] : block(body, other)[r][c];
      }
    }
    column += 3;
  });
  for (int r = 0; r < 3; ++r) {
    f.inverse_pivot[r] = 1.0 / f.row[r][r];
    for (int below = r + 1; below < 3; ++below) {
      const double by = f.row[r][below] * f.inverse_pivot[r];
      for (int c = below; c < column; ++c) f.row[below][c] -= by * f.row[r][c];
    }
  }
}

// The body's rows from those of all that are coupled with it, which thereby are with each other.
void BodySystem::eliminate(int body) {
  const Front& f = fronts_[body];
  int at = 3;
  for_each_body(f.others, [&](int low) {
    couple(low, f.others & ~(1UL << low));
    Block by;
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) by[r][c] = f.row[r][at + c] * f.inverse_pivot[r];
    }
    int column = at;
    for_each_body(f.others & ~((1UL << low) - 1UL), [&](int high) {
      Block& to = block(high, low);
      for (int r = 0; r < 3; ++r) {
        for (int i = 0; i < 3; ++i) {
          for (int j = 0; j < 3; ++j) to[i][j] -= f.row[r][column + i] * by[r][j];
        }
      }
      column += 3;
    });
    at += 3;
  });
}

void BodySystem::solve(BodyVector& rhs) const {
  for (int k = 0; k < count_; ++k) {
    const Front& f = fronts_[order_[k]];
    JacobianRow& own = rhs[order_[k]];
    for (int r = 0; r < 3; ++r) {
      const double by = own[r] * f.inverse_pivot[r];
      for (int below = r + 1; below < 3; ++below) own[below] -= by * f.row[r][below];
      int column = 3;
      for_each_body(f.others, [&](int other) {
        for (int c = 0; c < 3; ++c) rhs[other][c] -= by * f.row[r][column + c];
        column += 3;
      });
    }
  }
  for (int k = count_ - 1; k >= 0; --k) {
    const Front& f = fronts_[order_[k]];
    JacobianRow& own = rhs[order_[k]];
    for (int r = 2; r >= 0; --r) {
      double sum = own[r];
      for (int c = r + 1; c < 3; ++c) sum -= f.row[r][c] * own[c];
      int column = 3;
      for_each_body(f.others, [&](int other) {
        for (int c = 0; c < 3; ++c) sum -= f.row[r][column + c] * rhs[other][c];
        column += 3;
      });
      own[r] = sum * f.inverse_pivot[r];
    }
  }
}

}  // namespace mirocup::simulator
