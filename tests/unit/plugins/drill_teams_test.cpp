// SPDX-License-Identifier: MIT
//
// Holds the opponents of drills to what they decided when the drills were measured.
#include "tests/support/moments.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace mirocup::plugins {
namespace {

// What a team of the small league learns, in numbers of this test's own.
mirocup_setup facts() {
  mirocup_setup setup{};
  setup.size = sizeof setup;
  setup.robots = 3;
  setup.seed = 7;
  setup.control_period = 0.033;
  setup.half_length = 0.75;
  setup.half_width = 0.65;
  setup.goal_half_width = 0.2;
  setup.goal_area_depth = 0.15;
  setup.goal_area_half_width = 0.25;
  setup.robot_side = 0.075;
  setup.wheel_distance = 0.068;
  setup.wheel_radius = 0.023;
  setup.wheel_speed_limit = 80.0;
  setup.motor_time_constant = 0.05;
  setup.grip = 0.6;
  setup.ball_radius = 0.02135;
  setup.log = [](void*, const char* text) { write_line(text); };
  return setup;
}

std::uint64_t hash_of_commands(const std::string& name) {
  const mirocup_setup setup = facts();
  auto team = Plugin::load(std::string(MIROCUP_DRILL_TEAMS) + "/" + name + ".so", setup);
  if (!team) return 0;
  return test_support::hash_of_decisions(*team, setup.robots, 20000);
}

// Catches an opponent that plays otherwise than when the drills were measured. Who means to change
// one raises "version" in each drill in which it plays, and measures the table of docs/drills.md.
TEST(DrillTeams, DecideAsWhenTheDrillsWereMeasured) {
  EXPECT_EQ(hash_of_commands("attacker"), 0xcf05c32c0ea63da9u);
  EXPECT_EQ(hash_of_commands("crowd"), 0x28bcb3441e625501u);
  EXPECT_EQ(hash_of_commands("keeper"), 0xa7b0eb12df023eb5u);
}

}  // namespace
}  // namespace mirocup::plugins
