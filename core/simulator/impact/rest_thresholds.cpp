// SPDX-License-Identifier: MIT
#include "core/simulator/impact/rest_thresholds.hpp"

#include "core/simulator/trajectory/differential_drive.hpp"
#include "core/simulator/trajectory/rolling_ball.hpp"

#include <algorithm>

namespace mirocup::simulator {

namespace {

// A curve that holds for so many times the mean time between the tick's touches, or the time since
// the last one, is long enough.
constexpr double times_between_touches = 2.0;

// Of hold(), where a curve would have ended even earlier: the same would happen again and again.
constexpr double growth_when_forced = 8.0;
constexpr double longest_hold = 2e-3;  // s

// Of rest_slide() for each event, from Tolerances::rest_slide on up to what rests in company. The
// slides of a large crowd may be a little faster than any limit, and come back as fast.
constexpr double late_slide_growth = 1.05;

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
    : tolerances_(t),
      rest_after_touches_(growing(t.rest_speed, t.rest_growth_per_touch, never)),
      sink_after_touches_(growing(t.sink, t.sink_growth_per_touch, t.touch, t.patient_touches)),
      slide_after_touches_(growing(t.brief_slide, t.brief_slide_growth_per_touch, never)) {
  // Until the second touch.
  rest_after_touches_[0] = rest_after_touches_[1] = t.first_rest_speed;
}

void Patience::forget() {
  touching_.reset();
  touched_.reset();
  touches_ = {};
  exhausted_.reset();
}

void Patience::begin_tick(const BodySet& touching) {
  accustomed_ = touching_ | touched_;
  touching_ = touching;
  touched_.reset();
  last_touch_of_ = {};
  touches_ = {};
  met_ = {};
  followed_ = {};
  were_exhausted_ = exhausted_;
  exhausted_ = tolerances_.followed_per_tick > 0 ? BodySet{} : ~BodySet{};
  all_touches_ = 0;
  last_touch_ = 0.0;
  slide_ = no_sliding;
  roll_ = no_rolling;
  hold_ = tolerances_.hold;
}

void Patience::count(int body, double t) {
  if (touches_[body] < tolerances_.touches_never_forgotten) {
    const double forgotten = (t - last_touch_of_[body]) / tolerances_.touch_forgotten;
    touches_[body] = forgotten < touches_[body] ? touches_[body] - static_cast<int>(forgotten) : 0;
  }
  touches_[body] = std::min(touches_[body] + 1, most_counted);
  touched_.set(body);
  last_touch_of_[body] = t;
}

void Patience::note_touch(const Pair& pair, double t) {
  const BodySet both = bodies_of(pair);
  for_each_body(both, [&](int i) {
    count(i, t);
    met_[i] |= both;
  });
  ++all_touches_;
  last_touch_ = t;
}

// A bounce is a touch, if it was not noted as one.
void Patience::note_bounce(const Pair& pair, double t) {
  const auto count_once = [this, t](int body) {
    if (touches_[body] == 0 || last_touch_of_[body] != t) count(body, t);
  };
  count_once(pair.a);
  if (!pair.with_obstacle()) count_once(pair.partner);
}

// Who has met many will have many more events.
int Patience::cost_of_event(const BodySet& involved, const BodySet& company) {
  const int both = static_cast<int>(involved.count() * company.count());
  return both * both;
}

void Patience::note_event(const BodySet& involved, bool was_forced) {
  BodySet company = involved;
  for_each_body(involved, [&](int i) { company |= met_[i]; });
  const int cost = cost_of_event(involved, company);
  for_each_body(involved & ~exhausted_, [&](int i) {
    followed_[i] += cost;
    exhausted_[i] = followed_[i] >= tolerances_.followed_per_tick;
  });
  const Tolerances& t = tolerances_;
  hold_ = std::min(hold_ * (was_forced ? growth_when_forced : t.growth_per_event), longest_hold);
  roll_ = std::min(roll_ * t.growth_per_event, t.rest_speed);
  slide_ = slide_ < t.rest_slide ? std::min(slide_ * t.slide_growth_per_event, t.rest_slide)
                                 : std::min(slide_ * late_slide_growth, t.rest_speed);
}

void Patience::note_group(const BodySet& group) {
  if ((group & were_exhausted_).none()) return;
  if (cost_of_event(group, group) >= tolerances_.followed_per_tick) exhausted_ |= group;
}

int Patience::touches_of(const Pair& pair) const {
  return pair.with_obstacle() ? touches_[pair.a]
                              : std::max(touches_[pair.a], touches_[pair.partner]);
}

double Patience::rest_speed(const Pair& pair) const {
  if (lasts(pair.a) && (pair.with_obstacle() || lasts(pair.partner))) return tolerances_.rest_speed;
  return rest_after_touches_[touches_of(pair)];
}

double Patience::sink(const Pair& pair) const {
  return sink_after_touches_[touches_of(pair)];
}

double Patience::brief_slide(int robot) const {
  if (lasts(robot)) return tolerances_.brief_slide;
  return std::min(slide_after_touches_[touches_[robot]], rest_after_touches_[touches_[robot]]);
}

double Patience::long_enough(double t) const {
  if (all_touches_ == 0) return never;
  return times_between_touches * std::max(t / all_touches_, t - last_touch_);
}

}  // namespace mirocup::simulator
