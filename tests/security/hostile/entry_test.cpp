// SPDX-License-Identifier: MIT
//
// The file that is handed in, and the machine that it is played on, can be hostile too.
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>

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

TEST(HostileEntry, ThatIsNoLibraryDoesNotLoad) {
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

// Opening a pipe waits for its other end, unless one takes care.
TEST(HostileEntry, ThatIsAPipeDoesNotHoldTheServer) {
  const TemporaryFolder folder;
  mkfifo((folder / "pipe.so").c_str(), 0644);
  expect_no_load(folder / "pipe.so", "not a regular file");
}

TEST(HostileEntry, ThatIsALinkIsNotFollowed) {
  const TemporaryFolder folder;
  fs::create_symlink(program("house/chaser.so"), folder / "link.so");
  expect_no_load(folder / "link.so", "symbolic link");
  fs::create_symlink("/etc/shadow", folder / "shadow.so");
  expect_no_load(folder / "shadow.so", "symbolic link");
}

TEST(HostileEntry, ThatIsHugeIsNotRead) {
  const TemporaryFolder folder;
  std::ofstream(folder / "huge.so") << "\x7f"
                                       "ELF";
  fs::resize_file(folder / "huge.so", 1ull << 40);
  expect_no_load(folder / "huge.so", "larger than 32 MiB");
}

TEST(HostileEntry, ThatIsCutOffDoesNotLoad) {
  const TemporaryFolder folder;
  const std::string whole = read_file(program("house/chaser.so"));
  for (const std::size_t size :
       {std::size_t{60}, std::size_t{500}, whole.size() / 2, whole.size() - 1}) {
    write_file(folder / "cut.so", whole.substr(0, size));
    expect_no_load(folder / "cut.so", "cut off");
  }
}

// What is hashed is what plays, though the file changes all the time.
TEST(HostileEntry, ThatChangesWhileItIsReadPlaysAsItWasHashed) {
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

// The process of a team that somebody else kills: the leg is void, nobody loses.
TEST(Host, ThatKillsATeamVoidsTheLeg) {
  const TemporaryFolder folder;
  Running server(match("chaser", folder / "leg.json", "36000"));
  const std::string children = "/proc/" + std::to_string(server.pid()) + "/task/" +
                               std::to_string(server.pid()) + "/children";
  int team = 0;
  // Until it has left the probe behind and plays.
  for (int seen = 0; seen < 100;) {
    int pid = 0;
    if (std::ifstream(children) >> pid && pid == team) ++seen;
    team = pid;
    std::this_thread::yield();
    std::string name;
    std::ifstream("/proc/" + std::to_string(team) + "/comm") >> name;
    if (name.rfind("mirocup-plugin", 0) != 0 && name.rfind("memfd", 0) != 0) seen = 0;
  }
  kill(team, SIGKILL);
  EXPECT_EQ(server.wait().exit_code, 5);
  const Json result = read_json(folder / "leg.json")["result"];
  EXPECT_EQ(result["end"], "void");
  EXPECT_TRUE(result["fault"].is_null());
}

// A server that dies takes its teams along.
TEST(Host, ThatIsKilledLeavesNoTeamBehind) {
  const TemporaryFolder folder;
  std::string pids;
  {
    Running server(match("chaser", folder / "leg.json", "36000"));
    const std::string children = "/proc/" + std::to_string(server.pid()) + "/task/" +
                                 std::to_string(server.pid()) + "/children";
    while (std::count(pids.begin(), pids.end(), ' ') < 2) pids = read_file(children);
  }
  std::istringstream each(pids);
  for (int pid = 0; each >> pid;) {
    // Or the test never ends.
    while (kill(pid, 0) == 0) waitpid(pid, nullptr, WNOHANG);
  }
}

TEST(Host, WithoutNamespacesPlaysInT1) {
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

TEST(Host, BelowT1RefusesUnlessTrusted) {
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
