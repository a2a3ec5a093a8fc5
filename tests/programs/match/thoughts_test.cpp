// SPDX-License-Identifier: MIT
#include "record/thoughts_file.hpp"
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>
#include <sstream>

namespace mirocup {
namespace {

using namespace test_support;
using ThoughtJson = nlohmann::ordered_json;

std::vector<std::string> drawing_match(const TemporaryFolder& folder,
                                       const std::vector<std::string>& more) {
  std::vector<std::string> words{
      program("mirocup"), "match", "--blue",   program("teams/draws.so"), "--yellow", "idle",
      "--half",           "2",     "--record", folder / "leg.json"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::vector<ThoughtJson> thoughts_in(const std::string& path) {
  const auto lines = record::unpacked_thoughts(read_file(path), path);
  std::vector<ThoughtJson> all;
  if (!lines) return all;
  std::istringstream in(*lines);
  for (std::string line; std::getline(in, line);) all.push_back(ThoughtJson::parse(line));
  return all;
}

// Catches a shape that is lost or another one in a process than in the server, a leg that thoughts
// change, and text of a team that could be read as something else.
TEST(Thoughts, AreKeptBesideTheRecordAndChangeNothing) {
  std::string bytes, hash;
  for (const bool is_trusted : {false, true}) {
    const TemporaryFolder folder;
    std::vector<std::string> more{"--thoughts"};
    if (is_trusted) more.emplace_back("--trusted");
    const auto outcome = run(drawing_match(folder, more));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "shapes of the blue team's thoughts were left out"));
    const auto record = read_json(folder / "leg.json");
    const auto thoughts = thoughts_in(folder / "leg.blue.thoughts.zst");
    const std::size_t ticks = record["ticks"].get<std::size_t>();
    ASSERT_EQ(thoughts.size(), 7 * ticks + 1);  // the last line says what was left out
    EXPECT_EQ(thoughts[0]["tick"], 0);
    EXPECT_EQ(thoughts[7]["tick"], 1);
    EXPECT_EQ(thoughts[0]["layer"], "plan");
    EXPECT_EQ(thoughts[0]["colour"], "#ff8000ff");
    EXPECT_EQ(thoughts[0]["line"].size(), 4u);
    EXPECT_EQ(thoughts[3]["circle"][2], 0.03);
    EXPECT_EQ(thoughts[4]["polygon"], ThoughtJson::parse("[[0.2,0.2],[0.4,0.2],[0.3,0.4]]"));
    EXPECT_EQ(thoughts[5]["text"][2], "the \"ball\" <is> \\x1b[2J here");
    EXPECT_EQ(thoughts[6]["text"][2].get<std::string>().rfind("distance = ", 0), 0u);
    EXPECT_EQ(thoughts.back()["text"][2],
              std::to_string(ticks) + " shapes of the leg were left out");
    EXPECT_EQ(thoughts_in(folder / "leg.yellow.thoughts.zst").size(), 0u);
    const std::string now = read_file(folder / "leg.blue.thoughts.zst");
    if (!is_trusted) bytes = now, hash = record["state_hash"].get<std::string>();
    EXPECT_EQ(now, bytes);
    EXPECT_EQ(record["state_hash"], hash);
    EXPECT_EQ(run_mirocup({"verify", folder / "leg.json"}).exit_code, 0);
  }
  const TemporaryFolder folder;
  ASSERT_EQ(run(drawing_match(folder, {"--trusted"})).exit_code, 0);
  EXPECT_EQ(read_json(folder / "leg.json")["state_hash"], hash);
}

// Catches a house team that draws nothing or too much, that names a robot's role twice or not at
// all, and one that plays otherwise when it is watched.
TEST(Thoughts, OfHouseTeamsTellTheirPlansAndChangeNothing) {
  const std::map<std::string, std::set<std::string>> layers{
      {"keeper", {"roles", "shots", "targets"}},
      {"chaser", {"roles", "shots", "targets"}},
      {"striker", {"roles", "shots", "targets"}},
      {"navigator", {"roles", "shots", "targets"}},
      {"tactician", {"roles", "shots", "targets"}},
      {"planner", {"expected attacker", "expected ball", "roles", "shots", "targets", "values"}}};
  for (const auto& [team, expected] : layers) {
    const TemporaryFolder folder;
    std::vector<std::string> words{program("mirocup"), "match",   "--blue",   team,
                                   "--yellow",         "striker", "--league", "large",
                                   "--half",           "4",       "--record", folder / "leg.json"};
    ASSERT_EQ(run(words).exit_code, 0);
    const auto hash = read_json(folder / "leg.json")["state_hash"];
    words.emplace_back("--thoughts");
    const auto outcome = run(words);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_FALSE(contains(outcome.err, "left out")) << team;
    EXPECT_EQ(read_json(folder / "leg.json")["state_hash"], hash) << team;
    std::set<std::string> drawn;
    std::map<std::size_t, std::size_t> roles;  // by tick
    for (const ThoughtJson& thought : thoughts_in(folder / "leg.blue.thoughts.zst")) {
      drawn.insert(thought["layer"].get<std::string>());
      if (thought["layer"] == "roles") ++roles[thought["tick"].get<int>()];
    }
    EXPECT_EQ(drawn, expected) << team;
    const std::size_t told = team == "planner" ? 2 : 11;  // robots in a tick
    for (const auto& [tick, count] : roles) ASSERT_EQ(count, told) << team << ", tick " << tick;
  }
}

// A team in Python that stands, and draws shapes which tell its colour.
constexpr const char* python_team = R"py(
from mirocup.team import *

class Draws(Team):
    def decide(self, now):
        self.draw_line("plan", 0xff8000ff, position(now.own[1]), Point(0.1, self.setup.team))
        self.draw_circle("target", 0xffffffff, (0.5, 0.25), 0.03)
        self.draw_polygon("zone", 0xff000080, [(0.2, 0.2), (0.4, 0.2), (0.3, 0.4)])
        self.draw_text("R\u00f6lle" + 40 * "e", 0xffffffff, (0.0, 0.5), "h\u00e4lt")
        self.draw_value("distance", length(position(now.own[1])))
        self.draw_line("nowhere", 0, (0.0, 0.0), (math.inf, 0.0))
        self.draw_polygon("zone", 0, [(0.0, 0.0)] * 2)
        return []
)py";

// Catches a shape of a team in Python that is lost, is another one than a library's, or lands among
// those of the other team where both play in one process.
TEST(Thoughts, OfTeamsInPython) {
  if (!std::filesystem::exists(program("mirocup-python-host"))) GTEST_SKIP() << "not built";
  const TemporaryFolder folder;
  write_file(folder / "team.py", "import math" + std::string(python_team));
  std::string hash;
  for (const std::vector<std::string>& how :
       {std::vector<std::string>{}, {"--thoughts"}, {"--thoughts", "--trusted"}}) {
    std::vector<std::string> words{
        program("mirocup"), "match",  "--blue", folder / "team.py", "--yellow",
        folder / "team.py", "--half", "2",      "--record",         folder / "leg.json"};
    words.insert(words.end(), how.begin(), how.end());
    const auto outcome = run(words);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto record = read_json(folder / "leg.json");
    EXPECT_EQ(record["result"]["end"], "full_time") << record["result"];
    if (hash.empty()) hash = record["state_hash"].get<std::string>();
    EXPECT_EQ(record["state_hash"], hash);
    if (how.empty()) continue;
    for (const int team : {0, 1}) {
      const auto thoughts =
          thoughts_in(folder / (team == 0 ? "leg.blue.thoughts.zst" : "leg.yellow.thoughts.zst"));
      const std::size_t ticks = record["ticks"].get<std::size_t>();
      ASSERT_EQ(thoughts.size(), 5 * ticks + 1);
      EXPECT_EQ(thoughts[0]["layer"], "plan");
      EXPECT_EQ(thoughts[0]["colour"], "#ff8000ff");
      EXPECT_EQ(thoughts[0]["line"][3], team);
      EXPECT_EQ(thoughts[1]["circle"], ThoughtJson::parse("[0.5,0.25,0.03]"));
      EXPECT_EQ(thoughts[2]["polygon"], ThoughtJson::parse("[[0.2,0.2],[0.4,0.2],[0.3,0.4]]"));
      EXPECT_EQ(thoughts[3]["layer"].get<std::string>().rfind("R\u00f6lleee", 0), 0u);
      EXPECT_EQ(thoughts[3]["text"][2], "h\u00e4lt");
      EXPECT_EQ(thoughts[4]["text"][2].get<std::string>().rfind("distance = ", 0), 0u);
      EXPECT_EQ(thoughts.back()["text"][2],
                std::to_string(2 * ticks) + " shapes of the leg were left out");
    }
  }
}

// Catches a page for others with what only the team may see, and a page of its own without it.
TEST(Thoughts, AreOnPagesThatAreNotPublic) {
  const TemporaryFolder folder;
  ASSERT_EQ(run(drawing_match(folder, {"--trusted", "--thoughts"})).exit_code, 0);
  write_file(folder / "leg.json.blue.log", "to myself\n");
  const std::string record = folder / "leg.json";
  ASSERT_EQ(run_mirocup({"replay", record, "-o", folder / "own.html"}).exit_code, 0);
  ASSERT_EQ(run_mirocup({"replay", record, "--public", "-o", folder / "all.html"}).exit_code, 0);
  const std::string own = read_file(folder / "own.html"), all = read_file(folder / "all.html");
  EXPECT_TRUE(contains(own, "\"thoughts\":"));
  EXPECT_TRUE(contains(own, "to myself"));
  EXPECT_FALSE(contains(all, "\"thoughts\":"));
  EXPECT_FALSE(contains(all, "to myself"));
}

}  // namespace
}  // namespace mirocup
