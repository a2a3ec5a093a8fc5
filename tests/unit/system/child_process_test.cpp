// SPDX-License-Identifier: MIT
//
// Catches a child whose exit is reported wrongly, one that runs on another processor than it was
// told, one whose output is lost or goes where another user wants it, and a program that is asked
// and never ends, writes without end, or leaves a process that does.
#include "system/child_process.hpp"

#include "system/files.hpp"
#include "system/process_set.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <poll.h>
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
  const test_support::TemporaryFolder folder;
  const std::string log = folder / "log";
  EXPECT_EQ(*run_child({.arguments = {"sh", "-c", "cat; echo out; echo error >&2"},
                        .cpu = processors().front(),
                        .log = log}),
            0);
  EXPECT_EQ(*Disk().read(log, {.max_size = size_limit::log}), "out\nerror\n");
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

// A script of the shell that is asked. All its processes hold the descriptor 9.
class Asked : public testing::Test {
 protected:
  Asked() {
    EXPECT_EQ(mkfifo(held_.c_str(), 0600), 0);
    reader_.reset(open(held_.c_str(), O_RDONLY | O_NONBLOCK));
    sigprocmask(SIG_SETMASK, nullptr, &mask_);
  }
  ~Asked() override { sigprocmask(SIG_SETMASK, &mask_, nullptr); }  // a ProcessSet leaves another
  std::vector<std::string> command(const std::string& script) const {
    return {"sh", "-c", "exec 9>" + held_ + "; " + script};
  }
  bool are_all_gone() const {
    constexpr int patience = 60'000;  // ms, of a failure
    pollfd end{.fd = reader_.get(), .events = 0, .revents = 0};
    return poll(&end, 1, patience) == 1 && (end.revents & POLLHUP) != 0;
  }

 private:
  const test_support::TemporaryFolder folder_;
  const std::string held_ = folder_ / "held";
  Descriptor reader_;
  sigset_t mask_{};
};

constexpr ChildLimits plenty{.seconds = 60.0, .bytes = 1'000'000};

TEST_F(Asked, Answers) {
  const auto answer = ask(command("cat; echo out; echo error >&2; exit 3"), plenty);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->code, 3);
  EXPECT_EQ(answer->output, "out\nerror\n");
  EXPECT_EQ(ask({"/no/such/program"}, plenty)->code, not_found);
}

// Catches a question that waits for what the program leaves behind, or leaves it behind.
TEST_F(Asked, LeavesNoProcessBehind) {
  for (const char* left : {"sleep 1000", "yes", "(trap '' HUP TERM; sleep 1000)"}) {
    const auto answer = ask(command("echo out; " + std::string(left) + " & exit 0"), plenty);
    ASSERT_TRUE(answer) << left;
    EXPECT_EQ(answer->code, 0) << left;
    EXPECT_TRUE(answer->output.starts_with("out\n")) << left;
    EXPECT_TRUE(are_all_gone()) << left;
  }
}

// Catches a process that has left the group and fills a disk.
TEST_F(Asked, EndsWhatWritesInAnotherGroup) {
  ASSERT_TRUE(ask(command("echo out; setsid yes & exit 0"), plenty));
  EXPECT_TRUE(are_all_gone());
}

TEST_F(Asked, HasToEndInTime) {
  const auto answer = ask(command("sleep 1000 & sleep 1000"), {.seconds = 0.5});
  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.error().code, Errc::unavailable);
  EXPECT_EQ(answer.error().what, "sh has not ended after 0.5 s and was stopped");
  EXPECT_TRUE(are_all_gone());
}

TEST_F(Asked, WritesNoMoreThanTheLimit) {
  const auto answer = ask(command("exec yes"), plenty);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->code, 128 + SIGXFSZ);
  EXPECT_EQ(answer->output.size(), plenty.bytes);
}

// The same for children that run at the same time.
TEST_F(Asked, IsBoundedInASetOfProcessesToo) {
  ProcessSet processes;
  ASSERT_TRUE(processes.start(command("sleep 1000 & exit 3"), 1, -1, "/dev/null"));
  EXPECT_EQ(processes.wait()->code, 3);
  EXPECT_TRUE(are_all_gone());
  ASSERT_TRUE(processes.start(command("sleep 1000"), 2, -1, "/dev/null", {.seconds = 0.5}));
  EXPECT_EQ(processes.wait()->signal, SIGKILL);
  const test_support::TemporaryFolder folder;
  ASSERT_TRUE(processes.start({"yes"}, 3, -1, folder / "log", plenty));
  EXPECT_EQ(processes.wait()->signal, SIGXFSZ);
  EXPECT_EQ(std::filesystem::file_size(folder / "log"), plenty.bytes);
}

TEST(ChildProcess, NamesTheProgramThatCannotTakeThePlaceOfThisOne) {
  const Error error = become_program({"/no/such/program"});
  EXPECT_EQ(error.code, Errc::unavailable);
  EXPECT_EQ(error.what, "/no/such/program cannot be run: No such file or directory");
}

}  // namespace
}  // namespace mirocup::system
