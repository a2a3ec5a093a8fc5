// SPDX-License-Identifier: MIT
//
// Catches a night that failed, a check that hangs and a team that waits for a decision of which
// nobody is told, and a host who is called for what is in order.
#include "tournaments/league/health.hpp"

#include "system/clock.hpp"
#include "system/file_lock.hpp"
#include "tests/support/is_ok.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/tournaments/small_league.hpp"
#include "tournaments/league/book.hpp"
#include "tournaments/league/gaps.hpp"

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
    const auto found = health(disk_, *store, now);
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
  write(Paused{.team = "a", .why = "asks for a day", .by = "host", .at = utc_text(noon)});
  EXPECT_EQ(problems(noon), "") << "who has paused it knows";
  write(Paused{.team = "b", .why = "three legs lost", .by = "", .is_by_program = true});
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
  write(Ruled{.fixture = "r1-f1", .leg = 1, .score = {}, .why = "w", .by = "h"});
  EXPECT_EQ(found({"r1-f1-1-1"}), std::pair(false, Names{})) << "a ruling decided the leg";
  write(LegVoided{.fixture = "r1-f1", .leg = 1, .cause = VoidCause::ruling, .why = "w", .by = "h"});
  EXPECT_EQ(found({"r1-f1-1-1", "r1-f1-1-2"}), std::pair(false, Names{second}));
  write(Undone{.line = 3, .why = "w", .by = "h"});
  EXPECT_EQ(found({"r1-f1-1-1", "r1-f1-1-2"}), std::pair(false, Names{}));
}

}  // namespace
}  // namespace mirocup::league
