// SPDX-License-Identifier: MIT
//
// `mirocup league compare` as a person runs it. Catches conclusions from copies, a folder that is
// mixed up with another comparison, legs that are played twice, and an answer that depends on the
// number of jobs.
#include "tests/programs/league/league_command.hpp"
#include "tests/support/temporary_folder.hpp"

#include <algorithm>
#include <array>

namespace mirocup::test_support {
namespace {

namespace fs = std::filesystem;

// Legs of two seconds, and one JSON object.
Outcome compare(const std::vector<std::string>& more) {
  std::vector<std::string> words{program("mirocup"), "league", "compare", "--half", "1", "--json"};
  words.insert(words.end(), more.begin(), more.end());
  return run(words);
}

TEST(LeagueCompare, GoesOnWithTheLegsOfItsFolder) {
  const TemporaryFolder folder;
  const std::string kept = folder / "kept";
  expect_exit(1, compare({"chaser", "keeper", "--most", "2", "--keep", kept}));
  const std::string leg = kept + "/1-2-1b.json";
  const auto before = fs::last_write_time(leg);
  fs::remove(kept + "/1-2-2a.json");
  const Outcome more = compare({"chaser", "keeper", "--most", "4", "--keep", kept});
  EXPECT_EQ(fs::last_write_time(leg), before);
  EXPECT_TRUE(fs::exists(kept + "/1-2-2a.json"));
  EXPECT_EQ(more.out, compare({"chaser", "keeper", "--most", "4", "--jobs", "1"}).out);

  expect_exit(2, compare({"chaser", "keeper", "--seed", "2", "--keep", kept}),
              "comparison.json: seed is 1, and not 2");
}

TEST(LeagueCompare, RatesEachAgainstEach) {
  const std::vector<std::string> teams{"idle", "keeper", "chaser", "--against",
                                       "all",  "--most", "2"};
  const Outcome done = expect_exit(0, compare(teams));
  const auto json = nlohmann::json::parse(done.out);
  ASSERT_EQ(json["comparisons"].size(), 3u);
  for (const auto& pair : json["comparisons"]) EXPECT_EQ(pair["fixtures"], 2);
  ASSERT_EQ(json["table"].size(), 3u);
  EXPECT_GE(json["table"][0]["strength"]["value"], json["table"][2]["strength"]["value"]);
}

// Catches parameters that go to the other team, or to one leg of a fixture only.
TEST(LeagueCompare, GivesATeamItsParameters) {
  const TemporaryFolder folder;
  const std::string kept = folder / "kept";
  expect_exit(1, compare({"chaser", "chaser:nosuch=1", "--most", "1", "--keep", kept}),
              "no team asked for the parameter nosuch");
  for (const auto& [leg, own, other] :
       {std::array{"a", "yellow", "blue"}, std::array{"b", "blue", "yellow"}}) {
    const auto teams = nlohmann::json::parse(read_file(kept + "/1-2-1" + leg + ".json"))["teams"];
    EXPECT_EQ(teams[own]["parameters"], (nlohmann::json{{"nosuch", 1}}));
    EXPECT_TRUE(teams[other]["parameters"].empty());
  }
}

}  // namespace
}  // namespace mirocup::test_support
