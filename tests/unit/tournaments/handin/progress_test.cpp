// SPDX-License-Identifier: MIT
//
// Catches goals of another entry, a rating that does not rise with wins, one that other teams' legs
// move, and a comparison over house teams that only one entry has met.
#include "tournaments/handin/progress.hpp"

#include "tests/support/contains.hpp"
#include "tournaments/handin/team_desk_page.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <tuple>
#include <vector>

namespace mirocup::league {
namespace {

using test_support::contains;

using Json = nlohmann::ordered_json;

Json leg(int entry, const std::string& opponent, int goals, int against, int fouls = -1) {
  Json json{{"entry", entry},
            {"opponent", opponent},
            {"state", "played"},
            {"goals", goals},
            {"against", against}};
  if (fouls >= 0) json.update({{"fouls", fouls}, {"slowest_tick_ms", 0.1 * fouls}});
  return json;
}

const auto no_drills = [](int) { return Json(); };

Json marks(double mean, std::vector<std::tuple<const char*, int, double>> drills) {
  Json json{{"score", mean}, {"drills", Json::array()}};
  for (const auto& [name, version, score] : drills)
    json["drills"].push_back({{"name", name}, {"version", version}, {"score", score}});
  return json;
}

TEST(Progress, ComparesEntriesByTheirLegsAgainstHouseTeams) {
  Json friendlies = Json::array({leg(4, "house:striker", 3, 1, 2), leg(4, "house:chaser", 5, 0, 1),
                                 leg(4, "house:planner", 0, 9), leg(2, "house:striker", 1, 3, 4),
                                 leg(2, "house:chaser", 2, 2, 5), leg(2, "rivals", 0, 9)});
  friendlies.push_back({{"entry", 2}, {"opponent", "house:keeper"}, {"state", "waiting"}});
  const Json progress = progress_of(friendlies, no_drills);
  ASSERT_EQ(progress.size(), 2u);
  EXPECT_EQ(progress[0]["entry"], 4);
  EXPECT_EQ(progress[0]["legs"], 3);
  EXPECT_EQ(progress[1]["legs"], 2) << "a leg against a team and one that waits do not count";
  EXPECT_EQ(progress[0]["against"]["striker"], (Json{{"legs", 1}, {"goals", 3}, {"against", 1}}));
  EXPECT_GT(progress[0]["rating"].get<double>(), progress[1]["rating"].get<double>());
  EXPECT_LT(progress[0]["low"].get<double>(), progress[0]["rating"].get<double>());
  EXPECT_EQ(progress[1]["fouls"], 4.5);
  const std::string change = change_in_words(progress);
  EXPECT_TRUE(contains(change, "Entry 4 after entry 2: rating "));
  EXPECT_TRUE(contains(change,
                       "goals 8 : 1 after 3 : 5, fouls a leg 1.5 after 4.5, slowest tick 0.20 "
                       "after 0.50 ms."));

  const double before = progress[0]["rating"].get<double>();
  friendlies.push_back(leg(4, "house:striker", 0, 4));
  EXPECT_LT(progress_of(friendlies, no_drills)[0]["rating"].get<double>(), before);
  friendlies.push_back(leg(4, "rivals", 9, 0));
  EXPECT_EQ(progress_of(friendlies, no_drills)[0]["legs"], 4);
}

// Catches a comparison that counts legs of other pairs, and one that finds a difference in noise.
TEST(Progress, ComparesAnEntryWithTheFormerOneByTheirOwnLegs) {
  Json friendlies = Json::array({leg(4, "house:striker", 1, 1), leg(3, "house:striker", 1, 1)});
  EXPECT_TRUE(progress_of(friendlies, no_drills)[0]["former"].is_null());
  const auto meet = [&friendlies](int entry, int former, int goals, int against) {
    Json own = leg(entry, "ours", goals, against);
    own["opponent_entry"] = former;
    friendlies.push_back(own);
  };
  for (int i = 0; i < 10; ++i) meet(4, 3, i < 5 ? 1 : 0, i < 5 ? 0 : 1);
  meet(3, 2, 0, 9);
  const Json same = progress_of(friendlies, no_drills)[0]["former"];
  EXPECT_EQ(same["entry"], 3);
  EXPECT_EQ(same["legs"], 10);
  EXPECT_EQ(same["verdict"], "not told apart");
  EXPECT_LT(same["low"].get<double>(), -100.0);
  for (int i = 0; i < 10; ++i) meet(4, 3, 2, 0);
  const Json progress = progress_of(friendlies, no_drills);
  EXPECT_EQ(progress[0]["former"]["verdict"], "better");
  EXPECT_GT(progress[0]["former"]["low"].get<double>(), 0.0);
  EXPECT_TRUE(
      contains(change_in_words(progress), "In 20 legs against entry 3: better, difference"));
}

// Catches drills of another entry, marks of two versions of a drill side by side, and a mean over
// drills that only one entry has tried.
TEST(Progress, ComparesTheDrillsThatBothHaveTried) {
  const Json friendlies =
      Json::array({leg(4, "house:striker", 3, 1), leg(2, "house:striker", 1, 3)});
  const auto change = [&](const Json& now, const Json& before) {
    const Json progress =
        progress_of(friendlies, [&](int entry) { return entry == 4 ? now : before; });
    EXPECT_EQ(progress[0]["drills"], now);
    return change_in_words(progress);
  };
  const Json now = marks(50, {{"shoot", 1, 60}, {"save", 1, 30}, {"pass", 1, 40}, {"wait", 2, 70}});
  const Json before =
      marks(40, {{"save", 1, 45}, {"shoot", 1, 20}, {"pass", 1, 40}, {"wait", 1, 0}});
  EXPECT_TRUE(contains(change(now, before),
                       "goals 3 : 1 after 1 : 3, drills 43.3 after 35.0 (better: shoot "
                       "60 after 20; worse: save 30 after 45)."));
  EXPECT_TRUE(contains(change(now, now), "drills 50.0 after 50.0."));
  EXPECT_FALSE(contains(change(now, Json()), "drills"));
}

TEST(Progress, SaysNothingBeforeThereIsAny) {
  EXPECT_EQ(progress_of(Json::array(), no_drills), Json::array());
  EXPECT_EQ(change_in_words(progress_of(Json::array({leg(1, "house:idle", 1, 0)}), no_drills)), "");
}

TEST(Progress, ShowsNoMinusBeforeZero) {
  EXPECT_EQ(number_text({{"rating", -0.2}}, "rating", "%+.0f"), "0");
  EXPECT_EQ(number_text({{"rating", -0.6}}, "rating", "%+.0f"), "-1");
}

}  // namespace
}  // namespace mirocup::league
