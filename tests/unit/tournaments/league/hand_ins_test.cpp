// SPDX-License-Identifier: MIT
//
// Catches a team that hands in without a limit, one that is locked out by a clock, and a version
// that is removed although it played or plays.
#include "tournaments/league/hand_ins.hpp"

#include "tests/support/memory_files.hpp"

#include <gtest/gtest.h>

namespace mirocup::league {
namespace {

constexpr std::int64_t now = 1'795'000'000;  // s since 1970

Try try_at(std::int64_t at) {
  Try one;
  one.at = at;
  return one;
}

TEST(HandIns, CountsTheTriesOfTheLastHour) {
  HandIns known;
  add_try(known, try_at(now - 3600));
  add_try(known, try_at(now - 3599));
  add_try(known, try_at(now));
  EXPECT_EQ(tries_in_last_hour(known, now), 2);
}

TEST(HandIns, IsNotLockedOutByAClockThatJumps) {
  HandIns known;
  for (int i = 0; i < 20; ++i) add_try(known, try_at(now + 86'400 * 365));
  EXPECT_EQ(tries_in_last_hour(known, now), 0) << "the clock was a year ahead";
  for (int i = 0; i < 20; ++i) add_try(known, try_at(now + 5));
  EXPECT_EQ(tries_in_last_hour(known, now), 20) << "set back by seconds, it frees nobody";
}

TEST(HandIns, AreReadAsTheyWereWrittenAndStayBounded) {
  test_support::MemoryFiles files;
  const Folder folder{"l"};
  HandIns known;
  known.pinned = 7;
  for (int i = 0; i < 1000; ++i) add_try(known, try_at(now + i));
  known.tries.back().message = "bytes that are not UTF-8: \xff";
  ASSERT_TRUE(write_hand_ins(files, folder, "a", known));
  const auto read = read_hand_ins(files, folder, "a");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->pinned, 7);
  ASSERT_EQ(read->tries.size(), 100u);
  EXPECT_EQ(read->tries.back().at, now + 999);
  ASSERT_TRUE(files.write(folder.hand_ins("b"), R"({"schema": {}, "tries": 7})"));
  EXPECT_EQ(read_hand_ins(files, folder, "b").error().code, Errc::damaged);
  ASSERT_TRUE(files.write(folder.hand_ins("c"),
                          R"({"schema": "mirocup/hand-ins/1", "pinned": -1, "tries": []})"));
  EXPECT_EQ(read_hand_ins(files, folder, "c").error().what,
            "l/entries/c/hand-ins.json: /pinned: -1 is not at least 0");
}

class Pruning : public testing::Test {
 protected:
  void add(int number, bool is_accepted) {
    ASSERT_TRUE(add_entry(files_, folder_, "a", number, "library",
                          is_accepted ? R"({"accepted": true})" : R"({"accepted": false})"));
  }
  std::vector<int> left_after(const std::vector<int>& played, int versions) {
    Quota quota;
    quota.versions = versions;
    EXPECT_TRUE(prune_versions(files_, folder_, "a", played, quota));
    return entries_of(files_, folder_, "a").value();
  }

  test_support::MemoryFiles files_;
  Folder folder_{"l"};
};

TEST_F(Pruning, KeepsWhatPlayedAndWhatPlays) {
  for (int number = 1; number <= 30; ++number) add(number, number <= 25);
  EXPECT_EQ(left_after({1, 2, 3}, 4), (std::vector<int>{1, 2, 3, 23, 24, 25, 30}))
      << "refused ones go first, then the oldest";
  EXPECT_EQ(last_entry(files_, folder_, "a"), 30) << "the next one is 31";
  EXPECT_EQ(last_accepted_entry(files_, folder_, "a"), 25);
}

TEST_F(Pruning, RemovesTheLibrariesOfOlderRefusedVersions) {
  for (int number = 1; number <= 4; ++number) add(number, number == 1);
  EXPECT_EQ(left_after({}, 20), (std::vector<int>{1, 2, 3, 4}));
  EXPECT_TRUE(files_.exists(folder_.library("a", 1)));
  EXPECT_FALSE(files_.exists(folder_.library("a", 2)));
  EXPECT_FALSE(files_.exists(folder_.library("a", 3)));
  EXPECT_TRUE(files_.exists(folder_.library("a", 4)));
  EXPECT_TRUE(files_.exists(folder_.verdict("a", 2)));
}

}  // namespace
}  // namespace mirocup::league
