// SPDX-License-Identifier: MIT
#include "server/dds/round_trip.hpp"

#include <gtest/gtest.h>

namespace mirocup::dds {
namespace {

// Plays ticks of 33 ms; a lost state is sent again after the interval of that moment.
void play(RoundTrip& trip, int ticks, double network, int every_lost) {
  for (int t = 0; t < ticks; ++t) {
    const auto tick = static_cast<std::uint32_t>(t);
    const double now = 0.033 * t;
    trip.sent(tick, now);
    const bool is_lost = every_lost > 0 && t % every_lost != 0;
    EXPECT_TRUE(trip.answered(tick, now + network + (is_lost ? trip.resend_after() : 0.0)));
    EXPECT_FALSE(trip.answered(tick, now + 1.0)) << "only the first answer counts";
  }
}

TEST(RoundTrip, SendsAgainSoonOnAFastNetwork) {
  RoundTrip trip;
  EXPECT_EQ(trip.resend_after(), RoundTrip::min_resend_interval);
  play(trip, 100, 0.0002, 0);
  EXPECT_EQ(trip.resend_after(), RoundTrip::min_resend_interval);
}

// Catches states that are sent three times though no packet was lost.
TEST(RoundTrip, WaitsForTheAnswerOnASlowNetwork) {
  RoundTrip trip;
  play(trip, 100, 0.04, 0);
  EXPECT_NEAR(trip.resend_after(), 0.06, 1e-9);
}

// Catches an estimate that grows with each lost packet, so that lost states are sent again too
// late.
TEST(RoundTrip, IsNotMisledByLostPackets) {
  RoundTrip trip;
  play(trip, 200, 0.0002, 4);  // three of four are lost
  EXPECT_EQ(trip.resend_after(), RoundTrip::min_resend_interval);
}

TEST(RoundTrip, ForgetsOldTicksAndFollowsTheNetwork) {
  RoundTrip trip;
  trip.sent(3, 0.0);
  trip.sent(3 + 64, 1.0);
  EXPECT_FALSE(trip.answered(3, 1.1));
  play(trip, 100, 0.0002, 0);
  play(trip, 100, 0.06, 0);
  EXPECT_NEAR(trip.resend_after(), 0.09, 1e-9);
}

}  // namespace
}  // namespace mirocup::dds
