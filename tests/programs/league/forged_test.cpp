// SPDX-License-Identifier: MIT
//
// Records that somebody has changed and sealed anew. Catches a league that books or publishes a
// result, a call or a fault that the replay of its record does not show.
#include "record/json_reader.hpp"
#include "record/match_record.hpp"
#include "system/digest.hpp"
#include "tests/programs/league/league_command.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>

namespace mirocup::test_support {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

using Change = std::function<void(Json&)>;

// Changes a record and gives it the digest of its new text.
void forge(const std::string& path, const Change& change) {
  Json json = read_json(path);
  json.erase("sha256");
  change(json);
  std::string text = record::json_text(json, 1);
  text.resize(text.rfind("\n}"));
  write_file(path, text + ",\n \"sha256\": \"" + system::sha256(text) + "\"\n}\n");
}

void say_nine_goals(Json& json) {
  json["result"]["score"]["blue"] = 9;
  json["result"]["played"]["blue"] = 9;
  json["result"]["winner"] = "blue";
}

// Puts the replay of another leg in place of the record's own.
Change exchange_replay(const std::string& folder, const std::string& other) {
  return [folder, other](Json& json) {
    const std::string bytes = read_file(folder + "/records/" + other);
    write_file(folder + "/records/" + json["replay"]["file"].get<std::string>(), bytes);
    json["replay"]["sha256"] = system::sha256(bytes);
  };
}

void invent_a_fault(Json& json) {
  const Json fault{{"team", "blue"}, {"code", "crash"}, {"text", "signal 11"}};
  json["result"]["faults"] = Json::array({fault});
}

// Each program keeps its list of trusted programs there.
class ForgedRecords : public testing::Test {
 protected:
  ForgedRecords() {
    setenv("XDG_STATE_HOME", (temporary_ / "state").c_str(), 1);
    init_league(folder_, {"a=house:chaser", "b=house:keeper", "c=house:striker", "d=house:idle"},
                "2");
    const Outcome plan = expect_exit(0, run(league("plan", folder_)));
    std::vector<std::string> shard{program("mirocup-league"), "run-shard", folder_};
    std::istringstream ids(plan.out);
    for (std::string id; ids >> id;) shard.push_back(id);
    EXPECT_EQ(run(shard).exit_code, 0);
  }
  ~ForgedRecords() override { unsetenv("XDG_STATE_HOME"); }

  std::string record(const std::string& name) const {
    return folder_ + "/records/" + name + "-1.json";
  }

  const TemporaryFolder temporary_;
  const std::string folder_ = temporary_ / "l";
};

TEST_F(ForgedRecords, OfShardsAreVoidAndTheirLegsArePlayedAgain) {
  const std::map<std::string, Change> kinds{
      {"r1-f1-1", say_nine_goals},
      {"r1-f1-2", [](Json& json) { json["decisions"].erase(json["decisions"].size() - 2); }},
      {"r1-f2-1", exchange_replay(folder_, "r1-f2-2-1.replay.zst")},
      {"r1-f2-2",
       [](Json& json) {
         json["software"]["game"] = "0123456789abcdef";  // which plays this leg alike
         json["result"]["fault"] = {{"team", "blue"}, {"code", "crash"}, {"text", ""}};
       }},
      {"r2-f1-1", invent_a_fault},
      {"r2-f1-2",
       [](Json& json) {
         json["result"]["fault"] = {{"team", "blue"}, {"code", "crash"}, {"text", ""}};
       }},
      {"r2-f2-1", [](Json& json) { json["rules"]["forfeit_goals"] = 99; }},
      {"r2-f2-2", [](Json& json) { json["conditions"]["rolling_sigma"] = 0.2; }},
      {"r3-f1-1", [](Json& json) { json["state_hash"] = "0123456789abcdef"; }},
      {"r3-f1-2", [](Json& json) { json["decisions"][0]["offender"] = "blue"; }},
      {"r3-f2-1", [](Json& json) { json["stage"] = "knockout"; }},
  };
  for (const auto& [name, change] : kinds) forge(record(name), change);
  const std::string untouched = read_file(record("r3-f2-2"));

  const Outcome start = expect_exit(1, run(league("start", folder_)));
  std::set<std::string> voids;
  for (const auto& line : journal_of(folder_)) {
    if (line["kind"] != "void") continue;
    EXPECT_EQ(line["new_seed"], true) << line;
    voids.insert(line["fixture"].get<std::string>() + "-" + line["leg"].dump());
  }
  EXPECT_EQ(voids.size(), kinds.size());
  for (const auto& [name, change] : kinds) {
    EXPECT_TRUE(voids.contains(name)) << name << '\n' << start.err;
    EXPECT_TRUE(contains(start.err, "records/" + name + "-1.json"));
    EXPECT_TRUE(fs::exists(record(name))) << name << " is evidence";
    EXPECT_EQ(run_mirocup({"verify", folder_ + "/records/" + name + "-2.json"}).exit_code, 0);
  }
  EXPECT_TRUE(contains(start.err, "differs from tick "));
  EXPECT_FALSE(fs::exists(folder_ + "/site/replays/r1-f1-1-1.html"));
  EXPECT_EQ(count_kind(folder_, "leg"), 12);
  EXPECT_EQ(read_file(record("r3-f2-2")), untouched) << "nobody has changed it";
  EXPECT_FALSE(contains(read_file(folder_ + "/site/index.html"), "9:0"));
  EXPECT_EQ(run(league("start", folder_)).exit_code, 0) << "it is told once";
  EXPECT_EQ(run(league("publish", folder_)).exit_code, 0);
}

// Catches a record of other teams, entries or another seed that is booked for this leg.
TEST_F(ForgedRecords, OfOtherLegsAreNotThoseOfThisOne) {
  const std::string whole = read_file(record("r1-f1-1"));
  const auto hash = read_json(record("r1-f1-1"))["state_hash"];
  forge(record("r1-f1-1"),
        [](Json& json) { std::swap(json["teams"]["blue"], json["teams"]["yellow"]); });
  forge(record("r1-f2-1"),
        [](Json& json) { json["teams"]["blue"]["sha256"] = std::string(64, 'a'); });
  forge(record("r2-f1-1"), [](Json& json) { json["seed"] = 1; });
  EXPECT_EQ(run(league("start", folder_)).exit_code, 0);
  EXPECT_EQ(count_kind(folder_, "void"), 0);
  EXPECT_EQ(read_json(record("r1-f1-1"))["teams"], Json::parse(whole)["teams"]);
  EXPECT_EQ(read_json(record("r1-f1-1"))["state_hash"], hash);
  EXPECT_EQ(run(league("verify", folder_)).exit_code, 0);
}

// Catches a forger who says that another version has played the leg.
TEST_F(ForgedRecords, OfAnotherVersionAreToldAndNeitherBookedNorVoid) {
  forge(record("r1-f1-1"), [](Json& json) {
    say_nine_goals(json);
    json["software"]["game"] = "0123456789abcdef";
  });
  const Outcome start =
      expect_exit(4, run(league("start", folder_)), "another version of the game");
  EXPECT_TRUE(contains(start.err, "r1-f1-1-1.json"));
  EXPECT_EQ(count_kind(folder_, "void"), 0);
  EXPECT_EQ(count_kind(folder_, "leg"), 0);
}

// Catches a replay file that nobody compares with its record.
TEST_F(ForgedRecords, WithTheReplayOfAnotherLegAreTold) {
  fs::copy_file(folder_ + "/records/r1-f2-1-1.replay.zst",
                folder_ + "/records/r1-f1-1-1.replay.zst", fs::copy_options::overwrite_existing);
  expect_exit(4, run(league("start", folder_)), "r1-f1-1-1.replay.zst: it is not the replay");
  EXPECT_EQ(count_kind(folder_, "leg"), 0);
}

// Catches a record that was changed after it was booked, also after its page was made.
TEST_F(ForgedRecords, AreLeftOutOfThePages) {
  ASSERT_EQ(run(league("start", folder_)).exit_code, 0);
  const std::string index = read_file(folder_ + "/site/index.html");
  forge(record("r1-f1-1"), say_nine_goals);
  expect_exit(1, run(league("publish", folder_)), "r1-f1-1-1.json");
  const std::string page = folder_ + "/site/replays/r1-f1-1-1.html";
  EXPECT_FALSE(fs::exists(page));
  EXPECT_FALSE(contains(read_file(folder_ + "/site/index.html"), "r1-f1-1-1"));
  EXPECT_FALSE(contains(read_file(folder_ + "/site/legs.csv"), "r1-f1-1-1"));

  const std::vector<std::string> leg{"r1-f1", "--leg", "1", "--reason", "forged"};
  ASSERT_EQ(run(league("void", folder_, leg)).exit_code, 0);
  EXPECT_EQ(run(league("start", folder_)).exit_code, 0);
  EXPECT_EQ(run(league("publish", folder_)).exit_code, 0) << "the void attempt is not missed";
  forge(record("r1-f2-1"), say_nine_goals);
  expect_exit(
      0, run(league("rule", folder_, {"r1-f2", "--leg", "1", "--score", "7:6", "--reason", "x"})));
  EXPECT_EQ(run(league("publish", folder_)).exit_code, 0) << "a person has decided the leg";
  EXPECT_TRUE(contains(read_file(folder_ + "/site/index.html"), "7:6"));
  EXPECT_FALSE(fs::exists(folder_ + "/site/replays/r1-f2-1-1.html"));
}

}  // namespace
}  // namespace mirocup::test_support
