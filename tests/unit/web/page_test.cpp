// SPDX-License-Identifier: MIT
//
// Catches a page in which a name becomes markup, one that loads anything from elsewhere, one of a
// leg that was not played, and one that has grown too big.
#include "web/page.hpp"

#include "tests/support/controllers.hpp"
#include "web/page_parts.hpp"

#include <gtest/gtest.h>

namespace mirocup::web {
namespace {

record::MatchRecord played(double half_s, RobotLeague league = RobotLeague::small) {
  match::Leg match(test_support::short_setup(3, half_s, league));
  auto blue = test_support::ball_hunter();
  auto yellow = test_support::random_team(3);
  test_support::play(match, blue, yellow);
  record::MatchRecord record;
  record.software = record::this_software();
  record.teams[0].name = "</script><img src=x onerror=alert(1)>";
  record.teams[1].name = "\"{{script}}\" & 'co'";
  record.recording = replay::record(match);
  return record;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(ReplayPage, EscapesNamesOfTeams) {
  const auto page = replay_page(played(4.0));
  ASSERT_TRUE(page);
  EXPECT_EQ(page->html.find("<img"), std::string::npos);
  EXPECT_EQ(count(page->html, "</script>"), 2u) << "the leg's data and the page's script";
  EXPECT_NE(page->html.find("&quot;{{script}}&quot; &amp; &#39;co&#39;"), std::string::npos)
      << "a name that looks like a part of the template stays text";
}

TEST(ReplayPage, LoadsNothingFromElsewhere) {
  record::MatchRecord record = played(4.0);
  record.teams[0].name = "hunters";
  const auto page = replay_page(record);
  ASSERT_TRUE(page);
  for (const char* elsewhere : {"src=", "href=", "@import", "url(", "\nimport "}) {
    EXPECT_EQ(page->html.find(elsewhere), std::string::npos) << elsewhere;
  }
}

TEST(ReplayPage, RefusesARecordThatIsNotReproduced) {
  record::MatchRecord record = played(4.0);
  record.recording.ticks[50].commands[1].wheels[0][0] ^= 64;
  const auto page = replay_page(record);
  ASSERT_FALSE(page);
  EXPECT_EQ(page.error().tick, 51u);
}
TEST(ReplayPage, GivesItsDataBack) {
  const record::MatchRecord record = played(20.0, RobotLeague::large);
  const auto page = replay_page(record);
  ASSERT_TRUE(page);
  EXPECT_EQ(data_of_page(page->html), *replay_data(record));
  EXPECT_FALSE(data_of_page(page->html.substr(0, page->html.find("\"teams\"")))) << "cut off";
  EXPECT_FALSE(data_of_page("<html></html>"));
  EXPECT_FALSE(data_of_page("<script type=\"application/json\" id=\"leg\">[]</script>"));
}

TEST(ReplayPage, IsTheSameOnEveryMachineWithoutTimes) {
  record::MatchRecord record = played(4.0);
  const auto with = replay_page(record);
  const auto without = replay_page(record, Times::left_out);
  record.budget[0].cpu_seconds = 1.5;
  record.budget[1].slowest_tick_ms = 7.0;
  EXPECT_NE(replay_page(record)->html, with->html);
  EXPECT_EQ(replay_page(record, Times::left_out)->html, without->html);
}

// Forty seconds of the largest league, with random commands: a fifteenth of the 3 MB that the page
// of ten minutes may have, and 80 kB for the script and the style.
TEST(ReplayPage, StaysSmall) {
  const auto page = replay_page(played(20.0, RobotLeague::large));
  ASSERT_TRUE(page);
  EXPECT_LT(page->html.size(), 280'000u);
}

TEST(Assets, AreAllThere) {
  for (const char* name : {"page.html", "page.css", "picture.css", "main.js", "track.js"}) {
    EXPECT_FALSE(asset(name).empty()) << name;
  }
  EXPECT_TRUE(asset("nothing").empty());
}

}  // namespace
}  // namespace mirocup::web
