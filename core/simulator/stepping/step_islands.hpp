// SPDX-License-Identifier: MIT
//
// Which bodies are being time-stepped, and which of them share a step.
//
// A step island is a set of bodies that take one step together: the impulses of the step keep its
// members apart until the step ends or a body from outside collides with one of them. The steps of
// two islands may start at different times. Plain bookkeeping for one tick; uses model/ only.
// Threads: none.
#pragma once

#include "core/base/assert.hpp"
#include "core/simulator/model/body_pair.hpp"

#include <array>

namespace mirocup::simulator::stepping {

class StepIslands {
 public:
  // The members take one step together from `start`, in seconds of the tick. None of them may be in
  // another step.
  void begin_step(const BodySet& members, double start) {
    MIROCUP_ASSERT((stepping_ & members).none());
    stepping_ |= members;
    for_each_body(members, [&](int i) {
      island_[i] = members;
      start_[i] = start;
    });
  }
  // Ends the steps of these bodies, also before a step's planned end. Returns the bodies that were
  // in a step.
  BodySet end_step(const BodySet& bodies) {
    const BodySet left = stepping_ & bodies;
    stepping_ &= ~bodies;
    return left;
  }

  // Returns all bodies that are in a step.
  const BodySet& stepping() const { return stepping_; }
  bool is_stepping(int body) const { return stepping_[body]; }
  // Returns when the body's latest step started, in seconds of the tick.
  double start_of(int body) const { return start_[body]; }
  // Returns the island of a body in a step, itself included; otherwise the empty set.
  BodySet island_of(int body) const { return stepping_[body] ? island_[body] : BodySet{}; }

  // True if one step keeps the two sides of the pair apart. Obstacles belong to every step.
  bool share_step(const Pair& pair) const {
    if (!stepping_[pair.a]) return false;
    return pair.with_obstacle() || (stepping_[pair.partner] && island_[pair.a][pair.partner]);
  }

 private:
  BodySet stepping_;
  std::array<BodySet, max_bodies> island_;  // of each stepping body
  std::array<double, max_bodies> start_{};  // s of the tick, of each stepping body's step
};

}  // namespace mirocup::simulator::stepping
