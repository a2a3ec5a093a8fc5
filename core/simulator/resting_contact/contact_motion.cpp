// SPDX-License-Identifier: MIT
#include "core/simulator/resting_contact/contact_motion.hpp"

#include "core/base/assert.hpp"
#include "core/simulator/impact/delassus.hpp"
#include "core/simulator/impact/position_correction.hpp"
#include "core/simulator/model/solver_settings.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator::resting_contact {

ContactMotion::ContactMotion(const collision::StaticWorld& world)
    : world_(world), rows_(solver::max_unknowns) {}

void ContactMotion::move(const BodySet& cluster, const ContactForces& forces,
                         std::span<collision::Contact> contacts,
                         std::span<const trajectory::DriveReference> drives,
                         const SegmentRequest& request, std::span<BodyState> bodies,
                         std::span<trajectory::Segment> segments) {
  spoil(members_, mass_, braking_, slip_sign_, grounding_, held_, held_index_, wheels_,
        lateral_force_, rhs_);
  drives_ = drives;
  set_members(cluster, forces);
  select_active(contacts);
  close_gaps(bodies);
  // Wheels that begin a marginal slide hold instead, and the series start again. There are no more
  // rounds than wheels, because none begins to slide again.
  while (true) {
    start_series(request, bodies, segments);
    if (arrest_reversed_slip(contacts, segments)) continue;
    mark_persistent(contacts);
    if (is_at_rest(segments)) return stand_still(request, bodies, segments);
    extend_until_converged(request, segments);
    find_end(request, segments);
    if (!arrest_brief_slip(request, contacts, segments)) return;
  }
}

void ContactMotion::stand_still(const SegmentRequest& request, std::span<const BodyState> bodies,
                                std::span<trajectory::Segment> segments) const {
  for (const int i : members()) {
    segments[i] = trajectory::still_segment(bodies[i], request.begin, request.horizon);
  }
}

// Wheels that were to slide one way and are pulled the other way by the cluster hold instead: the
// decision was rounding. Returns true if there were any.
bool ContactMotion::arrest_reversed_slip(std::span<const collision::Contact> contacts,
                                         std::span<const trajectory::Segment> segments) {
  return arrest_slip(contacts, segments, [](const Grounding& g, const trajectory::Segment& s) {
    return g.slip_sign * s.left[1] < 0.0;
  });
}

// Wheels that are back at rest before anything else may change hold instead: the slide is not worth
// an event. Call when the segments have their end. Returns true if there were any.
bool ContactMotion::arrest_brief_slip(const SegmentRequest& request,
                                      std::span<const collision::Contact> contacts,
                                      std::span<const trajectory::Segment> segments) {
  return arrest_slip(contacts, segments, [&](const Grounding&, const trajectory::Segment& s) {
    return s.settles == trajectory::TerminalState::sideways &&
           s.end - s.begin < request.min_duration;
  });
}

// Lets those wheels hold that begin to slide from rest and for which is_marginal(grounding,
// segment). Otherwise they would begin and end the same slide for ever.
template <class IsMarginal>
bool ContactMotion::arrest_slip(std::span<const collision::Contact> contacts,
                                std::span<const trajectory::Segment> segments,
                                IsMarginal is_marginal) {
  bool found = false;
  for (const int i : members()) {
    Grounding& g = grounding_[i];
    if (g.ground != Ground::slides || segments[i].left[0] != 0.0) continue;
    if (!is_marginal(g, segments[i])) continue;
    g = {.ground = Ground::rolls, .lateral_force = -g.slip_sign * max_grip()};
    found = true;
  }
  if (found) select_active(contacts);
  return found;
}

// Extends the series of the cluster as fill_series() extends those of one body.
void ContactMotion::extend_until_converged(const SegmentRequest& request,
                                           std::span<trajectory::Segment> segments) {
  const double length = std::min(request.preferred_duration, request.horizon - request.begin);
  int k = 1;
  for (const int terms : trajectory::term_counts) {
    for (; k < terms - 1; ++k) extend(k, segments);
    set_terms_of_all(terms, segments);
    const bool converged = std::all_of(members().begin(), members().end(), [&](int i) {
      return has_converged(segments[i], length, settings::segment.contact_truncation);
    });
    if (converged) return;
  }
}

// Computes term k + 1 of poses, twists and rows, and term k of the forces.
void ContactMotion::extend(int k, std::span<trajectory::Segment> segments) {
  for (const int i : members())
    integrate_pose(segments[i], k, grounding_[i].ground != Ground::rolls);
  for (int i = 0; i < held_count_; ++i) extend_rows(world_, held_[i], k, rows_[i]);
  extend_twists(k, segments);
  solve_for_forces(k, segments);
}

void ContactMotion::set_terms_of_all(int terms, std::span<trajectory::Segment> segments) {
  for (const int i : members()) set_terms(segments[i], terms);
  for (int i = 0; i < held_count_; ++i) resting_contact::set_terms(rows_[i], terms);
  for (int w = 0; w < wheel_count_; ++w) {
    lateral_force_[w].terms = terms;
    lateral_force_[w][terms - 1] = 0.0;
  }
}

// Returns the length over which all series have converged, s.
double ContactMotion::converged_length_of_all(std::span<const trajectory::Segment> segments) const {
  double length = segments[members_[0]].end - segments[members_[0]].begin;
  for (const int i : members())
    length = converged_length(segments[i], length, settings::segment.contact_truncation);
  return length;
}

// True if nothing moves or gains speed. Commands are constant within a tick, so the cluster stays
// at rest.
bool ContactMotion::is_at_rest(std::span<const trajectory::Segment> segments) const {
  for (const int i : members()) {
    const trajectory::Segment& s = segments[i];
    for (const trajectory::Series* p : {&s.forward, &s.left, &s.omega}) {
      if (std::abs((*p)[0]) > settings::contact_motion.resting_speed ||
          std::abs((*p)[1]) > settings::contact_motion.resting_acceleration)
        return false;
    }
  }
  return true;
}

void ContactMotion::set_members(const BodySet& cluster, const ContactForces& forces) {
  member_count_ = 0;
  for_each_body(cluster, [&](int i) {
    members_[member_count_++] = i;
    mass_[i] = forces.mass(i, drives_);
    grounding_[i] = forces.grounding(i);
  });
}

// Collects the equations: contacts that press and wheels that hold. Redundant equations, which
// follow from the ones before them, keep their forces; so the forces with most room to change
// come first.
void ContactMotion::select_active(std::span<const collision::Contact> contacts) {
  wheel_count_ = 0;
  BodySet cluster;
  for (const int i : members()) {
    cluster.set(i);
    if (is_held_sideways(world_, grounding_[i])) wheels_[wheel_count_++] = i;
  }
  // std::stable_sort() would allocate: equal forces stay in the order of their indices.
  std::sort(wheels_.begin(), wheels_.begin() + wheel_count_, [this](int a, int b) {
    const double of_a = std::abs(grounding_[a].lateral_force);
    const double of_b = std::abs(grounding_[b].lateral_force);
    return of_a < of_b || (of_a == of_b && a < b);
  });

  held_count_ = 0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const collision::Contact& c = contacts[i];
    if (c.resting.is_active && cluster[c.pair.a]) held_index_[held_count_++] = static_cast<int>(i);
  }
  std::sort(held_index_.begin(), held_index_.begin() + held_count_, [contacts](int a, int b) {
    const double of_a = contacts[a].resting.force;
    const double of_b = contacts[b].resting.force;
    return of_a > of_b || (of_a == of_b && a < b);
  });
  have_friction_ = false;
  for (int i = 0; i < held_count_; ++i) {
    held_[i] = contacts[held_index_[i]];
    have_friction_ = have_friction_ || held_[i].resting.friction != 0.0;
  }
}

// The gaps of pressing contacts stay zero on the whole segment if no equation is redundant. A
// redundant equation follows from the others at the start only; later its gap may change.
void ContactMotion::mark_persistent(std::span<collision::Contact> contacts) const {
  bool all = true;
  for (int i = 0; i < equations(); ++i) all = all && !cholesky_.is_redundant(i);
  for (int i = 0; i < held_count_; ++i) contacts[held_index_[i]].resting.is_persistent = all;
}

// Computes the first two terms of all series, and makes velocities fit the contacts.
void ContactMotion::start_series(const SegmentRequest& request, std::span<BodyState> bodies,
                                 std::span<trajectory::Segment> segments) {
  for (const int i : members())
    segments[i] = trajectory::moving_segment(bodies[i], request.begin, request.horizon);
  for (int i = 0; i < held_count_; ++i) {
    start_rows(world_, held_[i], segments, rows_[i]);
    held_[i].row =
        solver::difference_row(held_[i].a, held_[i].b, rows_[i].first_a, rows_[i].first_b);
  }
  for (int k = 0; k < wheel_count_; ++k) lateral_force_[k] = {};

  factorise();
  project_velocities(bodies);
  for (const int i : members()) {
    const Twist& v = bodies[i].twist;
    segments[i].forward[0] = v.forward;
    segments[i].left[0] = v.left;
    segments[i].omega[0] = v.omega;
    if (world_.is_ball(i)) {
      braking_[i] = braking_along(trajectory::rolling_deceleration(world_.parameters),
                                  {v.forward, v.left}, grounding_[i].push);
    }
  }
  extend(0, segments);
}

// Moves bodies so that pressing gaps become zero. Gaps of nearly contradicting contacts would
// need a long move: they stay.
void ContactMotion::close_gaps(std::span<BodyState> bodies) {
  double widest = 0.0;
  for (int i = 0; i < held_count_; ++i) widest = std::max(widest, std::abs(held_[i].point.gap));
  if (widest <= settings::contact_motion.closed_gap_share * world_.tolerances.penetration) return;
  factorise();
  for (int i = 0; i < equations(); ++i) rhs_[i] = i < held_count_ ? -held_[i].point.gap : 0.0;
  cholesky_.solve(rhs_);
  std::array<impact::Displacement, max_bodies> displacements{};
  for (int i = 0; i < held_count_; ++i)
    impact::add_displacement(held_[i].row, rhs_[i], mass_, displacements);
  for (int w = held_count_; w < equations(); ++w) {
    impact::add_displacement(collision::lateral_wheel_row(wheel_state(w)), rhs_[w], mass_,
                             displacements);
  }
  const auto is_too_long = [&](int i) {
    const impact::Displacement& by = displacements[i];
    return std::abs(by.forward) + std::abs(by.left) + std::abs(by.omega) * world_.shape(i).radius >
           settings::contact_motion.max_displacement;
  };
  if (std::any_of(members().begin(), members().end(), is_too_long)) return;
  for (const int i : members()) bodies[i] = impact::displaced(bodies[i], displacements[i]);
}

// Makes the rates of pressing gaps and the slip of holding wheels zero. They differ from zero
// only by what close_gaps() has changed.
void ContactMotion::project_velocities(std::span<BodyState> bodies) {
  for (int i = 0; i < equations(); ++i) {
    rhs_[i] = i < held_count_ ? -collision::row_rate(held_[i].row, bodies)
                              : -bodies[wheel_state(i)].twist.left;
  }
  cholesky_.solve(rhs_);
  for (int i = 0; i < held_count_; ++i)
    collision::apply_impulse(held_[i].row, rhs_[i], mass_, bodies);
  for (int k = 0; k < wheel_count_; ++k) bodies[wheels_[k]].twist.left = 0.0;
  for (const int i : members()) {
    double& left = bodies[i].twist.left;
    slip_sign_[i] = grounding_[i].slip_sign;
    if (slip_sign_[i] == 0.0) continue;
    if (std::abs(left) <= world_.tolerances.slow_motion) {
      left = 0.0;
    } else {
      slip_sign_[i] = left > 0.0 ? 1.0 : -1.0;
    }
  }
}

// Factorises J M^-1 J' of the equations.
void ContactMotion::factorise() {
  impact::DelassusOperator bodies;
  for (int i = 0; i < held_count_; ++i) bodies.add(i, held_[i].row);
  for (int w = held_count_; w < equations(); ++w)
    bodies.add(w, collision::lateral_wheel_row(wheel_state(w)));
  cholesky_.reset(equations());
  bodies.couple(mass_, cholesky_);
  cholesky_.factorise();
}

// Computes term k + 1 of the twists, without the part that term k of the forces adds.
void ContactMotion::extend_twists(int k, std::span<trajectory::Segment> segments) {
  const Parameters& p = world_.parameters;
  for (const int i : members()) {
    const Grounding& g = grounding_[i];
    trajectory::Segment& s = segments[i];
    switch (g.ground) {
      case Ground::ball:
        extend_ball_twist(trajectory::rolling_deceleration(p), k, s, braking_[i]);
        break;
      case Ground::lifted:
        extend_twist_lifted(k, s);
        break;
      case Ground::rolls:
      case Ground::slides:
        extend_twist_on_ground(p, drives_[i], slip_sign_[i], k, s);
        break;
    }
  }
  for (int w = 0; w < wheel_count_; ++w) {
    trajectory::Segment& s = segments[wheels_[w]];
    s.left[k + 1] = -product_term(s.omega, s.forward, k) / (k + 1);
  }
  const double share = 1.0 / (k + 1);
  for (int i = 0; k > 0 && i < held_count_; ++i) {
    const RowTerms row = later_force_term(held_[i], rows_[i], k);
    if (held_[i].a != no_body) add_to_twist(held_[i].a, row.a, share, k + 1, segments);
    if (held_[i].b != no_body) add_to_twist(held_[i].b, row.b, -share, k + 1, segments);
  }
}

// Computes term k of the forces, and adds it to term k + 1 of the twists.
//
// The rate of a pressing gap, and the slip of holding wheels, is zero at all times: each of its
// terms is zero. Term k + 1 of the rate is its value without term k of the forces, plus (J M^-1
// J' force[k]) / (k + 1). So the right-hand side is -(k + 1) times the value without. Friction adds
// to the rates what the next round takes away.
void ContactMotion::solve_for_forces(int k, std::span<trajectory::Segment> segments) {
  if (k == 0) apply_redundant_forces(segments);
  const int rounds = have_friction_ ? settings::contact_forces.friction_rounds : 1;
  bool agree = false;
  for (int round = 0; round < rounds && !agree; ++round) {
    for (int i = 0; i < held_count_; ++i)
      rhs_[i] = -(k + 1) * gap_rate_term(held_[i], k + 1, rows_[i]);
    for (int w = 0; w < wheel_count_; ++w)
      rhs_[held_count_ + w] = -(k + 1) * segments[wheels_[w]].left[k + 1];
    cholesky_.solve(rhs_);
    agree = true;
    for (int i = 0; i < held_count_; ++i) {
      if (cholesky_.is_redundant(i)) continue;
      double& force = rows_[i].force[k];
      force = round == 0 ? rhs_[i] : force + rhs_[i];
      add_force(i, k, rhs_[i], segments);
      agree = agree &&
              std::abs(rhs_[i]) <= settings::contact_motion.friction_round_off * std::abs(force);
    }
    for (int w = 0; w < wheel_count_; ++w) {
      double& left = segments[wheels_[w]].left[k + 1];
      if (cholesky_.is_redundant(held_count_ + w)) continue;
      const double force = rhs_[held_count_ + w];
      lateral_force_[w][k] = round == 0 ? force : lateral_force_[w][k] + force;
      left += force * mass_[wheels_[w]].left / (k + 1);
    }
  }
  for (int w = 0; w < wheel_count_; ++w) segments[wheels_[w]].left[k + 1] = 0.0;
}

// The equations leave the forces of redundant ones open. They keep the constant value that
// ContactForces has decided.
void ContactMotion::apply_redundant_forces(std::span<trajectory::Segment> segments) {
  for (int i = 0; i < held_count_; ++i) {
    if (!cholesky_.is_redundant(i)) continue;
    rows_[i].force = {};
    rows_[i].force[0] = held_[i].resting.force;
    add_force(i, 0, rows_[i].force[0], segments);
  }
  for (int w = 0; w < wheel_count_; ++w) {
    if (!cholesky_.is_redundant(held_count_ + w)) continue;
    const int body = wheels_[w];
    lateral_force_[w][0] = grounding_[body].lateral_force;
    segments[body].left[1] += grounding_[body].lateral_force * mass_[body].left;
  }
}

// Adds to term k + 1 of the twists what this much of term k of the contact's force gives along the
// first term of its row.
void ContactMotion::add_force(int i, int k, double force,
                              std::span<trajectory::Segment> segments) const {
  const auto add = [&](const solver::ConstraintRow& row) {
    add_to_twist(row.a, row.on_a, force / (k + 1), k + 1, segments);
    if (row.b != no_body) add_to_twist(row.b, row.on_b, force / (k + 1), k + 1, segments);
  };
  have_friction_ ? add(first_push(held_[i], rows_[i])) : add(held_[i].row);
}

void ContactMotion::add_to_twist(int body, const solver::JacobianRow& row, double amount, int term,
                                 std::span<trajectory::Segment> segments) const {
  const solver::InverseMass& mass = mass_[body];
  trajectory::Segment& s = segments[body];
  s.forward[term] += amount * row[0] * mass.forward;
  s.left[term] += amount * row[1] * mass.left;
  s.omega[term] += amount * row[2] * mass.omega;
}

// Returns when a contact opens or its point leaves the edge, s after the start; at most `length`.
double ContactMotion::time_of_release(double min_duration, double length) const {
  for (int i = 0; i < held_count_; ++i) {
    const double from = std::min(min_duration, length);
    if (!cholesky_.is_redundant(i)) {
      length = std::min(length, first_crossing(rows_[i].force, 0.0, from, length));
    }
    length = time_on_edge(held_[i], rows_[i], settings::contact_motion.edge_overhang, length);
  }
  return length;
}

// Returns when the grip of wheels is used up, s after the start; at most `length`.
double ContactMotion::time_of_slip(double min_duration, double length) const {
  const double grip = max_grip();
  for (int w = 0; w < wheel_count_; ++w) {
    if (cholesky_.is_redundant(held_count_ + w)) continue;
    const double from = std::min(min_duration, length);
    length = std::min(length, first_crossing(lateral_force_[w], -grip, from, length));
    length = std::min(length, first_crossing(-1.0 * lateral_force_[w], -grip, from, length));
  }
  return length;
}

// Returns when a contact ceases to slide against its friction, s after the start; at most `length`.
double ContactMotion::time_of_stick(double length) const {
  for (int i = 0; have_friction_ && i < held_count_; ++i) {
    if (held_[i].resting.friction == 0.0) continue;
    length = time_of_rest(held_[i], rows_[i], world_.tolerances.slow_motion, length);
  }
  return length;
}

// Sets the common end of the segments: the earliest of convergence, release, slip, stick, and the
// ends of single bodies. The body that ends the segment may settle exactly there.
void ContactMotion::find_end(const SegmentRequest& request,
                             std::span<trajectory::Segment> segments) const {
  double length = converged_length_of_all(segments);
  length = time_of_slip(request.min_duration, time_of_release(request.min_duration, length));
  length = time_of_stick(length);
  int settling = no_body;
  for (const int i : members()) {
    segments[i].end = request.begin + length;  // limits the search for the body's own end
    const OwnEnd own = own_end(i, segments[i], length, request.min_duration);
    if (own.time > length) continue;
    length = own.time;
    settling = own.settles ? i : no_body;
  }
  for (const int i : members()) segments[i].end = request.begin + length;
  if (settling != no_body) {
    segments[settling].settles = world_.is_ball(settling) ? trajectory::TerminalState::everything
                                                          : trajectory::TerminalState::sideways;
  }
}

// Returns when sliding wheels grip again or the ball's braking changes, or never.
ContactMotion::OwnEnd ContactMotion::own_end(int body, const trajectory::Segment& segment,
                                             double length, double min_duration) const {
  const Grounding& g = grounding_[body];
  if (g.ground == Ground::slides) return {time_of_grip(segment, slip_sign_[body]), true};
  if (g.ground != Ground::ball) return {trajectory::never, false};
  const trajectory::RollingDeceleration deceleration =
      trajectory::rolling_deceleration(world_.parameters);
  const double time = time_of_braking_change(deceleration, segment, braking_[body], length);
  // A ball that would change its direction at once goes on for the minimum duration. A ball that
  // brakes by axis goes on along the other axis.
  if (time < min_duration) return {min_duration, false};
  return {time, !deceleration.is_per_axis()};
}

}  // namespace mirocup::simulator::resting_contact
