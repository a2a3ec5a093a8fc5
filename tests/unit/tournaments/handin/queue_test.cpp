// SPDX-License-Identifier: MIT
//
// Catches a team that others wait for because it hands in often or slow files, two checks of one
// team at once, and a book that loses or doubles a hand-in.
#include "tests/support/is_ok.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tournaments/handin/book.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>

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
  EXPECT_EQ(queue.find("a", 1)->times(NoAnswer::host_failed), 1);
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

// A queue of two processors on a clock of its own. Each hand-in needs some seconds of processor
// time for its check; one that gives way begins anew.
class Hall {
 public:
  void hand_in_at(double time, const std::string& team, int entry, double needed) {
    coming_.push_back({time, hand_in(team, entry)});
    needed_[{team, entry}] = needed;
  }

  // Returns when each hand-in had its answer, s.
  std::map<std::string, double> run() {
    constexpr double step = 0.25;
    std::map<std::string, double> answered;
    for (time_ = 0.0; time_ < 3600.0 && answered.size() < needed_.size(); time_ += step) {
      for (const auto& [at, handed] : coming_) {
        if (at == time_) queue_.add(handed);
      }
      for (auto& check : running_) check.processor += step;
      for (const RunningCheck& check : running_) {
        if (check.processor < needed_.at({check.team, check.entry})) continue;
        answered[check.team + std::to_string(check.entry)] = time_;
        queue_.answer(check.team, check.entry, HandInState::accepted, "");
      }
      std::erase_if(running_, [&](const RunningCheck& check) {
        return is_final(queue_.find(check.team, check.entry)->state);
      });
      if (running_.size() == 2) stop_one();
      while (running_.size() < 2 && queue_.next() != nullptr) {
        const WaitingHandIn next = *queue_.next();
        queue_.begin(next.team, next.entry);
        running_.push_back({.team = next.team, .entry = next.entry});
        ++begun[next.team];
      }
      std::set<std::string> teams;
      for (const RunningCheck& check : running_)
        EXPECT_TRUE(teams.insert(check.team).second) << "two checks of one team at once";
    }
    return answered;
  }

  std::map<std::string, int> begun;  // checks of each team

 private:
  void stop_one() {
    const WaitingHandIn* stopped = queue_.to_stop(running_);
    if (stopped == nullptr) return;
    const std::string team = stopped->team;
    queue_.wait_again(team, stopped->entry, NoAnswer::gave_way);
    std::erase_if(running_, [&](const RunningCheck& c) { return c.team == team; });
  }

  HandInQueue queue_;
  std::vector<std::pair<double, WaitingHandIn>> coming_;
  std::map<std::pair<std::string, int>, double> needed_;  // s
  std::vector<RunningCheck> running_;
  double time_ = 0.0;
};

// Catches checks that keep all processors for as long as they like, and, in the last line, a check
// that gives way again and again and never ends.
TEST(HandInQueue, LongChecksGiveWayAndComeToTheirEnd) {
  Hall hall;
  for (int entry = 1; entry <= 4; ++entry) {
    hall.hand_in_at(0.0, "a", entry, 40.0);
    hall.hand_in_at(0.0, "b", entry, 40.0);
  }
  for (int entry = 1; entry <= 30; ++entry) hall.hand_in_at(1.0 + 7.0 * entry, "c", entry, 2.0);
  const auto answered = hall.run();
  EXPECT_EQ(answered.size(), 38u);
  for (int entry = 1; entry <= 30; ++entry)
    EXPECT_LE(answered.at("c" + std::to_string(entry)) - (1.0 + 7.0 * entry), 6.0) << entry;
  // One after the other on the processor where they are left alone.
  for (const char* team : {"a", "b"}) {
    for (const char* entry : {"1", "2", "3", "4"})
      EXPECT_LE(answered.at(std::string(team) + entry), 8 * 40.0 + 60.0);
  }
}

// Catches a long check that starves while short ones of many teams keep coming.
TEST(HandInQueue, ALongCheckEndsWhileOthersKeepComing) {
  Hall hall;
  hall.hand_in_at(0.0, "slow", 1, 20.0);
  for (int i = 0; i < 200; ++i)
    hall.hand_in_at(1.0 * i, "t" + std::to_string(i % 20), 1 + i / 20, 2.5);
  const auto answered = hall.run();
  ASSERT_TRUE(answered.contains("slow1"));
  EXPECT_LE(answered.at("slow1"), 120.0) << "three rounds of 20 teams, and its own time";
  EXPECT_LE(hall.begun.at("slow"), 1 + HandInQueue::gives_way_at_most);
}

TEST(HandInQueue, NothingGivesWayWhereNobodyWaits) {
  Hall hall;
  hall.hand_in_at(0.0, "a", 1, 40.0);
  hall.hand_in_at(0.0, "b", 1, 40.0);
  hall.hand_in_at(0.0, "b", 2, 1.0);  // of a team that is being checked
  EXPECT_EQ(hall.run().at("a1"), 40.0);
  EXPECT_EQ(hall.begun.at("a"), 1);
}

// Catches a check that sleeps and so never uses processor time.
TEST(HandInQueue, ASleepingCheckGivesWay) {
  HandInQueue queue;
  queue.add(hand_in("a", 1));
  queue.begin("a", 1);
  RunningCheck check{.team = "a", .entry = 1, .processor = 0.1, .asleep = 2.5};
  EXPECT_EQ(queue.to_stop({check}), nullptr) << "nobody waits";
  queue.add(hand_in("b", 1));
  EXPECT_EQ(queue.to_stop({check}), nullptr);
  check.asleep = 3.0;
  ASSERT_NE(queue.to_stop({check}), nullptr);
  queue.wait_again("a", 1, NoAnswer::gave_way);
  EXPECT_EQ(queue.next()->team, "b");
  EXPECT_EQ(queue.find("a", 1)->times(NoAnswer::host_failed), 0) << "it is not the host's fault";
  check = {.team = "b", .entry = 1, .processor = 3.5, .asleep = 0.0};
  queue.begin("b", 1);
  ASSERT_NE(queue.to_stop({check}), nullptr) << "a waits again";
}

TEST(HandInQueue, CountsChecksThatUseUpTheirTime) {
  HandInQueue queue;
  queue.add(hand_in("a", 1));
  queue.add(hand_in("b", 1));
  queue.begin("a", 1);
  queue.wait_again("a", 1, NoAnswer::spent);
  EXPECT_EQ(queue.find("a", 1)->times(NoAnswer::spent), 1);
  EXPECT_EQ(queue.next()->team, "b") << "it waits behind the others";
  queue.wait_again("a", 1, NoAnswer::spent);
  EXPECT_EQ(queue.find("a", 1)->times(NoAnswer::spent), 2);
}

TEST(CompileTime, IsShorterAfterASourceThatWasNotCompiledInTime) {
  CompileTime time;
  EXPECT_EQ(time.of("a"), 60);
  time.note("a", false, 2.0);  // a mistake of the language
  EXPECT_EQ(time.of("a"), 60);
  time.note("a", true, 45.0);  // an honest large project
  EXPECT_EQ(time.of("a"), 60);
  time.note("a", false, 60.0);
  EXPECT_EQ(time.of("a"), 20);
  EXPECT_EQ(time.of("b"), 60);
  time.note("a", false, 20.0);
  EXPECT_EQ(time.of("a"), 20);
  time.note("a", true, 3.0);
  EXPECT_EQ(time.of("a"), 60);
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

TEST(Friendlies, NumbersTheLegsOfEachTeam) {
  Friendlies legs;
  EXPECT_EQ(legs.last_number("b"), 0);
  for (int i = 1; i <= 40'000; ++i) {
    EXPECT_EQ(legs.last_number("b"), i - 1);
    legs.add({.team = "b", .number = i, .entry = 1, .opponent = "house:idle"});
    legs.finish("b", i, FriendlyState::played, 0, 0, "full_time");
  }
  EXPECT_EQ(legs.last_number("a"), 0);
  EXPECT_EQ(legs.last_number("c"), 0);
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
    ASSERT_TRUE(test_support::is_ok(book));
    EXPECT_EQ(take(*book, "a").value_or(0), 1);
    EXPECT_EQ(take(*book, "a").value_or(0), 2);
    EXPECT_EQ(take(*book, "b").value_or(0), 1);
    book->begin("a", 1);
    ASSERT_TRUE(book->answer("b", 1, HandInState::refused, "b: no", 1'795'000'001));
    EXPECT_FALSE(open()) << "two processes do not check the same entry";
  }
  auto again = open();
  ASSERT_TRUE(test_support::is_ok(again));
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
