// SPDX-License-Identifier: MIT
#include "core/simulator/step_paths.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator {

namespace {

// Of what two may overlap within a step: as much is not worth a bend.
constexpr double not_worth_a_bend = 0.25;
// Farther, m, nobody is taken beside the arc: it would be at another speed than its twist says.
constexpr double most_bend = 2e-5;

// The next step is so long that it should overlap by this share of what it may, and grows by no more
// than that.
constexpr double cautious = 0.8;
constexpr double step_growth = 2.0;

}  // namespace

Body along_bent_arc(const Body& begin, const Vec2& bend, double length, double span) {
  Body body = along_arc(begin, span);
  const double part = span / length;
  body.position += (4.0 * part * (1.0 - part)) * bend;
  return body;
}

Segment bent_segment(const Body& now, const Vec2& bend, double step_begin, double begin,
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
  for (int i = 0; i < arena.bodies(); ++i) {
    shifted_[i] = arena.is_ball(i) ? arena.ball : arena.free_robot;
    shifted_[i].turn = 0.0;
  }
}

bool StepPaths::is_clear(const Step& step) {
  return std::none_of(step.contacts.begin(), step.contacts.end(), [&](const Contact& c) {
    return c.impulse == 0.0 && passes_through(step, c);
  });
}

// Only what opens at the end, and was not as far apart at the begin as that says, is worth a search.
bool StepPaths::passes_through(const Step& step, const Contact& c) {
  if (c.at.gap >= gap_rate(c, step.end) * step.length) return false;
  const auto presses = [&](const Contact& other) {
    return other.impulse != 0.0 && other.pair == c.pair;
  };
  if (std::any_of(step.contacts.begin(), step.contacts.end(), presses)) return false;
  for (const int i : {c.a, c.b}) {
    if (i != no_body) arcs_[i] = steady_segment(step.begin[i], 0.0, step.length);
  }
  const double overlaps =
      first_time_below(arena_, c.pair, -arena_.tolerances.overlap_within_step, arcs_, 0.0);
  return overlaps > 0.0 && overlaps != never;
}

double StepPaths::bend(const Step& step) {
  is_bent_ = false;
  for (int i = 0; i < arena_.bodies(); ++i) {
    if (step.members[i]) bend_[i] = {0.0, 0.0};
  }
  near_count_ = 0;
  for (const Contact& c : step.contacts) {
    if (c.impulse != 0.0) near_[near_count_++] = &c;
  }
  const double deepest = overlap_at(step, 0.5);
  const double most = arena_.tolerances.overlap_within_step;
  if (deepest <= not_worth_a_bend * most || deepest > most_bend) return deepest;
  push_middle_apart(step, 2.0 * deepest);
  is_bent_ = true;
  return std::max(overlap_at(step, 0.25), overlap_at(step, 0.75));
}

double StepPaths::next_length(const Step& step, double overlap) const {
  const double most = arena_.tolerances.overlap_within_step;
  const double ratio = cautious * (overlap > most_bend ? most_bend : most) / overlap;
  const double longer = is_bent_ ? std::cbrt(ratio) : std::sqrt(ratio);
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
    if (-line_gap_there(*near_[i]) > deepest) deepest = std::max(deepest, -gap_there(*near_[i]));
  }
  return deepest;
}

// Of the corner to the line along the edge.
double StepPaths::line_gap_there(const Contact& c) const {
  ContactPoint at = c.at;
  look_again(arena_, there_, c.pair, at);
  return at.gap;
}

// A corner that is still beside the edge is behind its line, and overlaps nothing.
double StepPaths::gap_there(const Contact& c) const {
  const double line_gap = line_gap_there(c);
  if (line_gap > -arena_.tolerances.overlap_within_step) return line_gap;
  const Body& other = there_[c.pair.with_obstacle() ? c.pair.a : c.pair.partner];
  return std::max(line_gap, gap(arena_, c.pair, there_[c.pair.a], other));
}

// The middle is where there_ is. What is farther than `reach` (m) from touching stays out of it.
void StepPaths::push_middle_apart(const Step& step, double reach) {
  problem_.reset(shifted_);
  near_count_ = 0;
  for (const Contact& c : step.contacts) {
    const double apart = gap_there(c);
    if (apart > reach) continue;
    problem_.add(row_of(c));
    problem_.b[near_count_] = apart;
    problem_.x[near_count_] = 0.0;
    near_[near_count_++] = &c;
  }
  problem_.solve();
  std::array<Twist, max_bodies> shift{};
  for (int i = 0; i < near_count_; ++i) {
    const Contact& c = *near_[i];
    const double amount = problem_.x[i];
    if (amount == 0.0) continue;
    if (c.a != no_body) add_impulse(c.row_a, amount, shifted_[c.a], shift[c.a]);
    if (c.b != no_body) add_impulse(c.row_b, -amount, shifted_[c.b], shift[c.b]);
  }
  for (int k = 0; k < arena_.bodies(); ++k) {
    if (step.members[k]) {
      bend_[k] = there_[k].heading.to_world({shift[k].forward, shift[k].left});
    }
  }
}

}  // namespace mirocup::simulator
