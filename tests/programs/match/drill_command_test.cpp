// SPDX-License-Identifier: MIT
//
// Runs mirocup drill as its users do.
#include "system/csv.hpp"
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace mirocup {
namespace {

using namespace test_support;
using Json = nlohmann::ordered_json;

Outcome drill(const std::vector<std::string>& more, const char* command = "drill") {
  std::vector<std::string> words{program("mirocup"), command};
  words.insert(words.end(), more.begin(), more.end());
  return run(words);
}
Outcome grade(const std::vector<std::string>& more) {
  return drill(more, "grade");
}

constexpr const char* own_drill =
    R"({"schema": "mirocup/drill/1", "title": "Mine", "version": 5, "opponent": "idle",
  "situation": {"ball": {"position": [{"from": 0.1, "to": 0.3}, 0]},
                "blue": [null, {"pose": [0, 0, 0]}],
                "yellow": [{"broken": true, "pose": [-0.3, 0.5, 0]},
                           {"broken": true, "pose": [0.3, 0.5, 0]}]},
  "seconds": 4, "tries": 3, "success": [{"event": "goal"}]})";

// Catches a drill that cannot be read or tried, such as one with a situation that overlaps.
TEST(DrillCommand, TriesEveryDrill) {
  const Outcome list = expect_exit(0, drill({"list", "--json"}));
  const Json drills = Json::parse(list.out)["drills"];
  EXPECT_GE(drills.size(), 20u);
  const Outcome tried = expect_exit(0, drill({"all", "striker", "--tries", "1", "--json"}));
  const Json report = Json::parse(tried.out);
  ASSERT_EQ(report["drills"].size(), drills.size());
  double sum = 0.0;
  for (const Json& one : report["drills"]) {
    EXPECT_EQ(one["tries"], 1);
    EXPECT_LE(one["low"], one["score"]);
    EXPECT_GE(one["high"], one["score"]);
    sum += one["score"].get<double>();
  }
  EXPECT_NEAR(report["score"].get<double>(), sum / static_cast<double>(drills.size()), 0.11);
  EXPECT_GT(report["score"], 20.0);
}

// Catches marks that depend on how many tries are played at once.
TEST(DrillCommand, GivesTheSameMarksForTheSameSeeds) {
  const auto once = drill({"turn-the-ball", "chaser", "--tries", "6", "--json", "--jobs", "1"});
  EXPECT_EQ(once.out,
            drill({"turn-the-ball", "chaser", "--tries", "6", "--json", "--jobs", "3"}).out);
  EXPECT_NE(once.out,
            drill({"turn-the-ball", "chaser", "--tries", "6", "--json", "--seed", "100"}).out);
}

// Catches a replay of another leg than the one that failed, and a failed try without one.
TEST(DrillCommand, WritesAReplayOfEachFailedTry) {
  const TemporaryFolder folder;
  std::ofstream(folder / "mine.json") << own_drill;
  const Outcome tried = expect_exit(
      0, drill({folder / "mine.json", "idle", "--json", "--replay", folder / "failed"}));
  const Json report = Json::parse(tried.out);
  EXPECT_EQ(report["drills"][0]["name"], "mine");
  EXPECT_EQ(report["drills"][0]["version"], 5);
  EXPECT_EQ(report["drills"][0]["failed_seeds"], (Json{1, 2, 3}));
  EXPECT_EQ(report["score"], 0.0);
  for (const char* seed : {"1", "2", "3"}) {
    const std::string path = folder / (std::string("failed/idle-mine-") + seed);
    EXPECT_TRUE(std::filesystem::exists(path + ".html"));
    EXPECT_TRUE(contains(read_file(folder / "failed/index.html"),
                         std::string("href=\"./idle-mine-") + seed + ".html\""));
    EXPECT_EQ(run_mirocup({"verify", path + ".json"}).exit_code, 0);
    EXPECT_EQ(run_mirocup({"rerun", path + ".json"}).exit_code, 0);
    EXPECT_EQ(read_json(path + ".json")["isolation"], why_no_t2().empty() ? "T2" : "T1");
  }
}

// Catches a team that spoils the tries of others, or ends the program, and a name of a team that
// becomes a formula in the computer of whoever grades.
TEST(DrillCommand, GradesSeveralTeamsIntoOneCsvEvenIfOneDies) {
  const TemporaryFolder folder;
  std::ofstream(folder / "mine.json") << own_drill;
  const Outcome tried = expect_exit(
      0, drill({folder / "mine.json", "+x=chaser", program("teams/gives_up.so"), "--csv"}));
  std::istringstream lines(tried.out);
  std::vector<std::string> rows;
  for (std::string line; std::getline(lines, line);) rows.push_back(line);
  ASSERT_EQ(rows.size(), 5u) << tried.out;
  EXPECT_EQ(rows[0], "team,drill,score,low,high,tries,failed_seeds,version");
  EXPECT_EQ(rows[1].rfind("'+x,mine,", 0), 0u);
  EXPECT_TRUE(rows[1].ends_with(",5")) << "the drill's version: " << rows[1];
  EXPECT_EQ(rows[2].rfind("'+x,all,", 0), 0u);
  EXPECT_EQ(rows[3].rfind("test,mine,0.0,", 0), 0u) << rows[3];
}

// The library of each project of `mirocup new` is team.so. Catches reports and replays that are
// named after the file, and a name on the command line that gives way to the library's own.
TEST(DrillCommand, CallsATeamAsItCallsItself) {
  const TemporaryFolder folder;
  std::string too_short = own_drill;
  too_short.replace(too_short.find("\"seconds\": 4"), 12, "\"seconds\": 0.1");
  std::ofstream(folder / "mine.json") << too_short;
  const std::string team = folder / "team.so";
  std::filesystem::copy_file(program("teams/draws.so"), team);
  const Outcome tried = expect_exit(0, drill({folder / "mine.json", team, "other=" + team, "--json",
                                              "--tries", "1", "--replay", folder / "failed"}));
  const Json teams = Json::parse(tried.out)["teams"];
  EXPECT_EQ(teams[0]["team"], "draws");
  EXPECT_EQ(teams[1]["team"], "other");
  EXPECT_TRUE(std::filesystem::exists(folder / "failed/draws-mine-1.html"));
  EXPECT_EQ(drill({folder / "mine.json", team, team, "--replay", folder / "failed"}).exit_code, 2);
}

TEST(DrillCommand, TriesTheEntriesOfALeague) {
  const TemporaryFolder temporary;
  const std::string folder = temporary / "l";
  const auto league = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {program("mirocup"), "league"});
    return run(words);
  };
  league({"init", folder, "--format", "nightly"});
  league({"submit", folder, "b", program("house/striker.so")});
  league({"submit", folder, "a", program("house/idle.so")});
  write_file(temporary / "c.csv", "team\nc\n");
  league({"team", folder, "--csv", temporary / "c.csv"});
  const Outcome tried =
      expect_exit(0, drill({"touch-the-ball", "--tries", "2", "--csv", "--league", folder}));
  EXPECT_TRUE(contains(tried.out, "\na,touch-the-ball,0.0,")) << "the last entry";
  EXPECT_LT(tried.out.find("\nb,touch-"), tried.out.find("\na,touch-")) << "in the league's order";
  EXPECT_EQ(tried.err, "mirocup: c has no entry\n");
  write_file(temporary / "s.json", R"({"schema": "mirocup/sheet/1", "title": "S", "start": "idle",
    "reference": "striker", "drills": [{"drill": "touch-the-ball", "change": {"tries": 4}}]})");
  write_file(folder + "/sheets.json", R"({"s": {"until": "2019-12-30"}})");
  const Outcome refused = grade({temporary / "s.json", folder, "--csv"});
  EXPECT_TRUE(contains(refused.err, "sheets.json: /s/until: "));
  write_file(folder + "/sheets.json", R"({"s": {"until": "2019-12-30 00:00", "grace_days": 2,
    "extensions": {"b": "2099-01-01 00:00"}}})");
  const Outcome graded = grade({temporary / "s.json", folder, "--csv"});
  EXPECT_TRUE(contains(graded.out, "\nb,s,100.0,")) << graded.err;
  EXPECT_TRUE(contains(graded.out, "no entry was accepted,0.0\nc,s,")) << "of a";
  write_file(temporary / "s.csv", graded.out);
  league({"grades", folder, "--drills", temporary / "s.csv", "--release"});
  EXPECT_EQ(read_json(folder + "/marks/sheets/b.json")["s"], "100.0");
  expect_exit(2, drill({"touch-the-ball", "--league", temporary / "x"}), "is not a league");
}

// Catches a scale that does not run from start to reference, weights that do not count, a broken
// entry that stops others, and a secret that draws the public tries.
TEST(Grade, RunsFromStartToReferenceWhateverIsBroken) {
  const TemporaryFolder folder;
  write_file(folder / "mine.json", own_drill);
  const auto sheet = [&](const std::string& reference) {
    write_file(folder / "s.json", R"({"schema": "mirocup/sheet/1", "title": "S", "start": "idle",
      "reference": ")" + reference + R"(", "drills": [{"drill": "mine.json", "weight": 3},
      {"drill": "touch-the-ball", "change": {"tries": 8, "seconds": 2}}]})");
    return folder / "s.json";
  };
  write_file(folder / "secret", "sixteen bytes or more");
  write_file(folder / "bad.so", "nothing");
  std::vector<std::string> words{sheet("striker"),  "idle",     "striker",
                                 "b=chaser",        "--csv",    program("teams/gives_up.so"),
                                 folder / "bad.so", "x=none.so"};
  const Outcome graded = expect_exit(1, grade(words));
  const auto rows = system::read_csv(graded.out)->rows;
  ASSERT_EQ(rows.size(), 7u) << graded.out;
  EXPECT_EQ(rows[2].cells[2], "100.0");
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto number = [&](std::size_t cell) { return std::stod(rows[i].cells[cell]); };
    EXPECT_EQ(rows[i].cells[5].empty(), i < 4) << graded.out;
    EXPECT_NEAR(number(2), 0.75 * number(6) + 0.25 * number(7), 0.11);
    if (i > 3) EXPECT_EQ(number(2), 0.0);
  }
  words.insert(words.end(), {"--seed-file", folder / "secret"});
  EXPECT_NE(grade(words).out, graded.out);
  words.back() = folder / "bad.so";
  EXPECT_EQ(grade(words).exit_code, 2) << "a secret of seven bytes";
  EXPECT_TRUE(contains(grade({sheet("idle"), "chaser"}).err, "s.json: /drills/0: "));
}

// Catches a start or a reference that decides otherwise in Python than in C++.
TEST(Grade, GivesBothLanguagesOneScore) {
  const TemporaryFolder folder;
  for (const std::string sheet : {"driving", "ball", "roles"}) {
    const std::string sources = program("share/mirocup/course/" + sheet);
    const std::string cpp = "course:" + sheet;
    EXPECT_TRUE(contains(grade({"list"}).out, "start in " + sources + "\n"));
    Json few = read_json(sources + ".json");
    for (Json& one : few["drills"]) one["change"]["tries"] = 6;
    if (sheet == "roles") few["not_allowed"] = {"irocup", "from mirocup.team"};
    write_file(folder / "few.json", few.dump());
    const Outcome outcome = expect_exit(
        sheet == "roles" ? 1 : 0, grade({folder / "few.json", cpp + "-start", sources + "/start.py",
                                         cpp + "-reference", sources + "/reference.py", "--json"}));
    const Json teams = Json::parse(outcome.out)["teams"];
    if (sheet == "roles") {
      EXPECT_TRUE(contains(outcome.out, " has from mirocup.team, which the sheet does not allow"));
      EXPECT_TRUE(teams[0]["note"].is_null()) << "no source is at hand";
    }
    for (const std::size_t i : {0u, 2u}) EXPECT_EQ(teams[i]["drills"], teams[i + 1]["drills"]);
    EXPECT_EQ(teams[3]["score"], 100.0);
  }
}

TEST(DrillCommand, SaysWhatIsWrong) {
  const TemporaryFolder folder;
  std::ofstream(folder / "bad.json") << R"({"schema": "mirocup/drill/1", "title": 3})";
  EXPECT_EQ(drill({"no-such-drill", "idle"}).exit_code, 2);
  EXPECT_TRUE(
      contains(drill({program("teams/draws.so"), "touch-the-ball"}).err, "name the drill before"));
  EXPECT_EQ(drill({"all"}).exit_code, 2);
  EXPECT_EQ(drill({"turn-the-ball", "no-such-team"}).exit_code, 2);
  EXPECT_EQ(drill({"turn-the-ball", "dds:team"}).exit_code, 2);
  expect_exit(2, drill({folder / "bad.json", "idle"}), "bad.json: /title");
  std::ofstream(folder / "alone.json")
      << R"({"schema": "mirocup/drill/1", "title": "a", "seconds": 1, "opponent": "nobody",
             "success": [{"event": "goal"}]})";
  expect_exit(2, drill({folder / "alone.json", "idle"}), "alone: /opponent: \"nobody\" is neither");
}

}  // namespace
}  // namespace mirocup
