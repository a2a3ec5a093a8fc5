// SPDX-License-Identifier: MIT
//
// Pairs that can touch: two bodies, or a body and an obstacle of the field.
#pragma once

#include "core/simulator/model/state.hpp"

#include <bit>

namespace mirocup::simulator {
inline namespace model {

// Obstacles by index: 0 to 7 are the half-plane walls (0 and 1 the side walls), 8 to 11 the end
// walls beside the goal mouths. A partner's index is that of a body, or max_bodies plus an
// obstacle's.
inline constexpr int side_walls = 2;
inline constexpr int plane_walls = 8;
inline constexpr int end_walls = 4;
inline constexpr int max_partners = max_bodies + plane_walls + end_walls;

inline constexpr int no_body = -1;  // instead of a body's index: an obstacle

// Body `a` and its partner: a body of lower index, or an obstacle. One pair has one representation.
struct Pair {
  int a = 0;
  int partner = 0;

  // True if the partner is an obstacle.
  bool with_obstacle() const { return partner >= max_bodies; }
  // True if the partner is a half-plane wall.
  bool with_plane() const { return with_obstacle() && obstacle() < plane_walls; }
  // Returns the index of the partner among the obstacles. Precondition: with_obstacle().
  int obstacle() const { return partner - max_bodies; }
  // Returns the index of the partner among the bodies; no_body if it is an obstacle.
  int b() const { return with_obstacle() ? no_body : partner; }

  bool operator==(const Pair&) const = default;
};

// Calls visit(body) for each body of the set, in increasing order of the index.
template <class Visit>
void for_each_body(const BodySet& bodies, Visit visit) {
  for (unsigned long left = bodies.to_ulong(); left != 0; left &= left - 1UL) {
    visit(std::countr_zero(left));
  }
}

// Returns the one or two bodies of a pair.
inline BodySet bodies_of(const Pair& pair) {
  BodySet bodies;
  bodies.set(pair.a);
  if (!pair.with_obstacle()) bodies.set(pair.partner);
  return bodies;
}

// Returns the pair of two bodies i != j, in either order.
inline Pair pair_of(int i, int j) {
  return i > j ? Pair{i, j} : Pair{j, i};
}
// Returns the pair of body i and an obstacle, 0 <= obstacle < plane_walls + end_walls.
inline Pair pair_with_obstacle(int i, int obstacle) {
  return {i, max_bodies + obstacle};
}

}  // namespace model
}  // namespace mirocup::simulator
