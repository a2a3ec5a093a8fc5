// SPDX-License-Identifier: MIT
#include "server/dds/inbox.hpp"

#include <gtest/gtest.h>

namespace mirocup::dds {
namespace {

TEST(Inbox, TakesTheFirstAnswerToThePresentTick) {
  Inbox inbox;
  inbox.expect(7);
  EXPECT_TRUE(inbox.accept(7));
  EXPECT_FALSE(inbox.accept(7));
  inbox.expect(8);
  EXPECT_FALSE(inbox.accept(7));
  EXPECT_TRUE(inbox.accept(8));
  EXPECT_EQ(inbox.counts().in_step, 2U);
  EXPECT_EQ(inbox.counts().duplicate, 2U);
}

TEST(Inbox, CountsLateAndEarlyCommandsByKind) {
  Inbox inbox;
  inbox.expect(7);
  EXPECT_FALSE(inbox.accept(6));
  EXPECT_FALSE(inbox.accept(8));
  EXPECT_FALSE(inbox.accept(0xffffffffU));
  inbox.count_foreign();
  inbox.expect(8);
  EXPECT_TRUE(inbox.accept(8));  // the inbox does not keep a command that came too early
  EXPECT_EQ(inbox.counts().late, 1U);
  EXPECT_EQ(inbox.counts().ahead, 2U);
  EXPECT_EQ(inbox.counts().foreign, 1U);
  EXPECT_EQ(inbox.counts().in_step, 1U);
}

}  // namespace
}  // namespace mirocup::dds
