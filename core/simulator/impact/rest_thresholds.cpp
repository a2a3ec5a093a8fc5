// SPDX-License-Identifier: MIT
#include "core/simulator/impact/rest_thresholds.hpp"

#include "core/simulator/trajectory/differential_drive.hpp"
#include "core/simulator/trajectory/rolling_ball.hpp"

#include <algorithm>

namespace mirocup::simulator::impact {

namespace {

// A curve that holds for so many times the mean time between the tick's touches, or the time since
// the last one, is long enough.
constexpr double times_between_touches = 2.0;

// Of hold(), where a curve would have ended even earlier: the same would happen again and again.
constexpr double forced_growth = 8.0;
constexpr double max_min_duration = 2e-3;  // s

// Of slip_threshold() for each event, from Tolerances::slip_threshold on up to what rests in company. The
// slides of a large crowd may be a little faster than any limit, and come back as fast.
constexpr double late_slip_growth = 1.05;

}  // namespace

RestThresholds::GrowthTable RestThresholds::growing(double first, double growth, double most,
                                                    int patient) {
  GrowthTable values;
  for (int i = 0; i <= max_counted; ++i) {
    values[i] = first;
    if (i >= patient) first = std::min(first * growth, most);
  }
  return values;
}

RestThresholds::RestThresholds(const Tolerances& t)
    : tolerances_(t),
      restitution_after_touches_(
          growing(t.restitution_threshold, t.restitution_growth_per_touch, trajectory::never)),
      penetration_after_touches_(
          growing(t.penetration, t.penetration_growth_per_touch, t.contact_gap, t.free_touches)),
      slip_after_touches_(
          growing(t.min_slip_speed, t.min_slip_growth_per_touch, trajectory::never)) {
  // Until the second touch.
  restitution_after_touches_[0] = restitution_after_touches_[1] = t.first_restitution_threshold;
}

void RestThresholds::forget() {
  touching_.reset();
  touched_.reset();
  touches_ = {};
  over_budget_.reset();
}

void RestThresholds::begin_tick(const BodySet& touching) {
  in_contact_before_ = touching_ | touched_;
  touching_ = touching;
  touched_.reset();
  last_touch_of_ = {};
  touches_ = {};
  encountered_ = {};
  event_cost_ = {};
  were_over_budget_ = over_budget_;
  over_budget_ = tolerances_.event_budget > 0 ? BodySet{} : ~BodySet{};
  all_touches_ = 0;
  last_touch_ = 0.0;
  slip_threshold_ = trajectory::slip_round_off;
  roll_threshold_ = trajectory::roll_round_off;
  min_duration_ = tolerances_.min_contact_duration;
}

void RestThresholds::count(int body, double t) {
  if (touches_[body] < tolerances_.remembered_touches) {
    const double forgotten = (t - last_touch_of_[body]) / tolerances_.impact_memory;
    touches_[body] = forgotten < touches_[body] ? touches_[body] - static_cast<int>(forgotten) : 0;
  }
  touches_[body] = std::min(touches_[body] + 1, max_counted);
  touched_.set(body);
  last_touch_of_[body] = t;
}

void RestThresholds::note_touch(const Pair& pair, double t) {
  const BodySet both = bodies_of(pair);
  for_each_body(both, [&](int i) {
    count(i, t);
    encountered_[i] |= both;
  });
  ++all_touches_;
  last_touch_ = t;
}

// A bounce is a touch, if it was not noted as one.
void RestThresholds::note_bounce(const Pair& pair, double t) {
  const auto count_once = [this, t](int body) {
    if (touches_[body] == 0 || last_touch_of_[body] != t) count(body, t);
  };
  count_once(pair.a);
  if (!pair.with_obstacle()) count_once(pair.partner);
}

// Who has met many will have many more events.
int RestThresholds::cost_of_event(const BodySet& involved, const BodySet& encountered) {
  const int both = static_cast<int>(involved.count() * encountered.count());
  return both * both;
}

void RestThresholds::note_event(const BodySet& involved, bool was_forced) {
  BodySet encountered = involved;
  for_each_body(involved, [&](int i) { encountered |= encountered_[i]; });
  const int cost = cost_of_event(involved, encountered);
  for_each_body(involved & ~over_budget_, [&](int i) {
    event_cost_[i] += cost;
    over_budget_[i] = event_cost_[i] >= tolerances_.event_budget;
  });
  const Tolerances& t = tolerances_;
  min_duration_ =
      std::min(min_duration_ * (was_forced ? forced_growth : t.growth_per_event), max_min_duration);
  roll_threshold_ = std::min(roll_threshold_ * t.growth_per_event, t.restitution_threshold);
  slip_threshold_ = slip_threshold_ < t.slow_slip
                        ? std::min(slip_threshold_ * t.slip_growth_per_event, t.slow_slip)
                        : std::min(slip_threshold_ * late_slip_growth, t.restitution_threshold);
}

void RestThresholds::note_island(const BodySet& group) {
  if ((group & were_over_budget_).none()) return;
  if (cost_of_event(group, group) >= tolerances_.event_budget) over_budget_ |= group;
}

int RestThresholds::touches_of(const Pair& pair) const {
  return pair.with_obstacle() ? touches_[pair.a]
                              : std::max(touches_[pair.a], touches_[pair.partner]);
}

double RestThresholds::restitution_threshold(const Pair& pair) const {
  if (is_lasting(pair.a) && (pair.with_obstacle() || is_lasting(pair.partner)))
    return tolerances_.restitution_threshold;
  return restitution_after_touches_[touches_of(pair)];
}

double RestThresholds::penetration(const Pair& pair) const {
  return penetration_after_touches_[touches_of(pair)];
}

double RestThresholds::min_slip_speed(int robot) const {
  if (is_lasting(robot)) return tolerances_.min_slip_speed;
  return std::min(slip_after_touches_[touches_[robot]],
                  restitution_after_touches_[touches_[robot]]);
}

double RestThresholds::preferred_duration(double t) const {
  if (all_touches_ == 0) return trajectory::never;
  return times_between_touches * std::max(t / all_touches_, t - last_touch_);
}

}  // namespace mirocup::simulator::impact
