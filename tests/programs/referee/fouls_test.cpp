// SPDX-License-Identifier: MIT
//
// Plays a match in which two teams break one law after the other (teams/fouls.cpp). Its record must
// have every law that play can break, with the intended reason. Catches a law that recorded
// situations trigger but a played match never does, and restarts whose poses get lost between
// sandbox, record and replay.
#include "core/referee/decision.hpp"
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace mirocup {
namespace {

using namespace test_support;
using Json = nlohmann::ordered_json;

// The laws that no simulated team can break, each with the reason.
const std::map<std::string, std::string> impossible{
    {"holding", "a square cannot hold a ball"},
    {"keeper_catch", "nor can a square keeper"},
    {"time_out", "teams have no way to ask, and nothing to do in a pause"},
    {"substitution", "nor anything to exchange"},
    {"hand",
     "a library is only asked for poses in its turn; "
     "PlacementRequests.ARequestOutOfTurnIsAHandOnTheField"},
    {"fallen", "a square in a plane cannot fall"},
    {"forfeit", "is no decision of the referee but an end: what a team did outside play"},
};

// These endings exclude each other, so each has a short leg of its own.
const std::set<std::string> other_ends{"golden_goal", "mercy", "lots"};

std::vector<std::string> leg(const std::string& record, const std::string& blue,
                             const std::string& yellow, const std::vector<std::string>& words) {
  std::vector<std::string> all{program("mirocup"), "match", "--blue",  blue,
                               "--yellow",         yellow,  "--stage", "knockout",
                               "--record",         record};
  all.insert(all.end(), words.begin(), words.end());
  return all;
}

std::set<std::string> laws_of(const Json& record) {
  std::set<std::string> laws;
  for (const Json& d : record["decisions"]) laws.insert(d["law"].get<std::string>());
  return laws;
}

// The decision that each foul must lead to.
const std::set<std::pair<std::string, std::string>> expected{
    {"kick_off", "KICK_OFF_VIOLATION"},
    {"goal", "GOAL"},
    {"own_goal", "GOAL"},
    {"two_defenders", "PENALTY_KICK"},
    {"four_defenders", "PENALTY_KICK"},
    {"two_attackers", "GOAL_KICK"},
    {"four_attackers", "GOAL_KICK"},
    {"keeper_hold", "PENALTY_KICK"},
    {"keeper_charge", "GOAL_KICK"},
    {"keeper_push_in", "GOAL_KICK"},
    {"keeper_block", "GOAL_KICK"},
    {"stalemate", "FREE_BALL"},
    {"stalemate", "GOAL_KICK"},
    {"push", "FREE_KICK"},
    {"attacking_push", "FREE_BALL"},
    {"collision", "NONE"},
    {"wall_push", "FREE_BALL"},
    {"placement", "PLACEMENT_FIXED"},
    {"half_time", "HALF_END"},
    {"extra_time", "PHASE"},
    {"shoot_out", "PHASE"},
    {"shoot_out", "MATCH_END"},
    {"penalty_attempt", "ATTEMPT_END"},
};

TEST(Fouls, AreAllCalledInOneMatch) {
  const TemporaryFolder folder;
  const std::string fouls = program("teams/fouls.so");
  expect_exit(0, run(leg(folder / "leg.json", fouls, fouls,
                         {"--league", "middle", "--half", "70", "--rule", "stalemate_s=6", "--rule",
                          "keeper_hold_s=4", "--rule", "golden_goal_s=20", "--rule", "pa_att_max=3",
                          "--rule", "collision_mps=1", "--rule", "wall_push=true"})));
  const Json record = read_json(folder / "leg.json");
  std::set<std::pair<std::string, std::string>> calls;
  for (const Json& d : record["decisions"]) {
    calls.emplace(d["law"].get<std::string>(), d["decision"].get<std::string>());
  }
  for (const auto& call : expected) {
    EXPECT_TRUE(calls.count(call)) << call.first << " was not called as " << call.second;
  }
  const std::set<std::string> seen = laws_of(record);
  for (const auto name : enum_names<referee::Law>) {
    const std::string law(name);
    EXPECT_EQ(seen.count(law) + impossible.count(law) + other_ends.count(law), 1u) << law;
  }
  EXPECT_EQ(record["result"]["end"], "shoot_out");
  EXPECT_EQ(run_mirocup({"verify", folder / "leg.json"}).exit_code, 0);
  expect_exit(0, run_mirocup({"rerun", folder / "leg.json", "--entries", program("teams")}));
}

TEST(Fouls, HaveLegsForTheEndingsThatExcludeEachOther) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> legs{
      {"golden_goal", {"--half", "1", "--rule", "golden_goal_s=100"}},
      {"mercy", {"--half", "100", "--rule", "mercy_goal_diff=1"}},
      {"lots",
       {"--half", "1", "--rule", "golden_goal_s=0", "--rule", "attempt_s=0.2", "--rule",
        "shoot_out_rounds=1", "--rule", "shoot_out_most_rounds=2"}},
  };
  for (const auto& [law, words] : legs) {
    const TemporaryFolder folder;
    expect_exit(0,
                run(leg(folder / "leg.json", law == "lots" ? "idle" : "striker", "idle", words)));
    EXPECT_TRUE(laws_of(read_json(folder / "leg.json")).count(law)) << law;
  }
  EXPECT_EQ(legs.size(), other_ends.size());
}

}  // namespace
}  // namespace mirocup
