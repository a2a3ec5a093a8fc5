// SPDX-License-Identifier: MIT
//
// The fixture of the laws' tests. A test writes its situation for the left team, which attacks +x;
// the fixture judges it as written and turned by 180 degrees.
#pragma once

#include "tests/support/pitch.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace mirocup::test_support {

class LawTest : public testing::TestWithParam<End> {
 protected:
  // Returns the situation at the end that is tested.
  referee::Situation seen(const referee::Situation& s) const {
    return GetParam() == End::left ? s : half_turned(s);
  }

  // Returns the end, or the team, that the one written in the test stands for.
  End at(End written) const { return GetParam() == End::left ? written : opposite(written); }

  // Judges the situation tick after tick, by `judge`, until something is called. Returns the number
  // of that tick, counted from 1; 0 if nothing is called in 400 ticks (13.2 s).
  template <class Judge>
  int ticks_until_called(const referee::Situation& s, Judge judge,
                         std::optional<referee::Decision>* called = nullptr) const {
    for (int tick = 1; tick <= 400; ++tick) {
      const std::optional<referee::Decision> decision = judge(seen(s));
      if (!decision) continue;
      if (called != nullptr) *called = decision;
      return tick;
    }
    return 0;
  }

  TestPitch pitch_;
};

inline std::string end_name(const testing::TestParamInfo<End>& end) {
  return std::string(to_string(end.param));
}

}  // namespace mirocup::test_support
