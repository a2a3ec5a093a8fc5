// SPDX-License-Identifier: MIT
//
// Catches a night that failed, a check that hangs and a team that waits for a decision of which
// nobody is told, and a host who is called for what is in order.
#include "tournaments/league/health.hpp"

#include "system/clock.hpp"
#include "system/file_lock.hpp"
#include "system/locations.hpp"
#include "system/text.hpp"
#include "tests/support/is_ok.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/tournaments/kept_entry.hpp"
#include "tests/unit/tournaments/small_league.hpp"
#include "tournaments/league/book.hpp"
#include "tournaments/league/gaps.hpp"
#include "tournaments/league/roster.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace mirocup::league {
namespace {

constexpr std::int64_t noon = 1'796'040'000;  // 2026-11-30T12:00:00Z
constexpr std::int64_t hour = 3600;

class LeagueHealth : public testing::Test {
 protected:
  LeagueHealth() {
    EXPECT_TRUE(init_folder(
        disk_, folder_, league_file_of({"a", "b"}, {.kind = FormatKind::nightly}, "submitted")));
    write(start_of(disk_, folder_));
  }

  void write(const Event& event) {
    auto store = LeagueStore::open(disk_, folder_);
    EXPECT_TRUE(test_support::is_ok(store) && test_support::is_ok(store->write(event)));
  }

  void play_night(int number, std::int64_t at) {
    write(NightBegan{.number = number, .entries = {}, .at = utc_text(at)});
    const std::string home = folder_.nights() + "/" + std::to_string(number);
    EXPECT_TRUE(disk_.make_folder(home) && disk_.write(home + "/report.txt", "told\n"));
  }

  // The sentences for the host, in one text.
  std::string problems(std::int64_t now) {
    const auto store = LeagueStore::open(disk_, folder_);
    const auto book = Book::open(disk_, folder_);
    const auto found = health(disk_, *store, book->hand_ins(), now);
    EXPECT_TRUE(test_support::is_ok(found));
    std::string text;
    for (const std::string& problem : found->problems) text += problem + "\n";
    return text;
  }

  test_support::TemporaryFolder temporary_;
  system::Disk disk_;
  Folder folder_{temporary_ / "l"};
};

TEST_F(LeagueHealth, OfNights) {
  EXPECT_EQ(problems(noon + 90 * 24 * hour), "") << "no night is expected before the first";
  play_night(1, noon);
  EXPECT_EQ(problems(noon + 30 * hour), "");
  EXPECT_NE(problems(noon + 40 * hour).find("no night has begun since night 1"), std::string::npos);
  play_night(2, noon + 7 * 24 * hour);
  EXPECT_EQ(problems(noon + 14 * 24 * hour), "") << "a night each week";
  ASSERT_TRUE(disk_.remove(folder_.nights() + "/2/report.txt"));
  const std::string broken = problems(noon + 7 * 24 * hour + 60);
  EXPECT_NE(broken.find("night 2 did not come to its end"), std::string::npos) << broken;
  const auto plays = system::FileLock::try_acquire(folder_.running());
  ASSERT_TRUE(plays && *plays);
  EXPECT_EQ(problems(noon + 30 * 24 * hour), "") << "it is being played";
}

TEST_F(LeagueHealth, OfTeamsThatArePaused) {
  write(Paused{.team = "a", .signature = {"asks for a day", "host", utc_text(noon)}});
  EXPECT_EQ(problems(noon), "") << "who has paused it knows";
  write(Paused{.team = "b", .signature = {"three legs lost", ""}, .is_by_program = true});
  const std::string text = problems(noon);
  EXPECT_NE(text.find("b is paused: three legs lost"), std::string::npos) << text;
  EXPECT_EQ(text.find("a is paused"), std::string::npos) << text;
}

TEST_F(LeagueHealth, OfChecksThatHang) {
  auto book = Book::open(disk_, folder_, nullptr);
  ASSERT_TRUE(test_support::is_ok(book));
  const auto hand_in = [&](std::int64_t at) {
    return book->take({.team = "a", .file = "a.so", .at = at, .is_network = true},
                      [](const std::string&) { return Result<void>(); });
  };
  const auto first = hand_in(noon);
  ASSERT_TRUE(test_support::is_ok(first));
  EXPECT_EQ(problems(noon + 60), "");
  const std::string late = problems(noon + 20 * 60);
  EXPECT_NE(late.find("hand-ins wait for their checks (1), the oldest for 20 min"),
            std::string::npos)
      << late;
  ASSERT_TRUE(book->write(Answered{.team = "a", .entry = *first}));
  EXPECT_EQ(problems(noon + 20 * 60), "");
}

// Catches a record that a decision explains and that is taken for a lost line, and a lost line that
// is taken for a leg that waits to be entered.
TEST_F(LeagueHealth, OfRecordsWithoutALine) {
  std::filesystem::remove_all(folder_.path);
  ASSERT_TRUE(init_folder(disk_, folder_, league_file_of({"a", "b"})));
  const auto found = [this](const std::vector<std::string>& records) {
    for (const std::string& record : records)
      EXPECT_TRUE(disk_.write(folder_.path + "/records/" + record + ".json", "{}"));
    const auto store = LeagueStore::open(disk_, folder_);
    auto gaps = league::gaps(disk_, *store, false);
    EXPECT_TRUE(test_support::is_ok(gaps));
    for (const std::string& record : records)
      EXPECT_TRUE(disk_.remove(folder_.path + "/records/" + record + ".json"));
    return std::pair(!gaps->lost.empty(), gaps->not_booked);
  };
  using Names = std::vector<std::string>;
  const std::string first = "records/r1-f1-1-1.json";
  const std::string second = "records/r1-f1-1-2.json";
  EXPECT_EQ(found({"r1-f1-1-1"}), std::pair(true, Names{first})) << "it has not started";
  write(start_of(disk_, folder_));
  EXPECT_EQ(found({"r1-f1-1-1"}), std::pair(false, Names{first}));
  EXPECT_EQ(found({"r1-f1-1-2"}), std::pair(true, Names{second})) << "no line made it void";
  for (const char* strange :
       {"r1-f1-1-0", "r1-f1-9-1", "r1-f1-1-1x", "-1-1-", "-", "", ".r1-f1-1-2"})
    EXPECT_EQ(found({strange}), std::pair(false, Names{})) << strange;
  // It may have come before a result was taken back that had made its fixture.
  EXPECT_EQ(found({"r9-f1-1-1"}), std::pair(false, Names{"records/r9-f1-1-1.json"}));
  write(Ruled{.fixture = "r1-f1", .leg = 1, .score = {}, .signature = {"w", "h"}});
  EXPECT_EQ(found({"r1-f1-1-1"}), std::pair(false, Names{})) << "a ruling decided the leg";
  write(
      LegVoided{.fixture = "r1-f1", .leg = 1, .cause = VoidCause::ruling, .signature = {"w", "h"}});
  EXPECT_EQ(found({"r1-f1-1-1", "r1-f1-1-2"}), std::pair(false, Names{second}));
  write(Undone{.line = 3, .signature = {"w", "h"}});
  EXPECT_EQ(found({"r1-f1-1-1", "r1-f1-1-2"}), std::pair(false, Names{}));
}

// Catches a team of which nobody is told that it fell to the last place, forfeits, or hands in what
// it was given, and one that is told so without a reason.
TEST(Roster, SaysWhoNeedsHelp) {
  const test_support::TemporaryFolder temporary;
  system::Disk disk;
  const Folder folder{temporary / "l"};
  LeagueFile file;
  file.format.kind = FormatKind::nightly;
  for (const std::string name : {"a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k"})
    file.teams.push_back({.name = name, .source = std::string(TeamConfig::submitted)});
  ASSERT_TRUE(init_folder(disk, folder, file));
  std::vector<EntryBooked> entries;
  for (const TeamConfig& team : file.teams) {
    keep_entry(disk, folder, team.name,
               team.name < "h" ? "library of " + team.name : "of a friend");
    entries.push_back({.team = team.name, .entry = 1, .sha256 = "s"});
  }
  const auto given = disk.read_named(system::team_kit().templates + "/c++/team.cpp", 1 << 20);
  ASSERT_TRUE(given);
  for (const std::string team : {"d", "h", "i"})
    ASSERT_TRUE(
        disk.write(folder.source(team, 1), system::replaced(*given, "@NAME@", "of " + team)));
  auto store = LeagueStore::open(disk, folder);
  const std::string config = disk.read_named(folder.config(), 1 << 20).value();
  ASSERT_TRUE(store->write(Started{.config_sha256 = system::sha256(config), .version = "0.1.0"}));
  // The team that is named first wins, but `last` loses.
  const auto play_night = [&](int number, const std::string& last) {
    ASSERT_TRUE(store->write(NightBegan{.number = number, .entries = entries}));
    for (std::size_t i = 0; i < store->state().fixtures.size(); ++i) {
      const Fixture f = store->state().fixtures[i].fixture;
      if (f.round != number) continue;
      const std::string home = store->state().name(f.home), away = store->state().name(f.away);
      const bool home_wins = home != last && (away == last || home < away);
      const std::string& loser = home_wins ? away : home;
      LegPlayed leg{.fixture = f.id(), .home = home, .away = away, .blue = home};
      leg.score = {home_wins ? 2 : 0, home_wins ? 0 : 2};
      leg.winner = home_wins ? home : away;
      leg.record = "records/" + f.id() + ".json";
      if (loser == "f") leg.fault = {.team = loser, .code = "crash", .text = "signal 11"};
      ASSERT_TRUE(test_support::is_ok(store->write(leg)));
    }
  };
  play_night(1, "k");
  entries = {{.team = "a", .entry = 2, .sha256 = "s"}};
  play_night(2, "a");
  const auto rows = roster(disk, *store, Book::open(disk, folder)->hand_ins());
  ASSERT_TRUE(test_support::is_ok(rows));
  using Notes = std::vector<std::string>;
  EXPECT_EQ((*rows)[0].notes, (Notes{"it has lost all 10 legs",
                                     "it has fallen by 10 ranks since the last night began"}));
  EXPECT_EQ((*rows)[3].notes, Notes{"it is the team that mirocup new writes, unchanged"});
  EXPECT_EQ((*rows)[5].notes,
            Notes{"it has lost 8 of 19 legs by its own faults, the last by crash: signal 11"});
  EXPECT_EQ((*rows)[7].same_as, Notes()) << "both have the file that everybody was given";
  EXPECT_EQ((*rows)[9].same_as, Notes{"k"});
}

}  // namespace
}  // namespace mirocup::league
