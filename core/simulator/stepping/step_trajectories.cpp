// SPDX-License-Identifier: MIT
#include "core/simulator/stepping/step_trajectories.hpp"

#include "core/simulator/impact/position_correction.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator::stepping {

namespace {

// Of what two may overlap within a step: as much is not worth a bend.
constexpr double min_correction_share = 0.25;
// Farther, m, nobody is taken beside the arc: it would be at another speed than its twist says.
constexpr double max_correction = 2e-5;
// How close what bends an arc has to be, as a share of the largest overlap.
constexpr double correction_tolerance = 1e-3;

// The next step is so long that it should overlap by this share of what it may, and grows by no more
// than that.
constexpr double length_safety = 0.8;
constexpr double step_growth = 2.0;

bool any_presses(std::span<const collision::Contact> contacts) {
  return std::any_of(contacts.begin(), contacts.end(),
                     [](const collision::Contact& c) { return c.impact.impulse != 0.0; });
}

// Was a corner of the pair, one that presses if any does, behind its edge when the step began, by more
// than what counts as touching?
bool was_behind_edge(const StepTrajectories::Step& step,
                     std::span<const collision::Contact> contacts, bool presses, double touch) {
  return std::any_of(contacts.begin(), contacts.end(), [&](const collision::Contact& c) {
    if (presses && c.impact.impulse == 0.0) return false;
    return c.point.gap < collision::row_rate(c.row, step.end) * step.length - touch;
  });
}

}  // namespace

BodyState along_corrected_arc(const BodyState& begin, const Vec2& correction, double length,
                              double span) {
  BodyState body = trajectory::along_arc(begin, span);
  const double part = span / length;
  body.position += (4.0 * part * (1.0 - part)) * correction;
  return body;
}

trajectory::MotionBound bound_of_corrected_arc(const BodyState& begin, const Vec2& end,
                                               const Vec2& correction, double t, double length) {
  const Twist& v = begin.twist;
  const double speed = std::sqrt(v.forward * v.forward + v.left * v.left);
  const double off_diagonal = 8.0 * std::sqrt(correction.squaredNorm()) / (length * length);
  return trajectory::bound_between(begin.position, end, t, length,
                                   speed * std::abs(v.omega) + off_diagonal, std::abs(v.omega));
}

trajectory::Segment corrected_segment(const BodyState& now, const Vec2& correction,
                                      double step_begin, double begin, double end) {
  trajectory::Segment s = trajectory::steady_segment(now, begin, end);
  const double length = end - step_begin;
  const double speed = 4.0 * (1.0 - 2.0 * (begin - step_begin) / length) / length;
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
  near_contact_count_ = 0;
  bool clear = true;
  for_each_pair(step.contacts, [&](std::span<const collision::Contact> contacts) {
    const bool presses = any_presses(contacts);
    const Pair& pair = contacts.front().pair;
    bool is_near = presses;
    if (was_behind_edge(step, contacts, presses, world_.tolerances.step_gap)) {
      is_near = gap(world_, pair, step.begin) <= max_correction;
      clear = clear && (is_near || !tunnels(step, pair));
    }
    if (!is_near && !presses) return;
    for (const collision::Contact& c : contacts) near_contacts_[near_contact_count_++] = &c;
  });
  return clear;
}

bool StepTrajectories::tunnels(const Step& step, const Pair& pair) {
  for_each_body(bodies_of(pair), [&](int i) {
    arcs_[i] = trajectory::steady_segment(step.begin[i], 0.0, step.length);
  });
  const double overlaps =
      first_time_below(world_, pair, -world_.tolerances.intermediate_penetration, arcs_, 0.0);
  return overlaps > 0.0 && overlaps != trajectory::never;
}

void StepTrajectories::clear_corrections(const BodySet& members) {
  is_corrected_ = false;
  for (int i = 0; i < world_.bodies(); ++i) {
    if (members[i]) correction_[i] = {0.0, 0.0};
  }
}

double StepTrajectories::correct_middle(const Step& step) {
  const double deepest = overlap_at(step, 0.5);
  const double most = world_.tolerances.intermediate_penetration;
  largest_correction_ = deepest;
  if (deepest <= min_correction_share * most || deepest > max_correction) return deepest;
  largest_correction_ = project_middle(step);
  if (largest_correction_ > max_correction) {
    clear_corrections(step.members);
    return deepest;
  }
  is_corrected_ = true;
  return std::max({overlap_at(step, 0.25), overlap_at(step, 0.5), overlap_at(step, 0.75)});
}

double StepTrajectories::next_length(const Step& step, double overlap) const {
  const double most = world_.tolerances.intermediate_penetration;
  // What would overlap without bends grows with the step's square,
  double longer = std::sqrt(length_safety * std::max(most, max_correction) / largest_correction_);
  if (is_corrected_) {
    // what overlaps with them, with its cube: never longer than its root says.
    const double root = std::sqrt(length_safety * most / overlap);
    longer = std::min(longer, root > 1.0 ? std::sqrt(root) : root);
  }
  return step.length * std::min(step_growth, longer);
}

// How deep two overlap then, of those with a contact that is near.
double StepTrajectories::overlap_at(const Step& step, double part) {
  const double span = part * step.length;
  for (int i = 0; i < world_.bodies(); ++i) {
    if (step.members[i])
      sampled_[i] = along_corrected_arc(step.begin[i], correction_[i], step.length, span);
  }
  double deepest = 0.0;
  for (int i = 0; i < near_contact_count_; ++i) {
    deepest = std::max(deepest, -sampled_gap(*near_contacts_[i]));
  }
  return deepest;
}

// A corner that is still beside the edge is behind its line, and overlaps nothing.
double StepTrajectories::sampled_gap(const collision::Contact& c) const {
  return clamped_gap(world_, sampled_, c, world_.tolerances.intermediate_penetration);
}

// The middle is where sampled_ is. What is farther from touching than anybody is taken stays out of it.
// Returns how far the farthest is, m.
double StepTrajectories::project_middle(const Step& step) {
  qp_.reset(translation_mass_);
  near_contact_count_ = 0;
  for (const collision::Contact& c : step.contacts) {
    const double apart = sampled_gap(c);
    if (apart > max_correction) continue;
    qp_.add(c.row);
    qp_.b[near_contact_count_] = apart;
    near_contacts_[near_contact_count_++] = &c;
  }
  qp_.solve(correction_tolerance);
  std::array<impact::Displacement, max_bodies> displacements{};
  for (int i = 0; i < near_contact_count_; ++i) {
    if (qp_.x[i] != 0.0)
      impact::add_displacement(near_contacts_[i]->row, qp_.x[i], translation_mass_, displacements);
  }
  double farthest = 0.0;
  for (int i = 0; i < world_.bodies(); ++i) {
    if (!step.members[i]) continue;
    correction_[i] =
        sampled_[i].heading.to_world({displacements[i].forward, displacements[i].left});
    farthest = std::max(farthest, correction_[i].norm());
  }
  return farthest;
}

}  // namespace mirocup::simulator::stepping
