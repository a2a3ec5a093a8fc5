// SPDX-License-Identifier: MIT
#include "core/match/leg.hpp"

#include "core/base/assert.hpp"
#include "core/match/call_text.hpp"
#include "core/referee/placement_check.hpp"
#include "core/referee/touches.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mirocup::match {

namespace {

// The last command of a late team is repeated for this many ticks; then its robots stop.
constexpr int max_repeated_ticks = 3;

// Each team has one tick to place in before the whistle.
constexpr int min_ready_ticks = 2;

void add(StateHash& hash, const Vec2& v) {
  hash.add(v.x());
  hash.add(v.y());
}

// The progress of a leg at its start. `toss` is what it would be at the kick-off.
referee::LegProgress progress_at(const Start& start, const referee::LegProgress& toss) {
  referee::LegProgress progress = toss;
  progress.phase = start.phase;
  progress.clock = start.clock;
  for (const Team team : both_teams) {
    const End end = team == start.left ? End::left : End::right;
    progress.score[index_of(end)] = start.score[index_of(team)];
  }
  const bool opens_phase = start.restart && start.clock == 0.0;
  if (opens_phase) progress.first = restart_of(start).taker;
  return progress;
}

}  // namespace

void set_pitch(Setup& setup, const PitchSpec& pitch) {
  setup.pitch_name = pitch.name;
  setup.parameters = pitch.parameters;
  if (pitch.control_period) setup.control_period = *pitch.control_period;
}

Leg::Leg(const Setup& setup, TickLogs tick_logs) : Leg(setup, tick_logs, nullptr) {}

Leg::Leg(const Setup& setup, TickLogs tick_logs, simulator::World& shared)
    : Leg(setup, tick_logs, &shared) {}

Leg::Leg(const Setup& setup, TickLogs tick_logs, simulator::World* shared)
    : setup_(setup),
      field_(field::make_field(setup.league)),
      pitch_{.field = field_,
             .rules = setup_.rules,
             .ball_radius = setup.parameters.ball_radius,
             .robot_side = setup.parameters.robot_side},
      rng_(mix_seed(setup.seed)),
      tick_logs_(tick_logs) {
  // The toss decides which team defends the left end and which kicks off (MiroSot law 6.1).
  left_ = rng_.coin() ? Team::blue : Team::yellow;
  if (setup.left) left_ = *setup.left;
  if (setup.start) left_ = setup.start->left;
  const Team kick_off = rng_.coin() ? Team::blue : Team::yellow;
  referee::LegProgress progress{.stage = setup.stage, .first = end_of(kick_off)};
  if (setup.start) progress = progress_at(*setup.start, progress);
  referee_ = std::make_unique<referee::Referee>(pitch_, progress);
  simulator::Parameters parameters = setup_.parameters;
  const Conditions& conditions = setup_.conditions;
  if (conditions != conditions_of(ConditionsPreset::exact)) {
    disturbances_.emplace(conditions, setup_.seed, field_.robots_per_team);
    parameters.rolling_resistance *= disturbances_->rolling_factor();
  }
  if (conditions.has_camera()) {
    camera_.emplace(conditions, setup_.seed, field_.robots_per_team, setup_.control_period);
  }
  if (shared == nullptr) {
    own_world_ = std::make_unique<simulator::World>(&field_, parameters, setup_.tolerances,
                                                    2 * field_.robots_per_team, true);
    shared = own_world_.get();
  } else {
    shared->clear(parameters.rolling_resistance);
  }
  world_ = shared;
  // No more than for half an hour: a record may claim days.
  constexpr double max_reserved = 65536.0;
  if (tick_logs_ == TickLogs::kept) {
    log_.reserve(static_cast<std::size_t>(
        std::min(2.2 * setup_.rules.half_s / setup_.control_period, max_reserved)));
  }
  if (setup_.start) {
    begin_at(*setup_.start);
  } else {
    apply(referee_->opening());
    place();
  }
  look();
}

void Leg::lay_aside() {
  world_->save(laid_aside_);
  world_ = nullptr;
  events_ = nullptr;
}

void Leg::take_up(simulator::World& shared) {
  world_ = &shared;
  world_->load(laid_aside_);
}

Briefing Leg::briefing(Team team) const {
  return {.field = &field_,
          .parameters = &setup_.parameters,
          .rules = &setup_.rules,
          .control_period = setup_.control_period,
          .team = team,
          .seed = mix_seed(setup_.seed + 1 + static_cast<std::uint64_t>(index_of(team)))};
}

void Leg::advance(Controller& blue, Controller& yellow) {
  const Snapshot now = view();
  blue.post(observe(now, Team::blue, field_.robots_per_team));
  yellow.post(observe(now, Team::yellow, field_.robots_per_team));
  advance({blue.collect(), yellow.collect()});
}

void Leg::advance(const ByTeam<Answer>& answers) {
  MIROCUP_ASSERT(!is_over());
  if (!accept_answers(answers)) return;
  simulate();
  judge();
  place();
  if (tick_logs_ == TickLogs::kept) record();
  end_tick();
  look();
}

// Returns false if one of the answers ends the leg.
bool Leg::accept_answers(const ByTeam<Answer>& given) {
  std::vector<TeamFault> faults;
  hands_ = {};
  for (const Team team : both_teams) {
    const int i = index_of(team);
    if (const auto* failure = std::get_if<HostFailure>(&given[i])) {
      declare_void(failure->text);
      return false;
    }
    if (const auto* fault = std::get_if<Fault>(&given[i])) {
      faults.push_back({team, *fault});
    } else if (const auto* command = std::get_if<Command>(&given[i])) {
      drive(team, *command);
      if (command->placement) on_placement_request(team, *command->placement);
    } else {
      ++late_ticks_[i];
      if (const auto& older = std::get<Late>(given[i]).older) {
        drive(team, *older);
      } else if (++late_in_a_row_[i] > max_repeated_ticks) {
        answers_[i] = {};
      }
    }
  }
  if (faults.empty()) return true;
  forfeit(std::move(faults));
  return false;
}

// Makes the command this tick's answer.
void Leg::drive(Team team, const Command& command) {
  const int i = index_of(team);
  const CheckedCommand checked =
      check(command, field_.robots_per_team, setup_.parameters.wheel_speed_limit);
  answers_[i] = checked.command;
  bad_values_[i] += checked.bad_values > 0 ? 1 : 0;
  late_in_a_row_[i] = 0;
}

// A placement request in the team's turn is granted at the end of the tick. A request out of its
// turn may be an offence.
void Leg::on_placement_request(Team team, const PlacementRequest& poses) {
  if (placing_ != team) {
    const bool counts = setup_.rules.hand_penalty && state_ == State::PLAY &&
                        referee_->phase() != referee::Phase::SHOOT_OUT;
    hands_[index_of(end_of(team))] = counts;
    if (counts) placement_requests_.push_back({tick_, team, poses});
    return;
  }
  const int robots = field_.robots_per_team;
  const PlacementRequest shown = unchanged_request(observe(view(), team, robots));
  if (bit_equal(poses, shown, robots)) return;
  requested_ = rounded(poses, shown, robots);
  requested_placement_ = requested_placement(standing(), end_of(team), shown, *requested_, robots);
}

void Leg::redraw(std::uint64_t seed) {
  if (disturbances_) disturbances_->redraw(seed);
  if (camera_) camera_->redraw(seed);
}

void Leg::simulate() {
  std::array<simulator::WheelCommand, simulator::max_robots> wheels;
  for (const Team team : both_teams) {
    for (int i = 0; i < field_.robots_per_team; ++i) {
      const int body = body_of(team, i);
      wheels[body] = driven_speeds(team, i);
      const simulator::BodyState robot = world_->robot(body);
      velocity_before_[index_of(team)][i] =
          robot.heading.to_world({robot.twist.forward, robot.twist.left});
    }
  }
  const simulator::BallState ball = world_->ball();
  ball_before_ = ball.position;
  events_ = &world_->advance({wheels.data(), static_cast<std::size_t>(world_->robots())},
                             setup_.control_period);
  note_ball_contacts(ball);
}

void Leg::note_ball_contacts(const simulator::BallState& before) {
  if (events_->last_to_touch_ball == simulator::no_body) return;
  const simulator::BodySet& touched = events_->touched[world_->robots()];
  for (const Team team : both_teams) {
    for (int i = 0; i < field_.robots_per_team; ++i) {
      if (touched[body_of(team, i)]) ball_contacts_.add(tick_, {team, i}, before);
    }
  }
}

simulator::WheelSpeeds Leg::driven_speeds(Team team, int robot) {
  if (!is_active(team, robot)) return {};
  const simulator::WheelSpeeds command = pending_[index_of(team)].speeds(robot);
  return disturbances_ ? disturbances_->drive(team, robot, command) : command;
}

// True if the robot's commands count. In a shoot-out only kicker and keeper play; the other robots
// stand in the kicker's half, where an attempt ends.
bool Leg::is_active(Team team, int robot) const {
  if (state_ != State::PLAY) return false;
  if (setup_.start && setup_.start->robots[index_of(team)][robot].is_broken) return false;
  if (referee_->phase() != referee::Phase::SHOOT_OUT) return true;
  return robot == (team_at(restart_.taker) == team ? referee::kicker : referee::keeper);
}

void Leg::judge() {
  judged_.reset();
  if (state_ != State::PLAY) {
    if (--ready_ticks_left_ <= 0) state_ = State::PLAY;
    return;
  }
  const referee::Judgement judgement = referee_->judge(judged_.emplace(situation()));
  for (const referee::Decision& note : judgement.notes) log_decision(note);
  if (judgement.decision) apply(*judgement.decision);
}

void Leg::apply(const referee::Decision& decision) {
  log_decision(decision);
  if (decision.verdict == referee::Verdict::MATCH_END) {
    end(decision);
  } else if (const auto next = referee_->follow_up(decision)) {
    apply(*next);
  } else if (decision.verdict == referee::Verdict::HALF_END ||
             decision.verdict == referee::Verdict::PHASE) {
    start_phase(decision.phase);
    apply(referee_->opening());
  } else {
    restart_ = decision;
    placement_is_due_ = true;
  }
}

// The ends change between halves. Extra time and the shoot-out start with a toss of their own.
void Leg::start_phase(referee::Phase phase) {
  const bool next_half = phase == referee::Phase::SECOND_HALF ||
                         (phase == referee::Phase::EXTRA && referee_->phase() == phase);
  if (next_half) {
    left_ = opponent_of(left_);
    referee_->start_half(phase);
    return;
  }
  const Team first = rng_.coin() ? Team::blue : Team::yellow;
  if (phase == referee::Phase::EXTRA) {
    referee_->start_extra_time(end_of(first));
  } else {
    const Team lots = rng_.coin() ? Team::blue : Team::yellow;
    referee_->start_shoot_out(end_of(first), end_of(lots));
  }
}

void Leg::place() {
  using referee::first_placer;
  const Team first = team_at(first_placer(restart_.restart, restart_.taker));
  if (std::exchange(placement_is_due_, false)) {
    place_bodies(
        by_hand(referee::default_placement(pitch_, restart_.restart, restart_.taker, restart_.spot),
                Moved::everything(field_.robots_per_team)));
    if (disturbances_) disturbances_->stop_robots();
    wait_for_whistle(first);
  } else if (placing_) {
    if (requested_) grant_placement();
    placing_ = placing_ == first ? std::optional(opponent_of(first)) : std::nullopt;
  }
}

void Leg::wait_for_whistle(Team first_to_place) {
  placing_ = first_to_place;
  state_ = State::READY;
  ready_ticks_left_ =
      std::max(min_ready_ticks,
               static_cast<int>(std::nearbyint(setup_.rules.ready_s / setup_.control_period)));
}

// What the start gives is put exactly there; by hand is put only what it leaves to a restart.
void Leg::begin_at(const Start& start) {
  restart_ = restart_of(start);
  referee::Placement placement = placement_of(pitch_, start);
  if (start.restart) {
    log_decision(restart_);
    restart_.spot = placement.ball;
    Moved left_out = Moved::everything(field_.robots_per_team);
    left_out.ball = !start.ball;
    for (const Team team : both_teams) {
      for (int i = 0; i < field_.robots_per_team; ++i) {
        const bool is_given = start.robots[index_of(team)][i].state.has_value();
        if (is_given) left_out.robots[index_of(end_of(team))].reset(i);
      }
    }
    placement = by_hand(placement, left_out);
    wait_for_whistle(team_at(referee::first_placer(restart_.restart, restart_.taker)));
  } else {
    state_ = State::PLAY;
  }
  place_bodies(placement);
  if (!start.restart) set_in_motion(start);
}

void Leg::set_in_motion(const Start& start) {
  if (start.ball) world_->set_ball(*start.ball);
  for (const Team team : both_teams) {
    Command command;
    for (int i = 0; i < field_.robots_per_team; ++i) {
      const RobotStart& robot = start.robots[index_of(team)][i];
      if (robot.state) world_->set_robot(body_of(team, i), *robot.state);
      command.wheels[i] = robot.wheels;
    }
    DrivenCommand& pending = pending_[index_of(team)];
    pending = check(command, field_.robots_per_team, setup_.parameters.wheel_speed_limit).command;
    answers_[index_of(team)] = pending;
    if (!disturbances_) continue;
    for (int i = 0; i < field_.robots_per_team; ++i) {
      disturbances_->receive(team, i, pending.speeds(i));
    }
  }
}

void Leg::grant_placement() {
  placement_requests_.push_back({tick_, *placing_, *std::exchange(requested_, std::nullopt)});
  const referee::Placement& wanted = requested_placement_;
  const End end = end_of(*placing_);
  const referee::CheckedPlacement granted = check_turn(pitch_, restart_, end, roles(), wanted);
  if (granted.any_moved()) {
    referee::Decision fixed;
    fixed.verdict = referee::Verdict::PLACEMENT_FIXED;
    fixed.law = referee::Law::placement;
    fixed.clock = referee_->clock();
    if (granted.ball_moved || granted.moved[index_of(end)].any()) fixed.team = end;
    fixed.robots = granted.moved;
    fixed.reason = reason_of(pitch_, wanted, granted);
    fixed.ball = granted.placement.ball;
    log_decision(fixed);
  }
  const Moved moved = Moved::between(standing(), granted.placement, field_.robots_per_team);
  place_bodies(by_hand(granted.placement, moved));
}

referee::Placement Leg::by_hand(const referee::Placement& wanted, const Moved& moved) {
  if (!setup_.conditions.disturbs_placing()) return wanted;
  return put_down(pitch_, restart_, roles(), wanted, moved, left_, *disturbances_);
}

referee::Roles Leg::roles() const {
  return referee_->phase() == referee::Phase::SHOOT_OUT ? referee::Roles::fixed
                                                        : referee::Roles::any;
}

// Where everything is now.
referee::Placement Leg::standing() const {
  referee::Placement now;
  now.ball = world_->ball().position;
  for (const Team team : both_teams) {
    for (int i = 0; i < field_.robots_per_team; ++i) {
      const simulator::BodyState robot = world_->robot(body_of(team, i));
      now.robots[index_of(end_of(team))][i] = {robot.position, robot.heading};
    }
  }
  return now;
}

void Leg::place_bodies(const referee::Placement& placement) {
  for (const Team team : both_teams) {
    for (int i = 0; i < field_.robots_per_team; ++i) {
      const Pose& pose = placement.robots[index_of(end_of(team))][i];
      world_->set_robot(body_of(team, i), {pose.position, pose.heading, {}});
    }
  }
  world_->set_ball({placement.ball, {0.0, 0.0}});
  were_placed_ = true;
  ball_contacts_.forget();
  restart_.spot = placement.ball;
  referee_->resume(restart_);
}

void Leg::look() {
  if (camera_) camera_->look(snapshot(), std::exchange(were_placed_, false));
}

void Leg::record() {
  hash_.add(static_cast<std::uint64_t>(tick_));
  hash_.add(static_cast<std::uint64_t>(state_));
  hash_.add(referee_->clock());
  for (const int score : referee_->score()) hash_.add(static_cast<std::uint64_t>(score));
  const simulator::BallState ball = world_->ball();
  add(hash_, ball.position);
  add(hash_, ball.velocity);
  for (int i = 0; i < world_->robots(); ++i) {
    const simulator::BodyState robot = world_->robot(i);
    add(hash_, robot.position);
    hash_.add(robot.heading.cos);
    hash_.add(robot.heading.sin);
    hash_.add(robot.twist.forward);
    hash_.add(robot.twist.left);
    hash_.add(robot.twist.omega);
  }
  log_.push_back({answers_, hash_.value()});
}

void Leg::end_tick() {
  pending_ = answers_;
  ++tick_;
}

void Leg::end(OutcomeKind kind) {
  state_ = State::END;
  Outcome outcome;
  outcome.kind = kind;
  for (const Team team : both_teams) {
    outcome.played[index_of(team)] = referee_->score()[index_of(end_of(team))];
  }
  outcome.score = outcome.played;
  if (outcome.score[0] != outcome.score[1]) {
    outcome.winner = outcome.score[0] > outcome.score[1] ? Team::blue : Team::yellow;
  }
  outcome_ = std::move(outcome);
}

void Leg::end(const referee::Decision& decision) {
  using referee::Law;
  switch (decision.law) {
    case Law::mercy:
      end(OutcomeKind::mercy);
      break;
    case Law::golden_goal:
      end(OutcomeKind::golden_goal);
      break;
    case Law::shoot_out:
    case Law::lots:
      end(OutcomeKind::shoot_out);
      outcome_->winner = team_at(*decision.team);
      outcome_->shoot_out.emplace();
      for (const Team team : both_teams) {
        (*outcome_->shoot_out)[index_of(team)] =
            referee_->shoot_out().scored[index_of(end_of(team))];
      }
      break;
    default:
      end(OutcomeKind::full_time);
  }
}

void Leg::forfeit(std::vector<TeamFault> faults) {
  MIROCUP_ASSERT(!is_over());
  MIROCUP_ASSERT(faults.size() == 1 || faults.size() == 2);
  const bool both = faults.size() > 1;
  end(both ? OutcomeKind::double_forfeit : OutcomeKind::forfeit);
  outcome_->score = {0, 0};
  outcome_->winner.reset();
  if (!both) {
    const Team winner = opponent_of(faults.front().team);
    outcome_->winner = winner;
    outcome_->score[index_of(winner)] = setup_.rules.forfeit_goals;
  }
  outcome_->faults = std::move(faults);
}

void Leg::declare_void(std::string why) {
  MIROCUP_ASSERT(!is_over());
  end(OutcomeKind::void_);
  outcome_->winner.reset();
  outcome_->why_void = std::move(why);
}

void Leg::log_decision(const referee::Decision& decision) {
  LoggedDecision logged;
  logged.tick = tick_;
  logged.decision = decision;
  logged.decision.reason = in_colours(decision.reason, left_);
  if (decision.team) logged.team = team_at(*decision.team);
  logged.taker = team_at(decision.taker);
  for (const Team team : both_teams) {
    logged.robots[index_of(team)] = decision.robots[index_of(end_of(team))];
  }
  logged.parties = parties_of(decision, logged.team, logged.taker);
  if (decision.verdict == referee::Verdict::GOAL && logged.team) give_credit(logged);
  decisions_.push_back(std::move(logged));
}

// The referee calls an own goal by the last touch alone. Here the touch must have mattered.
void Leg::give_credit(LoggedDecision& goal) const {
  const Team scoring = *goal.team;
  const GoalCredit credit = credit_of({.scoring = scoring,
                                       .end = end_of(opponent_of(scoring)),
                                       .restart = restart_.restart,
                                       .taker = team_at(restart_.taker),
                                       .control_period = setup_.control_period},
                                      ball_contacts_, field_, world_->parameters());
  goal.decision.law = credit.own_goal ? referee::Law::own_goal : referee::Law::goal;
  goal.decision.reason += credit.own_goal ? ", an own goal" : "";
  if (credit.scorer) {
    goal.decision.reason += (credit.own_goal ? " of " : ", scored by ") +
                            std::string(to_string(credit.scorer->team)) + " robot " +
                            std::to_string(credit.scorer->robot);
  }
  goal.credit = credit;
  goal.score = ByTeam<int>{};
  for (const LoggedDecision& before : decisions_) {
    if (before.score) goal.score = before.score;
  }
  ++(*goal.score)[index_of(scoring)];
}

referee::TickFacts Leg::situation() const {
  referee::TickFacts s;
  s.duration = setup_.control_period;
  s.ball_before = ball_before_;
  s.ball = world_->ball().position;
  s.hand = hands_;
  for (const Team team : both_teams) {
    const int e = index_of(end_of(team));
    for (int i = 0; i < field_.robots_per_team; ++i) {
      const simulator::BodyState robot = world_->robot(body_of(team, i));
      s.robots[e][i] = {robot.position, robot.heading};
      s.velocity[e][i] = velocity_before_[index_of(team)][i];
      if (!is_active(team, i)) continue;
      const simulator::WheelSpeeds wheels = pending_[index_of(team)].speeds(i);
      s.commanded[e][i] =
          setup_.parameters.speed_reference(wheels.left, wheels.right) * robot.heading.forward();
    }
  }
  add_touches(*events_, s);
  referee::add_near_touches(pitch_, s);
  return s;
}

std::optional<Touch> Leg::last_touch() const {
  if (events_ == nullptr || events_->last_to_touch_ball == simulator::no_body) return std::nullopt;
  const int body = events_->last_to_touch_ball;
  const int robots = field_.robots_per_team;
  return Touch{body < robots ? Team::blue : Team::yellow, body % robots};
}

void Leg::add_touches(const simulator::TickEvents& events, referee::TickFacts& s) const {
  const int ball = world_->robots();
  const auto robot_of = [&](int body) {
    const Team team = body < field_.robots_per_team ? Team::blue : Team::yellow;
    return referee::RobotId{end_of(team), body - body_of(team, 0)};
  };
  for (int body = 0; body < ball; ++body) {
    const simulator::BodySet& touched = events.touched[body];
    if (touched.none()) continue;
    const referee::RobotId robot = robot_of(body);
    if (touched[ball]) s.touched_ball[index_of(robot.end)].set(robot.index);
    for (int other = 0; other < body; ++other) {
      if (touched[other]) referee::set_touch(s, robot, robot_of(other));
    }
  }
  if (events.last_to_touch_ball != simulator::no_body) {
    s.last_touch = robot_of(events.last_to_touch_ball);
  }
}

Snapshot Leg::snapshot() const {
  Snapshot s;
  s.tick = tick_;
  s.time = tick_ * setup_.control_period;
  s.clock = referee_->clock();
  s.state = state_;
  s.phase = referee_->phase();
  s.restart = restart_.restart;
  s.taker = team_at(restart_.taker);
  s.left = left_;
  s.placing = placing_;
  s.ball = world_->ball();
  const referee::PendingCounts pending = referee_->pending_counts();
  s.stalemate_s = pending.stalemate_s;
  s.advantage_s = pending.advantage_s;
  for (const Team team : both_teams) {
    s.counts[index_of(team)] = pending.teams[index_of(end_of(team))];
    s.score[index_of(team)] = referee_->score()[index_of(end_of(team))];
    for (int i = 0; i < field_.robots_per_team; ++i) {
      s.robots[index_of(team)][i] = observed(world_->robot(body_of(team, i)));
    }
  }
  return s;
}

}  // namespace mirocup::match
