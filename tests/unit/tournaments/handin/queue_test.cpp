// SPDX-License-Identifier: MIT
//
// Catches a team that others wait for because it hands in often, two checks of one team at once,
// and a book that loses or doubles a hand-in.
#include "tests/support/temporary_folder.hpp"
#include "tournaments/handin/book.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace mirocup::league {
namespace {

WaitingHandIn hand_in(const std::string& team, int entry) {
  WaitingHandIn handed;
  handed.team = team;
  handed.entry = entry;
  handed.file = "team.so";
  handed.sha256 = "hash";
  handed.bytes = 3;
  handed.at = 1'795'000'000;
  return handed;
}

std::string order_of(HandInQueue queue) {
  std::string order;
  while (const WaitingHandIn* next = queue.next()) {
    order += (order.empty() ? "" : " ") + next->team + std::to_string(next->entry);
    queue.answer(std::string(next->team), next->entry, HandInState::accepted, "");
  }
  return order;
}

TEST(HandInQueue, LetsTeamsTakeTurns) {
  HandInQueue queue;
  for (int entry = 1; entry <= 3; ++entry) queue.add(hand_in("a", entry));
  queue.add(hand_in("b", 1));
  queue.add(hand_in("c", 1));
  queue.add(hand_in("b", 2));
  EXPECT_EQ(queue.before("c", 1), 2);
  EXPECT_EQ(queue.before("a", 3), 5);
  EXPECT_EQ(order_of(queue), "a1 b1 c1 a2 b2 a3");
  queue.begin("a", 1);
  EXPECT_EQ(queue.next()->team, "b") << "a team has one check at a time";
  queue.wait_again("a", 1);
  EXPECT_EQ(queue.next()->team, "a") << "it has kept its place";
  EXPECT_EQ(queue.find("a", 1)->failures, 1);
}

TEST(HandInQueue, LetsNobodyPassByHandingInAgainAtOnce) {
  HandInQueue queue;
  queue.add(hand_in("a", 1));
  queue.add(hand_in("b", 1));
  queue.answer("a", 1, HandInState::refused, "");
  queue.add(hand_in("a", 2));
  queue.add(hand_in("c", 1));
  EXPECT_EQ(order_of(queue), "b1 c1 a2") << "the round of b and c is not over";
  queue.add(hand_in("d", 1));
  queue.add(hand_in("a", 3));
  EXPECT_EQ(order_of(queue).substr(0, 5), "b1 c1");
}

TEST(HandInQueue, KeepsTheFirstAnswer) {
  HandInQueue queue;
  queue.add(hand_in("a", 1));
  queue.answer("a", 1, HandInState::refused, "no");
  queue.answer("a", 1, HandInState::accepted, "yes");
  queue.wait_again("a", 1);
  EXPECT_EQ(queue.find("a", 1)->state, HandInState::refused);
  EXPECT_EQ(queue.find("a", 1)->message, "no");
  EXPECT_EQ(queue.next(), nullptr);
  EXPECT_EQ(queue.unanswered(), 0);
}

class Book : public testing::Test {
 protected:
  Result<HandInBook> open() { return HandInBook::open(disk_, folder_, nullptr); }

  Result<int> take(HandInBook& book, const std::string& team) {
    return book.take(hand_in(team, 0),
                     [this](const std::string& path) { return disk_.write(path, "ELF"); });
  }

  test_support::TemporaryFolder temporary_;
  system::Disk disk_;
  Folder folder_{temporary_ / "."};
};

TEST_F(Book, GoesOnWhereAKilledServerWas) {
  {
    auto book = open();
    ASSERT_TRUE(book) << book.error().what;
    EXPECT_EQ(take(*book, "a").value_or(0), 1);
    EXPECT_EQ(take(*book, "a").value_or(0), 2);
    EXPECT_EQ(take(*book, "b").value_or(0), 1);
    book->begin("a", 1);
    ASSERT_TRUE(book->answer("b", 1, HandInState::refused, "b: no", 1'795'000'001));
    EXPECT_FALSE(open()) << "two processes do not check the same entry";
  }
  auto again = open();
  ASSERT_TRUE(again) << again.error().what;
  EXPECT_EQ(again->queue().unanswered(), 2);
  EXPECT_EQ(again->queue().find("a", 1)->state, HandInState::queued);
  EXPECT_EQ(again->queue().find("b", 1)->message, "b: no");
  EXPECT_EQ(take(*again, "b").value_or(0), 2);
  EXPECT_TRUE(std::filesystem::exists(folder_.library("b", 2)));
}

TEST_F(Book, NumbersNothingTwice) {
  std::filesystem::create_directories(folder_.entry("a", 7));  // of a check that was killed
  auto book = open();
  ASSERT_TRUE(book);
  EXPECT_EQ(take(*book, "a").value_or(0), 8);
  std::filesystem::remove_all(folder_.entries());
  EXPECT_EQ(take(*book, "a").value_or(0), 9);
}

TEST_F(Book, TakesNothingThatWasNotStored) {
  auto book = open();
  ASSERT_TRUE(book);
  const auto failed = book->take(hand_in("a", 0), [](const std::string&) -> Result<void> {
    return fail(Errc::unavailable, "the disk is full");
  });
  EXPECT_FALSE(failed);
  EXPECT_EQ(book->queue().unanswered(), 0);
}

TEST_F(Book, SaysWhichLineIsDamaged) {
  {
    auto book = open();
    ASSERT_TRUE(book && take(*book, "a"));
  }
  std::ofstream(folder_.hand_in_book(), std::ios::app) << "{\"n\":2,\"kind\":\"hand_in\"}\n";
  const auto damaged = open();
  ASSERT_FALSE(damaged);
  EXPECT_EQ(damaged.error().code, Errc::damaged);
  EXPECT_NE(damaged.error().what.find("line 2"), std::string::npos);
}

}  // namespace
}  // namespace mirocup::league
