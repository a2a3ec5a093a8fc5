// SPDX-License-Identifier: MIT
//
// The field of a league: its dimensions, its markings and the solid things around it.
//
// Frame: origin at the centre, x towards the right goal, y towards the upper wall, metres. Every
// field is symmetric under a half-turn. The walls are listed so that the half-turn swaps neighbours
// 2i and 2i+1: sums over walls then have the same order at both ends (core/README.md, "Fair ends").
//
// Sources of the numbers: FIRA MiroSot rule texts and their dimensioned figures for all three
// leagues. The free-ball marks of the small league, and the goal depth and free-ball marks of the
// large league, have no official source and follow common practice.
#pragma once

#include "core/base/vec2.hpp"
#include "core/field/frames.hpp"
#include "core/field/league.hpp"

#include <array>
#include <optional>

namespace mirocup::field {

// A rectangle at a goal line (given for the right end) with an optional arc on its front line.
struct Area {
  double depth = 0.0;       // from the goal line into the field
  double half_width = 0.0;  // |y| is at most this
  double arc_radius = 0.0;  // 0: no arc
  // |x| of the arc's centre, at y = 0. The part of the arc's disc in front of the rectangle belongs
  // to the area.
  double arc_centre = 0.0;
};

// A solid half-plane: points x with normal . x < offset are inside the wall. The unit normal points
// into the field.
struct Wall {
  Vec2 normal;
  double offset;
};

// The end wall beside a goal mouth: a solid quarter-plane whose corner is a goal post. Points x are
// inside it when both face . (x - post) < 0 and side . (x - post) < 0. `face` points into the field
// along x, `side` into the goal mouth along y.
struct GoalPost {
  Vec2 post;
  Vec2 face;
  Vec2 side;
};

// The dimensions, markings and solid parts of one field. Lengths are in metres.
struct Field {
  RobotLeague league = RobotLeague::small;
  int robots_per_team = 3;

  double half_length = 0.0;      // X: goal lines at x = -X and X
  double half_width = 0.0;       // Y: side walls at y = -Y and Y
  double corner_leg = 0.0;       // length of the legs of the solid corner triangles
  double goal_half_width = 0.0;  // the mouth is |y| < this
  double goal_depth = 0.0;

  double centre_circle_radius = 0.0;
  Area goal_area;
  std::optional<Area> penalty_area;  // the small league has none
  double penalty_mark_x = 0.0;       // |x| of the penalty mark, which is also the free-kick mark
  Vec2 free_ball_mark{0.0, 0.0};     // of the quarter x > 0, y > 0
  double free_ball_offset = 0.0;     // contenders stand this far from that mark along x

  std::array<Wall, 8> walls;      // side walls, goal backs, corner cuts
  std::array<GoalPost, 4> posts;  // end walls

  // True if the point is on or inside the area of that end. The inside of the goal belongs to the
  // area. `tolerance` is in metres.
  bool inside(const Area& area, End end, const Vec2& point, double tolerance = 1e-6) const;

  // Returns the distance of a point to the nearest solid thing, m; negative inside one.
  double clearance(const Vec2& point) const;
};

// Returns the field of a league.
Field make_field(RobotLeague league);

}  // namespace mirocup::field
