// SPDX-License-Identifier: MIT
//
// The candidate pairs of the broad phase, each with the time at which it first touches or a lower
// bound of that time. A pair whose swept boxes stay apart is not in the list and costs nothing
// more. Uses model, trajectory and solver.
#pragma once

#include "core/simulator/collision/collision_queries.hpp"

#include <array>
#include <optional>
#include <span>

namespace mirocup::simulator::collision {

// A pair that the broad phase did not rule out. The caller of PairList::find() sets the times, all
// in s of the tick.
struct CandidatePair {
  Pair pair;
  double contact_time = trajectory::never;  // first contact, or a lower bound of it if is_estimate
  double estimated = 0.0;                   // when the estimate was made; the pair was apart then
  double apart_at = -1.0;                   // a time at which the pair was found not to touch
  bool is_estimate = false;
  int estimates = 0;                               // how often the estimate was refined
  std::optional<geometry::Reference> reference{};  // that of two robots at `estimated`, if known

  // True if the pair is known not to touch at time t.
  bool is_apart_at(double t) const { return apart_at == t || (is_estimate && contact_time > t); }
};

// Every pair of bodies, and every body with every obstacle.
inline constexpr int max_candidate_pairs =
    max_bodies * (max_bodies - 1) / 2 + max_bodies * (plane_walls + end_walls);

// The candidate pairs of a world, each at most once. Nothing is allocated.
class PairList {
 public:
  std::span<const CandidatePair> list() const {
    return {list_.data(), static_cast<std::size_t>(count_)};
  }

  std::span<CandidatePair> list() { return {list_.data(), static_cast<std::size_t>(count_)}; }

  void clear() { count_ = 0; }

  // Returns the pair with the smallest contact time if that is at most t, and sets t to it; null if
  // there is no such pair. Among equal times the pair of lowest index is taken. The pointer is
  // valid until the list changes.
  CandidatePair* earliest(double& t);

  // Replaces the pairs of the changed bodies by those that the boxes do not rule out, and returns
  // these new pairs, whose times the caller has to set. `boxes` holds one swept box for each body.
  std::span<CandidatePair> find(const StaticWorld& world, std::span<const trajectory::Box> boxes,
                                const BodySet& changed);

 private:
  void add(const Pair& pair);

  std::array<CandidatePair, max_candidate_pairs> list_;
  int count_ = 0;
};

}  // namespace mirocup::simulator::collision
