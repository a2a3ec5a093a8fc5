// SPDX-License-Identifier: MIT
//
// Shares the processor time of a check among its trial legs, so that the check of a slow team has
// shorter legs instead of taking longer. A team that stays below half of its budget plays legs of
// full length, also on a busy machine.
//
// The use of a leg is the processor time of the checking process and of both teams, including
// loading, plus the time for which the entry slept. All times are in s.
#pragma once

#include <algorithm>
#include <cstdint>

namespace mirocup::app {

class CheckPlan {
 public:
  static constexpr double all = 20.0;        // most processor time, s, of a whole check
  static constexpr double causes = 15.0;     // most further use to find the cause of a refusal
  static constexpr double longest = 4.0;     // longest playing time of a leg
  static constexpr double shortest = 0.5;    // shortest playing time of a leg
  static constexpr double most_start = 4.0;  // longest processor time for loading an entry

  // A team that uses at most this much in a tick, in the mean of a leg, s, plays the whole leg. It
  // is twice the half of its budget, because the processor time of the same work differs twofold
  // between a quiet and a busy machine. While memory is watched, a tick takes three times as much.
  static constexpr double whole_legs = 1e-3;
  static constexpr double of_watching = 3.0;

  // Returns the use at which a leg stops after this many ticks. `share` is share_of().
  static double most_use(double share, std::uint32_t ticks, bool is_watched) {
    return std::max(share, ticks * whole_legs * (is_watched ? of_watching : 1.0));
  }

  // Adds the processor time of a leg, and the part of it that loading the entry took.
  void add(double used, double start) {
    used_ += used;
    start_ = start;
  }

  // From now on legs are played to find the cause of a refusal.
  void look_for_causes() { most_ = std::max(most_, used_ + causes); }

  // Returns the playing time of the next leg if `legs` legs, the next leg included, must be played.
  double share_of(int legs) const {
    return std::clamp((most_ - used_) / legs - start_, shortest, longest);
  }

  // True if the entry is quick, or a leg of a given playing time leaves enough of the plan for
  // `legs` legs that must follow. `tick` is what the entry uses in a tick, s.
  bool has_room_for(double playing, int legs, double tick) const {
    const bool is_quick = tick <= whole_legs && start_ <= 0.25 * most_start;
    return is_quick || used_ + start_ + playing + legs * (start_ + shortest) <= most_;
  }

  double used() const { return used_; }

 private:
  double most_ = all;
  double used_ = 0.0;
  double start_ = 0.0;  // use of the last leg for loading
};

}  // namespace mirocup::app
