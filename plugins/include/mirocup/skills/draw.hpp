// SPDX-License-Identifier: MIT
//
// Drawing a team's plans into the replay of `mirocup match --thoughts`. The skills and the house
// teams use the same layers and colours, so that the page shows the plans of all teams alike.
//
//   draw_role     what a robot does, a word beside it        layer "roles"
//   draw_target   where it drives to                         layer "targets"
//   draw_shot     where the ball is met, where it shall go   layer "shots"
//   draw_path     a path through some points                 layer of the caller
//
// These functions have no effect on the leg and return at once if thoughts are off. attack_ball(),
// guard_goal() and hold_goal() draw by themselves; functions for predictions (attack_ball_at(),
// rough_guard()) do not. Frames and units are those of strategy.h.
#pragma once

#include "mirocup/strategy.hpp"

namespace mirocup::strategy {

// Colours, 0xRRGGBBAA, that stand out from the field, the ball and both teams.
inline constexpr std::uint32_t target_colour = 0xffffffd0;
inline constexpr std::uint32_t shot_colour = 0xff8cf0ff;
inline constexpr std::uint32_t path_colour = 0x7df9ffff;

inline void draw_role(const Setup& setup, const Robot& robot, const char* role) {
  draw_text(setup, "roles", target_colour, position(robot) + Point{0.0, 0.055}, role);
}

inline void draw_target(const Setup& setup, const Robot& robot, Point target) {
  draw_line(setup, "targets", target_colour, position(robot), target);
  draw_circle(setup, "targets", target_colour, target, 0.015);
}

// Draws a shot. `meet`: the point where the robot meets the ball. `aim`: the target of the ball.
inline void draw_shot(const Setup& setup, const Robot& robot, Point meet, Point aim) {
  draw_target(setup, robot, meet);
  draw_circle(setup, "shots", shot_colour, meet, setup.ball_radius);
  draw_line(setup, "shots", shot_colour, meet, aim);
}

inline void draw_path(const Setup& setup, const char* layer, std::uint32_t colour,
                      const Point* points, int count) {
  for (int i = 1; i < count; ++i) {
    draw_line(setup, layer, colour, points[i - 1], points[i]);
  }
}

}  // namespace mirocup::strategy
