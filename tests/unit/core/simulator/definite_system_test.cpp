// SPDX-License-Identifier: MIT
//
// Solutions are put back into their equations. Catches rows that are eliminated in pairs but not
// with each other, an odd one that is left out, and a factorisation that a right side spoils.
#include "core/simulator/definite_system.hpp"

#include "core/base/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace mirocup::simulator {
namespace {

TEST(DefiniteSystem, SolvesForSeveralRightSides) {
  constexpr int most = 12;
  DefiniteSystem system(most);
  Random random(1);
  for (int n = 1; n <= most; ++n) {
    // Clear of singular by its diagonal; a third of the entries are zero.
    std::vector<double> a(n * n);
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < i; ++j) {
        a[i * n + j] = a[j * n + i] = random.below(3) == 0 ? 0.0 : random.uniform(-1.0, 1.0);
      }
      a[i * n + i] = n + random.uniform(0.0, 1.0);
    }
    system.reset(n);
    for (int k = 0; k < n; ++k) std::copy_n(&a[k * n], n, system.row(k));
    system.factorise();
    for (int side = 0; side < 3; ++side) {
      std::vector<double> b(n);
      for (double& value : b) value = random.uniform(-1.0, 1.0);
      std::vector<double> x = b;
      system.solve(x.data());
      for (int i = 0; i < n; ++i) {
        double sum = 0.0;
        for (int j = 0; j < n; ++j) sum += a[i * n + j] * x[j];
        EXPECT_NEAR(sum, b[i], 1e-14 * n) << n << " unknowns";
      }
    }
  }
}

}  // namespace
}  // namespace mirocup::simulator
