// SPDX-License-Identifier: MIT
#include "labs/pitch/camera_log.hpp"
#include "tests/support/is_ok.hpp"

#include <gtest/gtest.h>

namespace mirocup::pitch {
namespace {

constexpr const char* good_recording =
    "{\"schema\": \"mirocup/recording/1\", \"period\": 0.02, \"robots\": 2, \"pitch\": null}\n"
    "{\"t\": 0.0, \"ball\": [0.1, -0.2], \"blue\": [[0.3, 0.1, 1.5], null], \"yellow\": [],"
    " \"commands\": {\"blue\": [[1, 2], [3, 4]]}}\n"
    "\n"
    "{\"t\": 0.02, \"ball\": null, \"blue\": [null, [0, 0, 0]]}\n";

// Catches a reader that mixes up bodies, loses commands, or takes what was not seen for the origin.
TEST(PitchRecording, ReadsWhatItWrites) {
  const auto recording = parse_recording(good_recording, "r.jsonl");
  ASSERT_TRUE(test_support::is_ok(recording));
  ASSERT_EQ(recording->frames.size(), 2u);
  const Frame& first = recording->frames[0];
  EXPECT_EQ(*first.ball, Vec2(0.1, -0.2));
  EXPECT_EQ(first.robots[0][0]->heading, 1.5);
  EXPECT_FALSE(first.robots[0][1]);
  EXPECT_FALSE(first.robots[1][0]);
  EXPECT_EQ(first.commands[0][1].right, 4.0);
  EXPECT_TRUE(first.commands[1].empty());
  EXPECT_FALSE(recording->frames[1].ball);
  EXPECT_TRUE(recording->frames[1].robots[0][1]);
  EXPECT_EQ(recording->league, RobotLeague::small);
  const auto again = parse_recording(print_recording(*recording), "again");
  ASSERT_TRUE(test_support::is_ok(again));
  EXPECT_EQ(print_recording(*again), print_recording(*recording));
}

// Catches a table whose columns are taken by their order instead of their names.
TEST(PitchRecording, ReadsATable) {
  const auto recording = parse_csv(
      "ball_y,t,ball_x,blue0_x,blue0_y,blue0_heading,blue0_right,blue0_left\n"
      "0.2,0.0,0.1,1,2,3,5,4\n"
      ",0.1,,1,2,3,,\n",
      "r.csv");
  ASSERT_TRUE(test_support::is_ok(recording));
  EXPECT_EQ(*recording->frames[0].ball, Vec2(0.1, 0.2));
  EXPECT_EQ(recording->frames[0].robots[0][0]->position, Vec2(1.0, 2.0));
  EXPECT_EQ(recording->frames[0].commands[0][0].left, 4.0);
  EXPECT_FALSE(recording->frames[1].ball);
  EXPECT_TRUE(recording->frames[1].commands[0].empty());
}

// Catches bounds for a line where there is none for the file: a short line becomes a picture of 22
// robots, and 256 MB of them took 100 GB.
TEST(PitchRecording, HasABoundOfPicturesAndColumns) {
  const std::string table = "t\n1\n2\n3\n";
  EXPECT_TRUE(parse_csv(table, "r.csv", 3));
  const auto too_long = parse_csv(table, "r.csv", 2);
  ASSERT_FALSE(too_long);
  EXPECT_EQ(too_long.error().what.find("r.csv, line 4: a recording has at most 2 pictures"), 0u)
      << too_long.error().what;
  EXPECT_TRUE(parse_recording(good_recording, "r.jsonl", 2));
  const auto lines_too_long = parse_recording(good_recording, "r.jsonl", 1);
  ASSERT_FALSE(lines_too_long);
  EXPECT_NE(lines_too_long.error().what.find("at most 1 pictures"), std::string::npos);
  std::string columns = "t";
  for (int i = 0; i < 200; ++i) columns += ",t";
  const auto too_wide = parse_csv(columns + "\n", "r.csv");
  ASSERT_FALSE(too_wide);
  EXPECT_NE(too_wide.error().what.find("r.csv, line 1: at most 113 columns"), std::string::npos)
      << too_wide.error().what;
}

// Catches a message that does not say where the mistake is, and a mistake that passes.
TEST(PitchRecording, NamesLineKeyAndReason) {
  const auto what = [](const std::string& text) {
    const auto recording = parse_recording(text, "r");
    return recording ? std::string() : recording.error().what;
  };
  const std::string head = "{\"schema\": \"mirocup/recording/1\", \"robots\": 1}\n";
  EXPECT_EQ(what(""), "r: it is empty");
  EXPECT_EQ(what(head), "r: a recording has at least two pictures");
  EXPECT_NE(what(head + "{\"t\": 0, \"bal\": null}\n").find("r, line 2: /bal"), std::string::npos);
  EXPECT_NE(what(head + "{\"t\": 0}\n{\"t\": 1, \"blue\": [[0, 0]]}\n").find("line 3: /blue/0"),
            std::string::npos);
  EXPECT_NE(what(head + "{\"t\": 0, \"blue\": [null, null]}\n").find("line 2: /blue"),
            std::string::npos);
  const auto table = parse_csv("t,green0_x\n0,1\n", "r.csv");
  ASSERT_FALSE(table);
  EXPECT_NE(table.error().what.find("no column \"green0_x\""), std::string::npos);
}

}  // namespace
}  // namespace mirocup::pitch
