// SPDX-License-Identifier: MIT
//
// Tests leagues as a host runs them: one command from start to table, whatever fails in between.
#include "tests/programs/league/league_command.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <memory>

namespace mirocup {
namespace {

using namespace test_support;

// Makes a league of four teams, one of them over DDS, with short halves: twelve legs.
void make_league(const std::string& folder, const std::string& half = "10") {
  write_file(folder + ".json",
             R"({"schema": "mirocup/league/1", "title": "Test", "seed": 5,
    "rules": {"half_s": )" +
                 half +
                 R"(},
    "teams": [{"name": "striker", "entry": "house:striker"},
              {"name": "chaser", "entry": "house:chaser"},
              {"name": "idle", "entry": "house:idle"},
              {"name": "far", "entry": "house:keeper", "dds": true}]})");
  const Outcome made = expect_exit(0, run(league("init", folder, {"--config", folder + ".json"})));
  EXPECT_EQ(made.out, folder + ": 4 teams, 12 legs\n");
}

TEST(League, PlaysTheExampleOfTheReadme) {
  const TemporaryFolder temporary;
  const std::string folder = temporary / "class";
  std::string config =
      std::string(MIROCUP_SOURCE_FOLDER) + "/tournaments/examples/class/league.json";
  // Halves of 10 s: tests/distributions/check plays it whole, by ./play.
  auto shorter = read_json(config);
  shorter["rules"]["half_s"] = 10;
  config = temporary / "league.json";
  write_file(config, shorter.dump());
  ASSERT_EQ(run(league("init", folder, {"--config", config})).exit_code, 0);
  expect_exit(0, run(league("start", folder)));

  const Outcome status = run(league("status", folder, {"--json"}));
  const auto table = nlohmann::json::parse(status.out);
  EXPECT_GE(table["table"].size(), 5u);
  EXPECT_EQ(table["played"], table["legs"]);
  bool any_dds = false;
  int records = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder + "/records")) {
    if (file.path().extension() != ".json") continue;
    ++records;
    any_dds = any_dds || read_json(file.path())["teams"]["blue"]["kind"] == "dds";
    expect_exit(0, run_mirocup({"verify", file.path()}));
  }
  EXPECT_EQ(records, table["legs"]);
  EXPECT_TRUE(any_dds);
  expect_no_dead_links(folder);

  const std::string journal = read_file(folder + "/journal.jsonl");
  EXPECT_EQ(run(league("start", folder)).exit_code, 0);
  EXPECT_EQ(read_file(folder + "/journal.jsonl"), journal) << "nothing is played again";
}

// Catches teams over DDS that join the match of another league: a copy is played from another
// folder, by the same name and at the same time.
TEST(League, IsPlayedBesideACopyOfIt) {
  const TemporaryFolder temporary;
  std::vector<std::unique_ptr<Running>> nights;
  for (const std::string place : {"one", "two"}) {
    std::filesystem::create_directory(temporary / place);
    make_league(temporary / place + "/l", "2");
    nights.push_back(std::make_unique<Running>(std::vector<std::string>{
        "/bin/sh", "-c", "cd \"$1\" && exec \"$2\" league start l --jobs 2", "sh",
        temporary / place, program("mirocup")}));
  }
  for (const auto& night : nights) EXPECT_EQ(night->wait().exit_code, 0);
  for (const std::string place : {"one/l", "two/l"})
    EXPECT_EQ(count_kind(temporary / place, "void"), 0)
        << read_file(temporary / place + "/journal.jsonl");
}

TEST(League, HasTheSamePagesWithAnyNumberOfJobs) {
  const TemporaryFolder temporary;
  for (const char* jobs : {"1", "2", "8"}) {
    make_league(temporary / jobs, "5");
    ASSERT_EQ(run(league("start", temporary / jobs, {"--jobs", jobs})).exit_code, 0);
  }
  expect_same_site(temporary / "2", temporary / "1");
  expect_same_site(temporary / "8", temporary / "1");
}

TEST(League, EndsLikeAnUnstoppedLeagueAfterItWasStopped) {
  const TemporaryFolder temporary;
  make_league(temporary / "whole", "30");
  make_league(temporary / "stopped", "30");
  ASSERT_EQ(run(league("start", temporary / "whole")).exit_code, 0);

  Running running(league("start", temporary / "stopped"));
  ASSERT_TRUE(wait_until_it_plays(temporary / "stopped"));
  running.signal(SIGTERM);
  expect_exit(130, running.wait(), "the same command continues");
  EXPECT_EQ(run(league("status", temporary / "stopped")).exit_code, 1) << "legs are left";

  expect_exit(0, run(league("start", temporary / "stopped")));
  expect_same_site(temporary / "stopped", temporary / "whole");
}

TEST(League, BooksAMatchServerThatDiesAsVoidAndPlaysAgain) {
  const TemporaryFolder temporary;
  init_league(temporary / "l", {"a=house:striker", "b=house:chaser"}, "300");
  Running running(league("start", temporary / "l", {"--jobs", "1"}));
  // The match server is the league's only child.
  const std::string children = "/proc/" + std::to_string(running.pid()) + "/task/" +
                               std::to_string(running.pid()) + "/children";
  ASSERT_TRUE(wait_until([&] {
    const std::string pid = read_file(children);
    return !pid.empty() && kill(std::stoi(pid), SIGKILL) == 0;
  }));
  EXPECT_EQ(running.wait().exit_code, 0);
  const std::string journal = read_file(temporary / "l/journal.jsonl");
  EXPECT_TRUE(contains(journal, "\"kind\":\"void\""));
  EXPECT_EQ(read_json(temporary / "l/site/table.json")["played"], 2);
}

TEST(League, RefusesToGoOnWhenWhatWasDecidedHasChanged) {
  const TemporaryFolder temporary;
  const std::string folder = temporary / "l";
  init_league(folder, {"a=house:idle", "b=house:idle"});
  ASSERT_EQ(run(league("start", folder)).exit_code, 0);
  const std::string config = read_file(folder + "/league.json");

  std::string changed = config;
  changed.replace(changed.find("\"seed\": 3"), 9, "\"seed\": 2");
  write_file(folder + "/league.json", changed);
  Outcome outcome =
      expect_exit(2, run(league("start", folder)), "changed after the league started");
  write_file(folder + "/league.json", config);

  write_file(folder + "/entries/a/1/strategy.so", "another library");
  outcome = run(league("start", folder));
  EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
}

TEST(League, RefusesBadTeamsAndMissingFolders) {
  const TemporaryFolder temporary;
  EXPECT_EQ(run(league("start", temporary / "nothing")).exit_code, 2);
  EXPECT_EQ(run(league("init", temporary / "x", {"--team", "a=house:nobody"})).exit_code, 2);
  EXPECT_EQ(run(league("init", temporary / "x", {"--team", "../a=house:idle"})).exit_code, 2);
  EXPECT_EQ(run(league("init", temporary / "x", {"--team", "a"})).exit_code, 2);
  EXPECT_FALSE(std::filesystem::exists(temporary / "x/league.json")) << "nothing half made";
  // A variable of the shell that is not set; "/league.json" was meant by no host.
  expect_exit(2, run(league("status", "")), "DIR: \"\" names no folder");
}

// Pages of a round that was shown by mistake used to stay under names that everybody can guess.
TEST(League, KeepsNoPagesOfRoundsThatAreNotReleasedAnyMore) {
  const TemporaryFolder temporary;
  const std::string folder = temporary / "l";
  init_league(folder, {"a=house:chaser", "b=house:keeper", "c=house:idle"});
  ASSERT_EQ(run(league("start", folder)).exit_code, 0);
  const auto all = site_of(folder);
  const auto release = [&](std::vector<std::string> what) {
    what.insert(what.end(), {"--reason", "x"});
    EXPECT_EQ(run(league("release", folder, what)).exit_code, 0);
    EXPECT_EQ(run(league("publish", folder)).exit_code, 0);
    return site_of(folder);
  };
  const auto first = release({"--level", "teams", "--through", "r1"});
  for (const std::string name : {"replays/r2-f1-1-1.html", "statistics/r2-f1-1-1.json"}) {
    EXPECT_TRUE(all.contains(name)) << name;
    EXPECT_FALSE(first.contains(name)) << name;
  }
  EXPECT_TRUE(first.contains("replays/r1-f1-1-1.html"));
  EXPECT_TRUE(release({"--level", "all"}).contains("replays/r2-f1-1-1.html"));
}

TEST(League, HasAFrontPageBesideOthers) {
  const TemporaryFolder temporary;
  init_league(temporary / "autumn", {"a=house:chaser", "b=house:idle"});
  init_league(temporary / "spring", {"a=house:chaser", "b=house:idle", "c=house:idle"});
  expect_exit(0, run(league("index", temporary / "", {"--title", "<Soccer>"})));
  const std::string page = read_file(temporary / "index.html");
  EXPECT_TRUE(contains(page, "&lt;Soccer&gt;"));
  EXPECT_LT(page.find("href=\"autumn/\""), page.find("href=\"spring/\""));
  EXPECT_EQ(run(league("index", temporary / "", {"--static"})).exit_code, 0);
  EXPECT_TRUE(contains(read_file(temporary / "index.html"), "href=\"spring/site/index.html\""));
  write_file(temporary / "index.html", "the host's own page");
  EXPECT_EQ(run(league("index", temporary / "")).exit_code, 2);
  EXPECT_EQ(read_file(temporary / "index.html"), "the host's own page");
  EXPECT_EQ(run(league("index", temporary / "spring")).exit_code, 2) << "no folder of leagues";
}

}  // namespace
}  // namespace mirocup
