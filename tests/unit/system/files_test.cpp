// SPDX-License-Identifier: MIT
//
// Catches a write that leaves half a file or a temporary one, a cleaning that removes the file of a
// writer that still runs, and an error without the file's name. Catches a reader that waits,
// follows a stranger's link or reads without an end, and a writer that writes through a stranger's
// name.
#include "system/files.hpp"

#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <sys/file.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>
#include <vector>

namespace mirocup::system {
namespace {

class DiskTest : public testing::Test {
 protected:
  std::string at(const std::string& name) const { return folder_ / name; }

  // As the host reads what it names.
  Result<std::string> read(const std::string& name) {
    return disk_.read(at(name), {.max_size = 1 << 20, .links = Links::followed});
  }

  // As what a team may have written is read.
  Result<std::string> read_strange(const std::string& name) {
    return disk_.read(at(name), {.max_size = 1 << 20});
  }

  void expect_refused(const std::string& name, const std::string& why) {
    const auto got = read_strange(name);
    ASSERT_FALSE(got) << name;
    EXPECT_EQ(got.error().code, Errc::input) << name;
    EXPECT_EQ(got.error().what, at(name) + ": " + why);
  }

  const test_support::TemporaryFolder folder_;
  Disk disk_;
};

TEST_F(DiskTest, ReplacesAWholeFileAndLeavesNothingElse) {
  ASSERT_TRUE(disk_.write(at("a"), "first, and longer"));
  ASSERT_TRUE(disk_.write(at("a"), "second"));
  EXPECT_EQ(*read("a"), "second");
  EXPECT_EQ(*disk_.names_in(at(".")), std::vector<std::string>{"a"});
}

TEST_F(DiskTest, RemovesWhatKilledWritersLeftAndNothingElse) {
  ASSERT_TRUE(disk_.make_folder(at("site/replays")));
  const std::string left = at("site/replays/a.html.unfinished-" + std::string(32, '1'));
  const std::string being_written = at("site/replays/b.html.unfinished-" + std::string(32, '2'));
  const std::string not_ours = at("site/notes.unfinished-yet");
  for (const std::string& path : {left, being_written, not_ours}) {
    ASSERT_TRUE(disk_.append(path, "half a file"));
  }
  const int writer = open(being_written.c_str(), O_WRONLY | O_CLOEXEC);
  ASSERT_EQ(flock(writer, LOCK_EX), 0);
  ASSERT_TRUE(disk_.remove_unfinished(at(".")));
  EXPECT_FALSE(disk_.exists(left));
  EXPECT_TRUE(disk_.exists(being_written));
  EXPECT_TRUE(disk_.exists(not_ours));
  close(writer);
  ASSERT_TRUE(disk_.remove_unfinished(at(".")));
  EXPECT_FALSE(disk_.exists(being_written));
}

// --record /dev/null, as root, must not leave the machine without it.
TEST_F(DiskTest, WritesIntoAPipeAndLeavesIt) {
  ASSERT_EQ(mkfifo(at("pipe").c_str(), 0600), 0);
  const int reader = open(at("pipe").c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  ASSERT_TRUE(disk_.write(at("pipe"), "all of it"));
  char got[16];
  EXPECT_EQ(::read(reader, got, sizeof got), 9);
  close(reader);
  EXPECT_TRUE(std::filesystem::is_fifo(at("pipe")));
}

// Catches a standard output that is replaced by a file, for example by -o /dev/stdout >FILE.
TEST_F(DiskTest, WritesInPlaceWhatIsNoNameOfAFile) {
  for (const char* path : {"/dev/null", "/dev/stdout", "/proc/self/fd/1"}) {
    EXPECT_TRUE(is_written_in_place(path)) << path;
  }
  std::filesystem::create_symlink("/dev/null", at("link"));
  EXPECT_TRUE(is_written_in_place(at("link")));
  ASSERT_TRUE(disk_.write(at("file"), "x"));
  std::filesystem::create_symlink(at("file"), at("link to a file"));
  ASSERT_EQ(mkfifo(at("pipe").c_str(), 0600), 0);
  EXPECT_TRUE(is_written_in_place(at("pipe")));
  std::filesystem::create_symlink(at("pipe"), at("link to a pipe"));
  for (const std::string& path :
       {at("file"), at("link to a file"), at("link to a pipe"), at("none"), at("")}) {
    EXPECT_FALSE(is_written_in_place(path)) << path;
  }
}

TEST_F(DiskTest, AppendsAndTruncates) {
  ASSERT_TRUE(disk_.append(at("log"), "one\n"));
  ASSERT_TRUE(disk_.append(at("log"), "two\n"));
  EXPECT_EQ(*read("log"), "one\ntwo\n");
  ASSERT_TRUE(disk_.truncate(at("log"), 4));
  EXPECT_EQ(*read("log"), "one\n");
}

TEST_F(DiskTest, NamesTheFileAndTheReason) {
  const auto missing = read("nothing");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, Errc::unavailable);
  EXPECT_EQ(missing.error().what, at("nothing") + " cannot be read: No such file or directory");
  const auto nowhere = disk_.write(at("no/such/folder/file"), "x");
  ASSERT_FALSE(nowhere);
  EXPECT_NE(nowhere.error().what.find("no/such/folder/file"), std::string::npos);
}

TEST_F(DiskTest, ReadsRegularFilesOnly) {
  ASSERT_EQ(mkfifo(at("pipe").c_str(), 0600), 0);
  expect_refused("pipe", "it is not a regular file");
  ASSERT_TRUE(disk_.make_folder(at("folder")));
  expect_refused("folder", "it is a folder and not a regular file");
  const auto zero = disk_.read("/dev/zero", {.max_size = 100});
  ASSERT_FALSE(zero);
  EXPECT_EQ(zero.error().what, "/dev/zero: it is not a regular file");
  const int socket = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, at("socket").c_str(), sizeof address.sun_path - 1);
  ASSERT_EQ(bind(socket, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  expect_refused("socket", "it is not a regular file");
  close(socket);
}

TEST_F(DiskTest, FollowsALinkOnlyWhereTheHostHasNamedIt) {
  ASSERT_TRUE(disk_.write(at("secret"), "secret"));
  std::filesystem::create_symlink(at("secret"), at("link"));
  EXPECT_EQ(*read("link"), "secret");
  expect_refused("link", "it is a symbolic link; name the file itself");
  std::filesystem::create_symlink(at("nothing"), at("dangling"));
  expect_refused("dangling", "it is a symbolic link; name the file itself");
  std::filesystem::create_symlink("/dev/zero", at("endless"));
  const auto endless = read("endless");
  ASSERT_FALSE(endless);
  EXPECT_EQ(endless.error().what, at("endless") + ": it is not a regular file");
  // The links of /proc open the file itself and not its name.
  const int open_secret = open(at("secret").c_str(), O_RDONLY | O_CLOEXEC);
  const std::string path = "/proc/self/fd/" + std::to_string(open_secret);
  const auto through_proc = disk_.read(path, {.max_size = 100});
  ASSERT_FALSE(through_proc);
  EXPECT_EQ(through_proc.error().what, path + ": it is a symbolic link; name the file itself");
  close(open_secret);
}

TEST_F(DiskTest, KnowsTheSizeBeforeItReads) {
  ASSERT_TRUE(disk_.write(at("sparse"), "x"));
  ASSERT_EQ(::truncate(at("sparse").c_str(), off_t{8} << 30), 0);
  expect_refused("sparse", "it is larger than 1 MiB");
  ASSERT_TRUE(disk_.write(at("full"), std::string(1 << 20, 'x')));
  EXPECT_EQ(read_strange("full")->size(), 1u << 20);
}

TEST_F(DiskTest, NoticesAFileThatChangesWhileItIsRead) {
  for (const Growth growth : {Growth::refused, Growth::ignored}) {
    ASSERT_TRUE(disk_.write(at("file"), "first"));
    const auto file = open_file(at("file"), {.max_size = 100, .growth = growth});
    ASSERT_TRUE(file);
    ASSERT_TRUE(disk_.append(at("file"), std::string(1000, 'x')));
    const auto grown = read_file(*file);
    if (growth == Growth::ignored) {
      EXPECT_EQ(*grown, "first");
    } else {
      ASSERT_FALSE(grown);
      EXPECT_EQ(grown.error().what, at("file") + " was changed while it was read; try again");
    }
  }
  ASSERT_TRUE(disk_.write(at("file"), "longer than before"));
  const auto file = open_file(at("file"), {.max_size = 100});
  ASSERT_TRUE(disk_.truncate(at("file"), 3));
  EXPECT_FALSE(read_file(*file)) << "it became shorter";
  ASSERT_TRUE(disk_.write(at("file"), "whole"));
  const auto same = open_file(at("file"), {.max_size = 100});
  ASSERT_TRUE(disk_.write(at("file"), "other"));
  EXPECT_EQ(*read_file(*same), "whole") << "the name means another file now; the bytes stay";
}

// The owner of a file may ask the kernel to be told before others open it, and let them wait.
TEST_F(DiskTest, DoesNotWaitForTheHolderOfALease) {
  ASSERT_TRUE(disk_.write(at("file"), "x"));
  const int holder = open(at("file").c_str(), O_RDWR | O_CLOEXEC);
  signal(SIGIO, SIG_IGN);
  if (fcntl(holder, F_SETLEASE, F_WRLCK) != 0) GTEST_SKIP() << "this disk has no leases";
  const auto got = read_strange("file");
  ASSERT_FALSE(got);
  EXPECT_EQ(got.error().code, Errc::unavailable);
  close(holder);
}

TEST_F(DiskTest, WritesToNewNamesThatNobodyCanGuess) {
  ASSERT_TRUE(disk_.write(at("secret"), "secret"));
  std::filesystem::create_symlink(at("secret"), at("a.unfinished-" + std::to_string(getpid())));
  std::filesystem::create_symlink(at("secret"), at("a"));
  ASSERT_TRUE(disk_.write(at("a"), "new"));
  EXPECT_FALSE(std::filesystem::is_symlink(at("a"))) << "the link is replaced";
  EXPECT_EQ(*read("a"), "new");
  EXPECT_EQ(*read("secret"), "secret");
}

TEST_F(DiskTest, RemovesNoFileThroughALink) {
  ASSERT_TRUE(disk_.write(at("kept"), "kept"));
  const std::string digits(32, 'a');
  std::filesystem::create_symlink(at("kept"), at("b.unfinished-" + digits));
  ASSERT_EQ(mkfifo(at("c.unfinished-" + digits).c_str(), 0600), 0);
  ASSERT_TRUE(disk_.append(at("d.unfinished-" + digits), "half"));
  ASSERT_TRUE(disk_.remove_unfinished(at(".")));
  EXPECT_EQ(*read("kept"), "kept");
  EXPECT_FALSE(disk_.exists(at("d.unfinished-" + digits)));
}

TEST_F(DiskTest, AppendsToNoLink) {
  ASSERT_TRUE(disk_.write(at("kept"), "kept"));
  std::filesystem::create_symlink(at("kept"), at("journal"));
  EXPECT_FALSE(disk_.append(at("journal"), "line"));
  EXPECT_FALSE(disk_.truncate(at("journal"), 0));
  EXPECT_EQ(*read("kept"), "kept");
}

TEST_F(DiskTest, ClosesWhatOnlyTheOwnerReads) {
  using std::filesystem::perms;
  const auto mode = [this](const std::string& name) {
    return std::filesystem::status(at(name)).permissions();
  };
  const mode_t before = umask(022);
  ASSERT_TRUE(disk_.make_folder(at("entries")));
  EXPECT_EQ(mode("entries"), perms(0755));
  ASSERT_TRUE(disk_.make_folder(at("entries"), Readers::owner)) << "it was made for everybody";
  EXPECT_EQ(mode("entries"), perms(0700));
  ASSERT_TRUE(disk_.write(at("entries/a"), "x", Readers::owner));
  EXPECT_EQ(mode("entries/a"), perms(0600));
  ASSERT_TRUE(disk_.write(at("page"), "x"));
  EXPECT_EQ(mode("page"), perms(0644));
  umask(before);
  std::filesystem::create_directory_symlink(at("entries"), at("link"));
  EXPECT_FALSE(disk_.make_folder(at("link"), Readers::owner)) << "where does it lead?";
}

TEST_F(DiskTest, ListsAndRemovesNamesOfAnyBytes) {
  ASSERT_TRUE(disk_.write(at("b\n\xff"), "x"));
  ASSERT_TRUE(disk_.make_folder(at("a/b")));
  EXPECT_EQ(*disk_.names_in(at(".")), (std::vector<std::string>{"a", "b\n\xff"}));
  ASSERT_TRUE(disk_.write(at("kept"), "kept"));
  std::filesystem::create_symlink(at("kept"), at("a/b/link"));
  EXPECT_FALSE(disk_.remove(at("a"))) << "a tree is not removed";
  for (const char* name : {"a/b", "a", "b\n\xff"}) ASSERT_TRUE(disk_.remove(at(name)));
  ASSERT_TRUE(disk_.remove(at("a"))) << "it is gone already";
  EXPECT_EQ(*read("kept"), "kept");
  EXPECT_FALSE(disk_.names_in(at("nowhere")));
}

TEST_F(DiskTest, TakesForAbsentOnlyWhatHasNoName) {
  ASSERT_TRUE(disk_.write(at("file"), "x"));
  for (const std::string name : {"absent", "absent/absent"}) {
    EXPECT_FALSE(disk_.exists(at(name))) << name;
    EXPECT_EQ(disk_.read_if_there(at(name), {.max_size = 1}), std::nullopt) << name;
    EXPECT_EQ(disk_.names_if_there(at(name)), std::vector<std::string>{}) << name;
  }
  std::filesystem::create_symlink(at("loop"), at("loop"));
  std::filesystem::create_symlink(at("absent"), at("away"));
  std::filesystem::create_directory(at("folder"));
  for (const std::string name : {"loop", "loop/x", "away", "away/x", "away/x/y", "file/x"}) {
    EXPECT_TRUE(disk_.exists(at(name))) << name;
    EXPECT_FALSE(disk_.read_if_there(at(name), {.max_size = 1})) << name;
    EXPECT_FALSE(disk_.names_if_there(at(name))) << name;
  }
  EXPECT_EQ(disk_.read_if_there(at("folder"), {.max_size = 1}).error().code, Errc::damaged);
  EXPECT_EQ(disk_.read_if_there(at("file"), {.max_size = 0}).error().code, Errc::damaged);
  EXPECT_EQ(disk_.read_if_there(at("file"), {.max_size = 1}), std::string("x"));
  EXPECT_FALSE(disk_.names_if_there(at("file")));
}

}  // namespace
}  // namespace mirocup::system
