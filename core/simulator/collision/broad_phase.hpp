// SPDX-License-Identifier: MIT
//
// Broad phase: rules out most pairs by axis-aligned boxes that hold the bodies' reference points,
// and lists the contacts of the pairs that remain. Its functions are called for every body in every
// tick, so all are inline. Uses model, trajectory and solver.
//
// Bodies are few (at most 23), so every pair of boxes is compared; a sweep or a grid would not pay.
#pragma once

#include "core/simulator/collision/collision_queries.hpp"

#include <algorithm>
#include <span>

namespace mirocup::simulator::collision {

// True if along at least one axis the boxes are more than `reach`, m, apart.
inline bool are_apart(const trajectory::Box& a, const trajectory::Box& b, double reach) {
  const double x = std::max(a.low_x - b.high_x, b.low_x - a.high_x);
  const double y = std::max(a.low_y - b.high_y, b.low_y - a.high_y);
  return std::max(x, y) > reach;
}

// True if no point of the box is within `reach`, m, of the wall.
inline bool are_apart(const trajectory::Box& box, const field::Wall& wall, double reach) {
  const double nearest = std::min(wall.normal.x() * box.low_x, wall.normal.x() * box.high_x) +
                         std::min(wall.normal.y() * box.low_y, wall.normal.y() * box.high_y);
  return nearest - wall.offset > reach;
}

// True if along at least one axis the box is more than `reach`, m, away from the end wall, which is
// the quarter-plane behind a goal post.
inline bool are_apart(const trajectory::Box& box, const field::GoalPost& post, double reach) {
  const double face = std::min(post.face.x() * (box.low_x - post.post.x()),
                               post.face.x() * (box.high_x - post.post.x()));
  const double side = std::min(post.side.y() * (box.low_y - post.post.y()),
                               post.side.y() * (box.high_y - post.post.y()));
  return std::max(face, side) > reach;
}

// True if the interval from low to high is not strictly inside [-limit, limit], m.
inline bool is_beyond(double low, double high, double limit) {
  return !(low > -limit && high < limit);
}

// Returns the bodies with an index below i, one bit each.
inline unsigned long bodies_below(int i) {
  return (1UL << i) - 1UL;
}

// Calls add(pair) for each pair of body i that the boxes do not rule out: first with the bodies in
// `others` (one bit each) in increasing order, then with obstacles. `boxes` holds one box for each
// body.
template <class Add>
void for_each_candidate_pair(const StaticWorld& world, std::span<const trajectory::Box> boxes,
                             int i, unsigned long others, Add add) {
  const trajectory::Box& box = boxes[i];
  for_each_body(others, [&](int j) {
    if (!are_apart(box, boxes[j], world.reach(i, j))) add(pair_of(i, j));
  });
  if (world.field == nullptr) return;
  const field::Field& field = *world.field;
  const double reach = world.shape(i).radius + world.tolerances.contact_gap;
  const auto add_obstacle = [&](const auto& obstacle, int k) {
    if (!are_apart(box, obstacle, reach)) add(pair_with_obstacle(i, k));
  };
  // Side walls are near only where |y| is large; goal backs, corner cuts and end walls only where
  // |x| is large. (The line of a corner cut also passes behind a side wall, where no body is.)
  const double margin = field.corner_leg + reach;
  if (is_beyond(box.low_y, box.high_y, field.half_width - margin)) {
    for (int k = 0; k < side_walls; ++k) add_obstacle(field.walls[k], k);
  }
  if (is_beyond(box.low_x, box.high_x, field.half_length - margin)) {
    for (int k = side_walls; k < plane_walls; ++k) add_obstacle(field.walls[k], k);
    for (int k = 0; k < end_walls; ++k) add_obstacle(field.posts[k], plane_walls + k);
  }
}

// Appends the contacts that the bodies in `some` have with each other and with obstacles, if their
// gap is at most `margin`, m. `boxes` is scratch space for one box of each body.
inline void add_contacts_among(const StaticWorld& world, const BodySet& some,
                               std::span<const BodyState> bodies, double margin,
                               std::span<trajectory::Box> boxes, ContactList& list) {
  for (int i = 0; i < world.bodies(); ++i) {
    const Vec2& p = bodies[i].position;
    boxes[i] = {p.x() - margin, p.x() + margin, p.y() - margin, p.y() + margin};
  }
  const auto add = [&](const Pair& pair) { add_contacts(world, pair, bodies, margin, list); };
  for (int i = 0; i < world.bodies(); ++i) {
    if (some[i]) {
      for_each_candidate_pair(world, boxes, i, some.to_ulong() & bodies_below(i), add);
    }
  }
}

}  // namespace mirocup::simulator::collision
