// SPDX-License-Identifier: MIT
//
// A term of a class of eight teams, rehearsed with a clock that is moved: nights, a bad entry, an
// appeal, release, grades. Catches a night that plays what was not accepted, a digest that tells of
// other legs than the night's, and a result that pages tell before it is released.
#include "tests/programs/league/league_command.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <map>

namespace mirocup {
namespace {

namespace fs = std::filesystem;

using Json = nlohmann::ordered_json;
using namespace test_support;

const std::vector<std::string> class_teams{"alpha", "beta", "gamma", "delta", "epsilon", "zeta"};

// Sets the clock of all programs that are started from now on to noon (UTC) of a day of the term.
void go_to_day(int day) {
  constexpr long day_s = 86'400;
  const long now = std::time(nullptr);
  const long offset = day * day_s + day_s / 2 - now % day_s;
  setenv("MIROCUP_CLOCK_OFFSET", std::to_string(offset).c_str(), 1);
}

class Term : public testing::Test {
 protected:
  Term() { change_computer("first"); }
  ~Term() override {
    unsetenv("MIROCUP_CLOCK_OFFSET");
    unsetenv("XDG_STATE_HOME");
  }

  // The programs that are started from now on know what they remember on that computer.
  void change_computer(const std::string& name) const {
    setenv("XDG_STATE_HOME", (temporary_ / name).c_str(), 1);
  }

  void init() {
    std::string teams;
    for (const std::string& team : class_teams)
      teams += R"({"name": ")" + team + R"(", "entry": "submitted"}, )";
    write_file(temporary_ / "league.json",
               R"({"schema": "mirocup/league/1", "title": "Term", "zone": "Europe/Berlin",
  "format": {"kind": "nightly", "opponents": 2}, "rules": {"half_s": 4}, "seed": 9,
  "teams": [)" + teams +
                   R"({"name": "striker", "entry": "house:striker"},
            {"name": "idle", "entry": "house:idle"}]})");
    expect_exit(0, run(league("init", folder_, {"--config", temporary_ / "league.json"})));
  }

  // The answer to a command, which must end with that code.
  Outcome ask(const std::string& command, const std::vector<std::string>& more = {},
              int exit_code = 0) const {
    const Outcome outcome = run(league(command, folder_, more));
    EXPECT_EQ(outcome.exit_code, exit_code) << command << ": " << outcome.out << outcome.err;
    return outcome;
  }

  std::string page(const std::string& name) const { return read_file(folder_ + "/site/" + name); }

  const TemporaryFolder temporary_;
  const std::string folder_ = temporary_ / "term";
};

// Compares what teams were told of the last night with the journal.
void expect_digests(const std::string& folder) {
  struct Legs {
    int won = 0, drawn = 0, lost = 0;
  };
  std::map<std::string, Legs> legs;
  int nights = 0;
  for (const auto& line : journal_of(folder)) {
    if (line["kind"] == "night") {
      ++nights;
      legs.clear();
    }
    if (line["kind"] != "leg") continue;
    const int ahead = line["score"]["home"].get<int>() - line["score"]["away"].get<int>();
    for (const char* end : {"home", "away"}) {
      Legs& of = legs[line[end].get<std::string>()];
      ++(ahead == 0 ? of.drawn : (ahead > 0) == (end == std::string("home")) ? of.won : of.lost);
    }
  }
  for (const auto& [team, of] : legs) {
    const Json told =
        read_json(folder + "/nights/" + std::to_string(nights) + "/" + team + ".json");
    EXPECT_EQ(told["won"], of.won) << team;
    EXPECT_EQ(told["drawn"], of.drawn) << team;
    EXPECT_EQ(told["losses"].size(), of.lost) << team;
    EXPECT_LE(told["moments"].size(), 3u);
  }
}

TEST_F(Term, DoubtsAClockThatWentBack) {
  go_to_day(7);
  init();
  ask("submit", {"alpha", house("chaser")});
  ask("nightly");
  go_to_day(0);
  EXPECT_TRUE(contains(ask("nightly").err, "before the last line of the journal"));
  go_to_day(200);
  EXPECT_TRUE(contains(ask("nightly").err, "long after the last line of the journal"));
}

// Catches a timer that stands still, or a night that was killed, of which nobody is told.
TEST_F(Term, HealthCallsTheHostOnlyWhenSomethingIsWrong) {
  go_to_day(0);
  init();
  ask("submit", {"alpha", house("chaser")});
  ask("nightly");
  EXPECT_TRUE(contains(ask("health").out, "MiB left"));
  EXPECT_TRUE(contains(ask("status").out, "MiB used (records "));
  go_to_day(3);
  const Json late = Json::parse(ask("health", {"--json"}, 1).out);
  EXPECT_EQ(late["needs_person"], true);
  EXPECT_EQ(late["night"]["number"], 1);
  EXPECT_TRUE(contains(late["problems"].dump(), "no night has begun")) << late;
  fs::remove(folder_ + "/nights/1/report.txt");
  EXPECT_TRUE(contains(ask("health", {}, 1).out, "night 1 did not come to its end"));
}

// Catches pages that come back by themselves or that are linked although they are gone, records or
// numbers that go with them, and pages that cannot be made again.
TEST_F(Term, PrunedNightsKeepTheirRecordsAndNumbers) {
  go_to_day(0);
  init();
  ask("submit", {"alpha", house("chaser")});
  ask("nightly");
  ask("prune", {"--before", "2"}, 2);
  go_to_day(1);
  ask("nightly");
  const auto whole = site_of(folder_);
  const auto expect_pruned = [&] {
    for (const auto& [name, bytes] : site_of(folder_)) {
      EXPECT_FALSE(name.starts_with("replays/r1-")) << name;
      EXPECT_FALSE(contains(bytes, "replays/r1-") || contains(bytes, "\"r1-f1-1-1.html")) << name;
    }
    EXPECT_EQ(page("table.csv"), whole.at("table.csv"));
    EXPECT_EQ(page("statistics.csv"), whole.at("statistics.csv"));
    EXPECT_TRUE(fs::exists(folder_ + "/site/replays/r2-f1-1-1.html"));
  };
  EXPECT_TRUE(contains(ask("prune", {"--before", "2"}).out, "pages of 1 night are removed"));
  expect_pruned();
  const auto pruned = site_of(folder_);
  fs::remove_all(folder_ + "/site");
  ask("publish");
  expect_pruned();
  EXPECT_EQ(site_of(folder_), pruned);
  go_to_day(2);
  ask("nightly");
  EXPECT_FALSE(fs::exists(folder_ + "/site/replays/r1-f1-1-1.html"));
  ask("verify");
  ask("publish", {"--pages", "2"}, 2);
  ask("publish", {"--pages", "1"});
  EXPECT_TRUE(fs::exists(folder_ + "/site/replays/r1-f1-1-1.html"));
  EXPECT_TRUE(contains(page("rounds/r1.html"), "replays/r1-f1-1-1.html"));
  EXPECT_FALSE(fs::exists(folder_ + "/pruned.json"));
}

// Catches a closing round that plays with the entries of the last night, one that leaves out who
// handed in after it, one in which pairs meet unequally often, and pages that do not lead there.
TEST_F(Term, AClosingRoundOfTheLastEntriesDecidesTheSeason) {
  go_to_day(0);
  init();
  ask("submit", {"alpha", house("chaser")});
  ask("nightly");
  ask("submit", {"alpha", house("keeper")});
  ask("submit", {"beta", house("chaser")});
  EXPECT_EQ(ask("close", {"--legs", "2", "--reason", "over"}, 2).out, "") << "legs of what?";
  ask("close", {"--final", "double_round_robin", "--reason", "over", "--dry-run"});
  EXPECT_FALSE(fs::exists(folder_ + "/final"));
  const Outcome closed =
      ask("close", {"--final", "double_round_robin", "--legs", "4", "--reason", "over"});
  EXPECT_TRUE(contains(closed.out, "4 teams, 24 legs in the closing round")) << closed.out;
  const std::string entry = "/strategy.so";
  EXPECT_EQ(read_file(folder_ + "/final/entries/alpha/1" + entry),
            read_file(folder_ + "/entries/alpha/2" + entry));
  const Json table = read_json(folder_ + "/final/site/table.json")["table"];
  ASSERT_EQ(table.size(), 4u);
  for (const Json& row : table) EXPECT_EQ(row["played"], 12) << row;
  EXPECT_TRUE(contains(page("index.html"), "href=\"../final/site/index.html\""));
  EXPECT_TRUE(contains(page("digests/alpha.html"), "A closing round of the last entries"));
  ask("close", {"--final", "round_robin", "--reason", "again"}, 2);
  ask("nightly", {}, 2);

  // Marks of the closing round. Catches further legs that the mark does not count, or counts in one
  // command and not in the next, and such that nobody can look at.
  const std::string final_round = folder_ + "/final";
  const std::string scale = temporary_ / "scale.json";
  write_file(scale, R"([{"mark": 4, "beats": "idle"}, {"mark": 1, "beats": "striker"}])");
  const auto grades = [&](std::vector<std::string> more) {
    more.insert(more.end(), {"--scale", scale});
    return run(league("grades", final_round, more)).out;
  };
  EXPECT_TRUE(contains(grades({}), ",no,12\r\n")) << grades({});
  const std::string decided = grades({"--decide", "--most", "2", "--release"});
  const Json mark = read_json(final_round + "/marks/alpha.json");
  EXPECT_TRUE(contains(decided, "," + mark["count"].dump() + "\r\n")) << decided;
  EXPECT_EQ(grades({}), decided);
  EXPECT_EQ(mark["legs"].size(), mark["count"].get<std::size_t>() - 4) << "4 against beta";
  EXPECT_GT(mark["legs"].size(), 8u);
  EXPECT_FALSE(fs::exists(final_round + "/marks/striker.json"));
  const std::string record = mark["legs"].back()["record"].get<std::string>();
  EXPECT_EQ(run({program("mirocup"), "verify", final_round + "/" + record}).exit_code, 0) << record;
}

// Catches finals with other entries than those of the table, in another order, with a team that has
// left, and without the names that people know.
TEST_F(Term, FinalsTakeTheFirstOfTheTable) {
  go_to_day(0);
  init();
  for (const char* team : {"alpha", "beta", "gamma", "delta"}) {
    ask("submit", {team, house(team == std::string("alpha") ? "navigator" : "chaser")});
    ask("team", {team, "--display", std::string("The ") + team});
  }
  ask("nightly");
  ask("submit", {"alpha", house("keeper")});  // plays from the next night on
  const Json before = read_json(folder_ + "/site/table.json")["table"];
  const std::string gone = before[0]["team"].get<std::string>();
  ask("withdraw", {gone, "--reason", "left", "--results", "keep"});
  ask("publish");
  const std::string finals = temporary_ / "finals";
  const auto init_finals = [&](const std::string& top) {
    return run(league("init", finals, {"--from", folder_, "--top", top, "--half", "2"}));
  };
  EXPECT_EQ(init_finals("7").exit_code, 2);
  expect_exit(0, init_finals("4"));
  const Json config = read_json(finals + "/league.json");
  EXPECT_EQ(config["format"], "knockout");
  EXPECT_EQ(config["rules"]["half_s"], 2.0);
  std::vector<std::string> expected;
  for (const auto& row : before) {
    if (row["team"] != gone && expected.size() < 4)
      expected.push_back(row["team"].get<std::string>());
  }
  std::vector<std::string> found;
  for (const auto& team : config["teams"]) found.push_back(team["name"].get<std::string>());
  EXPECT_EQ(found, expected) << before;
  for (const std::string& team : found) {
    const std::string entry = "/entries/" + team + "/1/strategy.so";
    EXPECT_EQ(read_file(finals + entry), read_file(folder_ + entry)) << team;
  }
  expect_exit(0, run(league("start", finals)));
  const std::string home = read_file(finals + "/site/index.html");
  for (const std::string& team : found) {
    const bool is_house = team == "striker" || team == "idle";
    EXPECT_TRUE(is_house || contains(home, "The " + team)) << team;
  }
}

// Catches sources in another layout than JPlag's, a library that is taken for a source, a team that
// is not named, and what the class was given as somebody's own.
TEST_F(Term, SourcesAreExportedAsJPlagReadsThem) {
  init();
  for (const char* team : {"alpha", "beta", "gamma"}) ask("submit", {team, house("chaser")});
  const auto of = [&](const std::string& team) { return folder_ + "/entries/" + team + "/1/"; };
  const auto was_called = [&](const std::string& team, const std::string& name) {
    Json verdict = read_json(of(team) + "verdict.json");
    verdict["file"] = name;
    write_file(of(team) + "verdict.json", verdict.dump());
  };
  write_file(of("alpha") + "source", "int alpha;\n");
  was_called("alpha", "../mine.cpp");
  const std::string project = temporary_ / "project";
  fs::create_directories(project + "/src");
  write_file(project + "/src/one.cpp", "int beta;\n");
  expect_exit(0,
              run({"/usr/bin/tar", "-czf", of("beta") + "source", "-C", project, "src/one.cpp"}));
  was_called("beta", "project.tar.gz");
  const std::string to = temporary_ / "sources";
  const std::string said = ask("export", {"--sources", "-o", to}).out;
  EXPECT_EQ(read_file(to + "/submissions/alpha/team.cpp"), "int alpha;\n") << said;
  EXPECT_TRUE(contains(said, "beta: project.tar.gz, to be unpacked\n")) << said;
  EXPECT_TRUE(contains(said, "gamma: a library without its source")) << said;
  EXPECT_TRUE(contains(said, "zeta: no accepted entry")) << said;
  EXPECT_FALSE(fs::exists(to + "/submissions/gamma"));
  EXPECT_TRUE(contains(read_file(to + "/base/readme/mine.cpp"), "MIROCUP_EXPORT_TEAM(Mine"));
  for (const char* start : {"/base/c++/team.cpp", "/base/c/team.c", "/base/python/team.py"})
    EXPECT_TRUE(fs::exists(to + start)) << start;
  ask("export", {"--sources", "-o", to}, 2);
}

// Catches the name of a team's files where people look for their own name, a page that keeps the
// name of before, and a name that becomes markup or ends the data of a page.
TEST_F(Term, PeopleSeeDisplayNames) {
  go_to_day(0);
  init();
  ask("submit", {"alpha", house("navigator")});
  ask("team", {"alpha", "--display", "Zoë \"<&, Co"});
  ask("nightly");
  std::string replay;
  for (const auto& line : journal_of(folder_)) {
    if (line["kind"] == "leg" && (line["home"] == "alpha" || line["away"] == "alpha"))
      replay = "replays/" + fs::path(line["record"].get<std::string>()).stem().string() + ".html";
  }
  const std::string first = page(replay);
  EXPECT_TRUE(contains(first, "<span class=\"name\">Zoë &quot;&lt;&amp;, Co</span>")) << replay;
  EXPECT_TRUE(contains(first, R"("name":"Zoë \"\u003c&, Co","kind":)")) << replay;
  EXPECT_FALSE(contains(first, "\"name\":\"alpha\"") || contains(first, ">alpha<"));
  for (const char* name : {"index.html", "teams/alpha.html", "night.html"}) {
    EXPECT_TRUE(contains(page(name), "Zoë &quot;&lt;&amp;, Co")) << name;
    EXPECT_FALSE(contains(page(name), ">alpha<") || contains(page(name), "  alpha  ")) << name;
  }
  ask("team", {"alpha", "--display", "Löwen"});
  ask("publish");
  EXPECT_TRUE(contains(page(replay), "\"name\":\"Löwen\",\"kind\":"));
  EXPECT_FALSE(contains(page(replay), "Zoë"));
}

TEST_F(Term, OfThreeWeeks) {
  // Day 0: hand-ins. One of them copied, one is broken, one is not there.
  go_to_day(0);
  init();
  write_file(temporary_ / "class.csv",
             "team,display,members\nalpha,Zoë & Co,Zoë; Max\nbeta,Löwen,Ada\n");
  ask("team", {"--csv", temporary_ / "class.csv"});
  ask("submit", {"alpha", house("chaser")});
  ask("submit", {"beta", house("keeper")});
  ask("submit", {"gamma", house("navigator")});
  ask("submit", {"delta", "house:idle"});
  ask("submit", {"epsilon", house("chaser")});
  const std::string bad = temporary_ / "bad.so";
  write_file(bad, read_file(house("chaser")).substr(0, 3000));
  ask("submit", {"gamma", bad}, 1);
  const std::string entries = ask("status", {"--entries"}).out;
  EXPECT_TRUE(contains(entries, "zeta: nothing handed in")) << entries;
  EXPECT_TRUE(contains(entries, "gamma: refused")) << entries;
  EXPECT_TRUE(contains(entries, "the same file as epsilon")) << entries;
  EXPECT_TRUE(contains(entries, "alpha \"Zoë & Co\": accepted")) << entries;

  const std::string first = ask("nightly").out;
  EXPECT_TRUE(contains(first, "zeta: nothing was handed in")) << first;
  EXPECT_TRUE(contains(first, "alpha and epsilon handed in the same file")) << first;
  EXPECT_TRUE(contains(first, "gamma: entry 2 was not accepted")) << first;
  EXPECT_TRUE(contains(page("index.html"), "Zoë &amp; Co"));
  expect_digests(folder_);
  const int legs = count_kind(folder_, "leg");
  EXPECT_TRUE(contains(ask("nightly").err, "night 1 continues"));
  EXPECT_EQ(count_kind(folder_, "leg"), legs) << "the same night again plays nothing";

  // Day 7: zeta hands in for the first time, alpha has a new entry, and a student who has come to
  // the course is a team of its own.
  go_to_day(7);
  ask("submit", {"eta", house("keeper")});
  ask("team", {"eta", "--display", "Étoile"});
  EXPECT_TRUE(contains(ask("status", {"--entries"}).out, "eta \"Étoile\": accepted"));
  const Outcome twin = ask("submit", {"ETA", house("keeper")}, 1);
  EXPECT_TRUE(contains(twin.out, "the league has a team eta")) << twin.out;
  ask("submit", {"zeta", house("tactician")});
  ask("submit", {"alpha", house("navigator")});
  EXPECT_EQ(count_kind(folder_, "night"), 1) << "an entry plays from the next night on";
  EXPECT_FALSE(contains(read_file(folder_ + "/nights/1/beta.txt"), "replays/"))
      << "a link in a mail is whole, or there is none";
  EXPECT_FALSE(contains(ask("nightly").err, "the clock of this computer"));
  expect_digests(folder_);
  EXPECT_EQ(read_json(folder_ + "/nights/2/alpha.json")["new_entry"], true);
  EXPECT_EQ(count_kind(folder_, "join"), 1);
  const Json of_eta = read_json(folder_ + "/nights/2/eta.json");
  EXPECT_EQ(of_eta["new_entry"], true);
  EXPECT_TRUE(of_eta["strength_before"].is_null());
  EXPECT_TRUE(contains(page("index.html"), "Étoile"));

  // An appeal, decided wrongly, taken back, and decided again.
  std::string fixture;
  for (const auto& line : journal_of(folder_)) {
    if (line["kind"] == "leg") fixture = line["fixture"].get<std::string>();
  }
  const std::vector<std::string> rule{fixture, "--score", "2:1", "--reason", "the goal was valid"};
  ask("rule", rule, 2);
  auto of_leg = rule;
  of_leg.insert(of_leg.end(), {"--leg", "1"});
  auto dry = of_leg;
  dry.emplace_back("--dry-run");
  EXPECT_TRUE(contains(ask("rule", dry).out, "(was "));
  EXPECT_EQ(count_kind(folder_, "ruling"), 0) << "a dry run writes nothing";
  ask("rule", of_leg);
  ask("undo", {"1", "--reason", "the wrong leg", "--by", "A. Host"});
  of_leg.back() = "2";
  ask("rule", of_leg);
  ask("rule", {fixture, "--leg", "1", "--score", "101:0", "--reason", "x"}, 2);
  ask("rule", {fixture, "--leg", "1", "--score", "1:0", "--reason", " - "}, 2);
  const Json decisions = Json::parse(ask("decisions", {"--json"}).out)["decisions"];
  ASSERT_EQ(decisions.size(), 3u);
  EXPECT_EQ(decisions[0]["undone_by"], 2);
  EXPECT_TRUE(decisions[2]["undone_by"].is_null());

  // Day 14: a night that the class may not see yet.
  go_to_day(14);
  ask("release",
      {"--level", "teams", "--through", "r2", "--reason", "the final is shown on Friday"});
  ask("nightly");
  expect_digests(folder_);
  EXPECT_FALSE(fs::exists(folder_ + "/site/rounds/r3.html")) << "night 3 is not released";
  EXPECT_TRUE(contains(page("night.html"), "Night 2"));
  EXPECT_TRUE(fs::exists(folder_ + "/nights/3/alpha.txt")) << "the teams' digests are there";
  ask("verify");

  // Day 21: everything is shown, and the league ends.
  go_to_day(21);
  ask("release", {"--level", "all", "--reason", "it is Friday"});
  ask("close", {"--reason", "the term is over"});
  ask("nightly", {}, 2);
  ask("publish");
  EXPECT_TRUE(fs::exists(folder_ + "/site/rounds/r3.html"));
  EXPECT_TRUE(contains(page("index.html"), "Champion"));
  EXPECT_TRUE(contains(ask("submit", {"beta", house("striker")}, 1).out, "the league is closed"));
  const std::string grades = ask("grades").out;
  EXPECT_EQ(std::count(grades.begin(), grades.end(), '\n'), 10) << grades;

  for (const auto& line : journal_of(folder_)) EXPECT_TRUE(line.contains("at")) << line;
}

// Catches a program of the host that hears of a night twice, of one that is hidden, or not at all
// after it has failed; one that never ends, and with it the night (postfix's sendmail waits so for
// rights that a unit does not get); and digests for mails whose links lead nowhere.
TEST_F(Term, AProgramOfTheHostHearsOfEachNightOnce) {
  go_to_day(0);
  init();
  ask("submit", {"alpha", house("striker")});
  const std::string heard = temporary_ / "heard";
  const auto hears = [&](const std::string& last) {
    const std::string path = temporary_ / "hears";
    write_file(path, "#!/bin/sh\nls \"$1\" | grep alpha.txt && echo \"$1\" >>" + heard + "\n" +
                         last + "\n");
    fs::permissions(path, fs::perms::owner_all);
    return std::vector<std::string>{"--on-night", path, "--address", "https://league.example/"};
  };
  const Outcome failed = ask("nightly", hears("exit 7"), 3);
  EXPECT_TRUE(contains(failed.err, "exit code 7")) << failed.err;
  EXPECT_EQ(count_kind(folder_, "night"), 1);
  std::vector<std::string> never = hears("sleep 1000");
  never.insert(never.end(), {"--on-night-within", "1"});
  const Outcome stopped = ask("nightly", never, 3);
  EXPECT_TRUE(contains(stopped.err, "has not ended after 1 s")) << stopped.err;
  ask("nightly", hears("exit 0"));
  ask("nightly", hears("exit 0"));
  const std::string night = fs::absolute(folder_).string() + "/nights/1";
  const std::string thrice = night + "\n" + night + "\n" + night + "\n";
  EXPECT_EQ(read_file(heard), thrice) << "again after it failed, then no more";
  const std::string digest = read_file(folder_ + "/nights/1/idle.txt");
  EXPECT_TRUE(contains(digest, "  https://league.example/replays/")) << digest;

  go_to_day(1);
  ask("release", {"--level", "hidden", "--reason", "it is a surprise"});
  EXPECT_TRUE(contains(ask("nightly", hears("exit 0")).err, "this night is hidden"));
  const auto readers = [&](const std::string& path) {
    return fs::status(folder_ + path).permissions() &
           (fs::perms::group_all | fs::perms::others_all);
  };
  for (const std::string path : {"/journal.jsonl", "/records"})
    EXPECT_EQ(readers(path), fs::perms::none) << "another user of the host reads the results";
  EXPECT_EQ(read_file(heard), thrice);
  ask("nightly", {"--on-night", temporary_ / "nobody"});
  ask("release", {"--level", "teams", "--reason", "it is told"});
  const Outcome missing = ask("nightly", {"--on-night", temporary_ / "nobody"}, 3);
  EXPECT_TRUE(contains(missing.err, "cannot be started")) << missing.err;
  ask("release", {"--level", "all", "--reason", "it is Friday"});
  EXPECT_EQ(readers("/journal.jsonl"), readers("/league.json"));
}

// Catches a day without a night, because one leg of the night before was to be played again.
TEST_F(Term, AVoidLegIsPlayedInTheNextNight) {
  go_to_day(0);
  init();
  ask("submit", {"alpha", house("chaser")});
  ask("nightly");
  go_to_day(1);
  const std::string fixture = journal_of(folder_).back()["fixture"].get<std::string>();
  ask("void", {fixture, "--leg", "1", "--reason", "a cable was loose"});
  ask("nightly");
  EXPECT_EQ(count_kind(folder_, "night"), 2);
  expect_digests(folder_);
  EXPECT_EQ(ask("status").exit_code, 0) << "no leg is left";
}

}  // namespace
}  // namespace mirocup
