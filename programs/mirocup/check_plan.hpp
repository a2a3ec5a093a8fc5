// SPDX-License-Identifier: MIT
//
// Shares the processor time of a check among its trial legs, so that the check of a slow team has
// shorter legs and not a longer time. A pure function of what the legs before have used: a busy
// machine makes no leg shorter.
//
// Used means: processor time of the checking process and of both teams, loading included, and the
// time for which the entry slept. All times in s.
#pragma once

#include <algorithm>

namespace mirocup::app {

class CheckPlan {
 public:
  static constexpr double all = 20.0;        // of a check
  static constexpr double causes = 15.0;     // more, to find out why an entry is refused
  static constexpr double longest = 4.0;     // of playing, of one leg
  static constexpr double shortest = 0.5;    // of a leg without which there is no answer
  static constexpr double most_start = 4.0;  // of processor time, to load an entry

  // Adds what a leg has used, and how much of that it was to load the entry.
  void add(double used, double start) {
    used_ += used;
    start_ = start;
  }

  // Says that from now on legs are played for the cause of a refusal.
  void look_for_causes() { most_ = std::max(most_, used_ + causes); }

  // Returns how long the next leg may play, if so many legs must be played, itself included.
  double share_of(int legs) const {
    return std::clamp((most_ - used_) / legs - start_, shortest, longest);
  }

  // True if a leg may be played that takes so long, before so many that must be played.
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
