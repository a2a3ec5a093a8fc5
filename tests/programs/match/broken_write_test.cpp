// SPDX-License-Identifier: MIT
//
// A match server that is killed, or whose disk fills up, at any moment of writing leaves a whole
// record or none. Catches a record that exists before its replay, or before it is whole. For many
// more tries:
//   MIROCUP_TRIES=200 build/match_tests --gtest_filter='BrokenWrite.*'
#include "core/base/random.hpp"
#include "tests/support/program.hpp"
#include "tests/support/tries.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <sys/mount.h>
#include <unistd.h>

namespace mirocup {
namespace {

using namespace test_support;

constexpr int few = 20;

std::vector<std::string> match(const std::string& record, int seed = 1) {
  return {program("mirocup"),  "match",  "--blue", "idle",     "--yellow", "idle",
          "--trusted",         "--half", "10",     "--record", record,     "--seed",
          std::to_string(seed)};
}

// Returns whether a record exists, and expects an existing one to be whole.
bool is_there(const std::string& record) {
  const Outcome verified = run_mirocup({"verify", record});
  if (verified.exit_code == 3 && !std::filesystem::exists(record)) return false;
  EXPECT_EQ(verified.exit_code, 0) << verified.err << verified.out;
  return true;
}

// Catches marks or a table in a file that is cut off, with an exit code that says they are whole.
TEST(BrokenWrite, OfTheAnswerIsNoSuccess) {
  const auto shell = [](const std::string& words) {
    return run({"/bin/bash", "-c", "set -o pipefail; '" + program("mirocup") + "' " + words});
  };
  for (const char* command : {"drill list", "help match", "league init --help"}) {
    const Outcome full = shell(std::string(command) + " >/dev/full");
    EXPECT_EQ(full.exit_code, 3) << command;
    EXPECT_TRUE(contains(full.err, "standard output"));
    EXPECT_EQ(shell(std::string(command) + " >&-").exit_code, 0) << command;
    EXPECT_EQ(shell(std::string(command) + " | true").err, "") << command;
  }
}

TEST(BrokenWrite, KillLeavesTheWholeRecordOrNone) {
  const auto begin = std::chrono::steady_clock::now();
  {
    const TemporaryFolder folder;
    ASSERT_EQ(run(match(folder / "leg.json")).exit_code, 0);
  }
  const std::chrono::duration<double, std::micro> whole = std::chrono::steady_clock::now() - begin;
  double moment = whole.count();  // us
  Random random(7);
  int there = 0;
  int killed = 0;
  // More if all kills came too early or too late: the load of the machine has changed.
  for (int i = 0; i < tries(few) || (i < 300 && (there == 0 || killed == 0)); ++i) {
    const TemporaryFolder folder;
    Running server(match(folder / "leg.json"));
    usleep(static_cast<useconds_t>(moment));
    server.signal(SIGKILL);
    if (server.wait().exit_code != 0) ++killed;
    const bool is_written = is_there(folder / "leg.json");
    there += is_written ? 1 : 0;
    // Most kills come around the end of the match, when it writes, however fast this machine is.
    moment *= is_written ? random.uniform(0.7, 1.0) : random.uniform(1.0, 1.3);
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_GT(killed, 0);
  EXPECT_GT(there, 0);
}

TEST(BrokenWrite, FullDiskLeavesTheWholeRecordOrNone) {
  int there = 0;
  int refused = 0;
  for (int i = 0; i < tries(few); ++i) {
    const int kibibytes = 4 + 4 * (i % 12);  // pages
    const TemporaryFolder folder;
    const std::string disk = folder / "disk";
    std::filesystem::create_directory(disk);
    const std::string size = "size=" + std::to_string(kibibytes) + "k";
    if (mount("none", disk.c_str(), "tmpfs", 0, size.c_str()) != 0) {
      GTEST_SKIP() << "no file system of a test's own may be mounted here";
    }
    const Outcome played = run(match(disk + "/leg.json", i));
    const bool is_written = is_there(disk + "/leg.json");
    umount(disk.c_str());
    EXPECT_EQ(is_written, played.exit_code == 0) << played.err;
    there += is_written ? 1 : 0;
    if (played.exit_code == 3) ++refused;
  }
  EXPECT_GT(there, 0);
  EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace mirocup
