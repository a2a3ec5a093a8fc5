// SPDX-License-Identifier: MIT
//
// Catches pages that depend on the order in which legs were played, and text that becomes markup.
#include "tournaments/publish/site.hpp"

#include "tests/support/memory_files.hpp"
#include "tournaments/league/apply.hpp"
#include "tournaments/play/leg_record.hpp"
#include "tournaments/publish/html.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace mirocup::league {
namespace {

using test_support::MemoryFiles;

LeagueFile three_teams() {
  LeagueFile file;
  file.title = "A <i>title</i> & more";
  for (const char* name : {"a", "b", "c"}) file.teams.push_back({name, "house:idle", false});
  return file;
}

Json record(int blue, int yellow) {
  return {
      {"decisions", Json::array({{{"decision", "PENALTY_KICK"}, {"team", "blue"}}})},
      {"result",
       {{"score", {{"blue", blue}, {"yellow", yellow}}},
        {"winner", blue > yellow ? "blue" : "yellow"},
        {"end", "full_time"},
        {"fault", {{"team", "yellow"}, {"code", "crash"}, {"text", "<script>alert(1)</script>"}}}}},
      {"state_hash", "0123456789abcdef"}};
}

LegPlayed played(const LeagueFile& file, const Fixture& fixture, int leg, const Json& record) {
  const auto event = leg_played(file, {.fixture = fixture, .leg = leg}, record, "records/x.json");
  EXPECT_TRUE(event) << event.error().what;
  return event.value_or(LegPlayed());
}

LeagueState state_after(std::vector<std::pair<int, int>> legs) {
  const LeagueFile file = three_teams();
  LeagueState state = new_league(file);
  league::apply(state, Started{.config_sha256 = "x", .version = ""});
  const auto fixtures = round_robin(3);
  for (const auto& [fixture, leg] : legs) {
    const LegPlayed event = played(file, fixtures[fixture], leg, record(2 + fixture, leg));
    const auto valid = validate(state, event);
    EXPECT_TRUE(valid) << valid.error().what;
    league::apply(state, event);
  }
  return state;
}

TEST(Site, IsTheSameInWhateverOrderTheLegsWerePlayed) {
  const auto forwards = make_site(state_after({{0, 1}, {0, 2}, {1, 1}, {2, 1}}));
  const auto backwards = make_site(state_after({{2, 1}, {1, 1}, {0, 2}, {0, 1}}));
  ASSERT_EQ(forwards.size(), backwards.size());
  for (std::size_t i = 0; i < forwards.size(); ++i) {
    EXPECT_EQ(forwards[i].name, backwards[i].name);
    EXPECT_EQ(forwards[i].bytes, backwards[i].bytes) << forwards[i].name;
  }
}

TEST(Site, LetsNoTextBecomeMarkup) {
  const auto site = make_site(state_after({{0, 1}}));
  EXPECT_EQ(site[0].name, "index.html");
  EXPECT_EQ(site[0].bytes.find("<script>"), std::string::npos);
  EXPECT_EQ(site[0].bytes.find("<i>"), std::string::npos);
  EXPECT_NE(site[0].bytes.find("A &lt;i&gt;title&lt;/i&gt; &amp; more"), std::string::npos);
}

TEST(LeagueState, BooksColoursForTheirTeams) {
  // Leg 2: the away team is blue.
  const LeagueState state = state_after({{0, 1}, {0, 2}});
  const FixtureState& f = state.fixtures[0];
  EXPECT_EQ(f.legs[0].played->result.home_goals, 2);
  EXPECT_EQ(f.legs[0].played->result.away_goals, 1);
  EXPECT_EQ(f.legs[0].played->result.home_penalties, 1);
  EXPECT_EQ(f.legs[1].played->result.home_goals, 2) << "yellow in leg 2";
  EXPECT_EQ(f.legs[1].played->result.away_goals, 2);
  EXPECT_EQ(f.legs[1].played->result.away_penalties, 1);
  ASSERT_TRUE(f.legs[0].played->fault);
  EXPECT_EQ(f.legs[0].played->fault->code, "crash");
}

TEST(LeagueState, RefusesALegThatIsBookedTwice) {
  MemoryFiles files;
  const LeagueFile file = three_teams();
  auto journal = Journal::open(files, "journal.jsonl");
  const LegPlayed leg = played(file, round_robin(3)[0], 1, record(1, 0));
  EXPECT_TRUE(journal->append("start", fields_of(Started{.config_sha256 = "x", .version = ""})));
  EXPECT_TRUE(journal->append("leg", fields_of(leg)));
  EXPECT_TRUE(journal->append("leg", fields_of(leg)));
  const auto state = state_from_journal(file, *journal);
  ASSERT_FALSE(state);
  EXPECT_EQ(state.error().code, Errc::damaged);
  EXPECT_EQ(state.error().what,
            "journal.jsonl: line 3 does not fit the league: r1-f1 leg 1 is decided already");
}

TEST(LeagueFile, NamesThePlaceOfAMistake) {
  const auto what = [](const std::string& text) {
    const auto file = parse_league_file(text, "league.json");
    return file ? std::string("no error") : file.error().what;
  };
  const std::string schema = R"({"schema":"mirocup/league/1",)";
  EXPECT_NE(what("{").find("league.json: "), std::string::npos);
  EXPECT_NE(what("{}").find("/schema"), std::string::npos);
  EXPECT_NE(what(schema + R"("seeds":1})").find("/seeds: there is no such key"), std::string::npos);
  EXPECT_NE(what(schema + R"("rules":{"half":1}})").find("/rules/half: there is no such parameter"),
            std::string::npos);
  EXPECT_NE(what(schema + R"("rules":{"half_s":"long"}})").find("/rules/half_s"),
            std::string::npos);
  EXPECT_NE(
      what(schema + R"("teams":[{"name":"../x","entry":"house:idle"}]})").find("/teams/0/name"),
      std::string::npos);
  EXPECT_NE(what(schema + R"("teams":[{"name":"a","entry":"x"},{"name":"a","entry":"y"}]})")
                .find("/teams/1/name"),
            std::string::npos);
  EXPECT_EQ(what(schema + R"("teams":[{"name":"a","entry":"x"}]})"), "no error");
}

}  // namespace
}  // namespace mirocup::league
