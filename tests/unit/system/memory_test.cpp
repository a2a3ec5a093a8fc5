// SPDX-License-Identifier: MIT
//
// What the kernel tells about memory, in both versions of control groups. Catches a reader that
// sees the machine's memory where a group has less.
#include "system/memory.hpp"

#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace mirocup::system {
namespace {

class Memory : public testing::Test {
 protected:
  void write(const std::string& path, const std::string& text) const {
    const std::filesystem::path file = root_ + path;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << text;
  }

  const test_support::TemporaryFolder folder_;
  const std::string root_ = folder_ / "root";
};

TEST_F(Memory, IsWhatTheKernelCallsAvailable) {
  EXPECT_FALSE(available_memory(root_));
  write("/proc/meminfo", "MemTotal:  8000 kB\nMemFree:  100 kB\nMemAvailable:    4000 kB\n");
  EXPECT_EQ(available_memory(root_), 4000u << 10);
}

TEST_F(Memory, IsLimitedByTheGroupsAroundTheProcess) {
  write("/proc/meminfo", "MemAvailable: 4000000 kB\n");
  write("/proc/self/cgroup", "0::/batch/job\n");
  write("/sys/fs/cgroup/batch/job/memory.max", "max\n");
  write("/sys/fs/cgroup/batch/job/memory.current", "5000\n");
  EXPECT_EQ(available_memory(root_), 4000000ull << 10);
  write("/sys/fs/cgroup/batch/memory.max", "900000\n");
  write("/sys/fs/cgroup/batch/memory.current", "500000\n");
  write("/sys/fs/cgroup/batch/memory.stat", "anon 1\ninactive_file 20000\nactive_file 10000\n");
  EXPECT_EQ(available_memory(root_), 430000u) << "pages of files can be dropped";
  write("/sys/fs/cgroup/batch/job/memory.max", "4000\n");
  EXPECT_EQ(available_memory(root_), 0u) << "more is used than is allowed";
}

TEST_F(Memory, IsLimitedByGroupsOfTheFirstVersion) {
  write("/proc/meminfo", "MemAvailable: 4000000 kB\n");
  write("/proc/self/cgroup", "4:cpu,memory:/job\n1:pids:/job\n0::/\n");
  write("/sys/fs/cgroup/memory/job/memory.limit_in_bytes", "300000\n");
  write("/sys/fs/cgroup/memory/job/memory.usage_in_bytes", "100000\n");
  EXPECT_EQ(available_memory(root_), 200000u);
}

TEST_F(Memory, CountsTheKillsOfTheKernel) {
  EXPECT_FALSE(out_of_memory_kills(root_));
  write("/proc/vmstat", "pgfault 7\noom_kill 3\nother 1\n");
  EXPECT_EQ(out_of_memory_kills(root_), 3u);
}

TEST(MemoryOfThisMachine, IsKnown) {
  EXPECT_GT(available_memory().value_or(0), 1u << 20);
  EXPECT_EQ(mebibytes(std::size_t{181} << 20), "181 MiB");
}

}  // namespace
}  // namespace mirocup::system
