// SPDX-License-Identifier: MIT
#include "core/simulator/stepping/time_stepper.hpp"

#include "core/base/math.hpp"
#include "core/simulator/collision/broad_phase.hpp"
#include "core/simulator/collision/reference_edges.hpp"
#include "core/simulator/impact/islands.hpp"
#include "core/simulator/trajectory/rolling_ball.hpp"

#include <algorithm>
#include <bitset>
#include <cmath>

namespace mirocup::simulator {

namespace {

constexpr double radii_a_step = 0.5;
// So many times as far is taken where it turns out only at the end of a step.
constexpr double too_far = 1.5;

// Looks at the end of a step, and times that it is halved, before what is found there is taken.
constexpr int most_looks = 10;
// How close impulses have to be for a look, as a share of the largest relative velocity.
constexpr double close_enough = 1e-9;
// Contacts may contradict each other by a hair; then it is not for more looks to find an end.
constexpr int patient_looks = 4;
constexpr int most_halvings = 6;

// Overlaps at the begin of a step are not undone faster than that, m/s, unless the step is so long that
// it undoes as much, m, anyway.
constexpr double fastest_undoing = 2e-4;
constexpr double undone_at_once = 1e-7;

// The force of wheels is remembered a hair larger, lest rounding takes what was at its bound off it.
constexpr double above_rounding = 1.0 + 1e-12;
// As many steps as fit into a time exactly are not one more.
constexpr double below_rounding = 1.0 - 1e-9;

// No next step is judged to be shorter, as a share of the longest one; and one for which less than this
// share of its time was left says little about the next.
constexpr double shortest_step = 1.0 / 64.0;
constexpr double crumb = 0.5;

// Rounds in which the bounds of friction follow the normal impulses.
constexpr int friction_rounds = 10;

// The twist after a step without any contact and without the ground's sideways force.
Twist driven(const Parameters& p, const Drive& drive, const Twist& v, double step) {
  // The frame turns; the velocity does not, unless wheels that roll turn it.
  const Heading turned = Heading::from_angle(v.turn * step);
  const bool rolls = std::abs(v.left) <= no_sliding;
  const Vec2 kept =
      rolls ? Vec2{v.forward, -v.forward * turned.sin} : turned.to_body({v.forward, v.left});
  Twist next{kept.x(), kept.y(), v.turn};
  if (!drive.wheels_on_ground) return next;
  const double reached = -expm1(-step / p.motor_time_constant);
  next.forward += reached * (drive.forward - v.forward);
  next.turn += reached * (drive.turn - v.turn);
  if (p.grip == infinite_grip) next.left = 0.0;
  return next;
}

Twist braked(const Parameters& p, const Twist& v, double step) {
  const RollingDeceleration d = rolling_deceleration(p);
  const auto part_left = [&](double speed) {
    return speed == 0.0 ? 1.0 : std::max(0.0, 1.0 - step * (d.constant / speed + d.linear));
  };
  if (d.is_per_axis()) {
    return {v.forward * part_left(std::max(std::abs(v.forward), d.per_axis_below)),
            v.left * part_left(std::max(std::abs(v.left), d.per_axis_below)), 0.0};
  }
  const double left = part_left(std::sqrt(v.forward * v.forward + v.left * v.left));
  return {v.forward * left, v.left * left, 0.0};
}

bool is_same_place(const ContactPoint& p, const ContactPoint& q) {
  return p.kind == q.kind && p.point_on_a == q.point_on_a && p.corner == q.corner &&
         p.edge == q.edge;
}

// No point of the body is faster, m/s.
double speed_at_most(const geometry::Outline& shape, const Twist& v) {
  return std::abs(v.forward) + std::abs(v.left) + std::abs(v.turn) * shape.radius;
}

// The fastest that a point of some body is with the twist that twist_of(body) says, m/s.
template <class TwistOf>
double fastest_point(const Arena& arena, const BodySet& some, TwistOf twist_of) {
  double fastest = 0.0;
  for_each_body(some, [&](int i) {
    fastest = std::max(fastest, speed_at_most(arena.shape(i), twist_of(i)));
  });
  return fastest;
}

}  // namespace

ContactStepping::ContactStepping(const Arena& arena, SoftProblem& problem)
    : arena_(arena), problem_(problem), paths_(arena, problem) {
  forget();
  for (int i = 0; i < arena.robots; ++i) wheel_rows_[i] = lateral_wheel_row(i);
}

ContactStepping::Step ContactStepping::take(const BodySet& candidates,
                                            std::span<const Contact> touching,
                                            std::span<const Drive> drives,
                                            std::span<const InverseMass> mass, double longest,
                                            std::span<BodyState> bodies) {
  const double length = std::min(longest_step(candidates, bodies), next_step(candidates));
  double parts = std::ceil(longest / length * below_rounding);
  Step step;
  for (int halved = 0; halved <= most_halvings; ++halved, parts *= 2.0) {
    if (find(candidates, touching, drives, mass, longest / parts, bodies, step)) break;
  }
  for (int i = 0; i < arena_.bodies(); ++i) {
    if (!step.members[i]) continue;
    before_[i] = bodies[i].twist;
    bodies[i].twist = end_[i].twist;
  }
  stepped_ |= step.members;
  const double next = longest < crumb * length ? std::max(length, next_) : next_;
  for (int i = 0; i < arena_.bodies(); ++i) {
    if (step.members[i]) next_step_[i] = std::max(next, shortest_step * arena_.tolerances.step);
  }
  keep_what_presses(step);
  return step;
}

Twist ContactStepping::twist_after(int member, const Twist& kept, double part) const {
  const Twist& v = before_[member];
  return {v.forward + part * (kept.forward - v.forward), v.left + part * (kept.left - v.left),
          v.turn + part * (kept.turn - v.turn)};
}

void ContactStepping::keep_what_presses(const Step& step) {
  const auto last = std::remove_if(
      pressed_.begin(), pressed_.begin() + pressed_count_,
      [&](const Pressed& known) { return (bodies_of(known.pair) & step.members).any(); });
  pressed_count_ = static_cast<int>(last - pressed_.begin());
  contacts_.keep_if([](const Contact& c) { return c.impact.impulse != 0.0; });
  for (Contact& c : contacts_.contacts()) {
    c.resting = {.is_active = true, .force = c.impact.impulse / step.length};
    if (pressed_count_ == max_unknowns) continue;
    pressed_[pressed_count_++] = {
        .pair = c.pair, .point = c.point, .force = c.resting.force, .impulse = c.impact.impulse};
  }
  for (int i = 0; i < arena_.robots; ++i) {
    if (step.members[i]) wheel_force_[i] = wheel_impulse_[i] / step.length;
  }
}

void ContactStepping::forget() {
  pressed_count_ = 0;
  wheel_force_.fill(0.0);
  next_step_.fill(infinity);
}

void ContactStepping::begin_tick() {
  for (int i = 0; i < arena_.bodies(); ++i) {
    if (!stepped_[i]) next_step_[i] = infinity;
  }
  stepped_.reset();
}

// The impulses of a step like the last one.
void ContactStepping::recall(const BodySet& members, double length) {
  int next = 0;
  for (Contact& c : contacts_.contacts()) {
    c.impact.impulse = 0.0;
    for (int tried = 0; tried < pressed_count_; ++tried) {
      const Pressed& known = pressed_[next];
      next = next + 1 == pressed_count_ ? 0 : next + 1;
      if (!(known.pair == c.pair) || !is_same_place(known.point, c.point)) continue;
      c.impact.impulse = std::min(known.force * length, known.impulse);
      break;
    }
  }
  for (int i = 0; i < arena_.robots; ++i) {
    if (members[i]) wheel_impulse_[i] = wheel_force_[i] * length * above_rounding;
  }
}

double ContactStepping::fastest_of(const BodySet& some, std::span<const BodyState> bodies) const {
  return fastest_point(arena_, some, [&](int i) { return bodies[i].twist; });
}

// Nobody goes farther than half the ball's radius from where all of them go in a step: it would be seen
// behind what it hit.
double ContactStepping::longest_step(const BodySet& some, std::span<const BodyState> bodies) const {
  Vec2 common{0.0, 0.0};
  for_each_body(some, [&](int i) { common += bodies[i].velocity(); });
  common /= static_cast<double>(some.count());
  const double fastest = fastest_point(arena_, some, [&](int i) {
    const Vec2 own = bodies[i].heading.to_body(bodies[i].velocity() - common);
    return Twist{own.x(), own.y(), bodies[i].twist.turn};
  });
  const double farthest = radii_a_step * arena_.parameters.ball_radius;
  const double length = arena_.tolerances.step;
  return fastest * length > farthest ? farthest / fastest : length;
}

double ContactStepping::next_step(const BodySet& some) const {
  double shortest = infinity;
  for (int i = 0; i < arena_.bodies(); ++i) {
    if (some[i]) shortest = std::min(shortest, next_step_[i]);
  }
  return shortest;
}

// A step of that length. False if overlaps remain at its end, or if it turns out to be too long.
bool ContactStepping::find(const BodySet& candidates, std::span<const Contact> touching,
                           std::span<const Drive> drives, std::span<const InverseMass> mass,
                           double length, std::span<const BodyState> bodies, Step& step) {
  for (int i = 0; i < arena_.bodies(); ++i) {
    if (!candidates[i]) continue;
    alone_[i].twist = arena_.is_ball(i)
                          ? braked(arena_.parameters, bodies[i].twist, length)
                          : driven(arena_.parameters, drives[i], bodies[i].twist, length);
  }
  look_ahead(candidates, touching, length, bodies);
  step = {{}, length};
  if (contacts_.count == 0) return true;
  step.members = touching_with(bodies_of(contacts_.list[0].pair), contacts_.contacts());
  contacts_.keep_if([&](const Contact& c) { return step.members[c.pair.a]; });
  return settle(step.members, drives, mass, length, bodies) &&
         length <= too_far * longest_step(step.members, end_);
}

// How much the distance of two may change by what their motors add to their twists within a step, m.
double ContactStepping::reach_of_motors(const BodySet& candidates, double length,
                                        std::span<const BodyState> bodies) const {
  const auto added = [&](int i) {
    const Twist& v = bodies[i].twist;
    const Twist& alone = alone_[i].twist;
    return Twist{alone.forward - v.forward, alone.left - v.left, alone.turn - v.turn};
  };
  return 2.0 * fastest_point(arena_, candidates, added) * length;
}

// Where the candidates would be if they kept their twists, and what is close to what there.
void ContactStepping::look_ahead(const BodySet& candidates, std::span<const Contact> touching,
                                 double length, std::span<const BodyState> bodies) {
  for (int i = 0; i < arena_.bodies(); ++i) {
    if (candidates[i]) end_[i] = along_arc(bodies[i], length);
  }
  const double margin =
      fastest_of(candidates, bodies) * length + reach_of_motors(candidates, length, bodies);
  contacts_.count = 0;
  add_contacts_among(arena_, candidates, end_, margin, boxes_, contacts_);
  std::array<std::bitset<max_partners>, max_bodies> found;
  for (const Contact& c : contacts_.contacts()) found[c.pair.a].set(c.pair.partner);
  // Who touches may part faster than anybody goes, and yet not part once the others are heard.
  for (const Contact& c : touching) {
    if (!candidates[c.pair.a] || found[c.pair.a][c.pair.partner]) continue;
    found[c.pair.a].set(c.pair.partner);
    add_contacts(arena_, c.pair, end_, infinity, contacts_);
  }
  put_on_first_edges(arena_, bodies, end_, contacts_);
}

// Solves until what was solved for is what is found, along the normals of the look ahead. False if that
// does not come about.
bool ContactStepping::settle(const BodySet& members, std::span<const Drive> drives,
                             std::span<const InverseMass> mass, double length,
                             std::span<const BodyState> bodies) {
  next_ = length;
  paths_.straighten(members);
  recall(members, length);
  leave_overlaps(length, bodies);
  pose(members, drives, mass, length);
  for (int i = 0; i < arena_.bodies(); ++i) {
    if (members[i]) begin_[i] = bodies[i];
  }
  for (int look = 0; look < most_looks; ++look) {
    solve(members, mass, length);
    for (int i = 0; i < arena_.bodies(); ++i) {
      if (!members[i]) continue;
      begin_[i].twist = end_[i].twist;
      end_[i] = along_arc(begin_[i], length);
    }
    for (Contact& c : contacts_.contacts()) look_again(arena_, end_, c.pair, c.point);
    const Tolerances& t = arena_.tolerances;
    if (has_settled(look < patient_looks ? t.step_touch : t.step_overlap)) {
      return stays_apart(members, length);
    }
  }
  return false;
}

// Between its ends: does nobody pass through anybody, nor overlap too deep? Judges the next one, too.
bool ContactStepping::stays_apart(const BodySet& members, double length) {
  const StepPaths::Step step{members, begin_, end_, contacts_.contacts(), length};
  if (!paths_.is_clear(step)) return false;
  const double overlap = paths_.bend(step);
  next_ = paths_.next_length(step, overlap);
  return overlap <= arena_.tolerances.overlap_within_step ||
         overlap <= paths_.overlap_at_begin(step);
}

// What overlaps at the begin is undone in a step, but not faster than that would add energy: steps may
// be as short as what is left of a tick.
void ContactStepping::leave_overlaps(double length, std::span<const BodyState> bodies) {
  std::fill_n(left_.begin(), contacts_.count, 0.0);
  const double undone = fastest_undoing * length;
  if (undone >= undone_at_once) return;
  for (int i = 0; i < contacts_.count; ++i) {
    left_[i] = std::max(0.0, -gap_beyond(arena_, bodies, contacts_.list[i], 0.0) - undone);
  }
}

bool ContactStepping::has_settled(double touch) const {
  for (int i = 0; i < contacts_.count; ++i) {
    const Contact& c = contacts_.list[i];
    const double gap = c.point.gap + left_[i];
    if (gap < -touch || (c.impact.impulse > 0.0 && gap > touch)) return false;
  }
  return true;
}

// What impulses the step asks for: of contacts, along their tangents, of wheels.
void ContactStepping::pose(const BodySet& members, std::span<const Drive> drives,
                           std::span<const InverseMass> mass, double length) {
  const Parameters& p = arena_.parameters;
  int count = 0;
  const auto add = [&](const ConstraintRow& row, double& impulse) {
    row_[count] = &row;
    impulse_[count++] = &impulse;
  };
  for (Contact& c : contacts_.contacts()) add(c.row, c.impact.impulse);
  tangent_count_ = 0;
  for (const Contact& c : contacts_.contacts()) {
    if (c.material.friction == 0.0 || count == max_unknowns - max_bodies) continue;
    tangent_rows_[tangent_count_] = tangent_row(c, end_);
    tangent_impulse_[tangent_count_] = c.impact.impulse;
    add(tangent_rows_[tangent_count_], tangent_impulse_[tangent_count_]);
    ++tangent_count_;
  }
  const int with_tangents = count;
  for (int i = 0; i < arena_.robots; ++i) {
    const bool holds = members[i] && drives[i].wheels_on_ground && p.grip != infinite_grip;
    if (holds && count < max_unknowns) add(wheel_rows_[i], wheel_impulse_[i]);
  }
  problem_.reset(mass);
  for (int i = 0; i < count; ++i) problem_.add(*row_[i]);
  for (int i = with_tangents; i < count; ++i) set_bounds(i, most_grip(length));
  for (int i = 0; i < count; ++i) alone_rate_[i] = row_rate(*row_[i], alone_);
}

// These impulses, from where the last look ended. Sets the twists of end_.
void ContactStepping::solve(const BodySet& members, std::span<const InverseMass> mass,
                            double length) {
  const int normals = contacts_.count;
  const int with_tangents = normals + tangent_count_;
  const int count = problem_.size();
  for (int i = 0; i < count; ++i) {
    problem_.x[i] = *impulse_[i];
    problem_.b[i] = alone_rate_[i];
    // The gap at the end of the step, from what it is with the twists of the last look.
    if (i >= normals) continue;
    problem_.b[i] += (contacts_.list[i].point.gap + left_[i]) / length - row_rate(*row_[i], end_);
  }
  for (int i = normals; i < with_tangents; ++i) set_bounds(i, 0.0);
  problem_.solve(close_enough);
  for (int round = 0; round < friction_rounds && with_tangents > normals; ++round) {
    for (int i = normals, k = 0; i < with_tangents; ++i, ++k) {
      while (contacts_.list[k].material.friction == 0.0) ++k;
      set_bounds(i, contacts_.list[k].material.friction * problem_.x[k]);
    }
    problem_.solve(close_enough);
  }

  for (int i = 0; i < arena_.bodies(); ++i) {
    if (members[i]) end_[i].twist = alone_[i].twist;
  }
  for (int i = 0; i < count; ++i) {
    *impulse_[i] = problem_.x[i];
    apply_impulse(*row_[i], problem_.x[i], mass, end_);
  }
  for (int i = with_tangents; i < count; ++i) {
    if (std::abs(problem_.x[i]) < most_grip(length)) end_[row_[i]->a].twist.left = 0.0;
  }
}

void ContactStepping::set_bounds(int i, double bound) {
  problem_.low[i] = -bound;
  problem_.high[i] = bound;
}

double ContactStepping::most_grip(double length) const {
  const Parameters& p = arena_.parameters;
  return p.grip * p.robot_mass * gravity * length;
}

}  // namespace mirocup::simulator
