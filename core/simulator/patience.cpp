// SPDX-License-Identifier: MIT
#include "core/simulator/patience.hpp"

#include "core/simulator/ball_motion.hpp"
#include "core/simulator/robot_motion.hpp"

#include <algorithm>

namespace mirocup::simulator {

namespace {

// A curve that holds for so many times the mean time between the tick's touches, or the time since
// the last one, is long enough.
constexpr double times_between_touches = 2.0;

// Of hold(), where a curve would have ended even earlier: the same would happen again and again.
constexpr double growth_when_forced = 8.0;
constexpr double longest_hold = 2e-3;  // s

}  // namespace

Patience::Growing Patience::growing(double first, double growth, double most, int patient) {
  Growing values;
  for (int i = 0; i <= most_counted; ++i) {
    values[i] = first;
    if (i >= patient) first = std::min(first * growth, most);
  }
  return values;
}

Patience::Patience(const Tolerances& t)
    : event_growth_(t.growth_per_event),
      slide_growth_(t.slide_growth_per_event),
      most_slide_(t.rest_slide),
      rest_after_touches_(growing(t.rest_speed, t.rest_growth_per_touch, never)),
      rest_after_bounces_(growing(t.rest_speed, t.rest_growth_per_bounce, never)),
      sink_after_touches_(growing(t.sink, t.sink_growth_per_touch, t.touch, t.patient_touches)),
      slide_after_touches_(growing(t.brief_slide, t.brief_slide_growth_per_touch, never)),
      first_hold_(t.hold) {}

void Patience::begin_tick() {
  touches_ = {};
  bounces_ = {};
  all_touches_ = 0;
  last_touch_ = 0.0;
  slide_ = no_sliding;
  roll_ = no_rolling;
  hold_ = first_hold_;
}

void Patience::note_touch(const Pair& pair, double t) {
  const auto count = [this](int body) {
    touches_[body] = std::min(touches_[body] + 1, most_counted);
  };
  count(pair.a);
  if (!pair.with_obstacle()) count(pair.partner);
  ++all_touches_;
  last_touch_ = t;
}

void Patience::note_bounce(const Pair& pair) {
  unsigned char& bounces = bounces_[pair.a][pair.partner];
  if (bounces < most_counted) ++bounces;
}

void Patience::note_event(bool was_forced) {
  hold_ = std::min(hold_ * (was_forced ? growth_when_forced : event_growth_), longest_hold);
  roll_ = std::min(roll_ * event_growth_, rest_after_touches_[0]);
  slide_ = std::min(slide_ * slide_growth_, most_slide_);
}

int Patience::touches_of(const Pair& pair) const {
  return pair.with_obstacle() ? touches_[pair.a]
                              : std::max(touches_[pair.a], touches_[pair.partner]);
}

double Patience::rest_speed(const Pair& pair) const {
  return std::max(rest_after_touches_[touches_of(pair)],
                  rest_after_bounces_[bounces_[pair.a][pair.partner]]);
}

double Patience::sink(const Pair& pair) const {
  return sink_after_touches_[touches_of(pair)];
}

double Patience::brief_slide(int robot) const {
  return std::min(slide_after_touches_[touches_[robot]], rest_after_touches_[touches_[robot]]);
}

double Patience::long_enough(double t) const {
  if (all_touches_ == 0) return never;
  return times_between_touches * std::max(t / all_touches_, t - last_touch_);
}

}  // namespace mirocup::simulator
