// SPDX-License-Identifier: MIT
//
// Files that are none, names of any bytes, and names that another user has put in the way. Catches
// a reader that waits or takes all memory, an answer that is no JSON or that writes lines of its
// own, and a record that is written through a link.
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>

namespace mirocup {
namespace {

namespace fs = std::filesystem;
using namespace test_support;

std::vector<std::string> mirocup(std::vector<std::string> words) {
  words.insert(words.begin(), program("mirocup"));
  return words;
}

Outcome play(const std::string& record) {
  return run(mirocup({"match", "--blue", "idle", "--yellow", "idle", "--trusted", "--half", "1",
                      "--record", record}));
}

class StrangeFiles : public testing::Test {
 protected:
  TemporaryFolder folder_;
};

TEST_F(StrangeFiles, AreRefusedByEveryReader) {
  const std::string pipe = folder_ / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  write_file(folder_ / "big", "");
  ASSERT_EQ(truncate((folder_ / "big").c_str(), off_t{8} << 30), 0);
  for (const std::string& file : {pipe, std::string("/dev/zero"), folder_ / ".", folder_ / "big"}) {
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"verify", file},
          {"scene", file},
          {"referee", file},
          {"referee", "--record", file},
          {"replay", file, "-o", folder_ / "page.html"},
          {"rerun", file},
          {"league", "init", folder_ / "l", "--config", file},
          {"league", "init", folder_ / "l", "--team", "a=" + file}}) {
      const Outcome outcome = run(mirocup(command));
      EXPECT_EQ(outcome.exit_code, 2) << command[0] << ' ' << file << ": " << outcome.err;
      EXPECT_TRUE(contains(outcome.err, file + ": it is "));
    }
  }
}

// Catches a leg that a source or an archive loses by 0 : 10: its owner named the wrong file.
TEST_F(StrangeFiles, AreNoTeamOfAMatch) {
  for (const auto& [name, text] :
       {std::pair("team.cpp", "#include <cmath>\n"), std::pair("team.rar", "Rar!\x1a\x07\x01"),
        std::pair("README.md", "# Mine\n\n```\nx\n```\n")}) {
    write_file(folder_ / name, text);
    expect_exit(2, run(mirocup({"match", "--blue", folder_ / name, "--yellow", "idle"})), name);
  }
}

TEST_F(StrangeFiles, MayHaveNamesOfAnyBytes) {
  const std::string record = folder_ / "a\xff\n\x1b[31mverified\n.json";
  ASSERT_EQ(play(record).exit_code, 0);
  for (const std::vector<std::string>& command : {std::vector<std::string>{"verify", record},
                                                  {"rerun", record},
                                                  {"referee", "--record", record}}) {
    std::vector<std::string> with_json = command;
    with_json.emplace_back("--json");
    const Outcome json = run(mirocup(with_json));
    EXPECT_EQ(json.exit_code, 0) << command[0] << json.err;
    EXPECT_TRUE(nlohmann::json::accept(json.out)) << json.out;
    const Outcome text = run(mirocup(command));
    EXPECT_FALSE(contains(text.out, "\nverified"));
    EXPECT_EQ(text.out.find('\x1b'), std::string::npos) << text.out;
  }
  expect_exit(3, run(mirocup({"verify", folder_ / "no\nsuch\x1b[31mfile\xff"})),
              "no\\x0asuch\\x1b[31mfile\\xff cannot be read");
  EXPECT_EQ(run(mirocup({"match", "--blue", std::string(300, 'x'), "--yellow", "idle"})).exit_code,
            2)
      << "longer than any name of a file";
}

// A ball on its way for years, wheels that hold a billionth of the weight or any force, a rolling
// resistance that is linear below a nanometre per second, and robots of 20 nm did not end. A row
// of robots that is hit at 1e5 m/s overlapped.
TEST_F(StrangeFiles, AreScenesThatEnd) {
  const std::string file = folder_ / "s.json";
  for (const char* scene :
       {R"("duration":1e9)", R"("duration":1,"parameters":{"grip":1e-9})",
        R"("duration":1,"parameters":{"grip":0})", R"("duration":1,"parameters":{"grip":1e300})",
        R"("duration":1,"parameters":{"k":1e-9})",
        R"("duration":1,"parameters":{"robot_side":2e-8})",
        R"("duration":1,"robots":[{"pose":[0,0,0],"twist":[1e5,0,0]}])"}) {
    write_file(file, std::string("{\"schema\":\"mirocup/scene/1\",") + scene + "}");
    const Outcome refused = run(mirocup({"scene", file}));
    EXPECT_EQ(refused.exit_code, 2) << scene;
    EXPECT_TRUE(contains(refused.err, "s.json: /"));
  }
}

// In a folder that others may write to.
TEST_F(StrangeFiles, AreNotWrittenThroughLinks) {
  write_file(folder_ / "precious", "precious");
  for (const char* name : {"r.json", "r.replay.zst", "page.html"})
    fs::create_symlink(folder_ / "precious", folder_ / name);
  ASSERT_EQ(play(folder_ / "r.json").exit_code, 0);
  ASSERT_EQ(run(mirocup({"replay", folder_ / "r.json", "-o", folder_ / "page.html"})).exit_code, 0);
  EXPECT_EQ(read_file(folder_ / "precious"), "precious");
  for (const char* name : {"r.json", "r.replay.zst", "page.html"})
    EXPECT_FALSE(fs::is_symlink(folder_ / name)) << name;
  EXPECT_EQ(run(mirocup({"verify", folder_ / "r.json"})).exit_code, 0);
}

// A pipe or a link to a device of another user is a name in the way and no place to write to.
TEST_F(StrangeFiles, OfAnotherUserAreReplaced) {
  if (geteuid() != 0) GTEST_SKIP() << "only the superuser makes files of two users";
  constexpr uid_t other = 64001;
  ASSERT_EQ(mkfifo((folder_ / "r.json").c_str(), 0666), 0);
  ASSERT_EQ(chown((folder_ / "r.json").c_str(), other, other), 0);
  fs::create_symlink("/dev/full", folder_ / "r.replay.zst");
  ASSERT_EQ(lchown((folder_ / "r.replay.zst").c_str(), other, other), 0);
  ASSERT_EQ(play(folder_ / "r.json").exit_code, 0);
  EXPECT_EQ(run(mirocup({"verify", folder_ / "r.json"})).exit_code, 0);
}

// Catches a device that is refused because its folder is not the user's, and a replay beside it.
TEST_F(StrangeFiles, ADeviceIsWrittenIntoByAnyUser) {
  auto words = geteuid() == 0 ? mirocup_of_nobody() : mirocup({});
  words.insert(words.end(), {"match", "--blue", "idle", "--yellow", "idle", "--half", "1",
                             "--record", "/dev/null"});
  EXPECT_EQ(run(words).exit_code, 0);
  EXPECT_EQ(play("/dev/null").exit_code, 0);
  EXPECT_FALSE(fs::exists("/dev/null.replay.zst"));
}

}  // namespace
}  // namespace mirocup
