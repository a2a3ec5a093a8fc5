// SPDX-License-Identifier: MIT
//
// Two things that can touch: two bodies, or a body and an obstacle.
#pragma once

#include "core/simulator/model/state.hpp"

#include <bit>

namespace mirocup::simulator::inline model {

// Bodies are the robots by index, then the ball. Obstacles are the eight half-plane walls, side walls
// first, then the four end walls beside the goal mouths.
inline constexpr int side_walls = 2;
inline constexpr int plane_walls = 8;
inline constexpr int end_walls = 4;
inline constexpr int max_partners = max_bodies + plane_walls + end_walls;

inline constexpr int no_body = -1;  // where a body's index is asked for: an obstacle

// BodyState a, and as its partner a body of lower index or an obstacle.
struct Pair {
  int a = 0;
  int partner = 0;

  bool with_obstacle() const { return partner >= max_bodies; }
  bool with_plane() const { return with_obstacle() && obstacle() < plane_walls; }
  int obstacle() const { return partner - max_bodies; }
  int b() const { return with_obstacle() ? no_body : partner; }

  bool operator==(const Pair&) const = default;
};

// Calls visit(body) for each, in increasing order.
template <class Visit>
void for_each_body(const BodySet& bodies, Visit visit) {
  for (unsigned long left = bodies.to_ulong(); left != 0; left &= left - 1UL) {
    visit(std::countr_zero(left));
  }
}

inline BodySet bodies_of(const Pair& pair) {
  BodySet bodies;
  bodies.set(pair.a);
  if (!pair.with_obstacle()) bodies.set(pair.partner);
  return bodies;
}

inline Pair pair_of(int i, int j) {
  return i > j ? Pair{i, j} : Pair{j, i};
}
inline Pair pair_with_obstacle(int i, int obstacle) {
  return {i, max_bodies + obstacle};
}

}  // namespace mirocup::simulator::inline model
