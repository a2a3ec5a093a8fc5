// SPDX-License-Identifier: MIT
//
// Catches markings in the wrong place and bodies drawn elsewhere than they are.
#include "web/picture.hpp"

#include "web/markings.hpp"

#include <gtest/gtest.h>

namespace mirocup::web {
namespace {

TEST(SvgPath, IsInMillimetresWithYDownwards) {
  EXPECT_EQ(SvgPath().move_to({0.1, 0.2}).line_to({-0.03217, 0.0}).text(), "M100 -200L-32.2 0");
  EXPECT_EQ(millimetres(-0.00004), "0");
  EXPECT_EQ(millimetres(-0.0001), "-0.1");
}

// The numbers are those of the rules: goal area 0.15 x 0.70 m with an arc over 0.20 m.
TEST(Markings, MatchTheRulesInTheSmallLeague) {
  const Markings marks = markings(field::make_field(RobotLeague::small));
  EXPECT_NE(marks.lines.find("M750 350L600 350L600 -350L750 -350M600 -100A125 125 0 0 0 600 100"),
            std::string::npos)
      << marks.lines;
  EXPECT_NE(marks.lines.find("M-750 -350L-600 -350L-600 350L-750 350M-600 100A125 125 0 0 0 -600 "
                             "-100"),
            std::string::npos)
      << marks.lines;
  EXPECT_NE(marks.lines.find("M0 650L0 -650"), std::string::npos);
  EXPECT_NE(marks.lines.find("A200 200"), std::string::npos) << "centre circle";
  EXPECT_EQ(marks.goals[index_of(End::right)], "M750 200L850 200L850 -200L750 -200Z");
}

TEST(Picture, ShowsEveryBodyWhereItIs) {
  const field::Field field = field::make_field(RobotLeague::middle);
  Moment moment;
  moment.scene.left = Team::yellow;
  moment.scene.ball.position = {0.5, -0.25};
  moment.scene.robots[1][4] = {{-0.1, 0.3}, 1.0, {0.0, 0.0}, 0.0};
  moment.trail = {{0.4, -0.25}, {-0.4, 0.0}};  // it was put elsewhere in between
  const std::string svg = picture(field, simulator::Parameters{}, moment);
  EXPECT_NE(svg.find("class=\"ball\" r=\"21.4\" transform=\"translate(500 250)\""),
            std::string::npos);
  EXPECT_NE(svg.find("class=\"robot yellow\" transform=\"translate(-100 -300)\"><g "
                     "transform=\"rotate(-57)\">"),
            std::string::npos);
  EXPECT_NE(svg.find("class=\"goal left yellow\""), std::string::npos);
  EXPECT_NE(svg.find("d=\"M400 250M-400 0M500 250\""), std::string::npos) << svg;
  EXPECT_NE(svg.find(">4</text>"), std::string::npos);
  EXPECT_EQ(svg.find(">5</text>"), std::string::npos);
}

}  // namespace
}  // namespace mirocup::web
