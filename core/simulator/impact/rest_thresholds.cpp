// SPDX-License-Identifier: MIT
#include "core/simulator/impact/rest_thresholds.hpp"

#include "core/simulator/trajectory/differential_drive.hpp"
#include "core/simulator/trajectory/rolling_ball.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator::impact {

namespace {

// Two contacts are the same if this is equal. A corner that slides from one edge to the next keeps
// its contact; the ball has one contact with each body.
RestThresholds::Touched touched_of(const collision::Contact& c) {
  const bool is_corner = c.point.kind == collision::Touching::corner_on_edge;
  return {.a = static_cast<std::uint8_t>(c.pair.a),
          .partner = static_cast<std::uint8_t>(c.pair.partner),
          .corner = static_cast<std::uint8_t>(is_corner ? c.point.corner : 0),
          .point_on_a = c.point.point_on_a};
}

int cost_of_event(int bodies) {
  if (bodies <= 2) return bodies;
  const int square = bodies * bodies;
  const int large = settings::rest_thresholds.large_event;
  return bodies <= large ? square : square * square / (large * large);
}

}  // namespace

RestThresholds::RestThresholds(const Tolerances& tolerances, int bodies)
    : tolerances_(tolerances),
      least_budget_(tolerances.event_budget *
                    std::max(bodies, settings::rest_thresholds.bodies_of_least_budget)),
      cost_of_meeting_(std::min(bodies, settings::rest_thresholds.bodies_of_least_budget) - 1) {}

void RestThresholds::begin_tick(double duration) {
  drop_touched_before(-settings::rest_thresholds.contact_memory);
  const double parts = std::max(1.0, duration / settings::rest_thresholds.budget_duration);
  budget_ =
      static_cast<int>(std::min(least_budget_ * parts, settings::rest_thresholds.most_budget));
  spent_ = 0;
  meetings_ = 0;
  were_over_budget_ = memory_.over_budget;
  memory_.over_budget = budget_ > 0 ? BodySet{} : ~BodySet{};
  all_impacts_ = 0;
  last_impact_ = 0.0;
  min_duration_ = tolerances_.min_contact_duration;
}

void RestThresholds::end_tick(double duration) {
  for (int i = 0; i < memory_.count; ++i) memory_.touched[i].time -= duration;
}

void RestThresholds::drop_touched_before(double t) {
  const auto begin = memory_.touched.begin();
  const auto end = std::remove_if(begin, begin + memory_.count,
                                  [t](const Touched& known) { return known.time < t; });
  memory_.count = static_cast<int>(end - begin);
}

void RestThresholds::note_impact(double t) {
  ++all_impacts_;
  last_impact_ = t;
}

int RestThresholds::find(const collision::Contact& contact) const {
  const Touched key = touched_of(contact);
  const auto end = memory_.touched.begin() + memory_.count;
  const auto known = std::find_if(memory_.touched.begin(), end, [&](const Touched& other) {
    return other.a == key.a && other.partner == key.partner && other.corner == key.corner &&
           other.point_on_a == key.point_on_a;
  });
  return static_cast<int>(known - memory_.touched.begin());
}

// If the list is full, the contact stays unknown: its next approach bounces.
void RestThresholds::note_contact(const collision::Contact& contact,
                                  std::span<const solver::InverseMass> mass, double t) {
  const int most = static_cast<int>(memory_.touched.size());
  int i = find(contact);
  if (i == most) {
    drop_touched_before(t - settings::rest_thresholds.contact_memory);
    i = memory_.count;
    if (i == most) return;
  }
  Touched& known = memory_.touched[i];
  if (i == memory_.count) {
    known = touched_of(contact);
    ++memory_.count;
  }
  known.pressing =
      contact.resting.is_active
          ? contact.resting.force * collision::inverse_effective_mass(contact.row, mass)
          : 0.0;
  known.time = t;
  if (contact.impact.impulse != 0.0 && contact.impact.approach > 0.0)
    known.approach = contact.impact.approach;
}

double RestThresholds::restitution_threshold(const collision::Contact& contact, double t) const {
  const int i = find(contact);
  const Touched& known = memory_.touched[i < memory_.count ? i : 0];
  if (i == memory_.count || t - known.time > settings::rest_thresholds.contact_memory)
    return tolerances_.first_touch_threshold;
  const double e = contact.material.restitution;
  const double height = (1.0 - e) / (e * e) * tolerances_.series_height;
  if (known.pressing > 0.0)
    return std::max(tolerances_.pressing_threshold, std::sqrt(2.0 * known.pressing * height));
  const double of_series =
      (e + settings::rest_thresholds.series_margin * (1.0 - e)) * known.approach;
  const double flight = t - known.time;
  const bool is_low = of_series * flight < 4.0 * height;
  return std::max(tolerances_.first_touch_threshold,
                  is_low ? std::min(of_series, settings::rest_thresholds.max_acceleration * flight)
                         : 4.0 * height / std::max(flight, 1e-300));
}

void RestThresholds::note_event(const BodySet& involved, bool was_forced) {
  const int bodies = static_cast<int>(involved.count());
  spent_ += cost_of_event(bodies);
  if (bodies > 1) ++meetings_;
  if (spent_ >= budget_ || meetings_ * cost_of_meeting_ >= budget_) {
    memory_.over_budget |= involved;
  } else if (spent_ >= budget_ / settings::rest_thresholds.budget_divisor) {
    memory_.over_budget |= involved & were_over_budget_;
  }
  if (!was_forced) return;
  min_duration_ = std::min(min_duration_ * settings::rest_thresholds.forced_growth,
                           settings::rest_thresholds.max_min_duration);
}

void RestThresholds::note_island(const BodySet& island) {
  const bool is_large = static_cast<int>(island.count()) >= settings::rest_thresholds.large_island;
  if (is_large && (island & were_over_budget_).any()) memory_.over_budget |= island;
}

double RestThresholds::preferred_duration(double t) const {
  if (all_impacts_ == 0) return trajectory::never;
  return settings::rest_thresholds.times_between_impacts *
         std::max(t / all_impacts_, t - last_impact_);
}

}  // namespace mirocup::simulator::impact
