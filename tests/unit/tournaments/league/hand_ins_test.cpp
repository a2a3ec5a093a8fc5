// SPDX-License-Identifier: MIT
//
// Catches a team that others wait for because it hands in often or slow files, two checks of one
// team at once, a team that hands in without a limit, or that is locked out by a clock, a version
// that is removed although it played or plays, and a book that loses or doubles a hand-in.
#include "tests/support/is_ok.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tournaments/handin/check_runner.hpp"
#include "tournaments/league/book.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>

namespace mirocup::league {
namespace {

constexpr std::int64_t now = 1'795'000'000;  // s since 1970

HandedIn hand_in(const std::string& team, int entry) {
  HandedIn handed;
  handed.team = team;
  handed.entry = entry;
  handed.file = "team.so";
  handed.sha256 = "hash";
  handed.bytes = 3;
  handed.at = now;
  handed.is_network = true;
  return handed;
}

std::string order_of(HandIns queue) {
  std::string order;
  while (const HandedIn* next = queue.next()) {
    order += (order.empty() ? "" : " ") + next->team + std::to_string(next->entry);
    queue.apply(Answered{next->team, next->entry, HandInState::accepted});
  }
  return order;
}

TEST(HandIns, LetsTeamsTakeTurns) {
  HandIns queue;
  for (int entry = 1; entry <= 3; ++entry) queue.apply(hand_in("a", entry));
  queue.apply(hand_in("b", 1));
  queue.apply(hand_in("c", 1));
  queue.apply(hand_in("b", 2));
  EXPECT_EQ(queue.before("c", 1), 2);
  EXPECT_EQ(queue.before("a", 3), 5);
  queue.begin("a", 1);
  EXPECT_EQ(queue.next()->team, "b") << "a team has one check at a time";
  queue.wait_again("a", 1);
  EXPECT_EQ(queue.next()->team, "a") << "it has kept its place";
  EXPECT_EQ(queue.find("a", 1)->times(NoAnswer::host_failed), 1);
  EXPECT_EQ(order_of(std::move(queue)), "a1 b1 c1 a2 b2 a3");
}

TEST(HandIns, LetsNobodyPassByHandingInAgainAtOnce) {
  for (const bool has_more : {false, true}) {
    HandIns queue;
    queue.apply(hand_in("a", 1));
    queue.apply(hand_in("b", 1));
    queue.apply(Answered{"a", 1, HandInState::refused});
    queue.apply(hand_in("a", 2));
    queue.apply(hand_in("c", 1));
    if (has_more) {
      queue.apply(hand_in("d", 1));
      queue.apply(hand_in("a", 3));
    }
    const std::string order = order_of(std::move(queue));
    EXPECT_EQ(order.substr(0, 5), "b1 c1");
    if (!has_more) EXPECT_EQ(order, "b1 c1 a2") << "the round of b and c is not over";
  }
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
        if (at == time_) queue_.apply(handed);
      }
      for (auto& check : running_) check.processor += step;
      for (const RunningCheck& check : running_) {
        if (check.processor < needed_.at({check.team, check.entry})) continue;
        answered[check.team + std::to_string(check.entry)] = time_;
        queue_.apply(Answered{check.team, check.entry, HandInState::accepted});
      }
      std::erase_if(running_, [&](const RunningCheck& check) {
        return is_final(queue_.find(check.team, check.entry)->state);
      });
      if (running_.size() == 2) stop_one();
      while (running_.size() < 2 && queue_.next() != nullptr) {
        const HandedIn next = *queue_.next();
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
    const HandedIn* stopped = queue_.to_stop(running_);
    if (stopped == nullptr) return;
    const std::string team = stopped->team;
    queue_.wait_again(team, stopped->entry, NoAnswer::gave_way);
    std::erase_if(running_, [&](const RunningCheck& c) { return c.team == team; });
  }

  HandIns queue_;
  std::vector<std::pair<double, HandedIn>> coming_;
  std::map<std::pair<std::string, int>, double> needed_;  // s
  std::vector<RunningCheck> running_;
  double time_ = 0.0;
};

// Catches checks that keep all processors for as long as they like, and, in the last line, a check
// that gives way again and again and never ends.
TEST(HandIns, LongChecksGiveWayAndComeToTheirEnd) {
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
TEST(HandIns, ALongCheckEndsWhileOthersKeepComing) {
  Hall hall;
  hall.hand_in_at(0.0, "slow", 1, 20.0);
  for (int i = 0; i < 200; ++i)
    hall.hand_in_at(1.0 * i, "t" + std::to_string(i % 20), 1 + i / 20, 2.5);
  const auto answered = hall.run();
  ASSERT_TRUE(answered.contains("slow1"));
  EXPECT_LE(answered.at("slow1"), 120.0) << "three rounds of 20 teams, and its own time";
  EXPECT_LE(hall.begun.at("slow"), 1 + HandIns::gives_way_at_most);
}

TEST(HandIns, NothingGivesWayWhereNobodyWaits) {
  Hall hall;
  hall.hand_in_at(0.0, "a", 1, 40.0);
  hall.hand_in_at(0.0, "b", 1, 40.0);
  hall.hand_in_at(0.0, "b", 2, 1.0);  // of a team that is being checked
  EXPECT_EQ(hall.run().at("a1"), 40.0);
  EXPECT_EQ(hall.begun.at("a"), 1);
}

// Catches a check that sleeps and so never uses processor time.
TEST(HandIns, ASleepingCheckGivesWay) {
  HandIns queue;
  queue.apply(hand_in("a", 1));
  queue.begin("a", 1);
  RunningCheck check{.team = "a", .entry = 1, .processor = 0.1, .asleep = 2.5};
  EXPECT_EQ(queue.to_stop({check}), nullptr) << "nobody waits";
  queue.apply(hand_in("b", 1));
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

TEST(HandIns, CountsChecksThatUseUpTheirTime) {
  HandIns queue;
  queue.apply(hand_in("a", 1));
  queue.apply(hand_in("b", 1));
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

TEST(HandIns, KeepsTheFirstAnswer) {
  HandIns queue;
  queue.apply(hand_in("a", 1));
  queue.apply(Answered{"a", 1, HandInState::refused, "no"});
  queue.apply(Answered{"a", 1, HandInState::accepted, "yes"});
  queue.wait_again("a", 1);
  EXPECT_EQ(queue.find("a", 1)->state, HandInState::refused);
  EXPECT_EQ(queue.find("a", 1)->message, "no");
  EXPECT_EQ(queue.next(), nullptr);
  EXPECT_TRUE(queue.waiting().empty());
}

TEST(Friendlies, NumbersTheLegsOfEachTeam) {
  Friendlies legs;
  EXPECT_EQ(legs.last_number("b"), 0);
  for (int i = 1; i <= 40'000; ++i) {
    EXPECT_EQ(legs.last_number("b"), i - 1);
    legs.apply(Friendly{.team = "b", .number = i, .entry = 1, .opponent = "house:idle"});
    legs.apply(FriendlyEnded{.team = "b", .number = i, .state = FriendlyState::played});
  }
  EXPECT_EQ(legs.last_number("a"), 0);
  EXPECT_EQ(legs.last_number("c"), 0);
}

// A kill between the legs of a burst was a burst of some legs.
TEST(Friendlies, BurstEndsWhatWaitsForOlderEntries) {
  Friendlies legs;
  legs.apply(Burst{.team = "a", .entry = 1, .legs = {{"house:idle"}, {"b", 2}}});
  legs.apply(Friendly{.team = "b", .number = 1, .entry = 1, .opponent = "a", .opponent_entry = 1});
  legs.begin("a", 1);
  legs.apply(Burst{.team = "a", .entry = 2, .legs = {{"a", 1}}});
  EXPECT_EQ(legs.find("a", 1)->state, FriendlyState::playing);
  EXPECT_EQ(legs.find("a", 2)->state, FriendlyState::void_);
  EXPECT_EQ(legs.find("a", 2)->end, "a later entry was accepted");
  EXPECT_EQ(legs.find("a", 3)->opponent, "a");
  EXPECT_EQ(legs.find("b", 1)->state, FriendlyState::waiting);
  EXPECT_TRUE(legs.has_burst("a", 2));
}

TEST(Tries, AreThoseOfTheLastHourWhateverTheClockDoes) {
  HandIns known;
  int entry = 0;
  const auto try_at = [&](std::int64_t at) {
    known.apply(HandedIn{.team = "a", .entry = ++entry, .file = "a.so", .at = at});
  };
  try_at(now - 3600);
  try_at(now - 3599);
  try_at(now);
  known.apply(Rejected{.team = "a", .message = "a: not taken: it is a link", .at = now});
  EXPECT_EQ(known.tries_in_last_hour("a", now), 3);
  EXPECT_EQ(known.last_try("a")->message, "a: not taken: it is a link");
  EXPECT_EQ(known.last_number("a"), 3) << "what cannot be an entry has no number";
  known.apply(HandedIn{.team = "a", .entry = 4, .at = now});
  EXPECT_EQ(known.tries_in_last_hour("a", now), 3) << "the host has given a library";
  EXPECT_EQ(known.tries_in_last_hour("a", now - 365 * 86'400), 0) << "the clock was a year ahead";
  EXPECT_EQ(known.tries_in_last_hour("a", now - 5), 4) << "set back by seconds, it frees nobody";
}

TEST(Versions, KeepWhatPlayedAndWhatPlays) {
  HandIns known;
  for (int entry = 1; entry <= 30; ++entry) {
    known.apply(hand_in("a", entry));
    known.apply(Answered{.team = "a",
                         .entry = entry,
                         .state = entry <= 25 ? HandInState::accepted : HandInState::refused,
                         .library = "hash"});
  }
  known.apply(Pinned{.team = "a", .entry = 7});
  EXPECT_EQ(known.playing("a"), 7);
  const auto dropped = known.to_drop("a", {1, 2, 3}, 5);
  EXPECT_EQ(dropped.size(), 22u);
  EXPECT_EQ((std::vector<int>(dropped.begin(), dropped.begin() + 5)),
            (std::vector<int>{26, 27, 28, 29, 4}))
      << "refused ones go first, then the oldest";
  known.apply(Dropped{.team = "a", .entries = dropped});
  std::vector<int> left;
  for (const auto& [entry, handed] : known.of_team("a"))
    if (handed.is_kept()) left.push_back(entry);
  EXPECT_EQ(left, (std::vector<int>{1, 2, 3, 7, 23, 24, 25, 30}));
  EXPECT_EQ(known.last_kept("a"), 30);
  EXPECT_EQ(known.last_accepted("a"), 25);
  known.apply(Pinned{.team = "a"});
  EXPECT_EQ(known.playing("a"), 25);
}

class BookFile : public testing::Test {
 protected:
  Result<Book> open() { return Book::open(disk_, folder_, nullptr); }

  Result<int> take(Book& book, const std::string& team) {
    return book.take(hand_in(team, 0),
                     [this](const std::string& path) { return disk_.write(path, "ELF"); });
  }

  test_support::TemporaryFolder temporary_;
  system::Disk disk_;
  Folder folder_{temporary_ / "."};
};

// Catches a process that numbers or answers by the lines that it has read, although another one
// has written since, and one that goes on behind half a line.
TEST_F(BookFile, IsWrittenByTwoProcessesAtOnce) {
  auto server = open();
  auto host = open();
  ASSERT_TRUE(server && host);
  EXPECT_EQ(take(*server, "a").value_or(0), 1);
  EXPECT_EQ(take(*host, "a").value_or(0), 2);
  std::ofstream(folder_.hand_in_book(), std::ios::app) << "{\"n\":3,\"kind\":\"hand";
  EXPECT_EQ(take(*server, "a").value_or(0), 3);
  ASSERT_TRUE(test_support::is_ok(host->refresh()));
  EXPECT_EQ(host->hand_ins().last_number("a"), 3);
  EXPECT_EQ(open()->hand_ins().of_team("a").size(), 3u);
}

// Catches a number that is given twice, and files that a killed process has left in an entry.
TEST_F(BookFile, NumbersNothingTwice) {
  std::filesystem::create_directories(folder_.entry("a", 1));
  std::ofstream(folder_.source("a", 1)) << "of a process that was killed";
  auto book = open();
  ASSERT_TRUE(book);
  EXPECT_EQ(take(*book, "a").value_or(0), 1);
  EXPECT_FALSE(std::filesystem::exists(folder_.source("a", 1)));
  std::filesystem::remove_all(folder_.entries());
  EXPECT_EQ(take(*book, "a").value_or(0), 2);
}

TEST_F(BookFile, TakesNothingThatWasNotStored) {
  auto book = open();
  ASSERT_TRUE(book);
  const auto failed = book->take(hand_in("a", 0), [](const std::string&) -> Result<void> {
    return fail(Errc::unavailable, "the disk is full");
  });
  EXPECT_FALSE(failed);
  EXPECT_TRUE(book->hand_ins().of_team("a").empty());
  EXPECT_FALSE(std::filesystem::exists(folder_.entry("a", 1)));
}

// Catches an exception that nobody catches: the chain of hashes is right, and the value is of
// another type.
TEST_F(BookFile, SaysWhichLineIsDamaged) {
  const std::pair<const char*, Json> wrong[] = {
      {"hand_in", {{"entry", 1}}},  {"answer", {{"entry", 2}}},
      {"answer", {{"entry", "x"}}}, {"answer", {{"state", "queued"}}},
      {"answer", {{"plays", -1}}},  {"friendly", {{"number", 7}}},
      {"ended", {{"number", 7}}},   {"pin", {{"team", "../a"}}},
      {"pin", {{"team", 5}}},       {"pin", {{"at", 1e300}}},
      {"drop", {{"entries", {""}}}}};
  for (const auto& [kind, value] : wrong) {
    (void)disk_.remove(folder_.hand_in_book());
    auto book = open();
    ASSERT_TRUE(book && take(*book, "a"));
    Json line = Json::parse(R"({"team": "a", "at": 1, "entry": 1, "file": "f", "sha256": "s",
      "bytes": 1, "network": true, "state": "void", "message": "m", "plays": 0, "library": "",
      "number": 1, "opponent": "b", "opponent_entry": 0, "goals": 0, "against": 0, "end": ""})");
    line.update(value);
    auto journal = Journal::open(disk_, folder_.hand_in_book());
    ASSERT_TRUE(journal && journal->append(kind, line));
    const auto damaged = open();
    ASSERT_FALSE(damaged) << line;
    EXPECT_EQ(damaged.error().code, Errc::damaged);
    EXPECT_NE(damaged.error().what.find("hand-ins.jsonl: line 2: /" + value.begin().key()),
              std::string::npos)
        << damaged.error().what;
  }
}

}  // namespace
}  // namespace mirocup::league
