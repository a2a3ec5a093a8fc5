// SPDX-License-Identifier: MIT
//
// Catches a write that leaves half a file or a temporary one, a cleaning that removes the file of a
// writer that still runs, and an error without the file's name.
#include "server/system/files.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <filesystem>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace mirocup::system {
namespace {

class DiskTest : public testing::Test {
 protected:
  DiskTest() {
    folder_ = (std::filesystem::temp_directory_path() / "mirocup-disk-XXXXXX").string();
    EXPECT_NE(mkdtemp(folder_.data()), nullptr);
  }
  ~DiskTest() override { std::filesystem::remove_all(folder_); }

  std::string at(const std::string& name) const { return folder_ + "/" + name; }

  std::string folder_;
  Disk disk_;
};

TEST_F(DiskTest, ReplacesAWholeFileAndLeavesNothingElse) {
  ASSERT_TRUE(disk_.write(at("a"), "first, and longer"));
  ASSERT_TRUE(disk_.write(at("a"), "second"));
  EXPECT_EQ(*disk_.read(at("a")), "second");
  int files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder_)) ++files;
  EXPECT_EQ(files, 1);
}

TEST_F(DiskTest, RemovesWhatKilledWritersLeftAndNothingElse) {
  ASSERT_TRUE(disk_.make_folder(at("site/replays")));
  const std::string left = at("site/replays/a.html.unfinished-1");
  const std::string being_written = at("site/replays/b.html.unfinished-2");
  const std::string not_ours = at("site/notes.unfinished-yet");
  for (const std::string& path : {left, being_written, not_ours}) {
    ASSERT_TRUE(disk_.append(path, "half a file"));
  }
  const int writer = open(being_written.c_str(), O_WRONLY | O_CLOEXEC);
  ASSERT_EQ(flock(writer, LOCK_EX), 0);
  ASSERT_TRUE(disk_.remove_unfinished(folder_));
  EXPECT_FALSE(disk_.exists(left));
  EXPECT_TRUE(disk_.exists(being_written));
  EXPECT_TRUE(disk_.exists(not_ours));
  close(writer);
  ASSERT_TRUE(disk_.remove_unfinished(folder_));
  EXPECT_FALSE(disk_.exists(being_written));
}

TEST_F(DiskTest, WritesOverWhatAKilledWriterOfItsNumberLeft) {
  const std::string left = at("a.unfinished-" + std::to_string(getpid()));
  ASSERT_TRUE(disk_.append(left, "more than is written now"));
  ASSERT_TRUE(disk_.write(at("a"), "new"));
  EXPECT_EQ(*disk_.read(at("a")), "new");
  EXPECT_FALSE(disk_.exists(left));
}

// --record /dev/null, as root, must not leave the machine without it.
TEST_F(DiskTest, WritesIntoAPipeAndLeavesIt) {
  ASSERT_EQ(mkfifo(at("pipe").c_str(), 0600), 0);
  const int reader = open(at("pipe").c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  ASSERT_TRUE(disk_.write(at("pipe"), "all of it"));
  char got[16];
  EXPECT_EQ(read(reader, got, sizeof got), 9);
  close(reader);
  EXPECT_TRUE(std::filesystem::is_fifo(at("pipe")));
}

TEST_F(DiskTest, AppendsAndTruncates) {
  ASSERT_TRUE(disk_.append(at("log"), "one\n"));
  ASSERT_TRUE(disk_.append(at("log"), "two\n"));
  EXPECT_EQ(*disk_.read(at("log")), "one\ntwo\n");
  ASSERT_TRUE(disk_.truncate(at("log"), 4));
  EXPECT_EQ(*disk_.read(at("log")), "one\n");
}

TEST_F(DiskTest, NamesTheFileAndTheReason) {
  const auto missing = disk_.read(at("nothing"));
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, Errc::unavailable);
  EXPECT_EQ(missing.error().what, at("nothing") + " cannot be read: No such file or directory");
  const auto nowhere = disk_.write(at("no/such/folder/file"), "x");
  ASSERT_FALSE(nowhere);
  EXPECT_NE(nowhere.error().what.find("no/such/folder/file"), std::string::npos);
}

}  // namespace
}  // namespace mirocup::system
