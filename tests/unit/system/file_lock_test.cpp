// SPDX-License-Identifier: MIT
//
// Catches a lock that others can take or redirect, and a signal to a process that only has the
// number of one that held the lock.
#include "system/file_lock.hpp"

#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <array>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mirocup::system {
namespace {

using test_support::TemporaryFolder;

constexpr std::array<int, 1> asked_to_stop{SIGTERM};

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_text(const std::string& path, const std::string& text) {
  std::ofstream(path) << text;
}

TEST(FileLock, IsForOneHolderAndForThisUserOnly) {
  const TemporaryFolder folder;
  const std::string path = folder / ".lock";
  write_text(path, "open to others");
  chmod(path.c_str(), 0644);
  const auto held = FileLock::try_acquire(path);
  ASSERT_TRUE(held && *held);
  EXPECT_EQ(std::filesystem::status(path).permissions(), std::filesystem::perms(0600));
  EXPECT_EQ(text_of(path).substr(0, text_of(path).find('\n')), std::to_string(getpid()));
  const auto second = FileLock::try_acquire(path);
  ASSERT_TRUE(second);
  EXPECT_FALSE(*second);
}

TEST(FileLock, RefusesLinksAndPipes) {
  const TemporaryFolder folder;
  write_text(folder / "precious", "precious");
  std::filesystem::create_symlink(folder / "precious", folder / "link");
  write_text(folder / "first_name", "precious");
  std::filesystem::create_hard_link(folder / "first_name", folder / "second_name");
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  for (const char* name : {"link", "second_name", "pipe"}) {
    EXPECT_FALSE(FileLock::try_acquire(folder / name)) << name;
    EXPECT_FALSE(FileLock::acquire(folder / name)) << name;
    EXPECT_FALSE(FileLock::signal_holder(folder / name, asked_to_stop)) << name;
  }
  EXPECT_EQ(text_of(folder / "precious"), "precious");
}

TEST(FileLock, SignalsTheProcessThatHoldsIt) {
  const TemporaryFolder folder;
  const std::string path = folder / ".running";
  EXPECT_EQ(*FileLock::signal_holder(path, asked_to_stop), false) << "there is no file";
  std::array<int, 2> ready{};
  ASSERT_EQ(pipe(ready.data()), 0);
  const pid_t holder = fork();
  if (holder == 0) {
    const auto lock = FileLock::try_acquire(path);
    if (!lock || !*lock || write(ready[1], "x", 1) != 1) _exit(1);
    while (true) pause();
  }
  char byte = 0;
  ASSERT_EQ(read(ready[0], &byte, 1), 1);
  EXPECT_EQ(*FileLock::signal_holder(path, asked_to_stop), true);
  int status = 0;
  waitpid(holder, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGTERM);
  EXPECT_EQ(*FileLock::signal_holder(path, asked_to_stop), false) << "nobody holds it any more";
  close(ready[0]);
  close(ready[1]);
}

// The number of a process that held the lock may be another's now. Somebody who locks the file
// without being its holder must not bring the signal there.
TEST(FileLock, NeverSignalsAStaleNumber) {
  const TemporaryFolder folder;
  const std::string path = folder / ".running";
  const pid_t bystander = fork();
  if (bystander == 0) {
    while (true) pause();
  }
  for (const std::string& text :
       {std::to_string(bystander) + "\n", std::to_string(bystander) + "\n1\nanother start\n",
        std::string("1\n"), std::string("0\n"), std::string("-1\n"), std::string("no number"),
        std::string()}) {
    write_text(path, text);
    const int locker = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    ASSERT_EQ(flock(locker, LOCK_EX), 0);
    EXPECT_FALSE(FileLock::signal_holder(path, asked_to_stop)) << text;
    close(locker);
    EXPECT_EQ(*FileLock::signal_holder(path, asked_to_stop), false) << text;
  }
  EXPECT_EQ(waitpid(bystander, nullptr, WNOHANG), 0) << "it lives";
  kill(bystander, SIGKILL);
  waitpid(bystander, nullptr, 0);
}

}  // namespace
}  // namespace mirocup::system
