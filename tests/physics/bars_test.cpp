// SPDX-License-Identifier: MIT
//
// Every bar of the physics in a size that a check can afford. Catches a simulator that is not what
// the model says, in any kind of scene; physics_bars measures the same in full size.
#include "tests/physics/bars.hpp"

#include <gtest/gtest.h>

namespace mirocup::scenes {
namespace {

class PhysicsBars : public testing::TestWithParam<Kind> {};

TEST_P(PhysicsBars, AreMet) {
  for (const Bar& bar : GetParam().measure(Size::small)) {
    if (bar.is_timing) continue;
    EXPECT_TRUE(bar.met()) << bar.scene << ", " << bar.measure << ": " << bar.measured
                           << " instead of at most " << bar.limit;
  }
}

std::string name_of(const testing::TestParamInfo<Kind>& kind) {
  return kind.param.name;
}

INSTANTIATE_TEST_SUITE_P(All, PhysicsBars, testing::ValuesIn(kinds()), name_of);

}  // namespace
}  // namespace mirocup::scenes
