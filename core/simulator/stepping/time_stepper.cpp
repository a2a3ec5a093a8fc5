// SPDX-License-Identifier: MIT
#include "core/simulator/stepping/time_stepper.hpp"

#include "core/base/assert.hpp"
#include "core/base/math.hpp"
#include "core/simulator/collision/broad_phase.hpp"
#include "core/simulator/collision/reference_edges.hpp"
#include "core/simulator/impact/islands.hpp"
#include "core/simulator/model/solver_settings.hpp"
#include "core/simulator/trajectory/rolling_ball.hpp"

#include <algorithm>
#include <bitset>
#include <cmath>

namespace mirocup::simulator::stepping {

namespace {

// Returns a robot's twist after a step of `step` seconds without contacts and without the ground's
// lateral force, in its frame at the end.
Twist unconstrained_robot_twist(const Parameters& p, const trajectory::DriveReference& drive,
                                const Twist& v, double step) {
  // The frame turns. The velocity of a sliding robot keeps its direction in the field; wheels that
  // roll keep the forward speed instead, and their grip will have to supply the lateral rest.
  const Heading turned = Heading::from_angle(v.omega * step);
  const bool rolls = std::abs(v.left) <= settings::differential_drive.slip_round_off;
  const Vec2 kept =
      rolls ? Vec2{v.forward, -v.forward * turned.sin} : turned.to_body({v.forward, v.left});
  Twist next{kept.x(), kept.y(), v.omega};
  if (!drive.wheels_on_ground) return next;
  const double reached = -expm1(-step / drive.forward_lag);
  const double turned_to =
      drive.turn_lag == drive.forward_lag ? reached : -expm1(-step / drive.turn_lag);
  next.forward += reached * (drive.forward - v.forward);
  next.omega += turned_to * (drive.omega - v.omega);
  if (p.grip == infinite_grip) next.left = 0.0;
  return next;
}

// Returns the ball's twist after a step of `step` seconds without contacts: braked with the
// deceleration that it has at the start.
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

// True if both are the same corner or ball on the same edge or corner.
template <class Known>
bool is_same_feature(const Known& p, const collision::ContactPoint& q) {
  return p.kind == q.kind && p.point_on_a == q.point_on_a && p.corner == q.corner &&
         p.edge == q.edge;
}

// Returns an upper bound of the speed of all points of the body, m/s.
double max_speed_of_points(const geometry::Outline& shape, const Twist& v) {
  return std::abs(v.forward) + std::abs(v.left) + std::abs(v.omega) * shape.radius;
}

// Returns the largest of these bounds over some bodies that move with twist_of(body), m/s.
template <class TwistOf>
double max_speed(const collision::StaticWorld& world, const BodySet& some, TwistOf twist_of) {
  double fastest = 0.0;
  for_each_body(some, [&](int i) {
    fastest = std::max(fastest, max_speed_of_points(world.shape(i), twist_of(i)));
  });
  return fastest;
}

}  // namespace

TimeStepper::TimeStepper(const collision::StaticWorld& world, solver::RegularizedQp& problem)
    : world_(world), qp_(problem), trajectories_(world, problem) {
  forget_forces();
  for (int i = 0; i < world.robots; ++i) wheel_rows_[i] = collision::lateral_wheel_row(i);
}

// ---- One step: attempts with shorter and shorter lengths

TimeStepper::Step TimeStepper::take_step(const BodySet& candidates,
                                         std::span<const collision::Contact> touching,
                                         std::span<const trajectory::DriveReference> drives,
                                         std::span<const solver::InverseMass> mass, double longest,
                                         std::span<BodyState> bodies) {
  MIROCUP_ASSERT(candidates.any() && longest > 0.0);
  // The time left is divided into equal steps, so that no tiny rest remains.
  const double wanted = std::min(max_step_length(candidates, bodies), proposed_length(candidates));
  double parts = std::ceil(longest / wanted * settings::time_stepper.count_round_off);
  Attempt step{candidates, touching, drives, mass, bodies};
  for (int halved = 0; halved <= settings::time_stepper.max_halvings; ++halved, parts *= 2.0) {
    step.length = longest / parts;
    if (attempt(step)) break;
  }
  // If no attempt was accepted, the last one is taken: its overlap is small, and time must go on.
  for_each_body(step.members, [&](int i) {
    twist_before_[i] = bodies[i].twist;
    bodies[i].twist = end_[i].twist;
  });
  memory_.stepped |= step.members;
  propose_next(step, longest, wanted);
  remember_forces(step);
  return {step.members, step.length};
}

// Makes one attempt at a step of step.length. Sets step.members and step.next_length. False if the
// step is to be repeated with a shorter length: overlaps remain, or the bodies are too fast for it.
bool TimeStepper::attempt(Attempt& step) {
  spoil(contacts_.list, start_, end_, unconstrained_, allowed_overlap_, boxes_, row_, impulse_,
        unconstrained_rate_, tangent_rows_, tangent_impulse_, normal_of_tangent_, wheel_impulse_);
  set_unconstrained_twists(step);
  predict_contacts(step);
  step.members.reset();
  if (contacts_.count == 0) return true;
  // The first contact's island takes the step; the others wait for the next call.
  step.members = impact::islands_of(bodies_of(contacts_.list[0].pair), contacts_.contacts());
  contacts_.keep_if([&](const collision::Contact& c) { return step.members[c.pair.a]; });
  return solve_until_settled(step) &&
         step.length <= settings::time_stepper.travel_overrun * max_step_length(step.members, end_);
}

// Sets the length with which each member's next step starts. A step that had to be short because
// the tick was nearly over says little about the next one.
void TimeStepper::propose_next(const Attempt& step, double longest, double wanted) {
  const double next = longest < settings::time_stepper.min_informative_share * wanted
                          ? std::max(wanted, step.next_length)
                          : step.next_length;
  const double shortest = settings::time_stepper.min_step_share * world_.tolerances.max_step;
  for_each_body(step.members,
                [&](int i) { memory_.proposed_length[i] = std::max(next, shortest); });
}

Twist TimeStepper::twist_after(int member, const Twist& kept, double share) const {
  const Twist& v = twist_before_[member];
  return {v.forward + share * (kept.forward - v.forward), v.left + share * (kept.left - v.left),
          v.omega + share * (kept.omega - v.omega)};
}

// ---- Forces from step to step

// Keeps the pressing contacts of the step and remembers their forces as the warm start of the
// members' next steps. A force for which there is no room is forgotten: the next solve starts at
// zero there.
void TimeStepper::remember_forces(const Attempt& step) {
  const auto last = std::remove_if(
      memory_.force.begin(), memory_.force.begin() + memory_.forces,
      [&](const RememberedForce& known) { return (bodies_of(known.pair) & step.members).any(); });
  memory_.forces = static_cast<int>(last - memory_.force.begin());
  contacts_.keep_if([](const collision::Contact& c) { return c.impact.impulse != 0.0; });
  for (collision::Contact& c : contacts_.contacts()) {
    c.resting = {.is_active = true, .force = c.impact.impulse / step.length};
    if (memory_.forces == solver::max_unknowns) continue;
    memory_.force[memory_.forces++] = {.pair = c.pair,
                                       .kind = c.point.kind,
                                       .point_on_a = c.point.point_on_a,
                                       .corner = c.point.corner,
                                       .edge = c.point.edge,
                                       .force = c.resting.force,
                                       .impulse = c.impact.impulse};
  }
  for (int i = 0; i < world_.robots; ++i) {
    if (step.members[i]) memory_.wheel_force[i] = wheel_impulse_[i] / step.length;
  }
}

void TimeStepper::copy(const Memory& from, Memory& to) {
  to.stepped = from.stepped;
  to.wheel_force = from.wheel_force;
  to.proposed_length = from.proposed_length;
  to.forces = from.forces;
  std::copy_n(from.force.begin(), from.forces, to.force.begin());
}

void TimeStepper::forget_forces() {
  memory_.forces = 0;
  memory_.wheel_force.fill(0.0);
  memory_.proposed_length.fill(infinity);
}

void TimeStepper::begin_tick() {
  spoil(twist_before_);
  for (int i = 0; i < world_.bodies(); ++i) {
    if (!memory_.stepped[i]) memory_.proposed_length[i] = infinity;
  }
  memory_.stepped.reset();
}

// Sets the impulses to those of a step with the remembered forces.
void TimeStepper::warm_start(const Attempt& step) {
  // Contacts usually come in the order in which they were remembered: each search starts behind the
  // last find.
  int next = 0;
  for (collision::Contact& c : contacts_.contacts()) {
    c.impact.impulse = 0.0;
    for (int tried = 0; tried < memory_.forces; ++tried) {
      const RememberedForce& known = memory_.force[next];
      next = next + 1 == memory_.forces ? 0 : next + 1;
      if (!(known.pair == c.pair) || !is_same_feature(known, c.point)) continue;
      c.impact.impulse = std::min(known.force * step.length, known.impulse);
      break;
    }
  }
  for (int i = 0; i < world_.robots; ++i) {
    if (step.members[i])
      wheel_impulse_[i] =
          memory_.wheel_force[i] * step.length * settings::time_stepper.force_round_off;
  }
}

// ---- The length of a step

// Returns the longest step in which no body moves further than a share of the ball's radius against
// the mean motion of these bodies, s. A body that moves further could end up behind what it hit.
double TimeStepper::max_step_length(const BodySet& some, std::span<const BodyState> bodies) const {
  Vec2 common{0.0, 0.0};
  for_each_body(some, [&](int i) { common += bodies[i].velocity(); });
  common /= static_cast<double>(some.count());
  const double fastest = max_speed(world_, some, [&](int i) {
    const Vec2 own = bodies[i].heading.to_body(bodies[i].velocity() - common);
    return Twist{own.x(), own.y(), bodies[i].twist.omega};
  });
  const double farthest =
      settings::time_stepper.max_travel_in_radii * world_.parameters.ball_radius;
  const double length = world_.tolerances.max_step;
  return fastest * length > farthest ? farthest / fastest : length;
}

// Returns the shortest length that the last steps of these bodies proposed, s.
double TimeStepper::proposed_length(const BodySet& some) const {
  double shortest = infinity;
  for_each_body(some, [&](int i) { shortest = std::min(shortest, memory_.proposed_length[i]); });
  return shortest;
}

// ---- The contacts of a step

void TimeStepper::set_unconstrained_twists(const Attempt& step) {
  for_each_body(step.candidates, [&](int i) {
    const Twist& v = step.start[i].twist;
    unconstrained_[i].twist =
        world_.is_ball(i)
            ? unconstrained_ball_twist(world_.parameters, v, step.length)
            : unconstrained_robot_twist(world_.parameters, step.drives[i], v, step.length);
  });
}

// Returns how much the distance of two candidates may change because their motors change their
// twists within the step, m.
double TimeStepper::motor_reach(const Attempt& step) const {
  const auto added = [&](int i) {
    const Twist& v = step.start[i].twist;
    const Twist& alone = unconstrained_[i].twist;
    return Twist{alone.forward - v.forward, alone.left - v.left, alone.omega - v.omega};
  };
  return 2.0 * max_speed(world_, step.candidates, added) * step.length;
}

// Finds the contacts that can matter at the end of the step: all points that are close to each
// other where the candidates would be if they kept their twists. Sets end_ to those states.
void TimeStepper::predict_contacts(const Attempt& step) {
  for_each_body(step.candidates,
                [&](int i) { end_[i] = trajectory::along_arc(step.start[i], step.length); });
  const double speed =
      max_speed(world_, step.candidates, [&](int i) { return step.start[i].twist; });
  const double margin = speed * step.length + motor_reach(step);
  contacts_.count = 0;
  add_contacts_among(world_, step.candidates, end_, margin, boxes_, contacts_);
  std::array<std::bitset<max_partners>, max_bodies> found;
  for (const collision::Contact& c : contacts_.contacts()) found[c.pair.a].set(c.pair.partner);
  // A touching pair is always taken: alone it may part beyond the margin, but the contacts of other
  // bodies may hold it together.
  for (const collision::Contact& c : step.touching) {
    if (!step.candidates[c.pair.a] || found[c.pair.a][c.pair.partner]) continue;
    found[c.pair.a].set(c.pair.partner);
    add_contacts(world_, c.pair, end_, infinity, contacts_);
  }
  use_reference_edges(world_, step.start, end_, contacts_);
}

// ---- Fixed-point iteration for the gaps at the end

// Solves for the impulses, moves the members to the end of the step, measures the gaps there, and
// repeats until pressing contacts touch and nothing overlaps. Then checks the trajectories between
// the ends. False if one of the two fails.
bool TimeStepper::solve_until_settled(Attempt& step) {
  step.next_length = step.length;
  trajectories_.clear_corrections(step.members);
  warm_start(step);
  allow_initial_overlaps(step);
  build_problem(step);
  for_each_body(step.members, [&](int i) { start_[i] = step.start[i]; });
  for (int round = 0; round < settings::time_stepper.max_refinements; ++round) {
    solve_impulses(step);
    for_each_body(step.members, [&](int i) {
      start_[i].twist = end_[i].twist;
      end_[i] = trajectory::along_arc(start_[i], step.length);
    });
    for (collision::Contact& c : contacts_.contacts())
      refresh_contact(world_, end_, c.pair, c.point);
    // Contacts may contradict each other slightly; then more rounds would not find a better end.
    const Tolerances& t = world_.tolerances;
    const bool is_strict = round < settings::time_stepper.strict_refinements;
    if (has_settled(is_strict ? t.step_gap : t.step_gap_in_conflict))
      return check_trajectories(step);
  }
  return false;
}

// True if no contact overlaps and every pressing contact touches at the end, to `tolerance` metres.
bool TimeStepper::has_settled(double tolerance) const {
  for (int i = 0; i < contacts_.count; ++i) {
    const collision::Contact& c = contacts_.list[i];
    const double gap = c.point.gap + allowed_overlap_[i];
    if (gap < -tolerance || (c.impact.impulse > 0.0 && gap > tolerance)) return false;
  }
  return true;
}

// True if no pair tunnels or overlaps too deeply between the ends of the step; an overlap no deeper
// than that at the start is accepted. Corrects the trajectories and sets step.next_length.
bool TimeStepper::check_trajectories(Attempt& step) {
  const StepTrajectories::Step trajectories{step.members, start_, end_, contacts_.contacts(),
                                            step.length};
  if (!trajectories_.is_clear(trajectories)) return false;
  const double overlap = trajectories_.correct_middle(trajectories);
  step.next_length = trajectories_.next_length(trajectories, overlap);
  return overlap <= world_.tolerances.intermediate_penetration ||
         overlap <= trajectories_.overlap_at_start(trajectories);
}

// Sets how much of each contact's overlap at the start may remain at the end. A step removes
// overlap at a limited speed, because a step may be as short as the rest of a tick and would
// otherwise throw bodies apart.
void TimeStepper::allow_initial_overlaps(const Attempt& step) {
  std::fill_n(allowed_overlap_.begin(), contacts_.count, 0.0);
  const double undone = settings::time_stepper.max_undoing_speed * step.length;
  if (undone >= settings::time_stepper.undone_overlap) return;
  for (int i = 0; i < contacts_.count; ++i) {
    allowed_overlap_[i] =
        std::max(0.0, -clamped_gap(world_, step.start, contacts_.list[i], 0.0) - undone);
  }
}

// ---- The problem in impulses

// Sets up the unknowns of the step's QP in three ranges: normals_ (one per contact, in the order of
// contacts_), tangents_ (one per contact with friction), wheels_ (one per robot whose wheels can
// hold).
void TimeStepper::build_problem(const Attempt& step) {
  int count = 0;
  const auto add = [&](const solver::ConstraintRow& row, double& impulse) {
    row_[count] = &row;
    impulse_[count++] = &impulse;
  };
  for (collision::Contact& c : contacts_.contacts()) add(c.row, c.impact.impulse);
  normals_ = {0, count};
  for (int normal = 0; normal < normals_.end; ++normal) {
    const collision::Contact& c = contacts_.list[normal];
    // Contacts beyond the room of the QP slide without friction.
    if (c.material.friction == 0.0 || count == solver::max_unknowns - max_bodies) continue;
    const int k = count - normals_.end;
    normal_of_tangent_[k] = normal;
    tangent_rows_[k] = impact::tangent_row(c, end_);
    tangent_impulse_[k] = c.impact.impulse;
    add(tangent_rows_[k], tangent_impulse_[k]);
  }
  tangents_ = {normals_.end, count};
  for (int i = 0; i < world_.robots; ++i) {
    const bool holds = step.members[i] && step.drives[i].wheels_on_ground &&
                       world_.parameters.grip != infinite_grip;
    if (holds) add(wheel_rows_[i], wheel_impulse_[i]);
  }
  wheels_ = {tangents_.end, count};
  MIROCUP_ASSERT(count <= solver::max_unknowns);

  qp_.reset(step.mass);
  for (int i = 0; i < count; ++i) qp_.add(*row_[i]);
  for (int i = wheels_.begin; i < wheels_.end; ++i) set_bounds(i, max_grip(step.length));
  for (int i = 0; i < count; ++i)
    unconstrained_rate_[i] = collision::row_rate(*row_[i], unconstrained_);
}

// Solves for the impulses, starting from those of the last round, and sets the twists of end_.
void TimeStepper::solve_impulses(const Attempt& step) {
  const int count = wheels_.end;
  for (int i = 0; i < count; ++i) {
    qp_.x[i] = *impulse_[i];
    qp_.b[i] = unconstrained_rate_[i];
  }
  // A contact's gap at the end of the step is linearised around the twists of the last round:
  // gap + (rate - last rate) length >= 0.
  for (int i = normals_.begin; i < normals_.end; ++i) {
    qp_.b[i] += (contacts_.list[i].point.gap + allowed_overlap_[i]) / step.length -
                collision::row_rate(*row_[i], end_);
  }
  solve_with_friction();

  for_each_body(step.members, [&](int i) { end_[i].twist = unconstrained_[i].twist; });
  for (int i = 0; i < count; ++i) {
    *impulse_[i] = qp_.x[i];
    collision::apply_impulse(*row_[i], qp_.x[i], step.mass, end_);
  }
  // Wheels whose impulse is inside its bounds hold exactly.
  for (int i = wheels_.begin; i < wheels_.end; ++i) {
    if (std::abs(qp_.x[i]) < max_grip(step.length)) end_[row_[i]->a].twist.left = 0.0;
  }
}

// Solves the QP: first without friction, then with the bounds of the tangential impulses set to the
// coefficient times the normal impulse of the round before.
void TimeStepper::solve_with_friction() {
  const double tolerance = settings::time_stepper.impulse_tolerance;
  for (int i = tangents_.begin; i < tangents_.end; ++i) set_bounds(i, 0.0);
  qp_.solve(tolerance);
  if (tangents_.begin == tangents_.end) return;
  for (int round = 0; round < settings::time_stepper.friction_rounds; ++round) {
    for (int i = tangents_.begin; i < tangents_.end; ++i) {
      const int normal = normal_of_tangent_[i - tangents_.begin];
      set_bounds(i, contacts_.list[normal].material.friction * qp_.x[normal]);
    }
    qp_.solve(tolerance);
  }
}

void TimeStepper::set_bounds(int i, double bound) {
  qp_.low[i] = -bound;
  qp_.high[i] = bound;
}

// Returns the largest lateral impulse that the ground gives a robot's wheels in a step, N s.
double TimeStepper::max_grip(double length) const {
  const Parameters& p = world_.parameters;
  return p.grip * p.robot_mass * gravity * length;
}

}  // namespace mirocup::simulator::stepping
