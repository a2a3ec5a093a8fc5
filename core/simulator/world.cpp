// SPDX-License-Identifier: MIT
#include "core/simulator/world.hpp"

#include "core/base/assert.hpp"
#include "core/simulator/collision/broad_phase.hpp"
#include "core/simulator/collision/closest_approach.hpp"
#include "core/simulator/collision/next_contact.hpp"
#include "core/simulator/impact/islands.hpp"
#include "core/simulator/impact/position_correction.hpp"
#include "core/simulator/impact/wheel_stiction.hpp"
#include "core/simulator/model/solver_settings.hpp"
#include "core/simulator/trajectory/rolling_ball.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator {

namespace {

void renew(trajectory::MotorDecay& decay, double time_constant, double span) {
  if (span == decay.span && time_constant == decay.time_constant) return;
  decay = trajectory::motor_decay(time_constant, span);
}

}  // namespace

World::World(const field::Field* field, const Parameters& parameters, const Tolerances& tolerances,
             int robots, bool has_ball)
    : static_world_(collision::make_static_world(field, parameters, tolerances, robots, has_ball)),
      thresholds_(tolerances, static_world_.bodies()),
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

std::size_t World::size_of(const Memory& memory) {
  const auto* begin = reinterpret_cast<const std::byte*>(&memory);
  const auto* end =
      reinterpret_cast<const std::byte*>(memory.steps.force.data() + memory.steps.forces);
  return static_cast<std::size_t>(end - begin);
}

void World::save(Memory& memory) const {
  memory.bodies_were_set = bodies_were_set_;
  memory.thresholds = thresholds_.memory();
  memory.touches = 0;
  for (int i = 0; i < contacts_.count; ++i) {
    const Pair& pair = contacts_.list[i].pair;
    if (i > 0 && pair == contacts_.list[i - 1].pair) continue;
    memory.touch[memory.touches++] = {static_cast<std::uint8_t>(pair.a),
                                      static_cast<std::uint8_t>(pair.partner)};
  }
  steps_->save(memory.steps);
}

// The contacts themselves follow from the states of the bodies.
void World::recall(const Memory& memory) {
  bodies_were_set_ = memory.bodies_were_set;
  thresholds_.recall(memory.thresholds);
  contacts_.count = 0;
  for (int i = 0; i < memory.touches; ++i) {
    const Pair pair{memory.touch[i].a, memory.touch[i].partner};
    add_contacts(static_world_, pair, bodies_, static_world_.tolerances.contact_gap, contacts_);
  }
  keep_first_contacts_exact();
  islands_.sort(contacts_);
  steps_->recall(memory.steps);
}

void World::save(State& to) const {
  to.rolling_resistance = static_world_.parameters.rolling_resistance;
  std::copy_n(bodies_.begin(), static_world_.bodies(), to.bodies.begin());
  save(to.memory);
}

void World::load(const State& from) {
  static_world_.parameters.rolling_resistance = from.rolling_resistance;
  std::copy_n(from.bodies.begin(), static_world_.bodies(), bodies_.begin());
  recall(from.memory);
}

void World::clear(double rolling_resistance) {
  static_world_.parameters.rolling_resistance = rolling_resistance;
  bodies_.fill({});
  bodies_were_set_ = true;
  contacts_.count = 0;
  islands_.sort(contacts_);
  thresholds_.recall({});
  steps_->recall({});
  steps_->forget_forces();
}

// One tick, in order. Each event repeats steps 2 to 4 for the bodies that it involves (play_event).
//
//   1. Start: commands, memory of the last tick, islands that are over budget from the start.
//   2. Resolve collisions: contacts that approach become impacts.
//   3. Continue motion: time steps for bodies over budget, forces and new segments for the others,
//      then the times at which the pairs of these bodies can touch next.
//   4. Next event: the earliest end of a segment or first contact. Repeat from 2 until the end.
//   5. End: all bodies at `duration`, and their contacts for the start of the next tick.
const TickEvents& World::advance(std::span<const WheelCommand> commands, double duration) {
  MIROCUP_ASSERT(static_cast<int>(commands.size()) >= static_world_.robots && duration >= 0.0);
  const BodySet all(collision::bodies_below(static_world_.bodies()));

  start_tick(commands, duration);           // 1
  resolve_collisions(0.0);                  // 2
  continue_motion(all, {}, 0.0, duration);  // 3
  for (Event event = next_event(duration); event.time < duration; event = next_event(duration)) {
    play_event(event, duration);  // 4
  }

  advance_to(duration, all);  // 5
  thresholds_.note_steps(step_islands_.stepping());
  step_islands_ = {};
  collect_contacts(all, duration);
  thresholds_.end_tick(duration);
  if (statistics_ != nullptr) {
    statistics_->deepest_overlap = std::max(statistics_->deepest_overlap, events_.deepest_overlap);
  }
  return events_;
}

// Expects the contacts of the last tick's end in contacts_, unless bodies were set since then.
void World::start_tick(std::span<const WheelCommand> commands, double duration) {
  spoil(segments_, closed_form_end_, boxes_, bounds_, drives_);
  events_ = {};
  set_drives(commands);
  pairs_.clear();
  closed_form_.reset();
  step_islands_ = {};
  const bool were_set = bodies_were_set_;
  bodies_were_set_ = false;
  if (were_set) {
    collect_contacts_anywhere();
    thresholds_.forget();
    steps_->forget_forces();
  }
  steps_->begin_tick();
  thresholds_.begin_tick(duration);
  islands_.for_each(contacts_, [this](std::span<const collision::Contact> island) {
    if (!is_at_rest(bodies_of(island))) thresholds_.note_island(bodies_of(island));
  });
  // Islands that are over budget from the start step before impacts: take_steps() drops their
  // contacts, so these do not bounce.
  if (!were_set) {
    const BodySet stepped = thresholds_.over_budget() & over_budget_or_sticking() &
                            (may_press() | thresholds_.were_over_budget());
    take_steps(impact::islands_of(stepped, contacts_.contacts()), 0.0, duration);
  }
}

bool World::is_at_rest(const BodySet& bodies) const {
  bool rests = true;
  for_each_body(bodies, [&](int i) {
    const Twist& v = bodies_[i].twist;
    rests = rests && std::abs(v.forward) + std::abs(v.left) +
                             std::abs(v.omega) * static_world_.shape(i).radius <=
                         settings::world.resting_speed;
  });
  return rests;
}

void World::set_drives(std::span<const WheelCommand> commands) {
  for (int i = 0; i < static_world_.robots; ++i) {
    drives_[i] = trajectory::drive_reference(static_world_.parameters, commands[i]);
    const bool on_ground = drives_[i].wheels_on_ground;
    mass_[i] = on_ground ? static_world_.grounded_robot : static_world_.free_robot;
    if (on_ground && static_world_.parameters.grip == infinite_grip) bodies_[i].twist.left = 0.0;
  }
}

// Returns the pair that touches first, and sets t to the time of contact; null if none touches by
// time t. Estimates are lower bounds: they are made exact only where they could be the first.
const collision::CandidatePair* World::earliest_contact(double& t) {
  const double latest = t;
  while (true) {
    t = latest;
    collision::CandidatePair* first = pairs_.earliest(t);
    if (first == nullptr || !first->is_estimate) return first;
    if (refine_estimate(*first)) continue;
    first->contact_time = contact_time(static_world_, first->pair, segments_, first->estimated,
                                       static_world_.tolerances.penetration, first->reference);
    first->is_estimate = false;
  }
}

// Estimates the contact time again, from the time of the last estimate. That costs a quarter of
// the exact search, and most pairs that come close pass each other. Returns false if the exact
// search is due.
bool World::refine_estimate(collision::CandidatePair& n) const {
  if (n.contact_time == n.estimated || n.estimates == settings::world.max_estimates) return false;
  ++n.estimates;
  const double before = n.contact_time;
  n.contact_time = earliest_contact_of(n, before);
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

// The order matters in four places:
//   - The pair's touch is noted before its thresholds are used.
//   - The involved bodies grow to whole islands before they are advanced: bodies that touch must
//     get new trajectories together, and a step ends for all its members at once.
//   - Contacts are collected while step_islands_ still knows the steps: pairs of one step are
//     left out, because inside a step their gaps are not known.
//   - Steps end after that and before the motion is continued, which starts new ones.
void World::play_event(const Event& event, double tick_end) {
  const double t = event.time;
  ++events_.events;
  if (event.is_touch) thresholds_.note_impact(t);

  BodySet involved = event.involved;
  grow_island(t, involved);
  thresholds_.note_event(involved, was_forced_to_hold(event));
  advance_to(t, involved);

  // Where steps are only followed by steps, contacts are left to the next step: it knows no
  // impacts.
  const bool only_steps_end = !event.is_touch && (involved & ~step_islands_.stepping()).none();
  if (only_steps_end && to_be_stepped(involved).any()) {
    drop_contacts_of(~BodySet{});
  } else {
    collect_contacts(involved, t);
    resolve_collisions(t);
  }

  const BodySet were_stepping = step_islands_.end_step(involved);
  continue_motion(involved, were_stepping, t, tick_end);
}

// True if the event is the end of a segment that lasted just the minimum duration.
bool World::was_forced_to_hold(const Event& event) const {
  if (event.is_touch) return false;
  const double hold = thresholds_.min_duration();
  for (int i = 0; i < static_world_.bodies(); ++i) {
    const double length = event.time - segments_[i].begin;
    if (event.involved[i] && std::abs(length - hold) <= settings::world.forced_end_round_off * hold)
      return true;
  }
  return false;
}

// Records the touches, removes overlaps, and resolves impacts, island by island.
void World::resolve_collisions(double t) {
  add_touches(static_world_, contacts_.contacts(), events_);
  separate_overlaps();
  islands_.for_each(contacts_,
                    [this, t](std::span<collision::Contact> island) { collide(island, t); });
}

// Gives the involved bodies new trajectories from their contacts at time t. The order matters:
// steps take their contacts out of contacts_, so forces are decided for the others only, and
// pairs are updated when all trajectories are known.
void World::continue_motion(const BodySet& involved, const BodySet& were_stepping, double t,
                            double tick_end) {
  // Stepped are the bodies that were in a step, those that are to be stepped, and what touches
  // either.
  const BodySet stepped = were_stepping | (over_budget_or_sticking() & involved & may_press());
  take_steps(were_stepping | impact::islands_of(stepped, contacts_.contacts()), t, tick_end);

  islands_.for_each(contacts_, [this](std::span<collision::Contact> island) {
    forces_->decide(drives_, bodies_, island);
  });
  for (const collision::Contact& c : contacts_.contacts()) thresholds_.note_contact(c, mass_, t);
  const BodySet on_segments = involved & ~step_islands_.stepping();
  if (statistics_ != nullptr) add_pressing(contacts_.contacts(), on_segments, *statistics_);
  start_segments(on_segments, t, tick_end);
  update_pairs(involved, t, tick_end);
}

// Returns the bodies with a contact that may last. Without any budget, a contact does not whose
// bodies are about to bounce or have just bounced.
BodySet World::may_press() const {
  BodySet found;
  for (const collision::Contact& c : contacts_.contacts()) {
    if (static_world_.tolerances.event_budget > 0 ||
        std::abs(collision::row_rate(c.row, bodies_)) <= c.impact.restitution_threshold)
      found |= bodies_of(c.pair);
  }
  return found;
}

// Returns those of the bodies that are stepped again if they were stepped: those over budget, or
// all if contacts have friction.
BodySet World::to_be_stepped(const BodySet& bodies) const {
  return impact::has_friction(static_world_.parameters) ? bodies
                                                        : bodies & thresholds_.over_budget();
}

// Returns the bodies over budget, and those of islands whose friction has no constant direction.
// Where there is no budget at all, a lone robot that slides along walls has events_of_sliding.
BodySet World::over_budget_or_sticking() {
  BodySet found = thresholds_.over_budget();
  if (!impact::has_friction(static_world_.parameters)) return found;
  const std::array<BodyState, max_bodies> before = bodies_;  // deciding changes velocities
  islands_.for_each(contacts_, [&](std::span<collision::Contact> island) {
    const auto is_rough = [](const collision::Contact& c) { return c.material.friction > 0.0; };
    if (std::none_of(island.begin(), island.end(), is_rough)) return;
    const BodySet bodies = bodies_of(island);
    if (!forces_->decide(drives_, bodies_, island)) {
      found |= bodies;
    } else if (static_world_.tolerances.event_budget == 0 && bodies.count() == 1 &&
               events_.events < settings::world.events_of_sliding) {
      found &= ~bodies;
    }
  });
  bodies_ = before;
  return found;
}

// Takes one step of each island of the candidates, and drops the contacts of all candidates.
// Candidates without a lasting contact take no step.
void World::take_steps(const BodySet& candidates, double t, double tick_end) {
  // Scenes are sampled by ticks of duration zero, in which there is nothing to step over.
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

// Registers the members' trajectories of a step that starts at time t. It ends with the tick if
// the rest of the tick would be shorter than a share of the step.
void World::begin_step(const stepping::TimeStepper::Step& taken, double t, double tick_end) {
  events_.stepped = true;
  step_islands_.begin_step(taken.members, t);
  const double with_rest = (1.0 + settings::world.min_remaining_share) * taken.length;
  const double end = t + with_rest < tick_end ? t + taken.length : tick_end;
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

// Adds to `involved` the members of their steps and all bodies that touch them at time t,
// directly or through others.
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

// Sets the times at which the pairs of the involved bodies can touch next. Bodies whose pairs can
// touch get series instead of a closed form.
void World::update_pairs(const BodySet& involved, double t, double tick_end) {
  const std::span<collision::CandidatePair> found = pairs_.find(static_world_, boxes_, involved);
  for (collision::CandidatePair& n : found) {
    if (step_islands_.share_step(n.pair)) continue;
    const auto touch = next_contact_time(static_world_, n.pair, contacts_.contacts(), segments_,
                                         static_world_.tolerances.penetration);
    n.is_estimate = !touch;
    n.estimated = t;
    n.contact_time = touch ? *touch : earliest_contact_of(n, t);
  }
  for (const collision::CandidatePair& n : found) {
    if (n.contact_time == trajectory::never) continue;
    to_series(n.pair.a, t, tick_end);
    if (!n.pair.with_obstacle()) to_series(n.pair.partner, t, tick_end);
  }
}

// Returns a lower bound of the pair's next contact time from t on, or never. The exact search
// starts where the first estimate was made: with its reference edge, if both bodies have series.
double World::earliest_contact_of(collision::CandidatePair& n, double t) const {
  const Pair& pair = n.pair;
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
  if (t == n.estimated && !closed_form_[pair.a] && !closed_form_[pair.partner])
    n.reference = apart.reference;
  return earliest_contact_time(encounter, apart, radius_a, radius_b, touch);
}

// Moves an isolated robot in closed form until the end of the tick.
void World::start_closed_form(int body, double t, double tick_end) {
  closed_form_.set(body);
  segments_[body].begin = t;
  segments_[body].end = tick_end;
  const double span = tick_end - t;
  const trajectory::DriveReference& drive = drives_[body];
  KnownDecay& known = t == 0.0 ? whole_decay_ : rest_decay_;
  renew(known.forward, drive.forward_lag, span);
  const bool has_two_lags = drive.turn_lag != drive.forward_lag;
  if (has_two_lags) renew(known.turn, drive.turn_lag, span);
  const trajectory::MotorDecay& decay = known.forward;
  closed_form_end_[body] =
      closed_form_state(bodies_[body], drive, {decay, has_two_lags ? known.turn : decay});
  boxes_[body] = closed_form_box(bodies_[body], closed_form_end_[body], drive, decay);
  bounds_[body] = closed_form_bound(bodies_[body], closed_form_end_[body], drive, decay, t);
}

// Replaces a closed form, or the rest of a step, by a segment with series.
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

// Returns the body at time t of the tick, by whichever trajectory it has. Inside a step the twist
// is that of the whole step.
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
  return closed_form_state(bodies_[body], drives_[body], span);
}

Pose World::pose_of(int body, double t) const {
  return closed_form_[body] ? static_cast<Pose>(state_at(body, t)) : pose_at(segments_[body], t);
}

// Moves the bodies to time t. Members of a step that is interrupted get their share of its
// impulses.
void World::advance_to(double t, const BodySet& involved) {
  for_each_body(involved, [&](int i) {
    bodies_[i] = state_at(i, t);
    if (!step_islands_.is_stepping(i) || t >= segments_[i].end) return;
    const double start = step_islands_.start_of(i);
    const double share = (t - start) / (segments_[i].end - start);
    bodies_[i].twist = steps_->twist_after(i, bodies_[i].twist, share);
  });
  if (statistics_ != nullptr)
    statistics_->position_evaluations += static_cast<long>(involved.count());
}

// Sets contacts_ to the contacts among the involved bodies and with obstacles.
void World::collect_contacts(const BodySet& involved, double t) {
  contacts_.count = 0;
  for (const collision::CandidatePair& n : pairs_.list()) {
    if (!involved[n.pair.a] || !(n.pair.with_obstacle() || involved[n.pair.partner])) continue;
    // The gaps of pairs inside a step are known at its ends only.
    if (n.is_apart_at(t) || step_islands_.share_step(n.pair)) continue;
    add_contacts(static_world_, n.pair, bodies_, static_world_.tolerances.contact_gap, contacts_);
  }
  keep_first_contacts_exact();
  islands_.sort(contacts_);
}

// Contacts count as closed within contact_gap, but not before they have touched.
void World::keep_first_contacts_exact() {
  const double exact = settings::world.first_contact_gap;
  if (static_world_.tolerances.contact_gap <= exact) return;
  contacts_.keep_if([&](const collision::Contact& c) {
    return c.point.gap <= exact || thresholds_.remembers(c);
  });
}

// Sets contacts_ to those of all bodies, without the pair list: bodies were set.
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

// Removes overlaps that are worth it by position projection, and records the deepest.
void World::separate_overlaps() {
  double deepest = 0.0;
  for (const collision::Contact& c : contacts_.contacts())
    deepest = std::max(deepest, -c.point.gap);
  events_.deepest_overlap = std::max(events_.deepest_overlap, deepest);
  if (deepest > settings::world.projected_overlap * static_world_.tolerances.contact_gap) {
    impact::project_positions(contacts_.contacts(), free_mass_, bodies_, *regularized_qp_);
  }
}

// Resolves the impacts of one island, then its friction, then removes slow slip of wheels.
void World::collide(std::span<collision::Contact> contacts, double t) {
  for (collision::Contact& c : contacts)
    c.impact.restitution_threshold = thresholds_.restitution_threshold(c, t);
  impact::resolve_impacts(contacts, mass_, bodies_, *qp_);
  if (impact::has_friction(static_world_.parameters))
    impact::resolve_friction(contacts, mass_, bodies_, *qp_);
  for (const collision::Contact& c : contacts) {
    if (c.impact.impulse == 0.0 || c.impact.approach <= c.impact.restitution_threshold) continue;
    ++events_.impacts;
    if (statistics_ != nullptr) add_impact(c, t, *statistics_);
  }
  impact::arrest_slow_slip(static_world_, drives_, contacts, mass_, bodies_, *qp_);
  for (collision::Contact& c : contacts) {
    thresholds_.note_contact(c, mass_, t);
    // After the impact the same number is the speed from which a contact counts as opening.
    c.impact.restitution_threshold =
        std::min(c.impact.restitution_threshold, static_world_.tolerances.pressing_threshold);
  }
}

// Starts a segment of each of the bodies: a cluster's motion, a rolling ball, a closed form or a
// driven robot's series.
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
  for_each_body(involved & ~closed_form_, [&](int i) {
    boxes_[i] = swept_box(segments_[i]);
    bounds_[i] = bound_of_segment(segments_[i]);
  });
}

}  // namespace mirocup::simulator
