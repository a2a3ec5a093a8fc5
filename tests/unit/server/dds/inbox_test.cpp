// SPDX-License-Identifier: MIT
#include "server/dds/inbox.hpp"

#include <gtest/gtest.h>

namespace mirocup::dds {
namespace {

TEST(Inbox, TakesTheFirstAnswerToThePresentTick) {
  Inbox inbox;
  inbox.expect(7);
  EXPECT_EQ(inbox.sort(7), Arrival::in_step);
  EXPECT_EQ(inbox.sort(7), Arrival::repeated);
  inbox.expect(8);
  EXPECT_EQ(inbox.sort(7), Arrival::repeated);
  EXPECT_EQ(inbox.sort(8), Arrival::in_step);
  EXPECT_EQ(inbox.counts().in_step, 2U);
  EXPECT_EQ(inbox.counts().duplicate, 2U);
}

TEST(Inbox, CountsLateAndEarlyCommandsByKind) {
  Inbox inbox;
  inbox.expect(7);
  EXPECT_EQ(inbox.sort(6), Arrival::late);
  EXPECT_EQ(inbox.sort(8), Arrival::ahead);
  EXPECT_EQ(inbox.sort(0xffffffffU), Arrival::ahead);
  inbox.count_foreign();
  inbox.expect(8);
  EXPECT_EQ(inbox.sort(8), Arrival::in_step);  // a command that came too early is not kept
  EXPECT_EQ(inbox.counts().late, 1U);
  EXPECT_EQ(inbox.counts().ahead, 2U);
  EXPECT_EQ(inbox.counts().foreign, 1U);
  EXPECT_EQ(inbox.counts().in_step, 1U);
}

// Catches a process that sends an old command for ever and counts as present, and an older command
// that is driven after a newer one.
TEST(Inbox, TakesOfLateCommandsOnlyNewerOnes) {
  Inbox inbox;
  inbox.expect(20);
  EXPECT_EQ(inbox.sort(17), Arrival::late);
  EXPECT_EQ(inbox.sort(17), Arrival::old);
  EXPECT_EQ(inbox.sort(16), Arrival::old);
  EXPECT_EQ(inbox.sort(19), Arrival::late);
  EXPECT_EQ(inbox.sort(20), Arrival::in_step);
  inbox.expect(21);
  EXPECT_EQ(inbox.sort(19), Arrival::old);
  inbox.end_tick();  // the server listens while it waits for the other team
  EXPECT_EQ(inbox.sort(21), Arrival::late);
  EXPECT_EQ(inbox.counts().late, 6U);
}

TEST(Inbox, DrivesCommandsUpToSixTicksOld) {
  Inbox inbox;
  inbox.expect(20);
  EXPECT_TRUE(inbox.may_be_driven(19));
  EXPECT_TRUE(inbox.may_be_driven(20 - max_late_ticks));
  EXPECT_FALSE(inbox.may_be_driven(19 - max_late_ticks));
  EXPECT_FALSE(inbox.may_be_driven(21));
  inbox.expect(2);
  EXPECT_TRUE(inbox.may_be_driven(0));
}

}  // namespace
}  // namespace mirocup::dds
