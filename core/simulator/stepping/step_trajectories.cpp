// SPDX-License-Identifier: MIT
#include "core/simulator/stepping/step_trajectories.hpp"

#include "core/simulator/impact/position_correction.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator {

namespace {

// Of what two may overlap within a step: as much is not worth a bend.
constexpr double not_worth_a_bend = 0.25;
// Farther, m, nobody is taken beside the arc: it would be at another speed than its twist says.
constexpr double most_bend = 2e-5;
// How close what bends an arc has to be, as a share of the largest overlap.
constexpr double bent_enough = 1e-3;

// The next step is so long that it should overlap by this share of what it may, and grows by no more
// than that.
constexpr double cautious = 0.8;
constexpr double step_growth = 2.0;

bool do_press(std::span<const Contact> contacts) {
  return std::any_of(contacts.begin(), contacts.end(),
                     [](const Contact& c) { return c.impact.impulse != 0.0; });
}

// Was a corner of the pair, one that presses if any does, behind its edge when the step began, by more
// than what counts as touching?
bool came_from_behind(const StepPaths::Step& step, std::span<const Contact> contacts, bool presses,
                      double touch) {
  return std::any_of(contacts.begin(), contacts.end(), [&](const Contact& c) {
    if (presses && c.impact.impulse == 0.0) return false;
    return c.point.gap < row_rate(c.row, step.end) * step.length - touch;
  });
}

}  // namespace

BodyState along_bent_arc(const BodyState& begin, const Vec2& bend, double length, double span) {
  BodyState body = along_arc(begin, span);
  const double part = span / length;
  body.position += (4.0 * part * (1.0 - part)) * bend;
  return body;
}

Way way_along_bent_arc(const BodyState& begin, const Vec2& end, const Vec2& bend, double t,
                       double length) {
  const Twist& v = begin.twist;
  const double speed = std::sqrt(v.forward * v.forward + v.left * v.left);
  const double beside = 8.0 * std::sqrt(bend.squaredNorm()) / (length * length);
  return way_between(begin.position, end, t, length, speed * std::abs(v.turn) + beside,
                     std::abs(v.turn));
}

Segment bent_segment(const BodyState& now, const Vec2& bend, double step_begin, double begin,
                     double end) {
  Segment s = steady_segment(now, begin, end);
  const double length = end - step_begin;
  const double speed = 4.0 * (1.0 - 2.0 * (begin - step_begin) / length) / length;
  const double half_acceleration = -4.0 / (length * length);
  s.x[1] += speed * bend.x();
  s.y[1] += speed * bend.y();
  s.x[2] += half_acceleration * bend.x();
  s.y[2] += half_acceleration * bend.y();
  return s;
}

StepPaths::StepPaths(const Arena& arena, SoftProblem& problem)
    : arena_(arena), problem_(problem), arcs_(max_bodies) {
  bend_.fill({0.0, 0.0});
  for (int i = 0; i < arena.bodies(); ++i) {
    shifted_[i] = arena.is_ball(i) ? arena.ball : arena.free_robot;
    shifted_[i].turn = 0.0;
  }
}

bool StepPaths::is_clear(const Step& step) {
  near_count_ = 0;
  bool clear = true;
  for_each_pair(step.contacts, [&](std::span<const Contact> contacts) {
    const bool presses = do_press(contacts);
    const Pair& pair = contacts.front().pair;
    bool is_near = presses;
    if (came_from_behind(step, contacts, presses, arena_.tolerances.step_touch)) {
      is_near = gap(arena_, pair, step.begin) <= most_bend;
      clear = clear && (is_near || !passes_through(step, pair));
    }
    if (!is_near && !presses) return;
    for (const Contact& c : contacts) near_[near_count_++] = &c;
  });
  return clear;
}

bool StepPaths::passes_through(const Step& step, const Pair& pair) {
  for_each_body(bodies_of(pair),
                [&](int i) { arcs_[i] = steady_segment(step.begin[i], 0.0, step.length); });
  const double overlaps =
      first_time_below(arena_, pair, -arena_.tolerances.overlap_within_step, arcs_, 0.0);
  return overlaps > 0.0 && overlaps != never;
}

void StepPaths::straighten(const BodySet& members) {
  is_bent_ = false;
  for (int i = 0; i < arena_.bodies(); ++i) {
    if (members[i]) bend_[i] = {0.0, 0.0};
  }
}

double StepPaths::bend(const Step& step) {
  const double deepest = overlap_at(step, 0.5);
  const double most = arena_.tolerances.overlap_within_step;
  farthest_ = deepest;
  if (deepest <= not_worth_a_bend * most || deepest > most_bend) return deepest;
  farthest_ = push_middle_apart(step);
  if (farthest_ > most_bend) {
    straighten(step.members);
    return deepest;
  }
  is_bent_ = true;
  return std::max({overlap_at(step, 0.25), overlap_at(step, 0.5), overlap_at(step, 0.75)});
}

double StepPaths::next_length(const Step& step, double overlap) const {
  const double most = arena_.tolerances.overlap_within_step;
  // What would overlap without bends grows with the step's square,
  double longer = std::sqrt(cautious * std::max(most, most_bend) / farthest_);
  if (is_bent_) {
    // what overlaps with them, with its cube: never longer than its root says.
    const double root = std::sqrt(cautious * most / overlap);
    longer = std::min(longer, root > 1.0 ? std::sqrt(root) : root);
  }
  return step.length * std::min(step_growth, longer);
}

// How deep two overlap then, of those with a contact that is near.
double StepPaths::overlap_at(const Step& step, double part) {
  const double span = part * step.length;
  for (int i = 0; i < arena_.bodies(); ++i) {
    if (step.members[i]) there_[i] = along_bent_arc(step.begin[i], bend_[i], step.length, span);
  }
  double deepest = 0.0;
  for (int i = 0; i < near_count_; ++i) {
    deepest = std::max(deepest, -gap_there(*near_[i]));
  }
  return deepest;
}

// A corner that is still beside the edge is behind its line, and overlaps nothing.
double StepPaths::gap_there(const Contact& c) const {
  return gap_beyond(arena_, there_, c, arena_.tolerances.overlap_within_step);
}

// The middle is where there_ is. What is farther from touching than anybody is taken stays out of it.
// Returns how far the farthest is, m.
double StepPaths::push_middle_apart(const Step& step) {
  problem_.reset(shifted_);
  near_count_ = 0;
  for (const Contact& c : step.contacts) {
    const double apart = gap_there(c);
    if (apart > most_bend) continue;
    problem_.add(c.row);
    problem_.b[near_count_] = apart;
    near_[near_count_++] = &c;
  }
  problem_.solve(bent_enough);
  std::array<Shift, max_bodies> shifts{};
  for (int i = 0; i < near_count_; ++i) {
    if (problem_.x[i] != 0.0) add_shift(near_[i]->row, problem_.x[i], shifted_, shifts);
  }
  double farthest = 0.0;
  for (int i = 0; i < arena_.bodies(); ++i) {
    if (!step.members[i]) continue;
    bend_[i] = there_[i].heading.to_world({shifts[i].forward, shifts[i].left});
    farthest = std::max(farthest, bend_[i].norm());
  }
  return farthest;
}

}  // namespace mirocup::simulator
