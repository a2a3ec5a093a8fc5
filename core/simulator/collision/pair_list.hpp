// SPDX-License-Identifier: MIT
//
// Which pairs may touch before their segments end, and when. Pairs whose swept boxes stay apart are
// not here and cost nothing more.
#pragma once

#include "core/simulator/collision/collision_queries.hpp"

#include <array>
#include <span>

namespace mirocup::simulator::collision {

struct CandidatePair {
  Pair pair;
  double contact_time =
      trajectory::never;   // s of the tick; not before this while it is only estimated
  double estimated = 0.0;  // when the estimate was made: from here on the touch is to be found
  double apart_at = -1.0;  // s: when they were last seen not to touch
  bool is_estimate = false;
  int estimates = 0;  // how often it was estimated anew

  // Is it known, without looking, that they do not touch at time t?
  bool is_apart_at(double t) const { return apart_at == t || (is_estimate && contact_time > t); }
};

class PairList {
 public:
  std::span<const CandidatePair> list() const {
    return {list_.data(), static_cast<std::size_t>(count_)};
  }

  std::span<CandidatePair> list() { return {list_.data(), static_cast<std::size_t>(count_)}; }

  void clear() { count_ = 0; }

  // Not later than t, which becomes their time, as it is known; of several at once those of the lowest
  // bodies. Null if there are none.
  CandidatePair* earliest(double& t);

  // Finds the pairs of the changed bodies anew: those whose boxes meet. When they touch is for the
  // caller to say.
  std::span<CandidatePair> find(const StaticWorld& world, std::span<const trajectory::Box> boxes,
                                const BodySet& changed);

 private:
  void add(const Pair& pair);

  std::array<CandidatePair, 512> list_;
  int count_ = 0;
};

}  // namespace mirocup::simulator::collision
