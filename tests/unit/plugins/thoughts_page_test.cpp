// SPDX-License-Identifier: MIT
#include "plugins/host/team_host.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace mirocup::plugins {
namespace {

using match::ThoughtKind;

struct DrawingHost {
  std::unique_ptr<ThoughtsPage> page = std::make_unique<ThoughtsPage>();
  TeamHost host{nullptr, nullptr, page.get()};
  mirocup_setup setup{};
  DrawingHost() { give_host(setup, host); }
};

TEST(ThoughtsPage, HoldsWhatIsDrawn) {
  DrawingHost d;
  d.setup.draw_line(&d.host, "a layer whose name is longer than 31 bytes", 0x01020304, 1, 2, 3, 4);
  d.setup.draw_text(&d.host, nullptr, 5, 6, 7, "words");
  const double corners[] = {0, 0, 1, 0, 1, 1};
  d.setup.draw_polygon(&d.host, "p", 8, corners, 3);
  ThoughtReader reader(*d.page);
  const auto line = reader.next(), text = reader.next(), polygon = reader.next();
  ASSERT_TRUE(line && text && polygon);
  EXPECT_FALSE(reader.next());
  EXPECT_EQ(line->layer, "a layer whose name is longer th");
  EXPECT_EQ(line->colour, 0x01020304u);
  EXPECT_EQ(line->numbers[3], 4.0);
  EXPECT_EQ(text->kind, ThoughtKind::text);
  EXPECT_EQ(text->text, "words");
  EXPECT_EQ(text->layer, "");
  EXPECT_EQ(polygon->numbers.size(), 6u);
  EXPECT_EQ(polygon->numbers[2], 1.0);
  EXPECT_EQ(d.page->left_out, 0u);
}

TEST(ThoughtsPage, CountsWhatItDoesNotTake) {
  DrawingHost d;
  d.setup.draw_circle(&d.host, "c", 0, NAN, 0, 1);
  d.setup.draw_polygon(&d.host, "p", 0, nullptr, 3);
  const double corners[6] = {};
  d.setup.draw_polygon(&d.host, "p", 0, corners, 2);
  d.setup.draw_polygon(&d.host, "p", 0, corners, -1);
  d.setup.draw_text(&d.host, "t", 0, 0, 0, std::string(match::max_thought_text + 1, 'x').c_str());
  EXPECT_EQ(d.page->shapes, 0u);
  EXPECT_EQ(d.page->left_out, 5u);
  d.setup.draw_line(nullptr, "l", 0, 0, 0, 1, 1);
  TeamHost silent;
  d.setup.draw_line(&silent, "l", 0, 0, 0, 1, 1);  // nothing is kept, and nothing happens
}

// Catches a note that comes in each tick, and one about what is meant: a heading of -pi, no wheels.
TEST(TeamHost, TellsOnceOfWhatIsHardlyMeant) {
  const auto told_of = [](const mirocup_placement& placement, const mirocup_command& command,
                          std::uint32_t colour, double x) {
    TeamHost host;
    mirocup_setup setup{};
    give_host(setup, host);
    testing::internal::CaptureStderr();
    for (int i = 0; i < 2; ++i) {
      note_units(host, placement, 3);
      note_command(host, command, 3);
      setup.draw_line(&host, "l", colour, x, 0, 1, 1);
    }
    return testing::internal::GetCapturedStderr();
  };
  mirocup_placement placement{};
  placement.robots[1] = {-0.7, 0.2, -6.2831};
  placement.robots[4].heading = 90.0;  // of a robot that is not there
  mirocup_command command{};
  command.wheels[2].left = 3.0;
  EXPECT_EQ(told_of(placement, command, 0, 0.0), "");
  placement.robots[1] = {-40.0, 10.0, -45.0};
  command.wheels[3].right = 3.0;
  const std::string told = told_of(placement, command, 0xff0000, NAN);
  EXPECT_EQ(std::count(told.begin(), told.end(), '\n'), 5) << told;
  for (const char* part :
       {"robot 1 the heading -45", "(-40, 10)", "robots are 0 to 2", "0x00ff0000", "not finite"})
    EXPECT_NE(told.find(part), std::string::npos) << part << told;
  TeamHost host;
  testing::internal::CaptureStderr();
  note_own_name(host, "St\xc3\xbcrmer");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  testing::internal::CaptureStderr();
  note_own_name(host, std::string(41, 'x'));
  EXPECT_NE(testing::internal::GetCapturedStderr().find("is not shown"), std::string::npos);
}

// Catches a server that believes a page that the team's process wrote itself.
TEST(ThoughtsPage, IsNotTrusted) {
  DrawingHost d;
  d.setup.draw_line(&d.host, "l", 0, 0, 0, 1, 1);
  ThoughtsPage& page = *d.page;
  const auto copy = std::make_unique<ThoughtsPage>();
  page.shapes = page.numbers = page.text = 4'000'000'000u;
  copy_thoughts(page, *copy);
  EXPECT_EQ(copy->shapes, match::max_thoughts);
  ThoughtReader all(*copy);
  EXPECT_TRUE(all.next());
  EXPECT_FALSE(all.next());  // the next shape has no numbers, so it is no line

  page.shapes = 1;
  page.numbers = 3;
  copy_thoughts(page, *copy);
  EXPECT_FALSE(ThoughtReader(*copy).next());
  page.numbers = 4;
  page.shape[0].kind = static_cast<ThoughtKind>(77);
  copy_thoughts(page, *copy);
  EXPECT_FALSE(ThoughtReader(*copy).next());
  page.shape[0].kind = ThoughtKind::line;
  page.number[2] = INFINITY;
  copy_thoughts(page, *copy);
  EXPECT_FALSE(ThoughtReader(*copy).next());
}

}  // namespace
}  // namespace mirocup::plugins
