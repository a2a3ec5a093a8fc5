// SPDX-License-Identifier: MIT
//
// Holds the opponents of drills to what they decided when the drills were measured.
#include "plugins/host/plugin.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
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

// Draws moments of play that do not follow from each other, so that they do not depend on the
// simulator: often with robots at the ball, with each restart, with a ball that rests.
class Moments {
 public:
  Moments() {
    now_.size = sizeof now_;
    now_.robots = 3;
  }

  const mirocup_observation& next() {
    ++now_.tick;
    now_.state = chance(0.1) ? MIROCUP_READY : MIROCUP_PLAY;
    now_.restart = static_cast<int>(between(0.0, 6.0));
    now_.own_restart = chance(0.5) ? 1 : 0;
    now_.placing = chance(0.1) ? 1 : 0;
    now_.stalemate_s = between(0.0, 1.5);
    const double reach = chance(0.1) ? 0.05 : 1.0;
    now_.ball_x = reach * between(-0.74, 0.74);
    now_.ball_y = reach * between(-0.64, 0.64);
    const double speed = chance(0.3) ? 0.0 : 1.0;
    now_.ball_vx = speed * between(-1.0, 1.0);
    now_.ball_vy = speed * between(-1.0, 1.0);
    for (int i = 0; i < 3; ++i) {
      now_.own[i] = robot(i == 0 ? -0.72 : 2.0);
      now_.opponent[i] = robot(i == 0 ? 0.72 : 2.0);
    }
    return now_;
  }

 private:
  // Exactly specified by the standard, unlike std::uniform_real_distribution.
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(draw_() >> 11) * 0x1.0p-53;
  }
  bool chance(double p) { return between(0.0, 1.0) < p; }

  // On the goal line at `goal_x`, at the ball, or anywhere. A `goal_x` outside the field: no line.
  mirocup_robot robot(double goal_x) {
    mirocup_robot r{.x = between(-0.7, 0.7),
                    .y = between(-0.6, 0.6),
                    .heading = between(-3.14, 3.14),
                    .vx = between(-1.0, 1.0),
                    .vy = between(-1.0, 1.0),
                    .turn = between(-10.0, 10.0)};
    if (std::abs(goal_x) < 1.0 && chance(0.8)) {
      r.x = goal_x + between(-0.03, 0.03);
      r.y = between(-0.25, 0.25);
    } else if (chance(0.5)) {
      r.x = now_.ball_x + between(-0.15, 0.15);
      r.y = now_.ball_y + between(-0.15, 0.15);
    }
    return r;
  }

  std::mt19937_64 draw_{54};
  mirocup_observation now_{};
};

// FNV-1a over numbers that are rounded as the host rounds wheel speeds.
class Hash {
 public:
  void add(double value) {
    auto bits = static_cast<std::uint64_t>(std::llround(256.0 * value));
    for (int i = 0; i < 8; ++i, bits >>= 8) {
      value_ = (value_ ^ (bits & 0xff)) * 0x100000001b3;
    }
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325;
};

std::uint64_t hash_of_commands(const std::string& name) {
  const mirocup_setup setup = facts();
  auto team = Plugin::load(std::string(MIROCUP_DRILL_TEAMS) + "/" + name + ".so", setup);
  if (!team) return 0;
  Moments moments;
  Hash hash;
  for (int tick = 0; tick < 20000; ++tick) {
    const mirocup_observation& now = moments.next();
    if (now.placing != 0) {
      auto placement = team->place(now);
      for (const mirocup_pose& pose : placement->robots) {
        hash.add(pose.x), hash.add(pose.y), hash.add(pose.heading);
      }
    }
    const auto command = team->decide(now);
    for (int i = 0; i < now.robots; ++i) {
      hash.add(command->wheels[i].left), hash.add(command->wheels[i].right);
    }
  }
  return hash.value();
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
