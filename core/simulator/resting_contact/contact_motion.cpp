// SPDX-License-Identifier: MIT
#include "core/simulator/resting_contact/contact_motion.hpp"

#include "core/simulator/impact/delassus.hpp"
#include "core/simulator/impact/position_correction.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator::resting_contact {

namespace {

// How far (m) a corner may stand out over the end of its edge before the contact is looked at
// again.
constexpr double edge_overhang = 1e-10;

// A gap this share of the sink tolerance need not be closed.
constexpr double closed_gap_share = 0.01;

// Contacts that hardly differ ask for more than that, m, to close gaps that do: those stay.
constexpr double max_displacement = 1e-9;

// A cluster whose speeds (m/s, rad/s) and accelerations (m/s^2, rad/s^2) are below these is at
// rest.
constexpr double resting_speed = 1e-10;
constexpr double resting_acceleration = 1e-9;

}  // namespace

ContactMotion::ContactMotion(const collision::StaticWorld& world)
    : world_(world), rows_(solver::max_unknowns) {}

void ContactMotion::move(const BodySet& cluster, const ContactForces& forces,
                         std::span<collision::Contact> contacts,
                         std::span<const trajectory::DriveReference> drives,
                         const SegmentRequest& request, std::span<BodyState> bodies,
                         std::span<trajectory::Segment> segments) {
  drives_ = drives;
  set_members(cluster, forces);
  select_active(contacts);
  close_gaps(bodies);
  do {
    do {
      start_series(request, bodies, segments);
    } while (arrest_marginal_slip(request, contacts, segments));
    mark_persistent(contacts);
    if (is_at_rest(segments)) {
      for (int m = 0; m < member_count_; ++m) {
        segments[members_[m]] =
            trajectory::still_segment(bodies[members_[m]], request.begin, request.horizon);
      }
      return;
    }
    extend_until_converged(request, segments);
    find_end(request, segments);
  } while (arrest_marginal_slip(request, contacts, segments));
}

// WheelState at rest that were to slide one way, and that the cluster pulls the other or has back at
// rest before anything else may change: what was decided about them was rounding, or the slide was
// all but over. They would do the same again, and again.
bool ContactMotion::arrest_marginal_slip(const SegmentRequest& request,
                                         std::span<const collision::Contact> contacts,
                                         std::span<const trajectory::Segment> segments) {
  const double grip = max_grip();
  bool found = false;
  for (int m = 0; m < member_count_; ++m) {
    const int i = members_[m];
    const trajectory::Segment& s = segments[i];
    Grounding& g = grounding_[i];
    if (g.ground != Ground::slides || s.left[0] != 0.0) continue;
    const bool turns_back = g.slip_sign * s.left[1] < 0.0;
    const bool is_brief = s.settles == trajectory::TerminalState::sideways &&
                          s.end - s.begin < request.min_duration;  // once it has its end
    if (!turns_back && !is_brief) continue;
    g = {.ground = Ground::rolls, .lateral_force = -g.slip_sign * grip};
    found = true;
  }
  if (found) select_active(contacts);
  return found;
}

// As fill_series() does for one body.
void ContactMotion::extend_until_converged(const SegmentRequest& request,
                                           std::span<trajectory::Segment> segments) {
  const double length = std::min(request.preferred_duration, request.horizon - request.begin);
  int k = 1;
  for (const int terms : trajectory::term_counts) {
    for (; k < terms - 1; ++k) extend(k, segments);
    set_terms_of_all(terms, segments);
    const bool converged = std::all_of(
        members_.begin(), members_.begin() + member_count_,
        [&](int i) { return has_converged(segments[i], length, trajectory::contact_truncation); });
    if (converged) return;
  }
}

// Term k + 1 of everything.
void ContactMotion::extend(int k, std::span<trajectory::Segment> segments) {
  for (int m = 0; m < member_count_; ++m) integrate_pose(segments[members_[m]], k);
  for (int i = 0; i < held_count_; ++i) extend_rows(world_, held_[i], segments, k, rows_[i]);
  extend_twists(k, segments);
  solve_for_forces(k, segments);
}

void ContactMotion::set_terms_of_all(int terms, std::span<trajectory::Segment> segments) {
  for (int m = 0; m < member_count_; ++m) set_terms(segments[members_[m]], terms);
  for (int i = 0; i < held_count_; ++i) resting_contact::set_terms(rows_[i], terms);
  for (int w = 0; w < wheel_count_; ++w) lateral_force_[w].terms = terms;
}

double ContactMotion::converged_length_of_all(std::span<const trajectory::Segment> segments) const {
  double length = segments[members_[0]].end - segments[members_[0]].begin;
  for (int m = 0; m < member_count_; ++m) {
    length = converged_length(segments[members_[m]], length, trajectory::contact_truncation);
  }
  return length;
}

// Nothing moves and nothing gains speed: constant commands keep it so.
bool ContactMotion::is_at_rest(std::span<const trajectory::Segment> segments) const {
  for (int m = 0; m < member_count_; ++m) {
    const trajectory::Segment& s = segments[members_[m]];
    for (const trajectory::Series* p : {&s.forward, &s.left, &s.omega}) {
      if (std::abs((*p)[0]) > resting_speed || std::abs((*p)[1]) > resting_acceleration)
        return false;
    }
  }
  return true;
}

void ContactMotion::set_members(const BodySet& cluster, const ContactForces& forces) {
  slip_threshold_ = forces.slip_threshold();
  member_count_ = 0;
  for (int i = 0; i < world_.bodies(); ++i) {
    if (!cluster[i]) continue;
    members_[member_count_++] = i;
    mass_[i] = forces.mass(i, drives_);
    grounding_[i] = forces.grounding(i);
  }
}

// The equations are put in order of how far their forces are from a bound: where some follow from
// others, the last ones keep their force, and it is better that those with room to change do so.
void ContactMotion::select_active(std::span<const collision::Contact> contacts) {
  wheel_count_ = 0;
  BodySet cluster;
  for (int m = 0; m < member_count_; ++m) {
    const int i = members_[m];
    cluster.set(i);
    if (is_held_sideways(world_, grounding_[i])) wheels_[wheel_count_++] = i;
  }
  std::stable_sort(wheels_.begin(), wheels_.begin() + wheel_count_, [this](int a, int b) {
    return std::abs(grounding_[a].lateral_force) < std::abs(grounding_[b].lateral_force);
  });

  held_count_ = 0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const collision::Contact& c = contacts[i];
    if (c.resting.is_active && cluster[c.pair.a]) held_index_[held_count_++] = static_cast<int>(i);
  }
  std::stable_sort(
      held_index_.begin(), held_index_.begin() + held_count_,
      [contacts](int a, int b) { return contacts[a].resting.force > contacts[b].resting.force; });
  for (int i = 0; i < held_count_; ++i) held_[i] = contacts[held_index_[i]];
}

// Equations that follow from others do so only at the begin: later they may be off, and the gaps of
// the cluster with them.
void ContactMotion::mark_persistent(std::span<collision::Contact> contacts) const {
  bool all = true;
  for (int i = 0; i < equations(); ++i) all = all && !cholesky_.is_redundant(i);
  for (int i = 0; i < held_count_; ++i) contacts[held_index_[i]].resting.is_persistent = all;
}

// The first two terms.
void ContactMotion::start_series(const SegmentRequest& request, std::span<BodyState> bodies,
                                 std::span<trajectory::Segment> segments) {
  for (int m = 0; m < member_count_; ++m) {
    segments[members_[m]] =
        trajectory::moving_segment(bodies[members_[m]], request.begin, request.horizon);
  }
  for (int i = 0; i < held_count_; ++i) {
    start_rows(world_, held_[i], segments, rows_[i]);
    held_[i].row =
        solver::difference_row(held_[i].a, held_[i].b, rows_[i].first_a, rows_[i].first_b);
  }
  for (int k = 0; k < wheel_count_; ++k) lateral_force_[k] = {};

  factorise();
  project_velocities(bodies);
  for (int m = 0; m < member_count_; ++m) {
    const int i = members_[m];
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

// Moves bodies by what rounding has opened or closed.
void ContactMotion::close_gaps(std::span<BodyState> bodies) {
  double widest = 0.0;
  for (int i = 0; i < held_count_; ++i) widest = std::max(widest, std::abs(held_[i].point.gap));
  if (widest <= closed_gap_share * world_.tolerances.penetration) return;
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
           max_displacement;
  };
  const std::span<const int> members(members_.data(), static_cast<std::size_t>(member_count_));
  if (std::any_of(members.begin(), members.end(), is_too_long)) return;
  for (const int i : members) bodies[i] = impact::displaced(bodies[i], displacements[i]);
}

// The velocities fit already, but for what closing the gaps has changed.
void ContactMotion::project_velocities(std::span<BodyState> bodies) {
  for (int i = 0; i < equations(); ++i) {
    rhs_[i] = i < held_count_ ? -collision::row_rate(held_[i].row, bodies)
                              : -bodies[wheel_state(i)].twist.left;
  }
  cholesky_.solve(rhs_);
  for (int i = 0; i < held_count_; ++i)
    collision::apply_impulse(held_[i].row, rhs_[i], mass_, bodies);
  for (int k = 0; k < wheel_count_; ++k) bodies[wheels_[k]].twist.left = 0.0;
  for (int m = 0; m < member_count_; ++m) {
    const int i = members_[m];
    double& left = bodies[i].twist.left;
    slip_sign_[i] = grounding_[i].slip_sign;
    if (slip_sign_[i] == 0.0) continue;
    if (std::abs(left) <= slip_threshold_) {
      left = 0.0;
    } else {
      slip_sign_[i] = left > 0.0 ? 1.0 : -1.0;
    }
  }
}

void ContactMotion::factorise() {
  impact::DelassusOperator bodies;
  for (int i = 0; i < held_count_; ++i) bodies.add(i, held_[i].row);
  for (int w = held_count_; w < equations(); ++w)
    bodies.add(w, collision::lateral_wheel_row(wheel_state(w)));
  cholesky_.reset(equations());
  bodies.couple(mass_, cholesky_);
  cholesky_.factorise();
}

// Term k + 1 of the twists, but for what the forces' own term k adds.
void ContactMotion::extend_twists(int k, std::span<trajectory::Segment> segments) {
  const Parameters& p = world_.parameters;
  for (int m = 0; m < member_count_; ++m) {
    const int i = members_[m];
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
  for (int i = 0; i < held_count_; ++i) {
    add_to_twists(later_force_term(held_[i], rows_[i], k), 1.0 / (k + 1), k + 1, segments);
  }
}

// The gaps' rates keep their first term, and v_l stays zero where wheels hold: their next term,
// with the forces' own term still missing, says what that term must be.
void ContactMotion::solve_for_forces(int k, std::span<trajectory::Segment> segments) {
  // Forces that the equations leave open keep the value that was decided.
  for (int i = 0; i < equations(); ++i) {
    if (!cholesky_.is_redundant(i) || k > 0) continue;
    if (i < held_count_) {
      rows_[i].force[0] = held_[i].resting.force;
      add_force(i, 0, segments);
    } else {
      const int body = wheel_state(i);
      lateral_force_[i - held_count_][0] = grounding_[body].lateral_force;
      segments[body].left[1] += grounding_[body].lateral_force * mass_[body].left;
    }
  }
  for (int i = 0; i < equations(); ++i) {
    const double rate = i < held_count_ ? gap_rate_term(held_[i], segments, k + 1, rows_[i])
                                        : segments[wheel_state(i)].left[k + 1];
    rhs_[i] = -(k + 1) * rate;
  }
  cholesky_.solve(rhs_);
  for (int i = 0; i < held_count_; ++i) {
    if (cholesky_.is_redundant(i)) continue;
    rows_[i].force[k] = rhs_[i];
    add_force(i, k, segments);
  }
  for (int w = 0; w < wheel_count_; ++w) {
    if (!cholesky_.is_redundant(held_count_ + w)) lateral_force_[w][k] = rhs_[held_count_ + w];
    segments[wheels_[w]].left[k + 1] = 0.0;
  }
}

// What term k of the contact's own force adds to term k + 1 of the twists.
void ContactMotion::add_force(int i, int k, std::span<trajectory::Segment> segments) const {
  add_to_twists(held_[i].row, rows_[i].force[k] / (k + 1), k + 1, segments);
}

void ContactMotion::add_to_twists(const solver::ConstraintRow& row, double amount, int term,
                                  std::span<trajectory::Segment> segments) const {
  const auto add = [&](int body, const solver::JacobianRow& part) {
    const solver::InverseMass& mass = mass_[body];
    trajectory::Segment& s = segments[body];
    s.forward[term] += amount * part[0] * mass.forward;
    s.left[term] += amount * part[1] * mass.left;
    s.omega[term] += amount * part[2] * mass.omega;
  };
  add(row.a, row.on_a);
  if (row.b != no_body) add(row.b, row.on_b);
}

// When a contact lets go or its point leaves the edge; at most `length`.
double ContactMotion::time_of_release(double min_duration, double length) const {
  for (int i = 0; i < held_count_; ++i) {
    const double from = std::min(min_duration, length);
    if (!cholesky_.is_redundant(i)) {
      length = std::min(length, first_crossing(rows_[i].force, 0.0, from, length));
    }
    length = time_on_edge(held_[i], rows_[i], edge_overhang, length);
  }
  return length;
}

// When the grip of wheels is used up; at most `length`.
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

void ContactMotion::find_end(const SegmentRequest& request,
                             std::span<trajectory::Segment> segments) const {
  const double begin = request.begin;
  double length = converged_length_of_all(segments);
  length = time_of_slip(request.min_duration, time_of_release(request.min_duration, length));
  int settles = no_body;
  for (int m = 0; m < member_count_; ++m) {
    const int i = members_[m];
    const Grounding& g = grounding_[i];
    trajectory::Segment& s = segments[i];
    s.end = begin + length;
    double ends = trajectory::never;
    bool reverses = false;
    if (g.ground == Ground::slides) {
      ends = time_of_grip(s, slip_sign_[i]);
    } else if (g.ground == Ground::ball) {
      ends = time_of_braking_change(trajectory::rolling_deceleration(world_.parameters), s,
                                    braking_[i], length);
      reverses = ends < request.min_duration;
      if (reverses) ends = request.min_duration;
    }
    if (ends > length) continue;
    length = ends;
    const bool goes_on =
        reverses ||
        (world_.is_ball(i) && trajectory::rolling_deceleration(world_.parameters).is_per_axis());
    settles = goes_on ? no_body : i;
  }
  for (int m = 0; m < member_count_; ++m) segments[members_[m]].end = begin + length;
  if (settles != no_body) {
    segments[settles].settles = world_.is_ball(settles) ? trajectory::TerminalState::everything
                                                        : trajectory::TerminalState::sideways;
  }
}

}  // namespace mirocup::simulator::resting_contact
