// SPDX-License-Identifier: MIT
#include "core/simulator/impact/rest_thresholds.hpp"

#include "core/simulator/trajectory/differential_drive.hpp"
#include "core/simulator/trajectory/rolling_ball.hpp"

#include <algorithm>

namespace mirocup::simulator::impact {

// Returns first for up to `free` impacts, then that grown by each further impact up to a limit.
RestThresholds::GrowthTable RestThresholds::growing(double first, double growth, double limit,
                                                    int free) {
  GrowthTable values;
  for (int i = 0; i <= max_counted; ++i) {
    values[i] = first;
    if (i >= free) first = std::min(first * growth, limit);
  }
  return values;
}

RestThresholds::RestThresholds(const Tolerances& t)
    : tolerances_(t),
      restitution_after_impacts_(
          growing(t.restitution_threshold, t.restitution_growth_per_impact, trajectory::never)),
      penetration_after_impacts_(
          growing(t.penetration, t.penetration_growth_per_impact, t.contact_gap, t.free_impacts)),
      slip_after_impacts_(
          growing(t.min_slip_speed, t.min_slip_growth_per_impact, trajectory::never)) {
  // A body's first impact in a tick bounces however slow it is.
  restitution_after_impacts_[0] = restitution_after_impacts_[1] = t.first_restitution_threshold;
}

void RestThresholds::forget() {
  touching_.reset();
  hit_.reset();
  impacts_ = {};
  over_budget_.reset();
}

void RestThresholds::recall(const Memory& memory) {
  touching_ = memory.touching;
  hit_ = memory.hit;
  over_budget_ = memory.over_budget;
}

void RestThresholds::begin_tick(const BodySet& touching) {
  in_contact_before_ = touching_ | hit_;
  touching_ = touching;
  hit_.reset();
  last_impact_of_ = {};
  impacts_ = {};
  met_ = {};
  event_cost_ = {};
  were_over_budget_ = over_budget_;
  over_budget_ = tolerances_.event_budget > 0 ? BodySet{} : ~BodySet{};
  all_impacts_ = 0;
  last_impact_ = 0.0;
  slip_threshold_ = settings::differential_drive.slip_round_off;
  roll_threshold_ = settings::rolling_ball.roll_round_off;
  min_duration_ = tolerances_.min_contact_duration;
}

// Impacts that come now and then are forgotten, one for each impact_memory since the last one; but
// once there are remembered_impacts, bouncing has to end, and none is forgotten.
void RestThresholds::count(int body, double t) {
  if (impacts_[body] < tolerances_.remembered_impacts) {
    const double forgotten = (t - last_impact_of_[body]) / tolerances_.impact_memory;
    impacts_[body] = forgotten < impacts_[body] ? impacts_[body] - static_cast<int>(forgotten) : 0;
  }
  impacts_[body] = std::min(impacts_[body] + 1, max_counted);
  hit_.set(body);
  last_impact_of_[body] = t;
}

void RestThresholds::note_impact(const Pair& pair, double t) {
  const BodySet both = bodies_of(pair);
  for_each_body(both, [&](int i) {
    count(i, t);
    met_[i] |= both;
  });
  ++all_impacts_;
  last_impact_ = t;
}

void RestThresholds::note_bounce(const Pair& pair, double t) {
  const auto count_once = [this, t](int body) {
    if (impacts_[body] == 0 || last_impact_of_[body] != t) count(body, t);
  };
  count_once(pair.a);
  if (!pair.with_obstacle()) count_once(pair.partner);
}

// A body that has met many will have many more events.
int RestThresholds::cost_of_event(const BodySet& involved, const BodySet& met) {
  const int product = static_cast<int>(involved.count() * met.count());
  return product * product;
}

void RestThresholds::note_event(const BodySet& involved, bool was_forced) {
  BodySet met = involved;
  for_each_body(involved, [&](int i) { met |= met_[i]; });
  const int cost = cost_of_event(involved, met);
  for_each_body(involved & ~over_budget_, [&](int i) {
    event_cost_[i] += cost;
    over_budget_[i] = event_cost_[i] >= tolerances_.event_budget;
  });
  const Tolerances& t = tolerances_;
  min_duration_ = std::min(
      min_duration_ * (was_forced ? settings::rest_thresholds.forced_growth : t.growth_per_event),
      settings::rest_thresholds.max_min_duration);
  roll_threshold_ = std::min(roll_threshold_ * t.growth_per_event, t.restitution_threshold);
  slip_threshold_ = slip_threshold_ < t.slow_slip
                        ? std::min(slip_threshold_ * t.slip_growth_per_event, t.slow_slip)
                        : std::min(slip_threshold_ * settings::rest_thresholds.late_slip_growth,
                                   t.restitution_threshold);
}

void RestThresholds::note_island(const BodySet& island) {
  if ((island & were_over_budget_).none()) return;
  if (cost_of_event(island, island) >= tolerances_.event_budget) over_budget_ |= island;
}

int RestThresholds::impacts_of(const Pair& pair) const {
  return pair.with_obstacle() ? impacts_[pair.a]
                              : std::max(impacts_[pair.a], impacts_[pair.partner]);
}

double RestThresholds::restitution_threshold(const Pair& pair) const {
  if (is_lasting(pair.a) && (pair.with_obstacle() || is_lasting(pair.partner)))
    return tolerances_.restitution_threshold;
  return restitution_after_impacts_[impacts_of(pair)];
}

double RestThresholds::penetration(const Pair& pair) const {
  return penetration_after_impacts_[impacts_of(pair)];
}

double RestThresholds::min_slip_speed(int robot) const {
  if (is_lasting(robot)) return tolerances_.min_slip_speed;
  return std::min(slip_after_impacts_[impacts_[robot]],
                  restitution_after_impacts_[impacts_[robot]]);
}

double RestThresholds::preferred_duration(double t) const {
  if (all_impacts_ == 0) return trajectory::never;
  return settings::rest_thresholds.times_between_impacts *
         std::max(t / all_impacts_, t - last_impact_);
}

}  // namespace mirocup::simulator::impact
