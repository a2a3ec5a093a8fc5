// SPDX-License-Identifier: MIT
//
// Turns a trace into the situations that the referee judges, one for every control period.
#pragma once

#include "record/traces/trace.hpp"

namespace mirocup::traces {

inline constexpr double sample_period = 0.033;  // s

class TraceSampler {
 public:
  // Both arguments must outlive the sampler.
  TraceSampler(const Trace& trace, const referee::JudgedField& pitch);

  // Returns the number of the last sample: the first sample that shows the last frame or, if later,
  // the last sample within `hold`.
  int last_sample() const { return last_sample_; }

  // Returns the situation at the time k * sample_period, with the motion since the previous sample.
  // Sample 0 has the duration 0.
  referee::TickFacts sample(int k) const;

 private:
  struct Instant {
    Vec2 ball{0.0, 0.0};
    referee::ByRobot<Pose> robots;
  };

  const KeyFrame& frame_at(double t) const;
  Instant instant(double t) const;
  Vec2 first_seen(const Vec2& ball) const;
  Vec2 ball_at(double t) const;
  void place_unlisted_robots();
  void add_motion(double t, referee::TickFacts& s) const;
  void add_contacts(const KeyFrame& frame, referee::TickFacts& s) const;
  void add_drives(const KeyFrame& frame, referee::TickFacts& s) const;

  const Trace& trace_;
  const referee::JudgedField& pitch_;
  int last_sample_ = 0;
  referee::ByRobot<Pose> unlisted_;  // poses of the robots that the trace does not list
};

}  // namespace mirocup::traces
