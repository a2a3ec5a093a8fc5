// SPDX-License-Identifier: MIT
//
// Which pairs can touch at all, judged by boxes that hold the bodies' reference points, and what
// contacts they have. The first is asked for every body in every tick, so all of it is inline.
#pragma once

#include "core/simulator/collision/collision_queries.hpp"

#include <algorithm>
#include <span>

namespace mirocup::simulator::collision {

// Is no point of one box within `reach` (m, along an axis) of the other?
inline bool are_apart(const trajectory::Box& a, const trajectory::Box& b, double reach) {
  const double x = std::max(a.low_x - b.high_x, b.low_x - a.high_x);
  const double y = std::max(a.low_y - b.high_y, b.low_y - a.high_y);
  return std::max(x, y) > reach;
}

inline bool are_apart(const trajectory::Box& box, const field::Wall& wall, double reach) {
  const double nearest = std::min(wall.normal.x() * box.low_x, wall.normal.x() * box.high_x) +
                         std::min(wall.normal.y() * box.low_y, wall.normal.y() * box.high_y);
  return nearest - wall.offset > reach;
}

// An end wall is the quarter-plane behind its post.
inline bool are_apart(const trajectory::Box& box, const field::GoalPost& post, double reach) {
  const double face = std::min(post.face.x() * (box.low_x - post.post.x()),
                               post.face.x() * (box.high_x - post.post.x()));
  const double side = std::min(post.side.y() * (box.low_y - post.post.y()),
                               post.side.y() * (box.high_y - post.post.y()));
  return std::max(face, side) > reach;
}

// Do the coordinates from low to high leave [-inside, inside]? Of the obstacles, only side walls can be
// reached where x stays that far from the ends, and all others only where it does not.
inline bool is_beyond(double low, double high, double inside) {
  return !(low > -inside && high < inside);
}

// Bodies of an index below i, one bit each.
inline unsigned long bodies_below(int i) {
  return (1UL << i) - 1UL;
}

// Calls add(pair) for each pair of body i that can touch: with the others, one bit each, in
// increasing order, then with obstacles.
template <class Add>
void for_near_pairs(const StaticWorld& world, std::span<const trajectory::Box> boxes, int i,
                    unsigned long others, Add add) {
  const trajectory::Box& box = boxes[i];
  for_each_body(others, [&](int j) {
    if (!are_apart(box, boxes[j], world.reach(i, j))) add(pair_of(i, j));
  });
  if (world.field == nullptr) return;
  const field::Field& field = *world.field;
  const double reach = world.shape(i).radius + world.tolerances.contact_gap;
  const auto add_near = [&](const auto& obstacle, int k) {
    if (!are_apart(box, obstacle, reach)) add(pair_with_obstacle(i, k));
  };
  const double margin = field.corner_leg + reach;
  if (is_beyond(box.low_y, box.high_y, field.half_width - margin)) {
    for (int k = 0; k < side_walls; ++k) add_near(field.walls[k], k);
  }
  if (is_beyond(box.low_x, box.high_x, field.half_length - margin)) {
    for (int k = side_walls; k < plane_walls; ++k) add_near(field.walls[k], k);
    for (int k = 0; k < end_walls; ++k) add_near(field.posts[k], plane_walls + k);
  }
}

// The contacts with a gap of at most `margin`, m, of these bodies with each other and with obstacles,
// appended. Uses the boxes of all bodies.
inline void add_contacts_among(const StaticWorld& world, const BodySet& some,
                               std::span<const BodyState> bodies, double margin,
                               std::span<trajectory::Box> boxes, ContactList& list) {
  for (int i = 0; i < world.bodies(); ++i) {
    const Vec2& p = bodies[i].position;
    boxes[i] = {p.x() - margin, p.x() + margin, p.y() - margin, p.y() + margin};
  }
  const auto add = [&](const Pair& pair) { add_contacts(world, pair, bodies, margin, list); };
  for (int i = 0; i < world.bodies(); ++i) {
    if (some[i]) for_near_pairs(world, boxes, i, some.to_ulong() & bodies_below(i), add);
  }
}

}  // namespace mirocup::simulator::collision
