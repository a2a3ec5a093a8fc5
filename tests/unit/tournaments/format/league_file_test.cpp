// SPDX-License-Identifier: MIT
#include "tournaments/format/league_file.hpp"

#include "tests/support/is_ok.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace mirocup::league {
namespace {

using test_support::contains;

Result<LeagueFile> parse(const std::string& fields) {
  return parse_league_file(
      R"({"schema":"mirocup/league/1")" + (fields.empty() ? "" : "," + fields) + "}",
      "league.json");
}

std::string error_of(const std::string& fields) {
  return test_support::why_not(parse(fields));
}

std::string team(const std::string& more) {
  return R"("teams":[{"name":"a",)" + more + "}]";
}

// Catches numbers that overflow later, a team that a key is not for, and a message without its key.
TEST(LeagueFile, NamesThePlaceOfAMistake) {
  const std::pair<std::string, const char*> cases[]{
      {R"("points":{"win":2147483647})", "/points/win: 2147483647 is not at most 1000000"},
      {R"("points":{"loss":-2147483648})", "/points/loss: -2147483648 is not at least -1000000"},
      {R"("rules":{"forfeit_goals":2147483647})",
       "/rules/forfeit_goals: 2147483647 is not at most 10000"},
      {R"("rules":{"half":1})", "/rules/half: there is no such parameter"},
      {R"("rules":{"half_s":"long"})", "/rules/half_s: "},
      {R"("rules":{"half_s":0})", "/rules/half_s: "},
      {R"("rules":{"half_s":0.01})", "/rules/half_s: "},
      {R"("rules":{"half_s":1e300})", "/rules/half_s: "},
      {R"("seeds":1)", "/seeds: there is no such key"},
      {R"("rules_version":2)", "/rules_version: "},
      {R"("thoughts":"yes")", "/thoughts: true or false is expected, not \"yes\""},
      {R"("processor":"pentium")", "/processor: "},
      {R"("site":"pages")", "/site: the absolute path of a folder is expected"},
      {R"("teams":[{"name":"../x","entry":"house:idle"}])", "/teams/0/name: "},
      {R"("teams":[{"name":"a","entry":"x"},{"name":"a","entry":"y"}])", "/teams/1/name: "},
      {team(R"("entry":"house:idle","parameters":{"wait":"far"})"),
       "/teams/0/parameters/wait: a number is expected, not \"far\""},
      {team(R"("entry":"house:idle","parameters":[])"), "/teams/0/parameters"},
      {team(R"("entry":"house:idle","run":"./b")"), "/teams/0/run: "},
      {team(R"("entry":"firasim:b","dds":true)"), "/teams/0/dds: "},
      {team(R"("entry":"firasim:")"), "/teams/0/entry: "},
      {R"("zone":"Europe/Berlin","freeze":"2027-03-28T02:30:00")",
       "does not exist in Europe/Berlin: clocks go from \"2027-03-28T01:59:59\" to "
       "\"2027-03-28T03:"}};
  for (const auto& [fields, said] : cases) EXPECT_TRUE(contains(error_of(fields), said));
  EXPECT_EQ(error_of(R"("points":{"win":1000000,"loss":-1000000})"), "");
  EXPECT_EQ(error_of(team(R"("entry":"x")")), "");
  std::string teams = R"("teams":[)";
  for (int i = 0; i < 1001; ++i) teams += (i > 0 ? ",{}" : "{}");
  EXPECT_EQ(error_of(teams + "]"), "league.json: /teams: 0 to 1000 values are expected, not 1001");
  for (const char* text : {"{", "{}"})
    EXPECT_TRUE(contains(parse_league_file(text, "league.json").error().what, "league.json: "));
}

// Catches a key that is lost when the file of a league is written again, and one that counts where
// it is not there: commands that a host gives to nobody, thoughts that nobody asked for.
TEST(LeagueFile, KeepsWhatItSays) {
  using Is = std::function<bool(const LeagueFile&)>;
  const std::pair<std::string, Is> cases[]{
      {R"("thoughts":true)", [](const LeagueFile& f) { return f.keeps_thoughts; }},
      {R"("proofs":false)", [](const LeagueFile& f) { return !f.has_proofs; }},
      {R"("processor":"x86-64-v2")",
       [](const LeagueFile& f) { return f.processor == system::Processor::v2; }},
      {team(R"("entry":"house:idle","parameters":{"wait":0.4})"),
       [](const LeagueFile& f) {
         return f.teams[0].parameters == match::TeamParameters{{"wait", 0.4}};
       }},
      {team(R"("entry":"firasim:b")"),
       [](const LeagueFile& f) { return f.teams[0].is_started_by_people(); }},
      {team(R"("entry":"firasim:b","run":"./b","folder":"c","lockstep":true)"),
       [](const LeagueFile& f) {
         const FirasimProgram& program = f.teams[0].program;
         return program.run == "./b" && program.folder == "c" && program.lockstep;
       }},
      {R"("firasim":{"instance":3,"referee":"127.0.0.1:9"})", [](const LeagueFile& f) {
         return f.firasim.instance == 3 && f.firasim.referee == "127.0.0.1:9";
       }}};
  const auto usual = parse(team(R"("entry":"house:idle")"));
  ASSERT_TRUE(test_support::is_ok(usual));
  for (const auto& [fields, holds] : cases) {
    const auto file = parse(fields);
    ASSERT_TRUE(test_support::is_ok(file));
    EXPECT_TRUE(holds(*file)) << fields;
    const auto again = parse_league_file(print_league_file(*file), "league.json");
    ASSERT_TRUE(test_support::is_ok(again));
    EXPECT_TRUE(holds(*again)) << fields;
    EXPECT_FALSE(holds(*usual)) << fields;
  }
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
    EXPECT_TRUE(
        contains(time.error().what,
                 "no time: one like \"2026-11-30 19:00\" in the league's zone (Europe/Berlin)"));
  }
}

// What was published must not change by an upgrade, so a file says by which rules it was made.
TEST(LeagueFile, HasTheVersionOfItsRules) {
  EXPECT_TRUE(contains(print_league_file({}), "\"rules_version\": 1"));
  EXPECT_EQ(parse_league_file(print_league_file({}), "l")->rules_version, current_rules);
}

// Catches a host who moves the pages to another disk and is told that the rules were changed, and a
// key that hides another change.
TEST(LeagueFile, IsTheSameWithoutTheFolderOfItsPages) {
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
