// SPDX-License-Identifier: MIT
//
// Catches a child whose exit is reported wrongly, one that runs on another processor than it was
// told, and one whose output is lost or goes where another user wants it.
#include "system/child_process.hpp"

#include "system/files.hpp"
#include "system/process_set.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <sys/stat.h>

namespace mirocup::system {
namespace {

TEST(ChildProcess, ReportsHowItEnded) {
  const auto code_of = [](const std::string& script) {
    return *run_child({.arguments = {"sh", "-c", script}, .cpu = -1, .log = ""});
  };
  EXPECT_EQ(code_of("exit 0"), 0);
  EXPECT_EQ(code_of("exit 3"), 3);
  EXPECT_EQ(code_of("kill -KILL $$"), 128 + SIGKILL);
  EXPECT_EQ(*run_child({.arguments = {"/no/such/program"}, .cpu = -1, .log = ""}), not_found);
}

TEST(ChildProcess, WritesOutputAndErrorsToItsLogAndHasNoInput) {
  std::string folder = (std::filesystem::temp_directory_path() / "mirocup-child-XXXXXX").string();
  ASSERT_NE(mkdtemp(folder.data()), nullptr);
  const std::string log = folder + "/log";
  EXPECT_EQ(*run_child({.arguments = {"sh", "-c", "cat; echo out; echo error >&2"},
                        .cpu = processors().front(),
                        .log = log}),
            0);
  EXPECT_EQ(*Disk().read(log, {.max_size = size_limit::log}), "out\nerror\n");
  std::filesystem::remove_all(folder);
}

// A name that another user has put where the log goes.
TEST(ChildProcess, WritesItsLogThroughNoStrangersName) {
  const test_support::TemporaryFolder folder;
  Disk disk;
  ASSERT_TRUE(disk.write(folder / "precious", "precious"));
  std::filesystem::create_symlink(folder / "precious", folder / "link");
  std::filesystem::create_hard_link(folder / "precious", folder / "second_name");
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  for (const char* name : {"link", "second_name", "pipe"}) {
    EXPECT_FALSE(run_child({.arguments = {"echo", "out"}, .cpu = -1, .log = folder / name}))
        << name;
  }
  EXPECT_EQ(*disk.read(folder / "precious", {.max_size = 100}), "precious");
  EXPECT_EQ(*run_child({.arguments = {"echo", "out"}, .cpu = -1, .log = "/dev/null"}), 0);
}

TEST(ChildProcess, NamesTheProgramThatCannotTakeThePlaceOfThisOne) {
  const Error error = become_program({"/no/such/program"});
  EXPECT_EQ(error.code, Errc::unavailable);
  EXPECT_EQ(error.what, "/no/such/program cannot be run: No such file or directory");
}

}  // namespace
}  // namespace mirocup::system
