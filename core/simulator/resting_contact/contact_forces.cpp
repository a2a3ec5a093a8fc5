// SPDX-License-Identifier: MIT
#include "core/simulator/resting_contact/contact_forces.hpp"

#include "core/base/assert.hpp"
#include "core/simulator/impact/delassus.hpp"
#include "core/simulator/impact/friction.hpp"
#include "core/simulator/impact/islands.hpp"
#include "core/simulator/model/solver_settings.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator::resting_contact {

ContactForces::ContactForces(const collision::StaticWorld& world)
    : world_(world), rows_(solver::max_unknowns) {
  static_assert(std::tuple_size_v<decltype(collision::ContactList::list)> + max_robots <=
                solver::max_unknowns);
  constraints_.reserve(solver::max_unknowns);
  for (int i = 0; i < world.robots; ++i) wheel_rows_[i] = collision::lateral_wheel_row(i);
}

const solver::InverseMass& ContactForces::mass(
    int body, std::span<const trajectory::DriveReference> drives) const {
  if (world_.is_ball(body)) return world_.ball;
  return drives[body].wheels_on_ground ? world_.grounded_robot : world_.free_robot;
}

bool ContactForces::decide(std::span<const trajectory::DriveReference> drives,
                           std::span<BodyState> bodies, std::span<collision::Contact> contacts) {
  spoil(mass_, trial_, candidate_, wheels_, tangents_);
  // Candidates: the contacts whose gaps do not open. Members: the bodies that have one.
  candidate_count_ = 0;
  members_ = {};
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    collision::Contact& c = contacts[i];
    c.resting.is_active = false;
    c.resting.friction = 0.0;
    if (collision::row_rate(c.row, bodies) > c.impact.restitution_threshold) continue;
    candidate_[candidate_count_++] = static_cast<int>(i);
    members_ |= bodies_of(c.pair);
  }
  if (candidate_count_ == 0) return true;
  for_each_body(bodies_of(contacts), [&](int i) { mass_[i] = mass(i, drives); });

  classify_ground(drives, bodies);
  build_problem(drives, bodies, contacts);
  qp_.solve();

  const int ball = world_.robots;
  const bool ball_rests = world_.has_ball && members_[ball] && bodies[ball].twist.forward == 0.0 &&
                          bodies[ball].twist.left == 0.0;
  if (ball_rests) start_ball(drives, bodies, contacts);
  if (impact::has_friction(world_.parameters)) {
    if (!add_friction(bodies, contacts)) return false;
  } else {
    drop_weak_forces();
  }
  read_solution(contacts);
  project_velocities(bodies, contacts);
  // A ball at rest on which nothing presses stays at rest. The projection may leave it a speed of
  // rounding, with which it would stop at once, in event after event.
  if (ball_rests && impact::cluster_of(ball, contacts).none()) bodies[ball].twist = {};
  return true;
}

// Gives each pressing contact the friction against its slide. One that is about to slide gets it
// against the acceleration that it has without: it slides if that keeps its direction. False if
// a contact sticks, is the ball's, or no forces agree.
bool ContactForces::add_friction(std::span<const BodyState> bodies,
                                 std::span<collision::Contact> contacts) {
  for (int i = 0; i < qp_.size(); ++i)
    qp_.a(i, i) *= 1.0 + settings::contact_forces.friction_compliance;
  const solver::Unknowns without = qp_.b;
  std::array<bool, collision::max_contacts> begins;
  for (int i = 0; i < candidate_count_; ++i) {
    collision::Contact& c = contacts[candidate_[i]];
    tangents_[i] = impact::tangent_row(c, bodies);
    const double speed = collision::row_rate(tangents_[i], bodies);
    begins[i] = std::abs(speed) <= world_.tolerances.slow_motion;
    if (!begins[i]) c.resting.friction = std::copysign(c.material.friction, -speed);
  }
  for (const bool decides : {true, false}) {
    if (!find_friction(without, contacts)) return false;
    const std::array<BodyState, max_bodies> pushed = pushed_by_forces(contacts, true);
    for (int i = 0; i < candidate_count_; ++i) {
      collision::Contact& c = contacts[candidate_[i]];
      if (c.material.friction == 0.0 || qp_.x[i] <= settings::contact_forces.min_force) continue;
      if (c.point.kind != collision::Touching::corner_on_edge) return false;
      if (!begins[i]) continue;
      const double acceleration =
          slide_term(rows_[i], 1) + collision::row_rate(tangents_[i], pushed);
      if (decides) c.resting.friction = std::copysign(c.material.friction, -acceleration);
      const double least = settings::contact_forces.min_slide_acceleration;
      if (std::abs(acceleration) < least || acceleration * c.resting.friction > 0.0) return false;
    }
  }
  return true;
}

// Solves the problem again, b being that `without` friction, until the tangential forces belong to
// the normal ones. False if they do not get there.
bool ContactForces::find_friction(const solver::Unknowns& without,
                                  std::span<const collision::Contact> contacts) {
  for (int round = 0; round < settings::contact_forces.friction_rounds; ++round) {
    const std::array<BodyState, max_bodies> pushed = pushed_by_forces(contacts, false);
    for (int i = 0; i < qp_.size(); ++i) {
      const solver::ConstraintRow& row = i < candidate_count_
                                             ? contacts[candidate_[i]].row
                                             : wheel_rows_[wheels_[i - candidate_count_]];
      qp_.b[i] = without[i] + collision::row_rate(row, pushed);
    }
    const solver::Unknowns last = qp_.x;
    qp_.solve();
    double change = 0.0;
    double largest = 0.0;
    for (int i = 0; i < candidate_count_; ++i) {
      change = std::max(change, std::abs(qp_.x[i] - last[i]));
      largest = std::max(largest, qp_.x[i]);
    }
    if (change <= settings::contact_forces.friction_tolerance * largest) return true;
  }
  return false;
}

// Returns bodies whose twists are the accelerations by the tangential forces of the contacts, or by
// all forces of the solution.
std::array<BodyState, max_bodies> ContactForces::pushed_by_forces(
    std::span<const collision::Contact> contacts, bool by_all) const {
  std::array<BodyState, max_bodies> pushed{};
  for (int i = 0; i < candidate_count_; ++i) {
    const collision::Contact& c = contacts[candidate_[i]];
    if (c.resting.friction != 0.0)
      collision::apply_impulse(tangents_[i], c.resting.friction * qp_.x[i], mass_, pushed);
    if (by_all) collision::apply_impulse(c.row, qp_.x[i], mass_, pushed);
  }
  for (int k = 0; by_all && k < wheel_count_; ++k) {
    const solver::ConstraintRow& row = wheel_rows_[wheels_[k]];
    collision::apply_impulse(row, qp_.x[candidate_count_ + k], mass_, pushed);
  }
  return pushed;
}

// Projects the velocities of all touching bodies together onto the admissible ones: pressing gaps
// do not change, other gaps do not close, wheels that hold do not slide. The projection is
// orthogonal in the metric of the masses, so it never adds energy. A projection of one body alone
// could, because the others would go on unchanged.
void ContactForces::project_velocities(std::span<BodyState> bodies,
                                       std::span<const collision::Contact> contacts) {
  const auto presses = [](const collision::Contact& c) { return c.resting.is_active; };
  if (std::none_of(contacts.begin(), contacts.end(), presses)) return;
  constraints_.clear();
  for (const collision::Contact& c : contacts) constraints_.push_back({&c.row, presses(c)});
  for (int k = 0; k < wheel_count_; ++k) constraints_.push_back({&wheel_rows_[wheels_[k]], true});
  if (are_admissible(bodies)) return;

  // The impulses of the projection: min 1/2 x.Ax + b.x, where b are the rates before. An impulse
  // may have either sign if the rate must become zero, else it only pushes.
  const int count = static_cast<int>(constraints_.size());
  const auto row = [&](int i) -> const solver::ConstraintRow& { return *constraints_[i].row; };
  qp_.reset(count);
  for (int i = 0; i < count; ++i) {
    qp_.b[i] = collision::row_rate(row(i), bodies);
    if (constraints_[i].is_equality) qp_.low[i] = -infinity;
  }
  impact::assemble_delassus(count, row, mass_, qp_);
  qp_.solve();
  for (int i = 0; i < count; ++i) collision::apply_impulse(row(i), qp_.x[i], mass_, bodies);
}

// True if the velocities satisfy constraints_ already, to rounding.
bool ContactForces::are_admissible(std::span<const BodyState> bodies) const {
  return std::all_of(constraints_.begin(), constraints_.end(), [&](const VelocityConstraint& c) {
    const double rate = collision::row_rate(*c.row, bodies);
    return rate >= -settings::contact_forces.min_rate &&
           (!c.is_equality || rate <= settings::contact_forces.min_rate);
  });
}

// Where several contacts, or contacts and wheels, can do the same, the solution is one of many,
// and a force in it may be almost zero. Such a contact would open at once and close again with as
// weak a force. Sets weak forces to zero and solves again. Keeps the first solution if a gap
// would close without its force.
void ContactForces::drop_weak_forces() {
  const auto& x = qp_.x;
  const double largest = *std::max_element(x.begin(), x.begin() + candidate_count_);
  const auto is_weak = [&](double force) {
    return force > settings::contact_forces.min_force &&
           force < settings::contact_forces.weak_share * largest;
  };
  if (std::none_of(x.begin(), x.begin() + candidate_count_, is_weak)) return;
  const auto with_all = x;
  const double limit = settings::contact_forces.weak_share * largest;
  for (int i = 0; i < candidate_count_; ++i) {
    if (x[i] < limit) qp_.high[i] = 0.0;
  }
  qp_.solve();
  for (int i = 0; i < candidate_count_; ++i) {
    if (qp_.high[i] == 0.0 && qp_.gradient(i) < -settings::contact_forces.min_closing) {
      qp_.x = with_all;
      return;
    }
  }
}

// A ball at rest starts to roll if it is pushed harder than its rolling resistance. The resistance
// acts against the push, and the push depends on the resistance if the ball has several contacts:
// one correction is enough. A ball that is wedged between its contacts does not start.
void ContactForces::start_ball(std::span<const trajectory::DriveReference> drives,
                               std::span<const BodyState> bodies,
                               std::span<const collision::Contact> contacts) {
  const Parameters& p = world_.parameters;
  if (p.rolling_friction == RollingFriction::per_axis) return;  // no resistance at rest
  const double resistance = p.rolling_resistance * p.ball_mass * gravity;
  const Vec2 push = push_on_ball(contacts);
  if (std::sqrt(push.squaredNorm()) <= resistance) return;
  grounding_[world_.robots].push = push;
  build_problem(drives, bodies, contacts);
  qp_.solve();
  const double force = std::sqrt(push.squaredNorm());
  if (push_on_ball(contacts).dot(push) / force - resistance > settings::contact_forces.min_force)
    return;
  grounding_[world_.robots].push = {0.0, 0.0};
  build_problem(drives, bodies, contacts);
  qp_.solve();
}

// Sets grounding_ of the members and collects the wheels that may hold.
void ContactForces::classify_ground(std::span<const trajectory::DriveReference> drives,
                                    std::span<BodyState> bodies) {
  wheel_count_ = 0;
  for_each_body(members_, [&](int i) {
    Twist& v = bodies[i].twist;
    if (world_.is_ball(i)) {
      grounding_[i] = {.ground = Ground::ball};
      if (std::abs(v.forward) + std::abs(v.left) <= world_.tolerances.slow_motion) v = {};
    } else if (!drives[i].wheels_on_ground) {
      grounding_[i] = {.ground = Ground::lifted};
    } else if (std::abs(v.left) > world_.tolerances.slow_motion) {
      grounding_[i] = {.ground = Ground::slides, .slip_sign = v.left > 0.0 ? 1.0 : -1.0};
    } else {
      v.left = 0.0;
      grounding_[i] = {.ground = Ground::rolls};
      if (is_held_sideways(world_, grounding_[i])) wheels_[wheel_count_++] = i;
    }
  });
}

// Sets up the QP: unknowns are the forces of the candidates, then those of the wheels. A is J
// M^-1 J', b the acceleration of each gap (or of each robot's lateral slip) without these forces,
// from the first two terms of the motion.
void ContactForces::build_problem(std::span<const trajectory::DriveReference> drives,
                                  std::span<const BodyState> bodies,
                                  std::span<const collision::Contact> contacts) {
  const Parameters& p = world_.parameters;
  for_each_body(members_, [&](int i) {
    const Grounding& g = grounding_[i];
    trajectory::Segment& s = trial_[i];
    set_first_terms(bodies[i], s);
    s.left[1] = 0.0;
    if (g.ground == Ground::ball) {
      trajectory::Braking braking =
          braking_along(trajectory::rolling_deceleration(p), {s.forward[0], s.left[0]}, g.push);
      extend_ball_twist(trajectory::rolling_deceleration(p), 0, s, braking);
    } else if (g.ground == Ground::lifted) {
      extend_twist_lifted(0, s);
    } else {
      extend_twist_on_ground(p, drives[i], g.slip_sign, 0, s);
      // The lateral force of the wheels is an unknown. Without it a turning robot keeps its
      // direction and drifts off its circle.
      if (is_held_sideways(world_, grounding_[i])) s.left[1] = -s.omega[0] * s.forward[0];
    }
    integrate_pose(s, 0);
  });

  qp_.reset(candidate_count_ + wheel_count_);
  for (int i = 0; i < candidate_count_; ++i) {
    const collision::Contact& c = contacts[candidate_[i]];
    ContactSeries& rows = rows_[i];
    start_rows(world_, c, trial_, rows);
    extend_rows(world_, c, 0, rows);
    qp_.b[i] = gap_rate_term(c, 1, rows);
  }
  const auto row = [&](int i) -> const solver::ConstraintRow& {
    return i < candidate_count_ ? contacts[candidate_[i]].row
                                : wheel_rows_[wheels_[i - candidate_count_]];
  };
  impact::assemble_delassus(qp_.size(), row, mass_, qp_);
  const double grip_force = p.grip * p.robot_mass * gravity;
  for (int k = 0; k < wheel_count_; ++k) {
    const int unknown = candidate_count_ + k;
    qp_.b[unknown] = trial_[wheels_[k]].left[1];
    qp_.low[unknown] = -grip_force;
    qp_.high[unknown] = grip_force;
  }
}

// Returns the sum of the contact forces on the ball, N, field frame.
Vec2 ContactForces::push_on_ball(std::span<const collision::Contact> contacts) const {
  Vec2 push{0.0, 0.0};
  for (int i = 0; i < candidate_count_; ++i) {
    const collision::Contact& c = contacts[candidate_[i]];
    if (c.a == world_.robots) push += qp_.x[i] * c.point.normal;
  }
  return push;
}

// Sets the contacts' forces, and lets wheels slide whose grip is used up.
void ContactForces::read_solution(std::span<collision::Contact> contacts) {
  for (int i = 0; i < candidate_count_; ++i) {
    collision::Contact& c = contacts[candidate_[i]];
    c.resting.force = qp_.x[i];
    c.resting.is_active = c.resting.force > settings::contact_forces.min_force;
  }
  for (int k = 0; k < wheel_count_; ++k) {
    const int row = candidate_count_ + k;
    const double acceleration = qp_.gradient(row);
    Grounding& g = grounding_[wheels_[k]];
    g.lateral_force = qp_.x[row];
    // Inside its bounds the force holds the wheels; the acceleration that is left is rounding.
    const bool is_at_bound = g.lateral_force == qp_.low[row] || g.lateral_force == qp_.high[row];
    if (!is_at_bound || std::abs(acceleration) <= settings::contact_forces.min_slip_acceleration)
      continue;
    g = {.ground = Ground::slides, .slip_sign = acceleration > 0.0 ? 1.0 : -1.0};
  }
}

}  // namespace mirocup::simulator::resting_contact
