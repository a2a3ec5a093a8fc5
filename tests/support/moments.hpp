// SPDX-License-Identifier: MIT
//
// The decisions of a team in moments that are drawn, as one hash: two teams with one hash decide
// alike. The moments do not follow from each other, so they do not depend on the simulator.
#pragma once

#include "plugins/host/plugin.hpp"

#include <cmath>
#include <cstdint>
#include <random>

namespace mirocup::test_support {

// Often with robots at the ball, with each restart, with a ball that rests. All places are in the
// field of the small league.
class Moments {
 public:
  explicit Moments(int robots) {
    now_.size = sizeof now_;
    now_.robots = robots;
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
    for (int i = 0; i < now_.robots; ++i) {
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
class DecisionHash {
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

// Returns the hash of what a team of so many robots decides in so many moments, and 0 if it
// crashes.
inline std::uint64_t hash_of_decisions(plugins::Plugin& team, int robots, int ticks) {
  Moments moments(robots);
  DecisionHash hash;
  for (int tick = 0; tick < ticks; ++tick) {
    const mirocup_observation& now = moments.next();
    if (now.placing != 0) {
      const auto placement = team.place(now);
      if (!placement) return 0;
      for (const mirocup_pose& pose : placement->robots) {
        hash.add(pose.x), hash.add(pose.y), hash.add(pose.heading);
      }
    }
    const auto command = team.decide(now);
    if (!command) return 0;
    for (int i = 0; i < now.robots; ++i) {
      hash.add(command->wheels[i].left), hash.add(command->wheels[i].right);
    }
  }
  return hash.value();
}

}  // namespace mirocup::test_support
