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

namespace mirocup::simulator {

class Patience {
 public:
  explicit Patience(const Tolerances& tolerances);

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
  void note_group(const BodySet& group);
  // Who has had all that is followed in a tick.
  const BodySet& exhausted() const { return exhausted_; }

  // A slower approach of the pair does not bounce, m/s.
  double rest_speed(const Pair& pair) const;
  // A pair in contact that comes closer by this hits anew, m.
  double sink(const Pair& pair) const;
  // Wheels that an impact makes slide no faster than this are stopped by it, m/s.
  double brief_slide(int robot) const;
  // Wheels that slide, and a ball that rolls, no faster than this hold, m/s.
  double rest_slide() const { return slide_; }
  double rest_roll() const { return roll_; }
  // For so long no contact lets go and no wheels begin to slide, s.
  double hold() const { return hold_; }
  // A curve that holds for so long, s, is long enough at time t of the tick.
  double long_enough(double t) const;

 private:
  static constexpr int most_counted = 40;
  using Growing = std::array<double, most_counted + 1>;  // after so many of something
  static Growing growing(double first, double growth, double most, int patient = 0);

  static int cost_of_event(const BodySet& involved, const BodySet& company);
  int touches_of(const Pair& pair) const;
  void count(int body, double t);
  // Has the body been in company since before the tick, and not been touched anew?
  bool lasts(int body) const { return accustomed_[body] && touches_[body] == 0; }

  Tolerances tolerances_;
  Growing rest_after_touches_, sink_after_touches_, slide_after_touches_;

  BodySet touching_;                        // when this tick began
  BodySet touched_;                         // since it began
  BodySet accustomed_;                      // touched, or were touched, in the tick before
  std::array<BodySet, max_bodies> met_{};   // of each body: itself, and whom it touched in it
  std::array<int, max_bodies> touches_{};   // of each body in this tick, up to most_counted
  std::array<int, max_bodies> followed_{};  // of each in this tick, what it cost
  BodySet exhausted_, were_exhausted_;      // by it; in the tick before
  std::array<double, max_bodies> last_touch_of_{};  // s of the tick
  int all_touches_ = 0;
  double last_touch_ = 0.0;  // s of the tick
  double slide_ = 0.0;
  double roll_ = 0.0;
  double hold_ = 0.0;
};

}  // namespace mirocup::simulator
