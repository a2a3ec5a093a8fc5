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
constexpr double least_step_left = 0.5;

// So often it is estimated anew when two touch, from when they did not yet.
constexpr int most_looks_ahead = 2;

}  // namespace

World::World(const field::Field* field, const Parameters& parameters, const Tolerances& tolerances,
             int robots, bool has_ball)
    : arena_(make_arena(field, parameters, tolerances, robots, has_ball)),
      patience_(tolerances),
      problem_(std::make_unique<BoxProblem>()),
      soft_problem_(std::make_unique<SoftProblem>()),
      forces_(std::make_unique<ContactForces>(arena_)),
      motion_(std::make_unique<ContactMotion>(arena_)),
      steps_(std::make_unique<ContactStepping>(arena_, *soft_problem_)) {
  for (int i = 0; i < robots; ++i) free_mass_[i] = arena_.free_robot;
  if (has_ball) mass_[robots] = free_mass_[robots] = arena_.ball;
}

BodyState World::robot(int i) const {
  return {bodies_[i].position, bodies_[i].heading, bodies_[i].twist};
}

BallState World::ball() const {
  const BodyState& ball = bodies_[arena_.robots];
  return {ball.position, {ball.twist.forward, ball.twist.left}};
}

void World::set_robot(int i, const BodyState& state) {
  bodies_[i] = {state.position, state.heading, state.twist};
  bodies_were_set_ = true;
}

void World::set_ball(const BallState& state) {
  bodies_[arena_.robots] = {
      state.position, Heading{}, {state.velocity.x(), state.velocity.y(), 0.0}};
  bodies_were_set_ = true;
}

const TickEvents& World::advance(std::span<const WheelCommand> commands, double duration) {
  events_ = {};
  for (int i = 0; i < arena_.robots; ++i) {
    drives_[i] = drive_of(arena_.parameters, commands[i]);
    const bool on_ground = drives_[i].wheels_on_ground;
    mass_[i] = on_ground ? arena_.grounded_robot : arena_.free_robot;
    if (on_ground && arena_.parameters.grip == infinite_grip) bodies_[i].twist.left = 0.0;
  }
  const BodySet all(bodies_below(arena_.bodies()));
  neighbours_.clear();
  quiet_.reset();
  companies_ = {};
  const bool were_set = bodies_were_set_;
  if (were_set) {
    collect_contacts_anywhere();
    patience_.forget();
    steps_->forget();
  }
  bodies_were_set_ = false;
  steps_->begin_tick();
  patience_.begin_tick(bodies_of(contacts_.contacts()));
  groups_.for_each(contacts_, [this](std::span<const Contact> group) {
    patience_.note_group(bodies_of(group));
  });
  if (!were_set) step(touching_with(patience_.exhausted(), contacts_.contacts()), 0.0, duration);
  run_into_each_other(0.0);
  go_on(all, {}, 0.0, duration);

  for (Event event = next_event(duration); event.time < duration; event = next_event(duration)) {
    play_event(event, duration);
  }

  bring_to(duration, all);
  companies_ = {};
  collect_contacts(all, duration);
  if (trace_ != nullptr) {
    trace_->deepest_overlap = std::max(trace_->deepest_overlap, events_.deepest_overlap);
  }
  return events_;
}

// Not later than t, which becomes their time; null if there are none. Estimates are made exact only where
// that may decide.
const Neighbour* World::first_touch(double& t) {
  const double latest = t;
  while (true) {
    t = latest;
    Neighbour* first = neighbours_.first_to_touch(t);
    if (first == nullptr || !first->is_estimate) return first;
    if (looks_again(*first)) continue;
    const double sink = patience_.sink(first->pair);
    first->touch = touch_time(arena_, first->pair, segments_, first->estimated, sink);
    first->is_estimate = false;
  }
}

// An estimate from where the last one led costs a quarter of an exact time, and most who come close pass.
bool World::looks_again(Neighbour& n) const {
  if (n.touch == n.estimated || n.looks == most_looks_ahead) return false;
  ++n.looks;
  const double before = n.touch;
  n.touch = earliest_touch_of(n.pair, before);
  return n.touch > before;
}

World::Event World::next_event(double tick_end) {
  Event next{.time = tick_end, .is_touch = false, .pair = {}, .involved = {}};
  for (int i = 0; i < arena_.bodies(); ++i) next.time = std::min(next.time, segments_[i].end);
  if (const Neighbour* first = first_touch(next.time)) {
    next.is_touch = true;
    next.pair = first->pair;
    next.involved = bodies_of(first->pair);
  } else {
    for (int i = 0; i < arena_.bodies(); ++i) next.involved[i] = segments_[i].end <= next.time;
  }
  return next;
}

void World::play_event(const Event& event, double tick_end) {
  ++events_.events;
  if (event.is_touch) patience_.note_touch(event.pair, event.time);
  const double t = event.time;
  BodySet involved = event.involved;
  spread_over_touching(t, involved);
  patience_.note_event(involved, was_forced_to_hold(event));
  bring_to(t, involved);
  const bool a_step_is_over = !event.is_touch && (involved & ~companies_.stepping()).none();
  if (a_step_is_over && bound_for_steps(involved).any()) {
    drop_contacts_of(~BodySet{});
  } else {
    collect_contacts(involved, t);
    run_into_each_other(t);
  }
  go_on(involved, companies_.leave(involved), t, tick_end);
}

// Did a curve end as soon as it was allowed to?
bool World::was_forced_to_hold(const Event& event) const {
  if (event.is_touch) return false;
  const double hold = patience_.hold();
  for (int i = 0; i < arena_.bodies(); ++i) {
    const double length = event.time - segments_[i].begin;
    if (event.involved[i] && std::abs(length - hold) <= 1e-3 * hold) return true;
  }
  return false;
}

void World::run_into_each_other(double t) {
  add_touches(arena_, contacts_.contacts(), events_);
  separate_overlaps();
  groups_.for_each(contacts_, [this, t](std::span<Contact> group) { collide(group, t); });
}

// From the contacts that the involved bodies have now: who presses, and how all of them move on.
void World::go_on(const BodySet& involved, const BodySet& were_stepping, double t,
                  double tick_end) {
  step(were_stepping |
           touching_with(were_stepping | bound_for_steps(involved), contacts_.contacts()),
       t, tick_end);
  groups_.for_each(contacts_, [this](std::span<Contact> group) {
    forces_->decide(drives_, patience_.rest_slide(), patience_.rest_roll(), bodies_, group);
  });
  const BodySet on_curves = involved & ~companies_.stepping();
  if (trace_ != nullptr) add_pressing(contacts_.contacts(), on_curves, *trace_);
  start_segments(on_curves, t, tick_end);
  meet_neighbours(involved, t, tick_end);
}

// Of these, the bodies that go in small steps with whatever touches them.
BodySet World::bound_for_steps(const BodySet& bodies) const {
  return has_friction(arena_.parameters) ? bodies : bodies & patience_.exhausted();
}

// Those of the candidates whose contacts last take a small step, each with whom it may touch in it.
void World::step(const BodySet& candidates, double t, double tick_end) {
  // Scenes are sampled by ticks that last no time: there is nothing to step over.
  if (candidates.none() || t == tick_end) return;
  for (BodySet left = candidates; left.any();) {
    const ContactStepping::Step taken =
        steps_->take(left, contacts_.contacts(), drives_, mass_, tick_end - t, bodies_);
    if (taken.members.none()) break;
    set_out(taken, t, tick_end);
    left &= ~taken.members;
  }
  drop_contacts_of(candidates);
}

void World::set_out(const ContactStepping::Step& taken, double t, double tick_end) {
  events_.stepped = true;
  companies_.set_out(taken.members, t);
  const double end =
      t + (1.0 + least_step_left) * taken.length < tick_end ? t + taken.length : tick_end;
  for_each_body(taken.members, [&](int i) {
    quiet_.set(i);
    segments_[i].begin = t;
    segments_[i].end = end;
    ways_[i] = way_along_bent_arc(bodies_[i], steps_->end(i).position, steps_->bend(i), t, end - t);
    boxes_[i] = box_around(ways_[i], end - t);
  });
  add_touches(arena_, steps_->pressing(), events_);
  if (trace_ != nullptr) add_pressing(steps_->pressing(), taken.members, *trace_);
}

void World::spread_over_touching(double t, BodySet& involved) {
  bool grows = true;
  while (grows) {
    grows = false;
    for_each_body(involved, [&](int i) { involved |= companies_.company_of(i); });
    for (Neighbour& n : neighbours_.list()) {
      if (n.pair.with_obstacle() || involved[n.pair.a] == involved[n.pair.partner]) continue;
      if (n.is_apart_at(t)) continue;
      const Pose a = pose_now(n.pair.a, t);
      const Pose b = pose_now(n.pair.partner, t);
      if (gap(arena_, n.pair, a, b) > arena_.tolerances.touch) {
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
void World::meet_neighbours(const BodySet& involved, double t, double tick_end) {
  const std::span<Neighbour> found = neighbours_.find(arena_, boxes_, involved);
  for (Neighbour& n : found) {
    if (companies_.are_in_step(n.pair)) continue;
    const auto touch = next_touch_while_pressing(arena_, n.pair, contacts_.contacts(), segments_,
                                                 patience_.sink(n.pair));
    n.is_estimate = !touch;
    n.estimated = t;
    n.touch = touch ? *touch : earliest_touch_of(n.pair, t);
  }
  for (const Neighbour& n : found) {
    if (n.touch == never) continue;
    write_as_series(n.pair.a, t, tick_end);
    if (!n.pair.with_obstacle()) write_as_series(n.pair.partner, t, tick_end);
  }
}

double World::earliest_touch_of(const Pair& pair, double t) const {
  const double touch = arena_.tolerances.touch;
  const double radius_a = arena_.shape(pair.a).radius;
  if (pair.with_obstacle()) {
    const Encounter encounter{ways_[pair.a], Way{}, never, t, segments_[pair.a].end};
    const geometry::Separation apart = separation(arena_, pair, pose_now(pair.a, t), Pose{});
    return earliest_touch(encounter, apart, radius_a, apart.reach_b, touch);
  }
  const double radius_b = arena_.shape(pair.partner).radius;
  const double end = std::min(segments_[pair.a].end, segments_[pair.partner].end);
  const Encounter encounter{ways_[pair.a], ways_[pair.partner], radius_a + radius_b + touch, t,
                            end};
  if (stays_out_of_reach(encounter)) return never;
  const geometry::Separation apart =
      separation(arena_, pair, pose_now(pair.a, t), pose_now(pair.partner, t));
  return earliest_touch(encounter, apart, radius_a, radius_b, touch);
}

void World::start_quietly(int body, double t, double tick_end) {
  quiet_.set(body);
  segments_[body].begin = t;
  segments_[body].end = tick_end;
  const double span = tick_end - t;
  MotorDecay& decay = t == 0.0 ? whole_decay_ : rest_decay_;
  if (span != decay.span) decay = motor_decay(arena_.parameters, span);
  quiet_end_[body] = moved(bodies_[body], drives_[body], decay);
  boxes_[body] = box_around_way(bodies_[body], quiet_end_[body], drives_[body], decay);
  ways_[body] = quiet_way(bodies_[body], quiet_end_[body], drives_[body], decay, t);
}

void World::write_as_series(int body, double t, double tick_end) {
  if (!quiet_[body]) return;
  bodies_[body] = body_now(body, t);
  quiet_.reset(body);
  segments_[body] =
      companies_.is_stepping(body)
          ? bent_segment(bodies_[body], steps_->bend(body), segments_[body].begin, t,
                         segments_[body].end)
          : drive(arena_.parameters, bodies_[body], drives_[body], t, tick_end, never);
  boxes_[body] = swept_box(segments_[body]);
  ways_[body] = way_along(segments_[body]);
}

BodyState World::body_now(int body, double t) const {
  if (!quiet_[body]) return body_at(segments_[body], t);
  if (companies_.is_stepping(body)) {
    const Segment& s = segments_[body];
    return along_bent_arc(bodies_[body], steps_->bend(body), s.end - s.begin, t - s.begin);
  }
  if (t == segments_[body].end) return quiet_end_[body];
  const double span = t - segments_[body].begin;
  if (span == 0.0) return bodies_[body];
  return moved(bodies_[body], drives_[body], motor_decay(arena_.parameters, span));
}

Pose World::pose_now(int body, double t) const {
  return quiet_[body] ? static_cast<Pose>(body_now(body, t)) : pose_at(segments_[body], t);
}

void World::bring_to(double t, const BodySet& involved) {
  for_each_body(involved, [&](int i) {
    bodies_[i] = body_now(i, t);
    if (!companies_.is_stepping(i) || t >= segments_[i].end) return;
    const double begin = companies_.begin_of(i);
    const double part = (t - begin) / (segments_[i].end - begin);
    bodies_[i].twist = steps_->twist_after(i, bodies_[i].twist, part);
  });
  if (trace_ != nullptr) trace_->position_evaluations += static_cast<long>(involved.count());
}

void World::collect_contacts(const BodySet& involved, double t) {
  contacts_.count = 0;
  for (const Neighbour& n : neighbours_.list()) {
    if (!involved[n.pair.a] || !(n.pair.with_obstacle() || involved[n.pair.partner])) continue;
    // Within a step, nobody knows what the gaps of those who take it together are.
    if (n.is_apart_at(t) || companies_.are_in_step(n.pair)) continue;
    add_contacts(arena_, n.pair, bodies_, arena_.tolerances.touch, contacts_);
  }
  groups_.sort(contacts_);
}

void World::collect_contacts_anywhere() {
  contacts_.count = 0;
  const BodySet all(bodies_below(arena_.bodies()));
  add_contacts_among(arena_, all, bodies_, arena_.tolerances.touch, boxes_, contacts_);
  groups_.sort(contacts_);
}

void World::drop_contacts_of(const BodySet& bodies) {
  contacts_.keep_if([&](const Contact& c) { return (bodies_of(c.pair) & bodies).none(); });
  groups_.sort(contacts_);
}

void World::separate_overlaps() {
  double deepest = 0.0;
  for (const Contact& c : contacts_.contacts()) deepest = std::max(deepest, -c.point.gap);
  events_.deepest_overlap = std::max(events_.deepest_overlap, deepest);
  if (deepest > 2.0 * arena_.tolerances.touch) {
    push_apart(contacts_.contacts(), free_mass_, bodies_, *soft_problem_);
  }
}

void World::collide(std::span<Contact> contacts, double t) {
  for (Contact& c : contacts) c.impact.restitution_threshold = patience_.rest_speed(c.pair);
  resolve_impacts(contacts, mass_, bodies_, *problem_);
  if (has_friction(arena_.parameters)) resolve_friction(contacts, mass_, bodies_, *problem_);
  for (const Contact& c : contacts) {
    if (c.impact.impulse == 0.0 || c.impact.approach <= c.impact.restitution_threshold) continue;
    ++events_.impacts;
    if (trace_ != nullptr) add_impact(c, t, *trace_);
    patience_.note_bounce(c.pair, t);
  }
  stop_brief_slides(arena_, patience_, drives_, contacts, mass_, bodies_, *problem_);
}

void World::start_segments(const BodySet& involved, double t, double tick_end) {
  const Wanted wanted{t, tick_end, patience_.long_enough(t), patience_.hold()};
  BodySet left = involved;
  for (int i = 0; i < arena_.bodies(); ++i) {
    if (!left[i]) continue;
    const BodySet cluster = cluster_of(i, contacts_.contacts());
    left &= ~cluster;
    quiet_.reset(i);
    if (cluster.any()) {
      motion_->move(cluster, *forces_, contacts_.contacts(), drives_, wanted, bodies_, segments_);
    } else if (arena_.is_ball(i)) {
      segments_[i] = roll(rolling_deceleration(arena_.parameters), bodies_[i], t, tick_end);
    } else if (is_quiet(arena_.parameters, bodies_[i], drives_[i], tick_end - t)) {
      start_quietly(i, t, tick_end);
    } else {
      segments_[i] = drive(arena_.parameters, bodies_[i], drives_[i], t, tick_end, wanted.enough);
    }
  }
  for (int i = 0; i < arena_.bodies(); ++i) {
    if (!involved[i] || quiet_[i]) continue;
    boxes_[i] = swept_box(segments_[i]);
    ways_[i] = way_along(segments_[i]);
  }
}

}  // namespace mirocup::simulator
