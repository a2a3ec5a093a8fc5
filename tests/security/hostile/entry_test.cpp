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
using test_support::Outcome;
using test_support::program;
using test_support::read_file;
using test_support::read_json;
using test_support::run;
using test_support::Running;
using test_support::TemporaryFolder;
using test_support::wait_until;
using test_support::write_file;
using Json = nlohmann::ordered_json;

std::vector<std::string> match(const std::string& blue, const std::string& record,
                               const std::string& half = "2") {
  return {program("mirocup"), "match",  "--blue", blue,       "--yellow",
          "chaser",           "--half", half,     "--record", record};
}

void expect_no_load(const std::string& library, const std::string& why) {
  const TemporaryFolder folder;
  const Outcome played = run(match(library, folder / "leg.json"));
  ASSERT_EQ(played.exit_code, 0) << played.err;
  const Json result = read_json(folder / "leg.json")["result"];
  EXPECT_EQ(result["fault"]["code"], "no_load");
  EXPECT_NE(result["fault"]["text"].get<std::string>().find(why), std::string::npos)
      << result.dump();
}

TEST(HostileEntry, FileThatIsNoLibraryDoesNotLoad) {
  const TemporaryFolder folder;
  write_file(folder / "text.so", "not a library\n");
  expect_no_load(folder / "text.so", "not an ELF file");
  write_file(folder / "empty.so", "");
  expect_no_load(folder / "empty.so", "empty");
  fs::create_directory(folder / "folder.so");
  expect_no_load(folder / "folder.so", "not a regular file");
  expect_no_load("/dev/zero", "not a regular file");
  expect_no_load(program("mirocup-plugin-host"), "not a library");
}

// Catches an open() that waits for the other end of the pipe.
TEST(HostileEntry, PipeDoesNotHoldTheServer) {
  const TemporaryFolder folder;
  mkfifo((folder / "pipe.so").c_str(), 0644);
  expect_no_load(folder / "pipe.so", "not a regular file");
}

TEST(HostileEntry, SymbolicLinkIsNotFollowed) {
  const TemporaryFolder folder;
  fs::create_symlink(program("house/chaser.so"), folder / "link.so");
  expect_no_load(folder / "link.so", "symbolic link");
  fs::create_symlink("/etc/shadow", folder / "shadow.so");
  expect_no_load(folder / "shadow.so", "symbolic link");
}

TEST(HostileEntry, HugeFileIsNotRead) {
  const TemporaryFolder folder;
  std::ofstream(folder / "huge.so") << "\x7f"
                                       "ELF";
  fs::resize_file(folder / "huge.so", 1ull << 40);
  expect_no_load(folder / "huge.so", "larger than 32 MiB");
}

TEST(HostileEntry, TruncatedLibraryDoesNotLoad) {
  const TemporaryFolder folder;
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
    const Outcome played = run(match(folder / "entry.so", folder / "leg.json"));
    EXPECT_EQ(played.exit_code, 0) << played.err;
    const Json record = read_json(folder / "leg.json");
    const std::string sha256 = record["teams"]["blue"]["sha256"];
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
}

TEST(TeamProcess, EndsWhenItsServerIsKilled) {
  const TemporaryFolder folder;
  // Orphans become children of this process, so that none of them stays a zombie elsewhere.
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  std::vector<int> teams;
  std::vector<int> handles;  // a handle is readable once its process has ended
  {
    Running server(match("chaser", folder / "leg.json", "36000"));
    ASSERT_TRUE(wait_until([&] { return are_both_teams_there(server); })) << server.err();
    teams = children_of(server);
    for (const int pid : teams) {
      handles.push_back(static_cast<int>(syscall(SYS_pidfd_open, pid, 0)));
      ASSERT_GE(handles.back(), 0) << std::strerror(errno);
    }
  }
  for (std::size_t i = 0; i < teams.size(); ++i) {
    pollfd ended{handles[i], POLLIN, 0};
    EXPECT_EQ(poll(&ended, 1, 60'000), 1)
        << "process " << teams[i] << " of a team runs a minute after its server was killed";
    close(handles[i]);
    kill(teams[i], SIGKILL);
    waitpid(teams[i], nullptr, 0);
  }
}

TEST(HostWithoutNamespaces, PlaysInT1) {
  const TemporaryFolder folder;
  auto words = match("chaser", folder / "leg.json");
  words.insert(words.begin(), {program("hostile/without"), "namespaces"});
  EXPECT_EQ(run(words).exit_code, 0);
  EXPECT_EQ(read_json(folder / "leg.json")["isolation"], "T1");
  words.insert(words.end(), {"--isolation", "T2"});
  const Outcome refused = run(words);
  EXPECT_EQ(refused.exit_code, 3);
  EXPECT_NE(refused.err.find("T1 only"), std::string::npos) << refused.err;
}

TEST(HostWithoutLandlock, RefusesToPlayUnlessTrusted) {
  const TemporaryFolder folder;
  auto words = match("chaser", folder / "leg.json");
  words.insert(words.begin(), {program("hostile/without"), "landlock"});
  const Outcome refused = run(words);
  EXPECT_EQ(refused.exit_code, 3);
  EXPECT_NE(refused.err.find("Landlock"), std::string::npos) << refused.err;
  EXPECT_NE(refused.err.find("--trusted"), std::string::npos) << refused.err;
  EXPECT_FALSE(fs::exists(folder / "leg.json"));
  words.push_back("--trusted");
  EXPECT_EQ(run(words).exit_code, 0);
}

}  // namespace
}  // namespace mirocup
