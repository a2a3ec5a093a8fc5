// SPDX-License-Identifier: MIT
#include "core/simulator/world.hpp"

#include "core/simulator/collision/broad_phase.hpp"
#include "core/simulator/collision/closest_approach.hpp"
#include "core/simulator/collision/next_contact.hpp"
#include "core/simulator/impact/islands.hpp"
#include "core/simulator/impact/position_correction.hpp"
#include "core/simulator/impact/wheel_stiction.hpp"
#include "core/simulator/trajectory/rolling_ball.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator {

namespace {

// Of a step: what is left of a tick beyond one, and is less, belongs to it.
constexpr double min_remaining_share = 0.5;

// So often it is estimated anew when two touch, from when they did not yet.
constexpr int max_estimates = 2;

}  // namespace

World::World(const field::Field* field, const Parameters& parameters, const Tolerances& tolerances,
             int robots, bool has_ball)
    : static_world_(collision::make_static_world(field, parameters, tolerances, robots, has_ball)),
      thresholds_(tolerances),
      qp_(std::make_unique<solver::BoxQp>()),
      regularized_qp_(std::make_unique<solver::RegularizedQp>()),
      forces_(std::make_unique<resting_contact::ContactForces>(static_world_)),
      motion_(std::make_unique<resting_contact::ContactMotion>(static_world_)),
      steps_(std::make_unique<stepping::TimeStepper>(static_world_, *regularized_qp_)) {
  for (int i = 0; i < robots; ++i) free_mass_[i] = static_world_.free_robot;
  if (has_ball) mass_[robots] = free_mass_[robots] = static_world_.ball;
}

BodyState World::robot(int i) const {
  return {bodies_[i].position, bodies_[i].heading, bodies_[i].twist};
}

BallState World::ball() const {
  const BodyState& ball = bodies_[static_world_.robots];
  return {ball.position, {ball.twist.forward, ball.twist.left}};
}

void World::set_robot(int i, const BodyState& state) {
  bodies_[i] = {state.position, state.heading, state.twist};
  bodies_were_set_ = true;
}

void World::set_ball(const BallState& state) {
  bodies_[static_world_.robots] = {
      state.position, Heading{}, {state.velocity.x(), state.velocity.y(), 0.0}};
  bodies_were_set_ = true;
}

const TickEvents& World::advance(std::span<const WheelCommand> commands, double duration) {
  events_ = {};
  for (int i = 0; i < static_world_.robots; ++i) {
    drives_[i] = trajectory::drive_reference(static_world_.parameters, commands[i]);
    const bool on_ground = drives_[i].wheels_on_ground;
    mass_[i] = on_ground ? static_world_.grounded_robot : static_world_.free_robot;
    if (on_ground && static_world_.parameters.grip == infinite_grip) bodies_[i].twist.left = 0.0;
  }
  const BodySet all(collision::bodies_below(static_world_.bodies()));
  pairs_.clear();
  closed_form_.reset();
  step_islands_ = {};
  const bool were_set = bodies_were_set_;
  if (were_set) {
    collect_contacts_anywhere();
    thresholds_.forget();
    steps_->forget_forces();
  }
  bodies_were_set_ = false;
  steps_->begin_tick();
  thresholds_.begin_tick(bodies_of(contacts_.contacts()));
  islands_.for_each(contacts_, [this](std::span<const collision::Contact> group) {
    thresholds_.note_island(bodies_of(group));
  });
  if (!were_set)
    take_steps(impact::islands_of(thresholds_.over_budget(), contacts_.contacts()), 0.0, duration);
  resolve_collisions(0.0);
  continue_motion(all, {}, 0.0, duration);

  for (Event event = next_event(duration); event.time < duration; event = next_event(duration)) {
    play_event(event, duration);
  }

  advance_to(duration, all);
  step_islands_ = {};
  collect_contacts(all, duration);
  if (statistics_ != nullptr) {
    statistics_->deepest_overlap = std::max(statistics_->deepest_overlap, events_.deepest_overlap);
  }
  return events_;
}

// Not later than t, which becomes their time; null if there are none. Estimates are made exact only where
// that may decide.
const collision::CandidatePair* World::earliest_contact(double& t) {
  const double latest = t;
  while (true) {
    t = latest;
    collision::CandidatePair* first = pairs_.earliest(t);
    if (first == nullptr || !first->is_estimate) return first;
    if (refine_estimate(*first)) continue;
    const double sink = thresholds_.penetration(first->pair);
    first->contact_time =
        contact_time(static_world_, first->pair, segments_, first->estimated, sink);
    first->is_estimate = false;
  }
}

// An estimate from where the last one led costs a quarter of an exact time, and most who come close pass.
bool World::refine_estimate(collision::CandidatePair& n) const {
  if (n.contact_time == n.estimated || n.estimates == max_estimates) return false;
  ++n.estimates;
  const double before = n.contact_time;
  n.contact_time = earliest_contact_of(n.pair, before);
  return n.contact_time > before;
}

World::Event World::next_event(double tick_end) {
  Event next{.time = tick_end, .is_touch = false, .pair = {}, .involved = {}};
  for (int i = 0; i < static_world_.bodies(); ++i)
    next.time = std::min(next.time, segments_[i].end);
  if (const collision::CandidatePair* first = earliest_contact(next.time)) {
    next.is_touch = true;
    next.pair = first->pair;
    next.involved = bodies_of(first->pair);
  } else {
    for (int i = 0; i < static_world_.bodies(); ++i)
      next.involved[i] = segments_[i].end <= next.time;
  }
  return next;
}

void World::play_event(const Event& event, double tick_end) {
  ++events_.events;
  if (event.is_touch) thresholds_.note_impact(event.pair, event.time);
  const double t = event.time;
  BodySet involved = event.involved;
  grow_island(t, involved);
  thresholds_.note_event(involved, was_forced_to_hold(event));
  advance_to(t, involved);
  const bool a_step_is_over = !event.is_touch && (involved & ~step_islands_.stepping()).none();
  if (a_step_is_over && to_be_stepped(involved).any()) {
    drop_contacts_of(~BodySet{});
  } else {
    collect_contacts(involved, t);
    resolve_collisions(t);
  }
  continue_motion(involved, step_islands_.end_step(involved), t, tick_end);
}

// Did a curve end as soon as it was allowed to?
bool World::was_forced_to_hold(const Event& event) const {
  if (event.is_touch) return false;
  const double hold = thresholds_.min_duration();
  for (int i = 0; i < static_world_.bodies(); ++i) {
    const double length = event.time - segments_[i].begin;
    if (event.involved[i] && std::abs(length - hold) <= 1e-3 * hold) return true;
  }
  return false;
}

void World::resolve_collisions(double t) {
  add_touches(static_world_, contacts_.contacts(), events_);
  separate_overlaps();
  islands_.for_each(contacts_,
                    [this, t](std::span<collision::Contact> group) { collide(group, t); });
}

// From the contacts that the involved bodies have now: who presses, and how all of them move on.
void World::continue_motion(const BodySet& involved, const BodySet& were_stepping, double t,
                            double tick_end) {
  take_steps(were_stepping |
                 impact::islands_of(were_stepping | to_be_stepped(involved), contacts_.contacts()),
             t, tick_end);
  islands_.for_each(contacts_, [this](std::span<collision::Contact> group) {
    forces_->decide(drives_, thresholds_.slip_threshold(), thresholds_.roll_threshold(), bodies_,
                    group);
  });
  const BodySet on_curves = involved & ~step_islands_.stepping();
  if (statistics_ != nullptr) add_pressing(contacts_.contacts(), on_curves, *statistics_);
  start_segments(on_curves, t, tick_end);
  update_pairs(involved, t, tick_end);
}

// Of these, the bodies that go in small steps with whatever touches them.
BodySet World::to_be_stepped(const BodySet& bodies) const {
  return impact::has_friction(static_world_.parameters) ? bodies
                                                        : bodies & thresholds_.over_budget();
}

// Those of the candidates whose contacts last take a small step, each with whom it may touch in it.
void World::take_steps(const BodySet& candidates, double t, double tick_end) {
  // Scenes are sampled by ticks that last no time: there is nothing to step over.
  if (candidates.none() || t == tick_end) return;
  for (BodySet left = candidates; left.any();) {
    const stepping::TimeStepper::Step taken =
        steps_->take_step(left, contacts_.contacts(), drives_, mass_, tick_end - t, bodies_);
    if (taken.members.none()) break;
    begin_step(taken, t, tick_end);
    left &= ~taken.members;
  }
  drop_contacts_of(candidates);
}

void World::begin_step(const stepping::TimeStepper::Step& taken, double t, double tick_end) {
  events_.stepped = true;
  step_islands_.begin_step(taken.members, t);
  const double end =
      t + (1.0 + min_remaining_share) * taken.length < tick_end ? t + taken.length : tick_end;
  for_each_body(taken.members, [&](int i) {
    closed_form_.set(i);
    segments_[i].begin = t;
    segments_[i].end = end;
    bounds_[i] = stepping::bound_of_corrected_arc(bodies_[i], steps_->end(i).position,
                                                  steps_->correction(i), t, end - t);
    boxes_[i] = box_around(bounds_[i], end - t);
  });
  add_touches(static_world_, steps_->pressing(), events_);
  if (statistics_ != nullptr) add_pressing(steps_->pressing(), taken.members, *statistics_);
}

void World::grow_island(double t, BodySet& involved) {
  bool grows = true;
  while (grows) {
    grows = false;
    for_each_body(involved, [&](int i) { involved |= step_islands_.island_of(i); });
    for (collision::CandidatePair& n : pairs_.list()) {
      if (n.pair.with_obstacle() || involved[n.pair.a] == involved[n.pair.partner]) continue;
      if (n.is_apart_at(t)) continue;
      const Pose a = pose_of(n.pair.a, t);
      const Pose b = pose_of(n.pair.partner, t);
      if (gap(static_world_, n.pair, a, b) > static_world_.tolerances.contact_gap) {
        n.apart_at = t;
        continue;
      }
      involved.set(n.pair.a);
      involved.set(n.pair.partner);
      grows = true;
    }
  }
}

// When the involved bodies meet others. Whoever may do so needs its series.
void World::update_pairs(const BodySet& involved, double t, double tick_end) {
  const std::span<collision::CandidatePair> found = pairs_.find(static_world_, boxes_, involved);
  for (collision::CandidatePair& n : found) {
    if (step_islands_.share_step(n.pair)) continue;
    const auto touch = next_contact_time(static_world_, n.pair, contacts_.contacts(), segments_,
                                         thresholds_.penetration(n.pair));
    n.is_estimate = !touch;
    n.estimated = t;
    n.contact_time = touch ? *touch : earliest_contact_of(n.pair, t);
  }
  for (const collision::CandidatePair& n : found) {
    if (n.contact_time == trajectory::never) continue;
    to_series(n.pair.a, t, tick_end);
    if (!n.pair.with_obstacle()) to_series(n.pair.partner, t, tick_end);
  }
}

double World::earliest_contact_of(const Pair& pair, double t) const {
  const double touch = static_world_.tolerances.contact_gap;
  const double radius_a = static_world_.shape(pair.a).radius;
  if (pair.with_obstacle()) {
    const collision::ApproachQuery encounter{bounds_[pair.a], trajectory::MotionBound{},
                                             trajectory::never, t, segments_[pair.a].end};
    const geometry::Separation apart = separation(static_world_, pair, pose_of(pair.a, t), Pose{});
    return earliest_contact_time(encounter, apart, radius_a, apart.reach_b, touch);
  }
  const double radius_b = static_world_.shape(pair.partner).radius;
  const double end = std::min(segments_[pair.a].end, segments_[pair.partner].end);
  const collision::ApproachQuery encounter{bounds_[pair.a], bounds_[pair.partner],
                                           radius_a + radius_b + touch, t, end};
  if (stays_out_of_reach(encounter)) return trajectory::never;
  const geometry::Separation apart =
      separation(static_world_, pair, pose_of(pair.a, t), pose_of(pair.partner, t));
  return earliest_contact_time(encounter, apart, radius_a, radius_b, touch);
}

void World::start_closed_form(int body, double t, double tick_end) {
  closed_form_.set(body);
  segments_[body].begin = t;
  segments_[body].end = tick_end;
  const double span = tick_end - t;
  trajectory::MotorDecay& decay = t == 0.0 ? whole_decay_ : rest_decay_;
  if (span != decay.span) decay = trajectory::motor_decay(static_world_.parameters, span);
  closed_form_end_[body] = closed_form_state(bodies_[body], drives_[body], decay);
  boxes_[body] = closed_form_box(bodies_[body], closed_form_end_[body], drives_[body], decay);
  bounds_[body] = closed_form_bound(bodies_[body], closed_form_end_[body], drives_[body], decay, t);
}

void World::to_series(int body, double t, double tick_end) {
  if (!closed_form_[body]) return;
  bodies_[body] = state_at(body, t);
  closed_form_.reset(body);
  segments_[body] = step_islands_.is_stepping(body)
                        ? stepping::corrected_segment(bodies_[body], steps_->correction(body),
                                                      segments_[body].begin, t, segments_[body].end)
                        : drive(static_world_.parameters, bodies_[body], drives_[body], t, tick_end,
                                trajectory::never);
  boxes_[body] = swept_box(segments_[body]);
  bounds_[body] = bound_of_segment(segments_[body]);
}

BodyState World::state_at(int body, double t) const {
  if (!closed_form_[body]) return body_at(segments_[body], t);
  if (step_islands_.is_stepping(body)) {
    const trajectory::Segment& s = segments_[body];
    return stepping::along_corrected_arc(bodies_[body], steps_->correction(body), s.end - s.begin,
                                         t - s.begin);
  }
  if (t == segments_[body].end) return closed_form_end_[body];
  const double span = t - segments_[body].begin;
  if (span == 0.0) return bodies_[body];
  return closed_form_state(bodies_[body], drives_[body],
                           trajectory::motor_decay(static_world_.parameters, span));
}

Pose World::pose_of(int body, double t) const {
  return closed_form_[body] ? static_cast<Pose>(state_at(body, t)) : pose_at(segments_[body], t);
}

void World::advance_to(double t, const BodySet& involved) {
  for_each_body(involved, [&](int i) {
    bodies_[i] = state_at(i, t);
    if (!step_islands_.is_stepping(i) || t >= segments_[i].end) return;
    const double begin = step_islands_.start_of(i);
    const double part = (t - begin) / (segments_[i].end - begin);
    bodies_[i].twist = steps_->twist_after(i, bodies_[i].twist, part);
  });
  if (statistics_ != nullptr)
    statistics_->position_evaluations += static_cast<long>(involved.count());
}

void World::collect_contacts(const BodySet& involved, double t) {
  contacts_.count = 0;
  for (const collision::CandidatePair& n : pairs_.list()) {
    if (!involved[n.pair.a] || !(n.pair.with_obstacle() || involved[n.pair.partner])) continue;
    // Within a step, nobody knows what the gaps of those who take it together are.
    if (n.is_apart_at(t) || step_islands_.share_step(n.pair)) continue;
    add_contacts(static_world_, n.pair, bodies_, static_world_.tolerances.contact_gap, contacts_);
  }
  islands_.sort(contacts_);
}

void World::collect_contacts_anywhere() {
  contacts_.count = 0;
  const BodySet all(collision::bodies_below(static_world_.bodies()));
  add_contacts_among(static_world_, all, bodies_, static_world_.tolerances.contact_gap, boxes_,
                     contacts_);
  islands_.sort(contacts_);
}

void World::drop_contacts_of(const BodySet& bodies) {
  contacts_.keep_if(
      [&](const collision::Contact& c) { return (bodies_of(c.pair) & bodies).none(); });
  islands_.sort(contacts_);
}

void World::separate_overlaps() {
  double deepest = 0.0;
  for (const collision::Contact& c : contacts_.contacts())
    deepest = std::max(deepest, -c.point.gap);
  events_.deepest_overlap = std::max(events_.deepest_overlap, deepest);
  if (deepest > 2.0 * static_world_.tolerances.contact_gap) {
    impact::project_positions(contacts_.contacts(), free_mass_, bodies_, *regularized_qp_);
  }
}

void World::collide(std::span<collision::Contact> contacts, double t) {
  for (collision::Contact& c : contacts)
    c.impact.restitution_threshold = thresholds_.restitution_threshold(c.pair);
  impact::resolve_impacts(contacts, mass_, bodies_, *qp_);
  if (impact::has_friction(static_world_.parameters))
    impact::resolve_friction(contacts, mass_, bodies_, *qp_);
  for (const collision::Contact& c : contacts) {
    if (c.impact.impulse == 0.0 || c.impact.approach <= c.impact.restitution_threshold) continue;
    ++events_.impacts;
    if (statistics_ != nullptr) add_impact(c, t, *statistics_);
    thresholds_.note_bounce(c.pair, t);
  }
  arrest_slow_slip(static_world_, thresholds_, drives_, contacts, mass_, bodies_, *qp_);
}

void World::start_segments(const BodySet& involved, double t, double tick_end) {
  const resting_contact::SegmentRequest request{t, tick_end, thresholds_.preferred_duration(t),
                                                thresholds_.min_duration()};
  BodySet left = involved;
  for (int i = 0; i < static_world_.bodies(); ++i) {
    if (!left[i]) continue;
    const BodySet cluster = impact::cluster_of(i, contacts_.contacts());
    left &= ~cluster;
    closed_form_.reset(i);
    if (cluster.any()) {
      motion_->move(cluster, *forces_, contacts_.contacts(), drives_, request, bodies_, segments_);
    } else if (static_world_.is_ball(i)) {
      segments_[i] =
          roll(trajectory::rolling_deceleration(static_world_.parameters), bodies_[i], t, tick_end);
    } else if (has_closed_form(static_world_.parameters, bodies_[i], drives_[i], tick_end - t)) {
      start_closed_form(i, t, tick_end);
    } else {
      segments_[i] = drive(static_world_.parameters, bodies_[i], drives_[i], t, tick_end,
                           request.preferred_duration);
    }
  }
  for (int i = 0; i < static_world_.bodies(); ++i) {
    if (!involved[i] || closed_form_[i]) continue;
    boxes_[i] = swept_box(segments_[i]);
    bounds_[i] = bound_of_segment(segments_[i]);
  }
}

}  // namespace mirocup::simulator
