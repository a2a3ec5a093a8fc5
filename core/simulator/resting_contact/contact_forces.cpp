// SPDX-License-Identifier: MIT
#include "core/simulator/resting_contact/contact_forces.hpp"

#include "core/simulator/impact/delassus.hpp"
#include "core/simulator/impact/islands.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator::resting_contact {

namespace {

// Forces below this (N) and accelerations below this (m/s^2) are rounding.
constexpr double min_force = 1e-9;
constexpr double min_slip_acceleration = 1e-10;

// A gap that should not change does not if its rate (m/s) is below this.
constexpr double min_rate = 1e-12;

// A force below this share of the largest is weak.
constexpr double weak_share = 1e-3;

// A contact may do without its force if its gap then closes no faster than this, m/s^2.
constexpr double min_closing = 1e-9;

}  // namespace

ContactForces::ContactForces(const collision::StaticWorld& world)
    : world_(world), rows_(solver::max_unknowns) {
  constraints_.reserve(solver::max_unknowns);
  for (int i = 0; i < world.robots; ++i) wheel_rows_[i] = collision::lateral_wheel_row(i);
}

const solver::InverseMass& ContactForces::mass(
    int body, std::span<const trajectory::DriveReference> drives) const {
  if (world_.is_ball(body)) return world_.ball;
  return drives[body].wheels_on_ground ? world_.grounded_robot : world_.free_robot;
}

void ContactForces::decide(std::span<const trajectory::DriveReference> drives,
                           double slip_threshold, double roll_threshold,
                           std::span<BodyState> bodies, std::span<collision::Contact> contacts) {
  slip_threshold_ = slip_threshold;
  roll_threshold_ = roll_threshold;
  candidate_count_ = 0;
  BodySet in_contact;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    collision::Contact& c = contacts[i];
    c.resting.is_active = false;
    if (collision::row_rate(c.row, bodies) > c.impact.restitution_threshold) continue;
    candidate_[candidate_count_++] = static_cast<int>(i);
    in_contact |= bodies_of(c.pair);
  }
  if (candidate_count_ == 0) return;
  member_count_ = 0;
  for (int i = 0; i < world_.bodies(); ++i) {
    if (in_contact[i]) member_[member_count_++] = i;
  }

  classify_ground(drives, bodies);
  build_problem(drives, bodies, contacts);
  qp_.solve();

  const int ball = world_.robots;
  const bool rests = world_.has_ball && in_contact[ball] && bodies[ball].twist.forward == 0.0 &&
                     bodies[ball].twist.left == 0.0;
  if (rests) start_ball(drives, bodies, contacts);
  drop_weak_forces();
  read_solution(contacts);
  project_velocities(drives, bodies, contacts);
  // What that gives a ball at rest on which nothing presses is rounding: it would stop at once, again
  // and again.
  if (rests && impact::cluster_of(ball, contacts).none()) bodies[ball].twist = {};
}

// Gaps that are held do not change, no other closes, wheels that roll do not slide yet. Of all such
// velocities, those nearest to what they were, for all bodies together: that never adds energy. It
// could, if one body alone had to give way to another that goes on as it likes.
void ContactForces::project_velocities(std::span<const trajectory::DriveReference> drives,
                                       std::span<BodyState> bodies,
                                       std::span<const collision::Contact> contacts) {
  if (std::none_of(contacts.begin(), contacts.end(),
                   [](const collision::Contact& c) { return c.resting.is_active; })) {
    return;
  }
  std::array<solver::InverseMass, max_bodies> mass;
  constraints_.clear();
  for (const collision::Contact& c : contacts) {
    constraints_.push_back(c.row);
    for (const int i : {c.a, c.b}) {
      if (i != no_body) mass[i] = this->mass(i, drives);
    }
  }
  const auto held = [&](int i) {
    return i >= static_cast<int>(contacts.size()) || contacts[i].resting.is_active;
  };
  for (int k = 0; k < wheel_count_; ++k) constraints_.push_back(wheel_rows_[wheels_[k]]);

  qp_.reset(static_cast<int>(constraints_.size()));
  bool fits = true;
  for (int i = 0; i < qp_.size(); ++i) {
    qp_.b[i] = collision::row_rate(constraints_[i], bodies);
    fits = fits && qp_.b[i] >= -min_rate && (!held(i) || qp_.b[i] <= min_rate);
  }
  if (fits) return;
  for (int i = 0; i < qp_.size(); ++i) {
    if (held(i)) qp_.low[i] = -infinity;
  }
  impact::assemble_delassus(
      qp_.size(), [&](int i) -> const solver::ConstraintRow& { return constraints_[i]; }, mass,
      qp_);
  qp_.solve();
  for (int i = 0; i < qp_.size(); ++i) {
    collision::apply_impulse(constraints_[i], qp_.x[i], mass, bodies);
  }
}

// Where several contacts, or contacts and wheels, can do the same, the solution is one of many, and
// a force in it may be next to nothing: it would fall to zero at once, only to come back as little
// at the next look. Such contacts are left to the others, if these can do without.
void ContactForces::drop_weak_forces() {
  const auto& x = qp_.x;
  const double largest = *std::max_element(x.begin(), x.begin() + candidate_count_);
  const auto is_weak = [&](double force) {
    return force > min_force && force < weak_share * largest;
  };
  if (std::none_of(x.begin(), x.begin() + candidate_count_, is_weak)) return;
  const auto with_all = x;
  const double limit = weak_share * largest;
  for (int i = 0; i < candidate_count_; ++i) {
    if (x[i] < limit) qp_.high[i] = 0.0;
  }
  qp_.solve();
  for (int i = 0; i < candidate_count_; ++i) {
    if (qp_.high[i] == 0.0 && qp_.gradient(i) < -min_closing) {
      qp_.x = with_all;
      return;
    }
  }
}

// The resistance against a ball that starts is along its push, which depends on the resistance only
// if there are several contacts: one correction settles it. A ball that is held between its
// contacts does not start.
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
  if (push_on_ball(contacts).dot(push) / force - resistance > min_force) return;
  grounding_[world_.robots].push = {0.0, 0.0};
  build_problem(drives, bodies, contacts);
  qp_.solve();
}

void ContactForces::classify_ground(std::span<const trajectory::DriveReference> drives,
                                    std::span<BodyState> bodies) {
  wheel_count_ = 0;
  for (int k = 0; k < member_count_; ++k) {
    const int i = member_[k];
    Twist& v = bodies[i].twist;
    if (world_.is_ball(i)) {
      grounding_[i] = {.ground = Ground::ball};
      if (std::abs(v.forward) + std::abs(v.left) <= roll_threshold_) v = {};
    } else if (!drives[i].wheels_on_ground) {
      grounding_[i] = {.ground = Ground::lifted};
    } else if (std::abs(v.left) > slip_threshold_) {
      grounding_[i] = {.ground = Ground::slides, .slip_sign = v.left > 0.0 ? 1.0 : -1.0};
    } else {
      v.left = 0.0;
      grounding_[i] = {.ground = Ground::rolls};
      if (is_held_sideways(world_, grounding_[i])) wheels_[wheel_count_++] = i;
    }
  }
}

void ContactForces::build_problem(std::span<const trajectory::DriveReference> drives,
                                  std::span<const BodyState> bodies,
                                  std::span<const collision::Contact> contacts) {
  const Parameters& p = world_.parameters;
  std::array<solver::InverseMass, max_bodies> mass;
  for (int k = 0; k < member_count_; ++k) {
    const int i = member_[k];
    const Grounding& g = grounding_[i];
    trajectory::Segment& s = trial_[i];
    s = trajectory::moving_segment(bodies[i], 0.0, 0.0);
    if (g.ground == Ground::ball) {
      trajectory::Braking braking =
          braking_along(trajectory::rolling_deceleration(p), {s.forward[0], s.left[0]}, g.push);
      extend_ball_twist(trajectory::rolling_deceleration(p), 0, s, braking);
    } else if (g.ground == Ground::lifted) {
      extend_twist_lifted(0, s);
    } else {
      extend_twist_on_ground(p, drives[i], g.slip_sign, 0, s);
      // The wheels' sideways force is an unknown: without it a turning robot would drift off its
      // circle.
      if (is_held_sideways(world_, grounding_[i])) s.left[1] = -s.omega[0] * s.forward[0];
    }
    integrate_pose(s, 0);
    mass[i] = this->mass(i, drives);
  }

  qp_.reset(candidate_count_ + wheel_count_);
  for (int i = 0; i < candidate_count_; ++i) {
    const collision::Contact& c = contacts[candidate_[i]];
    ContactSeries& rows = rows_[i];
    start_rows(world_, c, trial_, rows);
    extend_rows(world_, c, trial_, 0, rows);
    qp_.b[i] = gap_rate_term(c, trial_, 1, rows);
  }
  const auto row = [&](int i) -> const solver::ConstraintRow& {
    return i < candidate_count_ ? contacts[candidate_[i]].row
                                : wheel_rows_[wheels_[i - candidate_count_]];
  };
  impact::assemble_delassus(qp_.size(), row, mass, qp_);
  const double grip_force = p.grip * p.robot_mass * gravity;
  for (int k = 0; k < wheel_count_; ++k) {
    const int unknown = candidate_count_ + k;
    qp_.b[unknown] = trial_[wheels_[k]].left[1];
    qp_.low[unknown] = -grip_force;
    qp_.high[unknown] = grip_force;
  }
}

Vec2 ContactForces::push_on_ball(std::span<const collision::Contact> contacts) const {
  Vec2 push{0.0, 0.0};
  for (int i = 0; i < candidate_count_; ++i) {
    const collision::Contact& c = contacts[candidate_[i]];
    if (c.a == world_.robots) push += qp_.x[i] * c.point.normal;
  }
  return push;
}

void ContactForces::read_solution(std::span<collision::Contact> contacts) {
  for (int i = 0; i < candidate_count_; ++i) {
    collision::Contact& c = contacts[candidate_[i]];
    c.resting.force = qp_.x[i];
    c.resting.is_active = c.resting.force > min_force;
  }
  for (int k = 0; k < wheel_count_; ++k) {
    const int row = candidate_count_ + k;
    const double acceleration = qp_.gradient(row);
    Grounding& g = grounding_[wheels_[k]];
    g.lateral_force = qp_.x[row];
    // Inside its bounds the force holds, whatever rounding leaves of the acceleration.
    const bool gives_all = g.lateral_force == qp_.low[row] || g.lateral_force == qp_.high[row];
    if (!gives_all || std::abs(acceleration) <= min_slip_acceleration) continue;
    g = {.ground = Ground::slides, .slip_sign = acceleration > 0.0 ? 1.0 : -1.0};
  }
}

}  // namespace mirocup::simulator::resting_contact
