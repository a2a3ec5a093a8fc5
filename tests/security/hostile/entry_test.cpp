// SPDX-License-Identifier: MIT
//
// Catches a server that trusts the file of an entry, and one that misjudges a fault of its own
// machine.
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <poll.h>
#include <sstream>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace mirocup {
namespace {

namespace fs = std::filesystem;
using namespace test_support;
using Json = nlohmann::ordered_json;

std::vector<std::string> match(const std::string& blue, const std::string& record,
                               const std::string& half = "2") {
  return {program("mirocup"), "match",  "--blue", blue,       "--yellow",
          "chaser",           "--half", half,     "--record", record};
}

void expect_no_load(const std::string& library, const std::string& why) {
  const TemporaryFolder folder;
  expect_exit(0, run(match(library, folder / "leg.json")));
  const Json result = read_json(folder / "leg.json")["result"];
  EXPECT_EQ(result["fault"]["code"], "no_load");
  EXPECT_TRUE(contains(result["fault"]["text"].get<std::string>(), why)) << result.dump();
}

// Catches an open() that waits for the other end of a pipe, a link that is followed, and a file
// that takes all memory.
TEST(HostileEntry, FileThatIsNoLibraryDoesNotLoad) {
  const TemporaryFolder folder;
  write_file(folder / "text.so", "not a library\n");
  write_file(folder / "empty.so", "");
  fs::create_directory(folder / "folder.so");
  mkfifo((folder / "pipe.so").c_str(), 0644);
  fs::create_symlink(program("house/chaser.so"), folder / "link.so");
  fs::create_symlink("/etc/shadow", folder / "shadow.so");
  write_file(folder / "huge.so",
             "\x7f"
             "ELF");
  fs::resize_file(folder / "huge.so", 1ull << 40);
  const std::map<std::string, std::string> reasons{
      {folder / "text.so", "not an ELF file"},          {folder / "empty.so", "empty"},
      {folder / "folder.so", "not a regular file"},     {"/dev/zero", "not a regular file"},
      {folder / "pipe.so", "not a regular file"},       {folder / "link.so", "symbolic link"},
      {folder / "shadow.so", "symbolic link"},          {folder / "huge.so", "larger than 32 MiB"},
      {program("mirocup-plugin-host"), "not a library"}};
  for (const auto& [file, why] : reasons) expect_no_load(file, why);
  const std::string whole = read_file(program("house/chaser.so"));
  for (const std::size_t size :
       {std::size_t{60}, std::size_t{500}, whole.size() / 2, whole.size() - 1}) {
    write_file(folder / "cut.so", whole.substr(0, size));
    expect_no_load(folder / "cut.so", "cut off");
  }
}

// The bytes that were hashed are those that play, even if the file changes all the time.
TEST(HostileEntry, FileThatChangesPlaysAsItWasHashed) {
  const TemporaryFolder folder;
  const std::string good = read_file(program("house/chaser.so"));
  const std::string bad = read_file(program("hostile/crash_segv.so"));
  write_file(folder / "good.so", good);
  write_file(folder / "bad.so", bad);
  fs::copy_file(folder / "good.so", folder / "entry.so");
  std::atomic<bool> is_over = false;
  std::thread changer([&] {
    for (int i = 0; !is_over; ++i) {
      fs::create_hard_link(folder / (i % 2 == 0 ? "bad.so" : "good.so"), folder / "next.so");
      fs::rename(folder / "next.so", folder / "entry.so");
      fs::remove(folder / "next.so");
    }
  });
  std::string hash_of_good;
  std::string hash_of_bad;
  for (int i = 0; i < 20; ++i) {
    expect_exit(0, run(match(folder / "entry.so", folder / "leg.json")));
    const Json record = read_json(folder / "leg.json");
    const std::string sha256 = record["teams"]["blue"]["sha256"].get<std::string>();
    std::string& hash = record["result"]["fault"].is_null() ? hash_of_good : hash_of_bad;
    if (hash.empty()) hash = sha256;
    EXPECT_EQ(sha256, hash);
  }
  is_over = true;
  changer.join();
  EXPECT_NE(hash_of_good, hash_of_bad);
}

// Returns the process IDs of the running processes that a server has started.
std::vector<int> children_of(const Running& server) {
  const std::string pid = std::to_string(server.pid());
  std::istringstream list(read_file("/proc/" + pid + "/task/" + pid + "/children"));
  return {std::istream_iterator<int>(list), {}};
}

// True if the process has become the host of a plugin, so it is not the probe that tries
// namespaces.
bool is_plugin_host(int pid) {
  const std::string name = read_file("/proc/" + std::to_string(pid) + "/comm");
  return name.rfind("mirocup-plugin", 0) == 0 || name.rfind("memfd", 0) == 0;
}

bool are_both_teams_there(const Running& server) {
  const std::vector<int> teams = children_of(server);
  return teams.size() == 2 && std::all_of(teams.begin(), teams.end(), is_plugin_host);
}

TEST(TeamProcess, KilledFromOutsideVoidsTheLeg) {
  const TemporaryFolder folder;
  Running server(match("chaser", folder / "leg.json", "36000"));
  ASSERT_TRUE(wait_until([&] { return are_both_teams_there(server); })) << server.err();
  kill(children_of(server).front(), SIGKILL);
  EXPECT_EQ(server.wait().exit_code, 5);
  const Json result = read_json(folder / "leg.json")["result"];
  EXPECT_EQ(result["end"], "void");
  EXPECT_TRUE(result["fault"].is_null());
  const std::string why = result["why_void"].get<std::string>();
  EXPECT_TRUE(contains(why, "team's process was killed from outside"));
}

class OrphanedTeams {
 public:
  // Orphans become children of this process, so that none of them stays a zombie elsewhere.
  explicit OrphanedTeams(std::vector<int> teams) : teams_(std::move(teams)) {
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    for (const int pid : teams_) {
      handles_.push_back(static_cast<int>(syscall(SYS_pidfd_open, pid, 0)));
      EXPECT_GE(handles_.back(), 0) << std::strerror(errno);
    }
  }

  void expect_end(int within_ms) const {
    for (std::size_t i = 0; i < teams_.size(); ++i) {
      pollfd ended{handles_[i], POLLIN, 0};  // readable once the process has ended
      EXPECT_EQ(poll(&ended, 1, within_ms), 1)
          << "process " << teams_[i] << " of a team runs on without its server";
      close(handles_[i]);
      kill(teams_[i], SIGKILL);
      waitpid(teams_[i], nullptr, 0);
    }
  }

 private:
  std::vector<int> teams_;
  std::vector<int> handles_;
};

// Returns the processor time of a process, s.
double processor_time(int pid) {
  clockid_t clock = 0;
  timespec time{};
  if (clock_getcpuclockid(pid, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0.0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

class TeamProcessInTier : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (GetParam() == std::string("T2") && !why_no_t2().empty()) GTEST_SKIP() << why_no_t2();
  }
  static std::vector<std::string> match_in_tier(const std::string& blue,
                                                const std::string& record) {
    auto words = match(blue, record, "36000");
    words.insert(words.end(), {"--isolation", GetParam()});
    return words;
  }
};
INSTANTIATE_TEST_SUITE_P(Tiers, TeamProcessInTier, testing::Values("T1", "T2"));

TEST_P(TeamProcessInTier, EndsWhenItsServerIsKilled) {
  const TemporaryFolder folder;
  std::optional<OrphanedTeams> teams;
  {
    Running server(match_in_tier("chaser", folder / "leg.json"));
    ASSERT_TRUE(wait_until([&] { return are_both_teams_there(server); })) << server.err();
    teams.emplace(children_of(server));
  }
  teams->expect_end(60'000);
}

// The server is stopped first, so that it does not end the team for the time that it uses.
TEST_P(TeamProcessInTier, ThatSpinsEndsWhenItsServerIsKilled) {
  const TemporaryFolder folder;
  std::optional<OrphanedTeams> teams;
  {
    Running server(match_in_tier(program("hostile/loop_forever.so"), folder / "leg.json"));
    ASSERT_TRUE(wait_until([&] { return are_both_teams_there(server); })) << server.err();
    const std::vector<int> pids = children_of(server);
    const auto spins = [&](double s) {
      return std::any_of(pids.begin(), pids.end(),
                         [s](int pid) { return processor_time(pid) > s; });
    };
    ASSERT_TRUE(wait_until([&] { return spins(0.2); })) << server.err();
    kill(server.pid(), SIGSTOP);
    ASSERT_TRUE(wait_until([&] { return spins(1.5); })) << "a tick may take 1 s";
    teams.emplace(pids);
  }
  teams->expect_end(10'000);
}

// What ends a job sends SIGTERM to all its processes. Catches a team that loses its leg by that.
TEST_P(TeamProcessInTier, IsNotEndedByASignalForTheWholeJob) {
  const TemporaryFolder folder;
  Running server(match_in_tier("chaser", folder / "leg.json"));
  ASSERT_TRUE(wait_until([&] { return are_both_teams_there(server); })) << server.err();
  for (const int pid : children_of(server)) {
    for (const int signal : {SIGTERM, SIGHUP, SIGINT, SIGUSR1, SIGXCPU, SIGSEGV}) kill(pid, signal);
  }
  const std::vector<int> teams = children_of(server);
  ASSERT_EQ(teams.size(), 2u);
  const double before = processor_time(teams[0]);
  EXPECT_TRUE(wait_until([&] { return processor_time(teams[0]) > before; })) << "it plays on";
  kill(server.pid(), SIGTERM);
  EXPECT_EQ(server.wait().exit_code, 130);
}

// What suspends a job stops all its processes. Catches a server that counts that time as the
// team's, which is then found without an answer for longer than a tick may take.
TEST_P(TeamProcessInTier, IsNotBlamedForTheTimeInWhichTheWholeJobWasStopped) {
  const TemporaryFolder folder;
  Running server(match_in_tier(program("hostile/slow_every_tick.so"), folder / "leg.json"));
  ASSERT_TRUE(wait_until([&] { return are_both_teams_there(server); })) << server.err();
  const std::vector<int> teams = children_of(server);
  ASSERT_EQ(teams.size(), 2u);
  const auto has_played = [&](double s) { return processor_time(teams[0]) > s; };
  ASSERT_TRUE(wait_until([&] { return has_played(0.1); })) << server.err();
  for (const int pid : teams) kill(pid, SIGSTOP);
  usleep(100'000);  // the server is waiting for an answer now
  kill(server.pid(), SIGSTOP);
  sleep(11);
  kill(server.pid(), SIGCONT);
  usleep(100'000);
  const double before = processor_time(teams[0]);
  for (const int pid : teams) kill(pid, SIGCONT);
  EXPECT_TRUE(wait_until([&] { return has_played(before + 0.1); })) << server.err();
  kill(server.pid(), SIGTERM);
  EXPECT_EQ(server.wait().exit_code, 130);
}

// RLIMIT_CPU ended long legs as void, and its soft limit would end one as the team's crash.
TEST(TeamProcess, HasNoLimitOfProcessorTimeButItsBudget) {
  const TemporaryFolder folder;
  auto words = match(program("hostile/slow_bank.so"), folder / "leg.json", "60");
  words.insert(words.begin(), {"/usr/bin/prlimit", "--cpu=1:"});
  expect_exit(0, run(words));
  const Json result = read_json(folder / "leg.json")["result"];
  EXPECT_EQ(result["fault"]["code"], "budget") << "more than 1 s, the limit: " << result.dump();
}

// Catches a bank that counts only when a tick is over.
TEST(TeamProcess, EndsInTheTickInWhichItsBankIsSpent) {
  const TemporaryFolder folder;
  expect_exit(0, run(match(program("hostile/slow_then_spin.so"), folder / "leg.json", "60")));
  const Json record = read_json(folder / "leg.json");
  EXPECT_EQ(record["result"]["fault"]["code"], "budget") << record["result"].dump();
  EXPECT_LT(record["budget"]["blue"]["cpu_seconds"], 2.7);
}

// A group of processes with little memory; it can only be made by root.
class SmallGroup {
 public:
  SmallGroup() {
    for (const std::string mount : {"/sys/fs/cgroup/memory", "/sys/fs/cgroup"}) {
      const std::string group = mount + "/mirocup_test." + std::to_string(getpid());
      if (mkdir(group.c_str(), 0755) != 0) continue;
      path_ = group;
      const bool is_first_version = fs::exists(group + "/memory.limit_in_bytes");
      const std::string limit = is_first_version ? "/memory.limit_in_bytes" : "/memory.max";
      std::ofstream file(group + limit);
      if (file << "200000000" << std::flush) return;
      rmdir(group.c_str());
      path_.clear();
    }
  }
  ~SmallGroup() {
    if (!path_.empty()) rmdir(path_.c_str());
  }
  SmallGroup(const SmallGroup&) = delete;
  SmallGroup& operator=(const SmallGroup&) = delete;

  bool exists() const { return !path_.empty(); }
  // Returns the words that run a program in the group.
  std::vector<std::string> words(const std::vector<std::string>& program) const {
    std::vector<std::string> words{"/bin/sh", "-c", "echo $$ > $0/cgroup.procs && exec \"$@\"",
                                   path_};
    words.insert(words.end(), program.begin(), program.end());
    return words;
  }

 private:
  std::string path_;
};

// Catches a team that makes its leg void where memory is short, and nobody learns who it was.
TEST(TeamProcess, ThatTheKernelEndsForItsMemoryIsNamed) {
  const SmallGroup group;
  if (!group.exists()) GTEST_SKIP() << "no control group of memory can be made here";
  const TemporaryFolder folder;
  const Outcome played =
      run(group.words(match(program("hostile/mem_leak.so"), folder / "leg.json", "20")));
  EXPECT_EQ(played.exit_code, 5) << "the host had not what both teams may take: " << played.err;
  const Json result = read_json(folder / "leg.json")["result"];
  EXPECT_EQ(result["end"], "void");
  EXPECT_TRUE(result["fault"].is_null());
  const std::string why = result["why_void"].get<std::string>();
  EXPECT_EQ(
      why.rfind("the blue team's process was ended for want of memory when it had taken 1", 0), 0u)
      << why;
  EXPECT_TRUE(contains(why, "a leg may take 2112 MiB"));
}

TEST(HostWithoutNamespaces, PlaysInT1) {
  const TemporaryFolder folder;
  auto words = match("chaser", folder / "leg.json");
  words.insert(words.begin(), {program("hostile/without"), "namespaces"});
  EXPECT_EQ(run(words).exit_code, 0);
  EXPECT_EQ(read_json(folder / "leg.json")["isolation"], "T1");
  words.insert(words.end(), {"--isolation", "T2"});
  expect_exit(3, run(words), "T1 only");
}

TEST(HostWithoutLandlock, RefusesToPlayUnlessTrusted) {
  const TemporaryFolder folder;
  auto words = match("chaser", folder / "leg.json");
  words.insert(words.begin(), {program("hostile/without"), "landlock"});
  const Outcome refused = expect_exit(3, run(words), "Landlock");
  EXPECT_TRUE(contains(refused.err, "--trusted"));
  EXPECT_FALSE(fs::exists(folder / "leg.json"));
  words.push_back("--trusted");
  EXPECT_EQ(run(words).exit_code, 0);
}

}  // namespace
}  // namespace mirocup
