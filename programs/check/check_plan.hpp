// SPDX-License-Identifier: MIT
//
// Shares the processor time of a check among its trial legs, so that the check of a slow team has
// shorter legs instead of taking longer. The shares depend only on the use of earlier legs, so a
// busy machine does not make a leg shorter.
//
// The use of a leg is the processor time of the checking process and of both teams, including
// loading, plus the time for which the entry slept. All times are in s.
#pragma once

#include <algorithm>

namespace mirocup::app {

class CheckPlan {
 public:
  static constexpr double all = 20.0;        // most processor time, s, of a whole check
  static constexpr double causes = 15.0;     // most further use to find the cause of a refusal
  static constexpr double longest = 4.0;     // longest playing time of a leg
  static constexpr double shortest = 0.5;    // shortest playing time of a leg
  static constexpr double most_start = 4.0;  // longest processor time for loading an entry

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

  // True if a leg of a given playing time leaves enough of the plan for `legs` legs that must
  // follow.
  bool has_room_for(double playing, int legs) const {
    return used_ + start_ + playing + legs * (start_ + shortest) <= most_;
  }

  double used() const { return used_; }

 private:
  double most_ = all;
  double used_ = 0.0;
  double start_ = 0.0;  // use of the last leg for loading
};

}  // namespace mirocup::app
