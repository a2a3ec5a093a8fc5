// SPDX-License-Identifier: MIT
//
// The fixture of the laws' tests. A test writes its situation for the left team, which attacks +x;
// the fixture judges it as written and turned by 180 degrees.
#pragma once

#include "core/referee/occupancy.hpp"
#include "tests/support/pitch.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace mirocup::test_support {

class LawTest : public testing::TestWithParam<End> {
 protected:
  // Returns the situation at the end that is tested.
  referee::TickFacts seen(const referee::TickFacts& s) const {
    return GetParam() == End::left ? s : half_turned(s);
  }

  // Returns the end, or the team, that the one written in the test stands for.
  End at(End written) const { return GetParam() == End::left ? written : opposite(written); }

  // Returns a situation with the ball there, and all robots out of the way.
  referee::TickFacts with_ball(const Vec2& ball) const {
    return empty_situation(pitch_.field, ball);
  }

  // Makes robot 0 of the right team the keeper of its goal area.
  void set_right_keeper() {
    occupancy_.keeper[index_of(at(End::right))] = referee::RobotId{at(End::right), 0};
  }

  // Judges the situation tick after tick, by `judge`, until something is called. Returns the number
  // of that tick, counted from 1; 0 if nothing is called in 400 ticks (13.2 s).
  template <class Judge>
  int ticks_until_called(const referee::TickFacts& s, Judge judge) {
    for (int tick = 1; tick <= 400; ++tick) {
      called_ = judge(seen(s));
      if (called_) return tick;
    }
    return 0;
  }

  // Expects a call against a team, and which team takes the restart, as the test is written.
  void expect_call(const std::optional<referee::Decision>& call, referee::Verdict verdict, End team,
                   std::optional<End> taker = std::nullopt) const {
    ASSERT_TRUE(call);
    EXPECT_EQ(call->verdict, verdict);
    EXPECT_EQ(call->team, at(team));
    EXPECT_EQ(call->taker, taker ? at(*taker) : call->taker);
  }

  TestPitch pitch_;
  referee::Occupancy occupancy_;
  std::optional<referee::Decision> called_;  // by the last ticks_until_called()
};

inline std::string end_name(const testing::TestParamInfo<End>& end) {
  return std::string(to_string(end.param));
}

}  // namespace mirocup::test_support
