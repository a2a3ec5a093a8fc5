// SPDX-License-Identifier: MIT
#include "server/dds/liveliness.hpp"

#include <gtest/gtest.h>

namespace mirocup::dds {
namespace {

constexpr double usual_step = 1.0;
constexpr double step = 0.05;

struct Host {
  ExcusedTime excused{usual_step};
  double now = 100.0;
  void pass(double seconds, bool is_up, bool any_heard) {
    for (double left = seconds; left > 1e-9; left -= step) {
      now += step;
      excused.look(now, is_up, any_heard);
    }
  }
};

TEST(ExcusedTime, IsNoneWhileTheNetworkWorks) {
  Host host;
  host.pass(10.0, true, true);
  host.pass(10.0, true, false);  // both teams are gone, but not by the host's fault
  EXPECT_EQ(host.excused.total(), 0.0);
  EXPECT_EQ(host.excused.was_down(), 0.0);
}

TEST(ExcusedTime, IsTheTimeWithoutACarrierAndUntilTheTeamsAreBack) {
  Host host;
  host.pass(1.0, true, true);
  host.pass(4.0, false, false);
  EXPECT_NEAR(host.excused.was_down(), 4.0, step);
  host.pass(2.0, true, false);
  EXPECT_NEAR(host.excused.total(), 6.0, step);
  host.pass(1.0, true, true);
  host.pass(9.0, true, false);  // away by themselves
  EXPECT_NEAR(host.excused.total(), 6.0, step);
  EXPECT_NEAR(host.excused.was_down(), 4.0, step);
}

TEST(ExcusedTime, DoesNotLastForEverAfterTheCarrierIsBack) {
  Host host;
  host.pass(1.0, false, false);
  host.pass(60.0, true, false);
  EXPECT_LT(host.excused.total(), 7.0);
}

// Catches a team that pulls the cable between it and the host to excuse its absence.
TEST(ExcusedTime, IsNoneWhileTheOtherTeamIsHeard) {
  Host host;
  host.pass(10.0, false, true);
  EXPECT_EQ(host.excused.total(), 0.0);
}

TEST(ExcusedTime, CountsTheTimeInWhichTheServerStoodStill) {
  Host host;
  host.pass(1.0, true, true);
  host.now += 11.0;  // stopped
  host.excused.look(host.now, true, false);
  EXPECT_NEAR(host.excused.total(), 11.0 - usual_step, 1e-9);
  EXPECT_EQ(host.excused.was_down(), 0.0);
}

}  // namespace
}  // namespace mirocup::dds
