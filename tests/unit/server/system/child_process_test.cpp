// SPDX-License-Identifier: MIT
//
// Catches a child whose exit is reported wrongly, one that runs on another processor than it was
// told, and one whose output is lost.
#include "server/system/child_process.hpp"

#include "server/system/files.hpp"
#include "server/system/process_set.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>

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
  EXPECT_EQ(*Disk().read(log), "out\nerror\n");
  std::filesystem::remove_all(folder);
}

TEST(ChildProcess, NamesTheProgramThatCannotTakeThePlaceOfThisOne) {
  const Error error = become_program({"/no/such/program"});
  EXPECT_EQ(error.code, Errc::unavailable);
  EXPECT_EQ(error.what, "/no/such/program cannot be run: No such file or directory");
}

}  // namespace
}  // namespace mirocup::system
