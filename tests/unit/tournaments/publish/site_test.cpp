// SPDX-License-Identifier: MIT
//
// Catches text that becomes markup, and a
// decision that is not listed or that seems to count although a later one undid it.
#include "tournaments/publish/site.hpp"

#include "tests/support/is_ok.hpp"
#include "tests/support/memory_files.hpp"
#include "tests/unit/tournaments/small_league.hpp"
#include "tests/unit/tournaments/whole_site.hpp"
#include "tournaments/play/leg_record.hpp"
#include "tournaments/publish/grades.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace mirocup::league {
namespace {

using test_support::contains;

using test_support::MemoryFiles;

LeagueFile three_teams() {
  LeagueFile file = league_file_of({"a", "b", "c"});
  file.title = "A <i>title</i> & more";
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
  EXPECT_TRUE(test_support::is_ok(event));
  return event.value_or(LegPlayed());
}

LeagueState state_after(std::vector<std::pair<int, int>> legs) {
  const LeagueFile file = three_teams();
  LeagueState state = started_league(file);
  const auto fixtures = round_robin(3);
  for (const auto& [fixture, leg] : legs) {
    const LegPlayed event = played(file, fixtures[fixture], leg, record(2 + fixture, leg));
    const auto valid = validate(state, event);
    EXPECT_TRUE(test_support::is_ok(valid));
    league::apply(state, event);
  }
  return state;
}

// Returns the row of a table in the section of that heading, cell by cell; 0 is the heads.
std::vector<std::string> row_of(const std::string& html, const std::string& heading, int row) {
  std::size_t at = html.find("<h2>" + heading + "</h2>");
  for (int i = 0; i <= row && at != std::string::npos; ++i) at = html.find("<tr>", at + 1);
  if (at == std::string::npos) return {};
  const std::string text = html.substr(at, html.find("</tr>", at) - at);
  std::vector<std::string> cells;
  for (std::size_t end = text.find("</t"); end != std::string::npos;
       end = text.find("</t", end + 1)) {
    const std::size_t begin = text.rfind('>', end - 1) + 1;
    cells.push_back(text.substr(begin, end - begin));
  }
  return cells;
}

// Returns the file of a site.
std::string page(const std::vector<SiteFile>& site, const std::string& name) {
  for (const SiteFile& file : site) {
    if (file.name == name) return file.bytes;
  }
  ADD_FAILURE() << "there is no " << name;
  return {};
}

// Catches numbers below another head, of the other team, and pages that show a team no goal that
// fell against it.
TEST(Site, ShowsTheStatisticsOfItsLegs) {
  statistics::LegReport leg;
  leg.leg = "r3-f1 leg 2";  // a plays in blue
  leg.state_hash = 0x0123456789abcdef;
  leg.names = {"a", "b"};
  statistics::TeamStatistics& blue = leg.statistics.teams[0];
  blue.shots = 7;
  blue.passes = 5;
  blue.goals[statistics::at(statistics::GoalOrigin::rebound)] = 1;
  blue.possession_s = 30.0;
  leg.statistics.teams[1].possession_s = 10.0;
  leg.statistics.teams[1].fouls[statistics::at(referee::Law::push)] = 3;
  statistics::Goal goal;
  goal.tick = 1000;
  goal.origin = statistics::GoalOrigin::rebound;
  goal.restart = referee::Restart::KICK_OFF;
  goal.loss = statistics::Loss{.tick = 900, .kind = statistics::LossKind::save};
  leg.statistics.goals.push_back(goal);

  const auto site = make_site({state_after({{2, 2}}), {{"records/x.json", {{}, leg}}}});
  const auto cell = [](const std::string& html, const std::string& heading, int row,
                       const std::string& head) {
    const auto heads = row_of(html, heading, 0);
    const auto cells = row_of(html, heading, row);
    EXPECT_EQ(heads.size(), cells.size()) << heading;
    const auto at = std::find(heads.begin(), heads.end(), head) - heads.begin();
    return at < static_cast<std::ptrdiff_t>(cells.size()) ? cells[at] : std::string("no such cell");
  };
  const std::string index = page(site, "index.html");
  EXPECT_EQ(cell(index, "Statistics", 1, "Shots"), "7");
  EXPECT_EQ(cell(index, "Statistics", 1, "Possession"), "75 %");
  EXPECT_EQ(cell(index, "Statistics", 2, "Fouls"), "3");
  EXPECT_EQ(cell(index, "Goals by kind", 1, "rebound"), "1");
  const std::string team = page(site, "teams/b.html");
  EXPECT_EQ(cell(team, "Play", 3, "Fouls"), "3") << "as yellow";
  EXPECT_EQ(cell(team, "Goals by kind", 2, "rebound"), "1") << "against it";
  EXPECT_EQ(cell(team, "How goals fell against it", 1, "Last restart"), "kick off: toss");
  EXPECT_TRUE(contains(team, "../replays/x.html#t=30.00")) << "3 s before the goal";
  EXPECT_FALSE(contains(page(site, "teams/a.html"), "How goals fell"));
  EXPECT_FALSE(contains(page(site, "teams/c.html"), "<h2>Play</h2>")) << "has not played";
  leg.state_hash ^= 1;
  const auto other = make_site({state_after({{2, 2}}), {{"records/x.json", {{}, leg}}}});
  EXPECT_FALSE(contains(page(other, "index.html"), "<h2>Statistics</h2>"))
      << "the journal has another leg";
}

TEST(Site, LetsNoTextBecomeMarkup) {
  const std::string index = page(make_site({state_after({{0, 1}})}), "index.html");
  EXPECT_FALSE(contains(index, "<script>"));
  EXPECT_FALSE(contains(index, "<i>"));
  EXPECT_TRUE(contains(index, "A &lt;i&gt;title&lt;/i&gt; &amp; more"));
}

void decide(LeagueState& state, const Event& event) {
  const auto valid = validate(state, event);
  ASSERT_TRUE(test_support::is_ok(valid));
  league::apply(state, event);
}

TEST(Decisions, AreListedWithWhatBecameOfThem) {
  LeagueState state = state_after({{0, 1}, {0, 2}, {1, 1}});
  const std::string none = "No person has decided anything";
  EXPECT_TRUE(contains(page(make_site({state}), "index.html"), none));
  const std::string at = "2026-11-30T18:00:00Z";
  const auto ids = [&](int fixture) { return state.fixtures[fixture].fixture.id(); };
  const auto voids = [&](int fixture, const std::string& why) {
    return LegVoided{.fixture = ids(fixture),
                     .leg = 1,
                     .attempt = 1,
                     .cause = VoidCause::ruling,
                     .signature = {why, "H", at}};
  };
  const Fixture second = state.fixtures[1].fixture;
  const std::string leaver = state.name(second.home);
  const std::string home = state.name(state.fixtures[0].fixture.home);
  const std::string away = state.name(state.fixtures[0].fixture.away);
  decide(state, Ruled{.fixture = ids(0),
                      .leg = 2,
                      .score = {.home = 999999, .away = 0},
                      .signature = {"<b>too much</b>, \"quoted\"", "<i>H</i>", at}});
  decide(state, Ruled{.fixture = ids(0), .leg = 2, .score = {}, .signature = {"a typing error"}});
  decide(state, voids(0, "cable fault"));
  decide(state, played(state.file, state.fixtures[0].fixture, 1, record(1, 0)));
  decide(state, voids(0, "oops"));
  decide(state, voids(1, "a person on the field"));
  decide(state,
         Paused{.team = leaver, .signature = {"3 legs in a row", "", at}, .is_by_program = true});
  decide(state, Resumed{.team = leaver, .signature = {"", "", at}});
  decide(state, Paused{.team = leaver, .signature = {"asked", "", at}});
  decide(state,
         Withdrawn{.team = leaver, .results = WithdrawnResults::keep, .signature = {"left"}});

  const std::string leg = ids(0) + " leg ";
  const std::string teams = ", " + home + " – " + away + ": ";
  const std::string other = ids(1) + " leg 1, " + leaver + " – " + state.name(second.away) + ": ";
  const std::string again = "void, to be played again with the same seed";
  const std::vector<std::string> lines{
      "number,at,by,kind,what,why,undone_by",
      "1," + at + ",<i>H</i>,ruling,\"" + leg + "2" + teams +
          "999999:0 (was 2:2)\",\"<b>too much</b>, \"\"quoted\"\"\",2",
      "2,,,ruling,\"" + leg + "2" + teams + "0:0 (was 999999:0)\",a typing error,",
      "3," + at + ",H,void,\"" + leg + "1" + teams + again + " (was 2:1)\",cable fault,",
      "4," + at + ",H,void,\"" + leg + "1" + teams + again + " (was 1:0)\",oops,",
      "5," + at + ",H,void,\"" + other + again + " (was 3:1)\",a person on the field,8",
      "6," + at + ",,resume," + leaver + " plays on,,",
      "7," + at + ",,pause," + leaver + " paused,asked,8",
      "8,,,withdraw,\"" + leaver + " withdrawn, its results stay\",left,"};
  std::string csv;
  for (const std::string& line : lines) csv += line + "\r\n";
  EXPECT_EQ(page(make_site({state}), "decisions.csv"), csv);
  const std::string index = page(make_site({state}), "index.html");
  for (const std::string text :
       {">Decisions</h2>", "&lt;b&gt;too much&lt;/b&gt;", "&lt;i&gt;H&lt;/i&gt;",
        ">overruled by 2</span>", "cable fault", "covered by 8, "}) {
    EXPECT_TRUE(contains(index, text)) << text;
  }
  EXPECT_FALSE(contains(index, "<b>"));
  const Json json = Json::parse(page(make_site({state}), "decisions.json"));
  ASSERT_EQ(json["decisions"].size(), 8u);
  EXPECT_EQ(json["decisions"][0]["undone_by"], 2);
  EXPECT_TRUE(json["decisions"][1]["at"].is_null());
}

// A void that was carried out stays in effect; only one whose leg waits can be overruled.
TEST(Decisions, ThatWereCarriedOutAreNotOverruled) {
  LeagueState state = state_after({{0, 1}});
  const Fixture f = state.fixtures[0].fixture;
  const LegVoided voided{
      .fixture = f.id(), .leg = 1, .attempt = 1, .cause = VoidCause::ruling, .signature = {"w"}};
  const Ruled ruled{.fixture = f.id(), .leg = 1, .score = {}, .signature = {"w"}};
  decide(state, voided);
  decide(state, played(state.file, f, 1, record(1, 0)));
  decide(state, voided);
  decide(state, ruled);
  decide(state, voided);
  decide(state, played(state.file, f, 1, record(1, 0)));
  decide(state, ruled);
  ASSERT_EQ(state.decisions.size(), 5u);
  EXPECT_FALSE(state.decisions[0].undone_by);
  EXPECT_EQ(state.decisions[1].undone_by, 2u);
  EXPECT_EQ(state.decisions[2].undone_by, 3u);
  EXPECT_FALSE(state.decisions[3].undone_by);
  EXPECT_FALSE(state.decisions[4].undone_by);
}

TEST(Decisions, OfLegsOfATeamThatLeavesNoResultsCountForNothing) {
  LeagueState state = state_after({{0, 1}, {0, 2}});
  const Fixture& f = state.fixtures[0].fixture;
  decide(state, Ruled{.fixture = f.id(), .leg = 1, .score = {}, .signature = {"w"}});
  decide(state, Withdrawn{.team = state.name(f.away),
                          .results = WithdrawnResults::annul,
                          .signature = {"left"}});
  const std::string index = page(make_site({state}), "index.html");
  EXPECT_TRUE(contains(index, ">covered by 2, " + state.name(f.away) + " has withdrawn</span>"));
}

// Plays a tie of a knockout that is level by goals: its third leg ends in that way. Returns the
// page of its round and the front page.
std::string page_of_level_tie(LegEnd end, std::optional<std::string> winner,
                              const KnownLegs& legs = {}) {
  LeagueState state =
      started_league(league_file_of({"ada", "bob"}, {.kind = FormatKind::knockout}));
  for (int leg = 1; leg <= 3; ++leg) {
    LegPlayed event = played_leg(state, state.fixtures[0].fixture, leg, {});
    if (leg == 3) {
      event.end = end;
      event.winner = winner;
    }
    EXPECT_TRUE(validate(state, event));
    league::apply(state, event);
  }
  const std::vector<SiteFile> site = make_site({.state = state, .legs = legs});
  return page(site, "rounds/k1.html") + page(site, "index.html");
}

// Catches a tie that does not say why one of the teams goes on.
TEST(Site, SaysWhoWonALevelTie) {
  const std::string by_lot = page_of_level_tie(LegEnd::full_time, std::nullopt);
  EXPECT_TRUE(contains(by_lot, "level: decided by lot for "));
  EXPECT_TRUE(contains(by_lot, " won\""));
  const std::string by_shoot_out = page_of_level_tie(LegEnd::shoot_out, "bob");
  EXPECT_FALSE(contains(by_shoot_out, "a lot decided"));
  EXPECT_TRUE(contains(by_shoot_out, "\"away won\""));
  EXPECT_FALSE(contains(by_shoot_out, "by lot"));
  // The shoot-out was level as well. Catches a bracket that says that it was won.
  KnownLegs legs;
  legs["records/k1-f1-3-1.json"].facts.emplace().shoot_out = HomeAway{.home = 2, .away = 2};
  const std::string level = page_of_level_tie(LegEnd::shoot_out, "bob", legs);
  EXPECT_TRUE(contains(level, "shoot-out, level, won by lot by bob"));
  EXPECT_TRUE(contains(level, ">by lot</text>")) << "the bracket";
  EXPECT_TRUE(contains(level, "came further in the knockout, by lot")) << "the table";
}

// Catches a term whose crosstable has a line for each leg, and a table that is ordered by a number
// that it does not show.
TEST(Site, SumsTheNightsOfATerm) {
  LeagueFile file =
      league_file_of({"ada", "bob", "eve"}, {.kind = FormatKind::nightly}, "submitted");
  file.freeze = "2020-11-30T18:00:00Z";
  LeagueState state = started_league(file);
  for (int night = 1; night <= 4; ++night) {
    NightBegan begun;
    begun.number = night;
    if (night == 1) begun.entries = {{"ada", 1, "s"}, {"bob", 1, "t"}};
    league::apply(state, begun);
    for (int leg = 1; leg <= 2; ++leg) {
      LegPlayed event = played_leg(state, state.fixtures.back().fixture, leg, {});
      (event.home == "ada" ? event.score.home : event.score.away) = 2;
      event.winner = "ada";
      ASSERT_TRUE(validate(state, event));
      league::apply(state, event);
    }
  }
  const std::vector<SiteFile> site = make_site({state});
  const std::string front = page(site, "index.html");
  EXPECT_TRUE(contains(front, "<span>8–0–0</span>"));
  EXPECT_TRUE(contains(front, "<span>16:0</span>"));
  EXPECT_TRUE(contains(front, "Deadline for entries: 2020-11-30 18:00 UTC."))
      << "true before it and after it";
  const TableRow first = state.table()[0];
  const long strength = std::lround(state.ratings().strengths[first.team].value);
  EXPECT_GT(strength, 0);
  EXPECT_TRUE(contains(front, "<td class=\"number points\">" + std::to_string(strength) + "</td>"));
  // Eve has not handed in.
  EXPECT_FALSE(contains(front, "class=\"open\"")) << "eight legs decide";
  EXPECT_TRUE(
      contains(front, "<td class=\"number\">–</td><th scope=\"row\"><a href=\"teams/eve.html\""));
  EXPECT_TRUE(contains(page(site, "teams/eve.html"), "No rank yet"));
  EXPECT_TRUE(contains(page(site, "teams/ada.html"), "Rank 1 of 2,"));
  const std::string csv = page(site, "table.csv");
  EXPECT_TRUE(contains(csv, "\r\n,eve,0,0,0,0,0,0,0,0,0,,,,,,,\r\n"));
  EXPECT_TRUE(contains(csv, ",3.0,yes\r\n"));
  const auto grades_csv = grades(overview(state), {}, "", "");
  ASSERT_TRUE(grades_csv);
  EXPECT_TRUE(contains(grades_csv->bytes, "\r\n,eve,0,0,,,,,,,,no entry,\r\n"));
}

TEST(LegFacts, AreThoseOfTheRecordAsTheHomeTeamSeesThem) {
  const std::string text = R"({"control_period": 0.5, "ticks": 40,
    "result": {"shoot_out": {"blue": 3, "yellow": 2}},
    "decisions": [
      {"tick": 4, "decision": "GOAL", "gainer": "yellow",
       "scorer": {"team": "yellow", "robot": 2}, "own_goal": false},
      {"tick": 8, "decision": "PENALTY_KICK", "gainer": "blue", "offender": "yellow"},
      {"tick": 9, "decision": "GOAL", "gainer": "blue",
       "scorer": {"team": "yellow", "robot": 0}, "own_goal": true}]})";
  const auto facts = facts_of(text, false);  // the home team is yellow
  ASSERT_TRUE(facts);
  EXPECT_EQ(facts->length, 20.0);
  ASSERT_EQ(facts->goals.size(), 2u);
  EXPECT_EQ(facts->goals[0].at, 2.0);
  EXPECT_TRUE(facts->goals[0].is_home);
  EXPECT_EQ(facts->goals[0].scorer, 2);
  EXPECT_FALSE(facts->goals[1].is_home);
  EXPECT_EQ(facts->goals[1].scorer, -1) << "an own goal has no scorer";
  EXPECT_EQ(std::pair(facts->fouls.home, facts->fouls.away), std::pair(1, 0));
  ASSERT_TRUE(facts->shoot_out);
  EXPECT_EQ(std::pair(facts->shoot_out->home, facts->shoot_out->away), std::pair(2, 3));
  for (const char* other : {"", "[]", "{}", R"({"control_period": 1, "ticks": 1})"})
    EXPECT_FALSE(facts_of(other, true)) << other;
}

// Catches a table before the first night that lots have ordered.
TEST(LeagueState, ListsTeamsThatHaveNotPlayedByName) {
  const LeagueState state =
      started_league(league_file_of({"t10", "t3", "a", "t2", "t1"}, {.kind = FormatKind::nightly}));
  std::string names;
  for (const TableRow& row : state.table()) names += state.name(row.team) + row.separated_by + " ";
  EXPECT_EQ(names, "a t1 t2 t3 t10 ");
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

}  // namespace
}  // namespace mirocup::league
