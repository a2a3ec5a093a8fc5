// SPDX-License-Identifier: MIT
//
// A trace as the situations that the referee is shown, one every control period.
#pragma once

#include "server/traces/trace.hpp"

namespace mirocup::traces {

inline constexpr double sample_period = 0.033;  // s

class TraceSampler {
 public:
  // Both outlive the film.
  TraceSampler(const Trace& trace, const referee::Pitch& pitch);

  // The last sample: the first that shows the last frame, or the last one within `hold`.
  int last_sample() const { return last_sample_; }

  // Sample 0 shows how it begins and takes no time.
  referee::Situation sample(int k) const;

 private:
  struct Instant {
    Vec2 ball{0.0, 0.0};
    referee::ByRobot<Pose> robots;
  };

  const KeyFrame& frame_at(double t) const;
  Instant instant(double t) const;
  Vec2 ball_at(double t) const;
  void place_unlisted_robots();
  void add_motion(double t, referee::Situation& s) const;
  void add_contacts(const KeyFrame& frame, referee::Situation& s) const;
  void add_drives(const KeyFrame& frame, referee::Situation& s) const;

  const Trace& trace_;
  const referee::Pitch& pitch_;
  int last_sample_ = 0;
  referee::ByRobot<Pose> unlisted_;  // where robots stand that the trace does not list
};

}  // namespace mirocup::traces
