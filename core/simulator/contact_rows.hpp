// SPDX-License-Identifier: MIT
//
// A contact that lasts, as power series: its Jacobian rows, its force, and whether it is still on
// its edge.
//
// Seen from the body with the edge, an edge's normal is constant and the touching point moves; seen
// from the body with the corner, the corner is constant and the normal turns. So every row is
// linear in the relative pose of the two, and one more term of the poses gives one more term of the
// rows.
#pragma once

#include "core/simulator/arena.hpp"

#include <array>
#include <span>

namespace mirocup::simulator {

struct ContactRows {
  // Rate of the gap: row_a . twist of a - row_b . twist of b. Zero for a side that is a wall.
  std::array<Series, 3> row_a, row_b;
  Series force;  // N, along the normal

  // What stays positive while the point is over its edge, or the ball at its corner; unused ones
  // are 1.
  std::array<Series, 2> inside;

  // Pose of the point's side in the frame of the edge's side, where both are bodies: its heading,
  // its position.
  Series cos, sin, x, y;
  Series dx, dy;  // the same position in the field's frame
};

// Sets term k of everything but the force from terms up to k of the segments.
void extend_rows(const Arena& arena, const Contact& contact, std::span<const Segment> segments,
                 int k, ContactRows& rows);

// Term k of the rate of the contact's gap.
double gap_rate_term(const Contact& contact, const ContactRows& rows,
                     std::span<const Segment> segments, int k);

}  // namespace mirocup::simulator
