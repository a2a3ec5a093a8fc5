// SPDX-License-Identifier: MIT
//
// Catches an entry that counts although it was rejected or not written to its end.
#include "tournaments/league/folder.hpp"

#include "tests/support/memory_files.hpp"

#include <gtest/gtest.h>

namespace mirocup::league {
namespace {

TEST(Folder, KnowsTheLastEntryAndTheLastThatWasAccepted) {
  test_support::MemoryFiles files;
  const Folder folder{"l"};
  EXPECT_EQ(last_entry(files, folder, "a"), 0);
  EXPECT_EQ(last_accepted_entry(files, folder, "a"), 0);
  ASSERT_TRUE(add_entry(files, folder, "a", 1, "first"));
  ASSERT_TRUE(add_entry(files, folder, "a", 2, "second", R"({"accepted": true})"));
  ASSERT_TRUE(add_entry(files, folder, "a", 3, "third", R"({"accepted": false})"));
  EXPECT_EQ(last_entry(files, folder, "a"), 3);
  EXPECT_EQ(last_accepted_entry(files, folder, "a"), 2);
  EXPECT_EQ(*files.read(folder.library("a", 2)), "second");
}

TEST(Folder, IgnoresAnEntryThatWasNotWrittenToItsEnd) {
  test_support::MemoryFiles files;
  const Folder folder{"l"};
  files.fail_after(1);  // the library is written, entry.json is not
  EXPECT_FALSE(add_entry(files, folder, "a", 1, "library"));
  EXPECT_TRUE(files.exists(folder.library("a", 1)));
  EXPECT_EQ(last_entry(files, folder, "a"), 0);
}

TEST(Folder, NamesRecordsByFixtureLegAndVersion) {
  Fixture fixture;
  fixture.round = 2;
  EXPECT_EQ(Folder::record_name(fixture, 1, 3), "records/r2-f1-1-3.json");
}

}  // namespace
}  // namespace mirocup::league
