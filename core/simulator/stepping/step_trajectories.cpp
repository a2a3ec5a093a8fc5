// SPDX-License-Identifier: MIT
#include "core/simulator/stepping/step_trajectories.hpp"

#include "core/base/assert.hpp"
#include "core/simulator/impact/position_correction.hpp"
#include "core/simulator/model/solver_settings.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator::stepping {

namespace {

bool any_presses(std::span<const collision::Contact> contacts) {
  return std::any_of(contacts.begin(), contacts.end(),
                     [](const collision::Contact& c) { return c.impact.impulse != 0.0; });
}

// True if a contact of the pair was behind its reference edge at the start of the step by more than
// `tolerance`, m. If the pair presses, only its pressing contacts count.
bool was_behind_edge(const StepTrajectories::Step& step,
                     std::span<const collision::Contact> contacts, bool presses, double tolerance) {
  return std::any_of(contacts.begin(), contacts.end(), [&](const collision::Contact& c) {
    if (presses && c.impact.impulse == 0.0) return false;
    // The gap at the start is the gap at the end minus its change.
    return c.point.gap < collision::row_rate(c.row, step.end) * step.length - tolerance;
  });
}

}  // namespace

// The correction is multiplied by the parabola 4 s (1 - s) of the share s of the step.
BodyState along_corrected_arc(const BodyState& start, const Vec2& correction, double length,
                              double span) {
  BodyState body = trajectory::along_arc(start, span);
  const double share = span / length;
  body.position += (4.0 * share * (1.0 - share)) * correction;
  return body;
}

trajectory::MotionBound bound_of_corrected_arc(const BodyState& start, const Vec2& end,
                                               const Vec2& correction, double t, double length) {
  const Twist& v = start.twist;
  const double speed = std::sqrt(v.forward * v.forward + v.left * v.left);
  // The second derivative of the parabola is constant: 8 correction / length^2.
  const double parabola = 8.0 * std::sqrt(correction.squaredNorm()) / (length * length);
  return trajectory::bound_between(start.position, end, t, length,
                                   speed * std::abs(v.omega) + parabola, std::abs(v.omega));
}

trajectory::Segment corrected_segment(const BodyState& now, const Vec2& correction,
                                      double step_start, double begin, double end) {
  trajectory::Segment s = trajectory::steady_segment(now, begin, end);
  // The parabola in powers of the time from `begin` on; its value there is in `now` already.
  const double length = end - step_start;
  const double speed = 4.0 * (1.0 - 2.0 * (begin - step_start) / length) / length;
  const double half_acceleration = -4.0 / (length * length);
  s.x[1] += speed * correction.x();
  s.y[1] += speed * correction.y();
  s.x[2] += half_acceleration * correction.x();
  s.y[2] += half_acceleration * correction.y();
  return s;
}

StepTrajectories::StepTrajectories(const collision::StaticWorld& world,
                                   solver::RegularizedQp& problem)
    : world_(world), qp_(problem), arcs_(max_bodies) {
  correction_.fill({0.0, 0.0});
  for (int i = 0; i < world.bodies(); ++i) {
    translation_mass_[i] = world.is_ball(i) ? world.ball : world.free_robot;
    translation_mass_[i].omega = 0.0;
  }
}

bool StepTrajectories::is_clear(const Step& step) {
  static_assert(std::tuple_size_v<decltype(near_contacts_)> >=
                std::tuple_size_v<decltype(collision::ContactList::list)>);
  spoil(largest_correction_, sampled_, near_contacts_);
  near_contact_count_ = 0;
  bool clear = true;
  for_each_pair(step.contacts, [&](std::span<const collision::Contact> contacts) {
    const Pair& pair = contacts.front().pair;
    const bool presses = any_presses(contacts);
    const bool was_behind = was_behind_edge(step, contacts, presses, world_.tolerances.step_gap);
    const bool nearly_touched =
        was_behind && gap(world_, pair, step.start) <= settings::step_trajectories.max_correction;
    if (was_behind && !nearly_touched) clear = clear && !tunnels(step, pair);
    if (!presses && !nearly_touched) return;
    for (const collision::Contact& c : contacts) near_contacts_[near_contact_count_++] = &c;
  });
  return clear;
}

// True if the pair, apart at the start of the step, overlaps inside it. The arcs are those without
// corrections.
bool StepTrajectories::tunnels(const Step& step, const Pair& pair) {
  for_each_body(bodies_of(pair), [&](int i) {
    arcs_[i] = trajectory::steady_segment(step.start[i], 0.0, step.length);
  });
  const double first_overlap =
      first_time_below(world_, pair, -world_.tolerances.intermediate_penetration, arcs_, 0.0);
  return first_overlap > 0.0 && first_overlap != trajectory::never;
}

void StepTrajectories::clear_corrections(const BodySet& members) {
  is_corrected_ = false;
  for (int i = 0; i < world_.bodies(); ++i) {
    if (members[i]) correction_[i] = {0.0, 0.0};
  }
}

double StepTrajectories::correct_middle(const Step& step) {
  const double deepest = overlap_at(step, 0.5);
  largest_correction_ = deepest;
  const bool is_negligible = deepest <= settings::step_trajectories.min_correction_share *
                                            world_.tolerances.intermediate_penetration;
  if (is_negligible || deepest > settings::step_trajectories.max_correction) return deepest;
  largest_correction_ = project_middle(step);
  if (largest_correction_ > settings::step_trajectories.max_correction) {
    clear_corrections(step.members);
    return deepest;
  }
  is_corrected_ = true;
  return std::max({overlap_at(step, 0.25), overlap_at(step, 0.5), overlap_at(step, 0.75)});
}

// The overlap is a power of the step's length, so the permitted overlap gives the length. Where a
// ratio of lengths is a cube root, square roots bound it from below: they are the same bits on
// every computer, and a shorter step does no harm.
double StepTrajectories::next_length(const Step& step, double overlap) const {
  const double permitted = world_.tolerances.intermediate_penetration;
  const double safety = settings::step_trajectories.length_safety;
  // Without corrections the overlap is of second order. Corrections can take away max_correction.
  double ratio =
      std::sqrt(safety * std::max(permitted, settings::step_trajectories.max_correction) /
                largest_correction_);
  if (is_corrected_) {
    // With corrections it is of third order: the ratio of lengths is the cube root of `square`^2.
    const double square = std::sqrt(safety * permitted / overlap);
    ratio = std::min(ratio, square > 1.0 ? std::sqrt(square) : square);
  }
  return step.length * std::min(settings::step_trajectories.max_growth, ratio);
}

// Samples the members at this share of the step. Returns the deepest overlap of the near
// contacts, m.
double StepTrajectories::overlap_at(const Step& step, double share) {
  const double span = share * step.length;
  for (int i = 0; i < world_.bodies(); ++i) {
    if (step.members[i])
      sampled_[i] = along_corrected_arc(step.start[i], correction_[i], step.length, span);
  }
  double deepest = 0.0;
  for (int i = 0; i < near_contact_count_; ++i) {
    deepest = std::max(deepest, -sampled_gap(*near_contacts_[i]));
  }
  return deepest;
}

// Returns the gap of a contact where the bodies were sampled last, m. It is clamped because a
// corner that is still beside its edge lies behind the edge's line without overlapping.
double StepTrajectories::sampled_gap(const collision::Contact& c) const {
  return clamped_gap(world_, sampled_, c, world_.tolerances.intermediate_penetration);
}

// Sets the corrections to the smallest displacements, weighted by mass, that leave no overlap in
// the middle of the step, where overlap_at() has sampled the members. Contacts further apart than
// any correction constrain nothing. Returns the largest correction, m.
double StepTrajectories::project_middle(const Step& step) {
  qp_.reset(translation_mass_);
  near_contact_count_ = 0;
  for (const collision::Contact& c : step.contacts) {
    const double apart = sampled_gap(c);
    if (apart > settings::step_trajectories.max_correction) continue;
    qp_.add(c.row);
    qp_.b[near_contact_count_] = apart;
    near_contacts_[near_contact_count_++] = &c;
  }
  qp_.solve(settings::step_trajectories.correction_tolerance);
  std::array<impact::Displacement, max_bodies> displacements{};
  for (int i = 0; i < near_contact_count_; ++i) {
    if (qp_.x[i] != 0.0)
      impact::add_displacement(near_contacts_[i]->row, qp_.x[i], translation_mass_, displacements);
  }
  double largest = 0.0;
  for (int i = 0; i < world_.bodies(); ++i) {
    if (!step.members[i]) continue;
    correction_[i] =
        sampled_[i].heading.to_world({displacements[i].forward, displacements[i].left});
    largest = std::max(largest, correction_[i].norm());
  }
  return largest;
}

}  // namespace mirocup::simulator::stepping
