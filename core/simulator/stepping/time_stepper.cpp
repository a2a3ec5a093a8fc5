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

namespace mirocup::simulator::stepping {

namespace {

constexpr double max_travel_in_radii = 0.5;
// So many times as far is taken where it turns out only at the end of a step.
constexpr double travel_overrun = 1.5;

// Looks at the end of a step, and times that it is halved, before what is found there is taken.
constexpr int max_refinements = 10;
// How close impulses have to be for a look, as a share of the largest relative velocity.
constexpr double impulse_tolerance = 1e-9;
// Contacts may contradict each other by a hair; then it is not for more looks to find an end.
constexpr int strict_refinements = 4;
constexpr int max_halvings = 6;

// Overlaps at the begin of a step are not undone faster than that, m/s, unless the step is so long that
// it undoes as much, m, anyway.
constexpr double max_undoing_speed = 2e-4;
constexpr double undone_overlap = 1e-7;

// The force of wheels is remembered a hair larger, lest rounding takes what was at its bound off it.
constexpr double force_round_off = 1.0 + 1e-12;
// As many steps as fit into a time exactly are not one more.
constexpr double count_round_off = 1.0 - 1e-9;

// No next step is judged to be shorter, as a share of the longest one; and one for which less than this
// share of its time was left says little about the next.
constexpr double min_step_share = 1.0 / 64.0;
constexpr double min_informative_share = 0.5;

// Rounds in which the bounds of friction follow the normal impulses.
constexpr int friction_rounds = 10;

// The twist after a step without any contact and without the ground's sideways force.
Twist unconstrained_robot_twist(const Parameters& p, const trajectory::DriveReference& drive,
                                const Twist& v, double step) {
  // The frame turns; the velocity does not, unless wheels that roll turn it.
  const Heading turned = Heading::from_angle(v.omega * step);
  const bool rolls = std::abs(v.left) <= trajectory::slip_round_off;
  const Vec2 kept =
      rolls ? Vec2{v.forward, -v.forward * turned.sin} : turned.to_body({v.forward, v.left});
  Twist next{kept.x(), kept.y(), v.omega};
  if (!drive.wheels_on_ground) return next;
  const double reached = -expm1(-step / p.motor_time_constant);
  next.forward += reached * (drive.forward - v.forward);
  next.omega += reached * (drive.omega - v.omega);
  if (p.grip == infinite_grip) next.left = 0.0;
  return next;
}

Twist unconstrained_ball_twist(const Parameters& p, const Twist& v, double step) {
  const trajectory::RollingDeceleration d = trajectory::rolling_deceleration(p);
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

bool is_same_place(const collision::ContactPoint& p, const collision::ContactPoint& q) {
  return p.kind == q.kind && p.point_on_a == q.point_on_a && p.corner == q.corner &&
         p.edge == q.edge;
}

// No point of the body is faster, m/s.
double speed_at_most(const geometry::Outline& shape, const Twist& v) {
  return std::abs(v.forward) + std::abs(v.left) + std::abs(v.omega) * shape.radius;
}

// The fastest that a point of some body is with the twist that twist_of(body) says, m/s.
template <class TwistOf>
double fastest_point(const collision::StaticWorld& world, const BodySet& some, TwistOf twist_of) {
  double fastest = 0.0;
  for_each_body(some, [&](int i) {
    fastest = std::max(fastest, speed_at_most(world.shape(i), twist_of(i)));
  });
  return fastest;
}

}  // namespace

TimeStepper::TimeStepper(const collision::StaticWorld& world, solver::RegularizedQp& problem)
    : world_(world), qp_(problem), trajectories_(world, problem) {
  forget_forces();
  for (int i = 0; i < world.robots; ++i) wheel_rows_[i] = collision::lateral_wheel_row(i);
}

TimeStepper::Step TimeStepper::take_step(const BodySet& candidates,
                                         std::span<const collision::Contact> touching,
                                         std::span<const trajectory::DriveReference> drives,
                                         std::span<const solver::InverseMass> mass, double longest,
                                         std::span<BodyState> bodies) {
  const double length = std::min(max_step_length(candidates, bodies), proposed_length(candidates));
  double parts = std::ceil(longest / length * count_round_off);
  Step step;
  for (int halved = 0; halved <= max_halvings; ++halved, parts *= 2.0) {
    if (attempt(candidates, touching, drives, mass, longest / parts, bodies, step)) break;
  }
  for (int i = 0; i < world_.bodies(); ++i) {
    if (!step.members[i]) continue;
    twist_before_[i] = bodies[i].twist;
    bodies[i].twist = end_[i].twist;
  }
  stepped_ |= step.members;
  const double next =
      longest < min_informative_share * length ? std::max(length, next_length_) : next_length_;
  for (int i = 0; i < world_.bodies(); ++i) {
    if (step.members[i])
      proposed_length_of_[i] = std::max(next, min_step_share * world_.tolerances.max_step);
  }
  remember_forces(step);
  return step;
}

Twist TimeStepper::twist_after(int member, const Twist& kept, double part) const {
  const Twist& v = twist_before_[member];
  return {v.forward + part * (kept.forward - v.forward), v.left + part * (kept.left - v.left),
          v.omega + part * (kept.omega - v.omega)};
}

void TimeStepper::remember_forces(const Step& step) {
  const auto last = std::remove_if(
      remembered_.begin(), remembered_.begin() + remembered_count_,
      [&](const RememberedForce& known) { return (bodies_of(known.pair) & step.members).any(); });
  remembered_count_ = static_cast<int>(last - remembered_.begin());
  contacts_.keep_if([](const collision::Contact& c) { return c.impact.impulse != 0.0; });
  for (collision::Contact& c : contacts_.contacts()) {
    c.resting = {.is_active = true, .force = c.impact.impulse / step.length};
    if (remembered_count_ == solver::max_unknowns) continue;
    remembered_[remembered_count_++] = {
        .pair = c.pair, .point = c.point, .force = c.resting.force, .impulse = c.impact.impulse};
  }
  for (int i = 0; i < world_.robots; ++i) {
    if (step.members[i]) wheel_force_[i] = wheel_impulse_[i] / step.length;
  }
}

void TimeStepper::forget_forces() {
  remembered_count_ = 0;
  wheel_force_.fill(0.0);
  proposed_length_of_.fill(infinity);
}

void TimeStepper::begin_tick() {
  for (int i = 0; i < world_.bodies(); ++i) {
    if (!stepped_[i]) proposed_length_of_[i] = infinity;
  }
  stepped_.reset();
}

// The impulses of a step like the last one.
void TimeStepper::warm_start(const BodySet& members, double length) {
  int next = 0;
  for (collision::Contact& c : contacts_.contacts()) {
    c.impact.impulse = 0.0;
    for (int tried = 0; tried < remembered_count_; ++tried) {
      const RememberedForce& known = remembered_[next];
      next = next + 1 == remembered_count_ ? 0 : next + 1;
      if (!(known.pair == c.pair) || !is_same_place(known.point, c.point)) continue;
      c.impact.impulse = std::min(known.force * length, known.impulse);
      break;
    }
  }
  for (int i = 0; i < world_.robots; ++i) {
    if (members[i]) wheel_impulse_[i] = wheel_force_[i] * length * force_round_off;
  }
}

double TimeStepper::max_point_speed(const BodySet& some, std::span<const BodyState> bodies) const {
  return fastest_point(world_, some, [&](int i) { return bodies[i].twist; });
}

// Nobody goes farther than half the ball's radius from where all of them go in a step: it would be seen
// behind what it hit.
double TimeStepper::max_step_length(const BodySet& some, std::span<const BodyState> bodies) const {
  Vec2 common{0.0, 0.0};
  for_each_body(some, [&](int i) { common += bodies[i].velocity(); });
  common /= static_cast<double>(some.count());
  const double fastest = fastest_point(world_, some, [&](int i) {
    const Vec2 own = bodies[i].heading.to_body(bodies[i].velocity() - common);
    return Twist{own.x(), own.y(), bodies[i].twist.omega};
  });
  const double farthest = max_travel_in_radii * world_.parameters.ball_radius;
  const double length = world_.tolerances.max_step;
  return fastest * length > farthest ? farthest / fastest : length;
}

double TimeStepper::proposed_length(const BodySet& some) const {
  double shortest = infinity;
  for (int i = 0; i < world_.bodies(); ++i) {
    if (some[i]) shortest = std::min(shortest, proposed_length_of_[i]);
  }
  return shortest;
}

// A step of that length. False if overlaps remain at its end, or if it turns out to be too long.
bool TimeStepper::attempt(const BodySet& candidates, std::span<const collision::Contact> touching,
                          std::span<const trajectory::DriveReference> drives,
                          std::span<const solver::InverseMass> mass, double length,
                          std::span<const BodyState> bodies, Step& step) {
  for (int i = 0; i < world_.bodies(); ++i) {
    if (!candidates[i]) continue;
    unconstrained_[i].twist =
        world_.is_ball(i)
            ? unconstrained_ball_twist(world_.parameters, bodies[i].twist, length)
            : unconstrained_robot_twist(world_.parameters, drives[i], bodies[i].twist, length);
  }
  predict_contacts(candidates, touching, length, bodies);
  step = {{}, length};
  if (contacts_.count == 0) return true;
  step.members = impact::islands_of(bodies_of(contacts_.list[0].pair), contacts_.contacts());
  contacts_.keep_if([&](const collision::Contact& c) { return step.members[c.pair.a]; });
  return solve_until_settled(step.members, drives, mass, length, bodies) &&
         length <= travel_overrun * max_step_length(step.members, end_);
}

// How much the distance of two may change by what their motors add to their twists within a step, m.
double TimeStepper::motor_reach(const BodySet& candidates, double length,
                                std::span<const BodyState> bodies) const {
  const auto added = [&](int i) {
    const Twist& v = bodies[i].twist;
    const Twist& alone = unconstrained_[i].twist;
    return Twist{alone.forward - v.forward, alone.left - v.left, alone.omega - v.omega};
  };
  return 2.0 * fastest_point(world_, candidates, added) * length;
}

// Where the candidates would be if they kept their twists, and what is close to what there.
void TimeStepper::predict_contacts(const BodySet& candidates,
                                   std::span<const collision::Contact> touching, double length,
                                   std::span<const BodyState> bodies) {
  for (int i = 0; i < world_.bodies(); ++i) {
    if (candidates[i]) end_[i] = trajectory::along_arc(bodies[i], length);
  }
  const double margin =
      max_point_speed(candidates, bodies) * length + motor_reach(candidates, length, bodies);
  contacts_.count = 0;
  add_contacts_among(world_, candidates, end_, margin, boxes_, contacts_);
  std::array<std::bitset<max_partners>, max_bodies> found;
  for (const collision::Contact& c : contacts_.contacts()) found[c.pair.a].set(c.pair.partner);
  // Who touches may part faster than anybody goes, and yet not part once the others are heard.
  for (const collision::Contact& c : touching) {
    if (!candidates[c.pair.a] || found[c.pair.a][c.pair.partner]) continue;
    found[c.pair.a].set(c.pair.partner);
    add_contacts(world_, c.pair, end_, infinity, contacts_);
  }
  use_reference_edges(world_, bodies, end_, contacts_);
}

// Solves until what was solved for is what is found, along the normals of the look ahead. False if that
// does not come about.
bool TimeStepper::solve_until_settled(const BodySet& members,
                                      std::span<const trajectory::DriveReference> drives,
                                      std::span<const solver::InverseMass> mass, double length,
                                      std::span<const BodyState> bodies) {
  next_length_ = length;
  trajectories_.clear_corrections(members);
  warm_start(members, length);
  allow_initial_overlaps(length, bodies);
  build_problem(members, drives, mass, length);
  for (int i = 0; i < world_.bodies(); ++i) {
    if (members[i]) start_[i] = bodies[i];
  }
  for (int look = 0; look < max_refinements; ++look) {
    solve_impulses(members, mass, length);
    for (int i = 0; i < world_.bodies(); ++i) {
      if (!members[i]) continue;
      start_[i].twist = end_[i].twist;
      end_[i] = trajectory::along_arc(start_[i], length);
    }
    for (collision::Contact& c : contacts_.contacts())
      refresh_contact(world_, end_, c.pair, c.point);
    const Tolerances& t = world_.tolerances;
    if (has_settled(look < strict_refinements ? t.step_gap : t.step_gap_in_conflict)) {
      return check_trajectories(members, length);
    }
  }
  return false;
}

// Between its ends: does nobody pass through anybody, nor overlap too deep? Judges the next one, too.
bool TimeStepper::check_trajectories(const BodySet& members, double length) {
  const StepTrajectories::Step step{members, start_, end_, contacts_.contacts(), length};
  if (!trajectories_.is_clear(step)) return false;
  const double overlap = trajectories_.correct_middle(step);
  next_length_ = trajectories_.next_length(step, overlap);
  return overlap <= world_.tolerances.intermediate_penetration ||
         overlap <= trajectories_.overlap_at_begin(step);
}

// What overlaps at the begin is undone in a step, but not faster than that would add energy: steps may
// be as short as what is left of a tick.
void TimeStepper::allow_initial_overlaps(double length, std::span<const BodyState> bodies) {
  std::fill_n(allowed_overlap_.begin(), contacts_.count, 0.0);
  const double undone = max_undoing_speed * length;
  if (undone >= undone_overlap) return;
  for (int i = 0; i < contacts_.count; ++i) {
    allowed_overlap_[i] =
        std::max(0.0, -clamped_gap(world_, bodies, contacts_.list[i], 0.0) - undone);
  }
}

bool TimeStepper::has_settled(double touch) const {
  for (int i = 0; i < contacts_.count; ++i) {
    const collision::Contact& c = contacts_.list[i];
    const double gap = c.point.gap + allowed_overlap_[i];
    if (gap < -touch || (c.impact.impulse > 0.0 && gap > touch)) return false;
  }
  return true;
}

// What impulses the step asks for: of contacts, along their tangents, of wheels.
void TimeStepper::build_problem(const BodySet& members,
                                std::span<const trajectory::DriveReference> drives,
                                std::span<const solver::InverseMass> mass, double length) {
  const Parameters& p = world_.parameters;
  int count = 0;
  const auto add = [&](const solver::ConstraintRow& row, double& impulse) {
    row_[count] = &row;
    impulse_[count++] = &impulse;
  };
  for (collision::Contact& c : contacts_.contacts()) add(c.row, c.impact.impulse);
  tangent_count_ = 0;
  for (const collision::Contact& c : contacts_.contacts()) {
    if (c.material.friction == 0.0 || count == solver::max_unknowns - max_bodies) continue;
    tangent_rows_[tangent_count_] = impact::tangent_row(c, end_);
    tangent_impulse_[tangent_count_] = c.impact.impulse;
    add(tangent_rows_[tangent_count_], tangent_impulse_[tangent_count_]);
    ++tangent_count_;
  }
  const int with_tangents = count;
  for (int i = 0; i < world_.robots; ++i) {
    const bool holds = members[i] && drives[i].wheels_on_ground && p.grip != infinite_grip;
    if (holds && count < solver::max_unknowns) add(wheel_rows_[i], wheel_impulse_[i]);
  }
  qp_.reset(mass);
  for (int i = 0; i < count; ++i) qp_.add(*row_[i]);
  for (int i = with_tangents; i < count; ++i) set_bounds(i, max_grip(length));
  for (int i = 0; i < count; ++i)
    unconstrained_rate_[i] = collision::row_rate(*row_[i], unconstrained_);
}

// These impulses, from where the last look ended. Sets the twists of end_.
void TimeStepper::solve_impulses(const BodySet& members, std::span<const solver::InverseMass> mass,
                                 double length) {
  const int normals = contacts_.count;
  const int with_tangents = normals + tangent_count_;
  const int count = qp_.size();
  for (int i = 0; i < count; ++i) {
    qp_.x[i] = *impulse_[i];
    qp_.b[i] = unconstrained_rate_[i];
    // The gap at the end of the step, from what it is with the twists of the last look.
    if (i >= normals) continue;
    qp_.b[i] += (contacts_.list[i].point.gap + allowed_overlap_[i]) / length -
                collision::row_rate(*row_[i], end_);
  }
  for (int i = normals; i < with_tangents; ++i) set_bounds(i, 0.0);
  qp_.solve(impulse_tolerance);
  for (int round = 0; round < friction_rounds && with_tangents > normals; ++round) {
    for (int i = normals, k = 0; i < with_tangents; ++i, ++k) {
      while (contacts_.list[k].material.friction == 0.0) ++k;
      set_bounds(i, contacts_.list[k].material.friction * qp_.x[k]);
    }
    qp_.solve(impulse_tolerance);
  }

  for (int i = 0; i < world_.bodies(); ++i) {
    if (members[i]) end_[i].twist = unconstrained_[i].twist;
  }
  for (int i = 0; i < count; ++i) {
    *impulse_[i] = qp_.x[i];
    collision::apply_impulse(*row_[i], qp_.x[i], mass, end_);
  }
  for (int i = with_tangents; i < count; ++i) {
    if (std::abs(qp_.x[i]) < max_grip(length)) end_[row_[i]->a].twist.left = 0.0;
  }
}

void TimeStepper::set_bounds(int i, double bound) {
  qp_.low[i] = -bound;
  qp_.high[i] = bound;
}

double TimeStepper::max_grip(double length) const {
  const Parameters& p = world_.parameters;
  return p.grip * p.robot_mass * gravity * length;
}

}  // namespace mirocup::simulator::stepping
