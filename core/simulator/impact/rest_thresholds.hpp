// SPDX-License-Identifier: MIT
//
// How closely a tick is followed, and how that wears off.
//
// Bodies in a crowd would bounce, let go and grip again ever faster and ever less. So within a tick
// what counts as rest grows: for a body with each of its touches, for curves with each event. A
// body's first touch is an impact however slow, touches that come now and then are forgotten again,
// and what happens in a crowd concerns nobody elsewhere. What is rest is stopped, never thrown back,
// so no energy comes of it.
#pragma once

#include "core/simulator/model/body_pair.hpp"
#include "core/simulator/model/parameters.hpp"
#include "core/simulator/model/tolerances.hpp"

#include <array>

namespace mirocup::simulator::impact {

class RestThresholds {
 public:
  explicit RestThresholds(const Tolerances& tolerances);

  // `touching`: the bodies with a contact now.
  void begin_tick(const BodySet& touching);
  // Bodies were put somewhere: whatever touches now does so for the first time.
  void forget();
  void note_touch(const Pair& pair, double t);  // s of the tick
  // Counts as a touch if it did not come of one, as when wheels grip again and throw a robot at what
  // it touches anyway.
  void note_bounce(const Pair& pair, double t);
  // `was_forced`: a curve ended as soon as it was allowed to, at hold().
  void note_event(const BodySet& involved, bool was_forced);
  // The tick begins with these in one group of bodies that touch. If a single event of all of them costs
  // what is followed in a tick, and it was too much in the last one, none is.
  void note_island(const BodySet& group);
  // Who has had all that is followed in a tick.
  const BodySet& over_budget() const { return over_budget_; }

  // A slower approach of the pair does not bounce, m/s.
  double restitution_threshold(const Pair& pair) const;
  // A pair in contact that comes closer by this hits anew, m.
  double penetration(const Pair& pair) const;
  // WheelState that an impact makes slide no faster than this are stopped by it, m/s.
  double min_slip_speed(int robot) const;
  // WheelState that slide, and a ball that rolls, no faster than this hold, m/s.
  double slip_threshold() const { return slip_threshold_; }
  double roll_threshold() const { return roll_threshold_; }
  // For so long no contact lets go and no wheels begin to slide, s.
  double min_duration() const { return min_duration_; }
  // A curve that holds for so long, s, is long enough at time t of the tick.
  double preferred_duration(double t) const;

 private:
  static constexpr int max_counted = 40;
  using GrowthTable = std::array<double, max_counted + 1>;  // after so many of something
  static GrowthTable growing(double first, double growth, double most, int patient = 0);

  static int cost_of_event(const BodySet& involved, const BodySet& encountered);
  int touches_of(const Pair& pair) const;
  void count(int body, double t);
  // Has the body been in company since before the tick, and not been touched anew?
  bool is_lasting(int body) const { return in_contact_before_[body] && touches_[body] == 0; }

  Tolerances tolerances_;
  GrowthTable restitution_after_touches_, penetration_after_touches_, slip_after_touches_;

  BodySet touching_;           // when this tick began
  BodySet touched_;            // since it began
  BodySet in_contact_before_;  // touched, or were touched, in the tick before
  std::array<BodySet, max_bodies>
      encountered_{};                         // of each body: itself, and whom it touched in it
  std::array<int, max_bodies> touches_{};     // of each body in this tick, up to max_counted
  std::array<int, max_bodies> event_cost_{};  // of each in this tick, what it cost
  BodySet over_budget_, were_over_budget_;    // by it; in the tick before
  std::array<double, max_bodies> last_touch_of_{};  // s of the tick
  int all_touches_ = 0;
  double last_touch_ = 0.0;  // s of the tick
  double slip_threshold_ = 0.0;
  double roll_threshold_ = 0.0;
  double min_duration_ = 0.0;
};

}  // namespace mirocup::simulator::impact
