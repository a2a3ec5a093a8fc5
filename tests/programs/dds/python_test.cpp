// SPDX-License-Identifier: MIT
//
// A team in Python, which uses libmirocup_team and only Python's standard library.
#include "tests/programs/dds/network.hpp"

#include <gtest/gtest.h>

namespace mirocup {
namespace {

using namespace test_support;

TEST(PythonTeam, PlaysAFullLeg) {
  const TemporaryFolder folder;
  const std::string id = match_id("python");
  Running team({"/usr/bin/env", "MIROCUP_TEAM_LIBRARY=" + program("libmirocup_team.so"),
                "PYTHONDONTWRITEBYTECODE=1", "python3", "-S",
                MIROCUP_SOURCE_FOLDER "/examples/python/chaser.py", id, "blue", "snake"});
  expect_exit(0,
              run_mirocup({"match", "--blue", "dds:snake", "--yellow", "idle", "--league", "large",
                           "--half", "20", "--match", id, "--record", folder / "leg.json"}));
  expect_exit(0, team.wait());
  const auto record = read_json(folder / "leg.json");
  EXPECT_EQ(record["result"]["end"], "full_time") << record["result"].dump();
  EXPECT_GT(record["result"]["score"]["blue"],
            0);  // it receives true observations, and its commands are driven
  EXPECT_EQ(record["network"]["blue"]["in_step"], record["ticks"]);
  EXPECT_EQ(run_mirocup({"verify", folder / "leg.json"}).exit_code, 0);
}

// The team's placement request arrives: the record names a robot that was refused its place.
TEST(PythonTeam, SaysWhereItStands) {
  const TemporaryFolder folder;
  const std::string id = match_id("python-places");
  const std::string script =
      "import mirocup_team\n"
      "def place(setup, now, placement): placement.robots[2].x = 0.5\n"
      "def decide(setup, now): return []\n"
      "mirocup_team.play('" +
      id + "', 'blue', 'snake', decide, place=place)\n";
  Running team({"/usr/bin/env", "MIROCUP_TEAM_LIBRARY=" + program("libmirocup_team.so"),
                "PYTHONDONTWRITEBYTECODE=1", "PYTHONPATH=" MIROCUP_SOURCE_FOLDER "/examples/python",
                "python3", "-c", script});
  expect_exit(0, run_mirocup({"match", "--blue", "dds:snake", "--yellow", "idle", "--half", "1",
                              "--match", id, "--record", folder / "leg.json"}));
  expect_exit(0, team.wait());
  const auto record = read_json(folder / "leg.json");
  int fixed = 0;
  for (const auto& d : record["decisions"]) {
    if (d["decision"] != "PLACEMENT_FIXED") continue;
    ++fixed;
    EXPECT_EQ(d["team"], "blue");
    EXPECT_TRUE(contains(d["reason"].get<std::string>(), "robot 2")) << d;
  }
  EXPECT_EQ(fixed, 2) << "one for each kick-off";
}

// Catches `mirocup join` that takes a file of Python for a library that does not load, and one that
// plays it in another way than `mirocup match` does.
TEST(PythonTeam, JoinsWithoutAProgramOfItsOwn) {
  if (!std::filesystem::exists(program("mirocup-python.so"))) GTEST_SKIP() << "not built";
  const TemporaryFolder folder;
  const std::string id = match_id("python-join");
  write_file(folder / "team.py",
             "from mirocup.team import *\n"
             "class A(Team):\n"
             "    def decide(self, now):\n"
             "        return [drive_to(self.setup, r, ball(now)) for r in now.own]\n");
  const auto play = [&](const std::string& blue, const char* record) {
    expect_exit(0, run_mirocup({"match", "--blue", blue, "--yellow", "idle", "--half", "3",
                                "--match", id, "--record", folder / record}));
    return read_json(folder / record)["state_hash"];
  };
  Running remote(join(id, "blue", "snake", folder / "team.py"));
  const auto on_network = play("dds:snake", "dds.json");
  expect_exit(0, remote.wait());
  EXPECT_EQ(on_network, play(folder / "team.py", "py.json"));
}

}  // namespace
}  // namespace mirocup
