// SPDX-License-Identifier: MIT
//
// Statistics of a league, as a host asks for them.
#include "tests/programs/league/league_command.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace mirocup {
namespace {

using Json = nlohmann::ordered_json;
using namespace test_support;

// Catches legs that are missing or counted twice, numbers that depend on what site/ keeps, and
// pages that differ when they are made again.
TEST(LeagueStatistics, AreTheSameFromPagesAndFromRecords) {
  const TemporaryFolder temporary;
  const std::string folder = temporary / "spring";
  init_league(folder, {"a=house:striker", "b=house:chaser", "c=house:idle"}, "10");
  ASSERT_EQ(run(league("start", folder)).exit_code, 0);

  const std::vector<std::string> command{program("mirocup"), "stats", folder, "--json"};
  const Outcome kept = expect_exit(0, run(command));
  const Json json = Json::parse(kept.out);
  EXPECT_EQ(json["legs"].size(), 6u);
  EXPECT_EQ(json["teams"].size(), 3u);
  for (const Json& team : json["teams"]) EXPECT_EQ(team["legs"], 4);
  auto site = site_of(folder);
  EXPECT_EQ(kept.out, site["statistics.json"]);
  EXPECT_TRUE(contains(site["index.html"], "<h2>Statistics</h2>"));
  EXPECT_TRUE(contains(site["index.html"], "href=\"replays/r1-f1-1-1.html\""));
  EXPECT_TRUE(contains(site["teams/c.html"], "<h2>Play</h2>"));

  // One file of another leg and one that is no JSON: both are counted anew.
  std::vector<std::filesystem::path> files;
  for (const auto& file : std::filesystem::directory_iterator(folder + "/site/statistics"))
    files.push_back(file.path());
  ASSERT_EQ(files.size(), 6u);
  write_file(files[0], read_file(files[1]));
  write_file(files[2], "{");
  EXPECT_EQ(run(command).out, kept.out);

  std::filesystem::remove_all(folder + "/site");
  EXPECT_EQ(run(command).out, kept.out) << "from the records alone";
  EXPECT_FALSE(std::filesystem::exists(folder + "/site")) << "it only reads";
  const Outcome published = expect_exit(0, run(league("publish", folder)));
  EXPECT_EQ(published.out, folder + "/site/index.html\n");
  EXPECT_TRUE(site_of(folder) == site);
}

}  // namespace
}  // namespace mirocup
