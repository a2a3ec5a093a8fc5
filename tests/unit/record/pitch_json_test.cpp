// SPDX-License-Identifier: MIT
#include "record/pitch_json.hpp"

#include "tests/support/is_ok.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace mirocup::record {
namespace {

std::string pitch_error(const std::string& text) {
  return test_support::why_not(parse_pitch(text, "p.json"));
}

// Catches a number that is written under another key, or lost: then a record could not be verified.
TEST(PitchJson, ReadsBackEveryPreset) {
  for (const auto name : enum_names<match::PitchPreset>) {
    const auto pitch = pitch_of_option(std::string(name));
    ASSERT_TRUE(pitch);
    EXPECT_EQ(match::problem_with(pitch->parameters), "") << name;
    const auto json = to_json(*pitch);
    const auto again = parse_pitch(json.dump(), "p.json");
    ASSERT_TRUE(test_support::is_ok(again));
    EXPECT_EQ(to_json(*again), json) << name;
    EXPECT_EQ(again->parameters.turn_time_constant, pitch->parameters.turn_time_constant);
    EXPECT_EQ(again->parameters.grip, pitch->parameters.grip);
  }
}

TEST(PitchJson, ReadsIdentifiedNumbersMotorsAndOutlines) {
  const auto pitch = parse_pitch(R"({"preset": "vsss", "name": "ours",
      "parameters": {"wheel_radius": {"value": 0.021, "low": 0.02, "high": 0.022},
                     "restitution": {"ball_wall": {"value": 0.5, "low": 0.4, "high": 0.6}}},
      "motor": {"kind": "two_lags", "turn_time_constant": 0.03},
      "outline": [[0.03, -0.03], [0.03, 0.03], [-0.03, 0.0]]})",
                                 "p.json");
  ASSERT_TRUE(test_support::is_ok(pitch));
  EXPECT_EQ(pitch->parameters.wheel_radius, 0.021);
  EXPECT_EQ(pitch->parameters.wheel_distance, 0.08);
  EXPECT_EQ(pitch->parameters.restitution.ball_wall, 0.5);
  EXPECT_EQ(pitch->parameters.turn_time_constant, 0.03);
  EXPECT_EQ(pitch->parameters.robot_corners.corners, 3);
}

// Catches numbers that make no robot and yet begin a leg, and a message without the reason.
TEST(PitchJson, RefusesWhatMakesNoRobot) {
  EXPECT_EQ(
      pitch_error(R"({"parameters": {"robot_side": 0.5}})"),
      "p.json: /parameters: robot_side is 0.5, not within 0.02 to 0.1: the places at restarts "
      "are for robots of that size");
  EXPECT_NE(pitch_error(R"({"parameters": {"wheel_distance": 0.3}})").find("wheels would stand"),
            std::string::npos);
  EXPECT_NE(pitch_error(R"({"parameters": {"wheel_radus": 0.3}})").find("/parameters/wheel_radus"),
            std::string::npos);
  EXPECT_NE(pitch_error(R"({"motor": {"kind": "one_lag", "turn_time_constant": 0.1}})")
                .find("a motor with one lag"),
            std::string::npos);
  EXPECT_NE(pitch_error(R"({"outline": [[0.1, -0.03], [0.03, 0.03], [-0.03, 0.0]]})")
                .find("outside the square"),
            std::string::npos);
}

}  // namespace
}  // namespace mirocup::record
