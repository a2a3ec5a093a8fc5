// SPDX-License-Identifier: MIT
//
// Catches a league file whose numbers overflow later, and a message without file and key.
#include "tournaments/format/league_file.hpp"

#include "tests/support/is_ok.hpp"

#include <gtest/gtest.h>

namespace mirocup::league {
namespace {

std::string error_of(const std::string& fields) {
  const auto file =
      parse_league_file("{\"schema\":\"mirocup/league/1\"," + fields + "}", "league.json");
  return file ? "none" : file.error().what;
}

TEST(LeagueFile, BoundsItsNumbers) {
  EXPECT_EQ(error_of(R"("points":{"win":1000000,"loss":-1000000})"), "none");
  EXPECT_EQ(error_of(R"("points":{"win":2147483647})"),
            "league.json: /points/win: 2147483647 is not at most 1000000");
  EXPECT_EQ(error_of(R"("points":{"loss":-2147483648})"),
            "league.json: /points/loss: -2147483648 is not at least -1000000");
  EXPECT_EQ(error_of(R"("rules":{"forfeit_goals":2147483647})"),
            "league.json: /rules/forfeit_goals: 2147483647 is not at most 10000");
  std::string teams = R"("teams":[)";
  for (int i = 0; i < 1001; ++i) teams += (i > 0 ? ",{}" : "{}");
  EXPECT_EQ(error_of(teams + "]"), "league.json: /teams: 0 to 1000 values are expected, not 1001");
}

// Catches parameters that are lost when the file of a league is written again.
TEST(LeagueFile, KeepsTheParametersOfATeam) {
  const auto text = [](const std::string& parameters) {
    return R"("teams":[{"name":"a","entry":"house:idle","parameters":)" + parameters + "}]";
  };
  EXPECT_EQ(error_of(text(R"({"wait":"far"})")),
            "league.json: /teams/0/parameters/wait: a number is expected, not \"far\"");
  EXPECT_EQ(error_of(text("[]")).substr(0, 32), "league.json: /teams/0/parameters");
  const auto file = parse_league_file(
      "{\"schema\":\"mirocup/league/1\"," + text(R"({"wait":0.4})") + "}", "league.json");
  ASSERT_TRUE(test_support::is_ok(file));
  EXPECT_EQ(file->teams[0].parameters, (match::TeamParameters{{"wait", 0.4}}));
  const auto again = parse_league_file(print_league_file(*file), "league.json");
  ASSERT_TRUE(test_support::is_ok(again));
  EXPECT_EQ(again->teams[0].parameters, file->teams[0].parameters);
}

// Catches a league that keeps thoughts without being told, or forgets to when its file is written
// again.
TEST(LeagueFile, KeepsThoughtsWhereItSaysSo) {
  EXPECT_EQ(error_of(R"("thoughts":"yes")"),
            "league.json: /thoughts: true or false is expected, not \"yes\"");
  for (const bool keeps : {false, true}) {
    const auto file = parse_league_file(
        std::string(R"({"schema":"mirocup/league/1")") + (keeps ? R"(,"thoughts":true})" : "}"),
        "league.json");
    ASSERT_TRUE(test_support::is_ok(file));
    EXPECT_EQ(file->keeps_thoughts, keeps);
    const auto again = parse_league_file(print_league_file(*file), "league.json");
    ASSERT_TRUE(test_support::is_ok(again));
    EXPECT_EQ(again->keeps_thoughts, keeps);
  }
}

// Catches a league whose host says that nobody gets commands, and that gives them out all the same.
TEST(LeagueFile, HasProofsUnlessItSaysNo) {
  for (const bool has : {true, false}) {
    const auto file = parse_league_file(
        std::string(R"({"schema":"mirocup/league/1")") + (has ? "}" : R"(,"proofs":false})"),
        "league.json");
    ASSERT_TRUE(test_support::is_ok(file));
    EXPECT_EQ(file->has_proofs, has);
    const auto again = parse_league_file(print_league_file(*file), "league.json");
    ASSERT_TRUE(test_support::is_ok(again));
    EXPECT_EQ(again->has_proofs, has);
  }
}

TEST(LeagueFile, NamesTheOldestProcessor) {
  EXPECT_NE(error_of(R"("processor":"pentium")").find("/processor: "), std::string::npos);
  EXPECT_EQ(LeagueFile().processor, system::Processor::v3);
  const auto file =
      parse_league_file(R"({"schema":"mirocup/league/1","processor":"x86-64-v2"})", "league.json");
  ASSERT_TRUE(test_support::is_ok(file));
  EXPECT_EQ(file->processor, system::Processor::v2);
  const auto again = parse_league_file(print_league_file(*file), "league.json");
  ASSERT_TRUE(test_support::is_ok(again));
  EXPECT_EQ(again->processor, system::Processor::v2);
}

// Catches settings of a program for FIRASim that are lost on the way, or that a library has.
TEST(LeagueFile, KeepsHowAProgramForFirasimPlays) {
  const auto parse = [](const std::string& team) {
    return parse_league_file(R"({"schema": "mirocup/league/1", "firasim": {"instance": 3,
        "referee": "127.0.0.1:9"}, "teams": [{"name": "a", )" +
                                 team + "}]}",
                             "f");
  };
  const auto file = parse(R"("entry": "firasim:b", "run": "./b", "folder": "c", "lockstep": true)");
  ASSERT_TRUE(test_support::is_ok(file));
  const auto again = parse_league_file(print_league_file(*file), "f");
  ASSERT_TRUE(test_support::is_ok(again));
  for (const LeagueFile& read : {*file, *again}) {
    EXPECT_TRUE(read.teams[0].is_firasim());
    EXPECT_EQ(read.teams[0].program.run, "./b");
    EXPECT_EQ(read.teams[0].program.folder, "c");
    EXPECT_TRUE(read.teams[0].program.lockstep);
    EXPECT_EQ(read.firasim.instance, 3);
    EXPECT_EQ(read.firasim.referee, "127.0.0.1:9");
  }
  EXPECT_TRUE(parse(R"("entry": "firasim:b")")->teams[0].is_started_by_people());
  const auto refusal = [&](const std::string& team) {
    const auto refused = parse(team);
    return refused ? "" : refused.error().what;
  };
  EXPECT_NE(refusal(R"("entry": "house:idle", "run": "./b")").find("/teams/0/run"),
            std::string::npos);
  EXPECT_NE(refusal(R"("entry": "firasim:b", "dds": true)").find("/teams/0/dds"),
            std::string::npos);
  EXPECT_NE(refusal(R"("entry": "firasim:")").find("/teams/0/entry"), std::string::npos);
}

TEST(LeagueFile, FreezesAtATimeThatExists) {
  const std::string text = R"({"schema": "mirocup/league/1", "zone": "Europe/Berlin",
                              "freeze": "2027-03-28T02:30:00"})";
  const auto refused = parse_league_file(text, "l");
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().what.find("does not exist in Europe/Berlin: clocks go from "
                                      "\"2027-03-28T01:59:59\" to \"2027-03-28T03:00:00\""),
            std::string::npos)
      << refused.error().what;
}

TEST(LeagueFile, TakesTimesAsPeopleTypeThem) {
  LeagueFile file =
      *parse_league_file(R"({"schema": "mirocup/league/1", "zone": "Europe/Berlin"})", "l");
  for (const char* text :
       {"2027-01-30 18:00", "2027-01-30T18:00", "2027-01-30 18:00:00", "2027-01-30T17:00Z",
        "2027-01-30 17:00 Z", "2027-01-30 19:00+02:00", "2027-01-30T18:00:00 +0100"}) {
    const auto time = utc_of(text, file);
    ASSERT_TRUE(time) << text;
    EXPECT_EQ(*time, "2027-01-30T17:00:00Z") << text;
  }
  for (const char* text : {"", "2027-01-30", "30.01.2027 18:00", "18:00", "2027-01-30T24:00",
                           "2027-02-30 18:00", "2027-01-30 18:00 CET", "2027-01-30 18:00+1",
                           "2027-01-30 18:00:00:00", "2027-01-30 18:00:0"}) {
    const auto time = utc_of(text, file);
    ASSERT_FALSE(time) << text;
    EXPECT_NE(time.error().what.find(
                  "no time: one like \"2026-11-30 19:00\" in the league's zone (Europe/Berlin)"),
              std::string::npos)
        << time.error().what;
  }
}

// What was published must not change by an upgrade, so a file says by which rules it was made.
TEST(LeagueFile, HasTheVersionOfItsRules) {
  EXPECT_NE(print_league_file({}).find("\"rules_version\": 1"), std::string::npos);
  EXPECT_EQ(parse_league_file(print_league_file({}), "l")->rules_version, current_rules);
  EXPECT_FALSE(parse_league_file(R"({"schema": "mirocup/league/1", "rules_version": 2})", "l"));
}

// Catches a host who moves the pages to another disk and is told that the rules were changed, and a
// key that hides another change.
TEST(LeagueFile, IsTheSameWithoutTheFolderOfItsPages) {
  EXPECT_EQ(error_of(R"("site":"pages")"),
            "league.json: /site: the absolute path of a folder is expected");
  LeagueFile file;
  file.title = "site";
  file.teams = {{.name = "site", .source = "house:idle", .parameters = {{"site", 0.5}}}};
  const std::string before = print_league_file(file);
  EXPECT_EQ(without_site(before), before);
  file.site = "/srv/a \"b\"";
  EXPECT_EQ(parse_league_file(print_league_file(file), "l")->site, file.site);
  for (const std::string value : {"/srv/site", "/srv/a, {b}", ""}) {
    for (const char* mark : {"{", "\"title\": \"site\",", "\"seed\": 1,"}) {
      std::string text = before;
      text.insert(text.find(mark) + std::string(mark).size(), "\n\t\"site\" : \"" + value + "\",");
      EXPECT_EQ(without_site(text), before) << text;
    }
    std::string last = before;
    last.insert(last.rfind('\n', last.rfind('}')), ",\n  \"site\": \"" + value + "\"");
    EXPECT_EQ(without_site(last), before) << last;
  }
  for (const char* text :
       {"", "{\"site\"", "{\"site\":", "{\"site\": \"", "\"site\": \"a\"", "{\"site\": \"a"})
    EXPECT_NE(without_site(text), before) << "whatever a damaged file becomes";
}

}  // namespace
}  // namespace mirocup::league
