// SPDX-License-Identifier: MIT
//
// Shares the processor time of a check among its trial legs, so that the check of a slow team has
// shorter legs and not a longer time. The shares depend only on the use of earlier legs, so a busy
// machine does not make a leg shorter.
//
// Used means: processor time of the checking process and of both teams, loading included, and the
// time for which the entry slept. All times in s.
#pragma once

#include <algorithm>

namespace mirocup::app {

class CheckPlan {
 public:
  static constexpr double all = 20.0;        // of a check
  static constexpr double causes = 15.0;     // in addition, to find the cause of a refusal
  static constexpr double longest = 4.0;     // of playing in one leg
  static constexpr double shortest = 0.5;    // of a leg without which there is no answer
  static constexpr double most_start = 4.0;  // of processor time, to load an entry

  // Adds the use of a leg, and the part of it that loading the entry took.
  void add(double used, double start) {
    used_ += used;
    start_ = start;
  }

  // From now on legs are played to find the cause of a refusal.
  void look_for_causes() { most_ = std::max(most_, used_ + causes); }

  // Returns how long the next leg may play if `legs` legs, itself included, must be played.
  double share_of(int legs) const {
    return std::clamp((most_ - used_) / legs - start_, shortest, longest);
  }

  // True if there is room for a leg that plays so long, before `legs` legs that must be played.
  bool has_room_for(double playing, int legs) const {
    return used_ + start_ + playing + legs * (start_ + shortest) <= most_;
  }

  double used() const { return used_; }

 private:
  double most_ = all;
  double used_ = 0.0;
  double start_ = 0.0;  // of the last leg
};

}  // namespace mirocup::app
