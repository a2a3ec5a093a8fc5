// SPDX-License-Identifier: MIT
#include "record/statistics/counter.hpp"

#include <cmath>

namespace mirocup::statistics {

LegWatcher::LegWatcher(const match::Leg& leg) : before_(leg.snapshot()) {}

PlayTick LegWatcher::see(const match::Leg& leg) {
  const match::Snapshot now = leg.snapshot();
  PlayTick tick;
  tick.tick = before_.tick;
  tick.is_play = leg.judged().has_value();
  tick.goes_on = now.state == match::State::PLAY;
  tick.phase = before_.phase;
  tick.left = before_.left;
  tick.ball_velocity = now.ball.velocity;
  tick.decisions = std::span(leg.decisions()).subspan(decisions_);
  decisions_ = leg.decisions().size();
  if (tick.is_play) {
    // The situation shows where the bodies were before a restart moved them.
    const referee::TickFacts& judged = *leg.judged();
    tick.ball = judged.ball;
    for (const Team team : both_teams) {
      const int end = index_of(team == before_.left ? End::left : End::right);
      tick.touched[index_of(team)] = judged.touched_ball[end];
      for (int i = 0; i < leg.field().robots_per_team; ++i) {
        tick.driven[index_of(team)] +=
            (judged.robots[end][i].position - before_.robots[index_of(team)][i].position).norm();
      }
    }
  }
  before_ = now;
  return tick;
}

namespace {

End end_of(const PlayTick& tick, Team team) {
  return team == tick.left ? End::left : End::right;
}

// The place in the frame of the team, which attacks +x.
Vec2 seen_by(const PlayTick& tick, Team team, const Vec2& place) {
  return attack_sign(end_of(tick, team)) * place;
}

GoalOrigin origin_of(const match::GoalCredit& credit) {
  if (credit.own_goal) return GoalOrigin::own_goal;
  // The kinds of goals have the names of origins, but for those of a shoot-out.
  return from_string<GoalOrigin>(to_string(credit.kind)).value_or(GoalOrigin::open_play);
}

// Rounded to microseconds, so that a file has the very number that was counted.

double rounded(double value) {
  return std::round(value * 1e6) / 1e6;
}

}  // namespace

Counter::Counter(const field::Field& field, double control_period)
    : field_(field), control_period_(control_period) {}

void Counter::add(const PlayTick& tick) {
  if (tick.phase == referee::Phase::SHOOT_OUT) return;
  if (tick.is_play) {
    count_play(tick);
  } else {
    ++dead_ticks_;
  }
  count_decisions(tick);
}

void Counter::count_play(const PlayTick& tick) {
  ++play_ticks_;
  for (const Team team : both_teams) {
    counted_.teams[index_of(team)].distance_m += tick.driven[index_of(team)];
    if (seen_by(tick, team, tick.ball).x() > 0.0) ++opponent_half_ticks_[index_of(team)];
  }
  count_touches(tick);
  if (holder_) ++possession_ticks_[index_of(*holder_)];
  if (!tick.goes_on) return;
  count_shot(tick);
  end_what_is_over(tick);
}

void Counter::count_touches(const PlayTick& tick) {
  const bool blue = tick.touched[0].any();
  const bool yellow = tick.touched[1].any();
  if (!blue && !yellow) return;
  if (blue && yellow) {
    count_contest(tick);
  } else {
    count_touch(tick, blue ? Team::blue : Team::yellow);
  }
  last_touch_ = tick.tick;
  ball_then_ = tick.ball;
  for (const Team team : both_teams) {
    if (tick.touched[index_of(team)].any()) {
      last_place_[index_of(team)] = seen_by(tick, team, tick.ball);
    }
  }
}

void Counter::count_touch(const PlayTick& tick, Team team) {
  TeamStatistics& own = counted_.teams[index_of(team)];
  const bool was_shot_at =
      shot_ && shot_->team != team && shot_->on_goal && shot_->last_on_goal + 1 >= tick.tick;
  const std::size_t mark = shot_ ? shot_->mark : 0;
  if (shot_ && shot_->team != team) shot_.reset();
  if (save_ && save_->team != team) {  // the ball came back to the attackers: it was kept out
    ++counted_.teams[index_of(save_->team)].saves;
    save_.reset();
  }
  if (was_shot_at) save_ = Save{team, tick.tick, mark};

  const bool flew =
      sender_ && last_touch_ + 1 < tick.tick && (tick.ball - ball_then_).norm() >= min_flight_m;
  const referee::RobotSet& robots = tick.touched[index_of(team)];
  if (flew && sender_->team == team && (sender_->robots & robots).none()) {
    ++own.passes;
    counted_.passes.push_back({.tick = tick.tick,
                               .team = team,
                               .from = last_place_[index_of(team)],
                               .to = seen_by(tick, team, tick.ball)});
  }
  const bool intercepts = flew && sender_->team != team && !was_shot_at;
  if (intercepts) ++own.interceptions;
  if (holder_ && *holder_ != team) {
    lose_ball(tick, *holder_,
              was_shot_at  ? LossKind::save
              : intercepts ? LossKind::interception
                           : LossKind::tackle);
  }
  holder_ = team;
  sender_ = Sender{team, robots};
}

void Counter::lose_ball(const PlayTick& tick, Team team, LossKind kind) {
  Loss loss{.tick = tick.tick, .kind = kind, .place = last_place_[index_of(team)], .third = {}};
  const double third = field_.half_length / 3.0;
  loss.third = loss.place.x() < -third  ? Third::own
               : loss.place.x() > third ? Third::opponent
                                        : Third::middle;
  ++counted_.teams[index_of(team)].losses[at(loss.third)];
  last_loss_[index_of(team)] = loss;
}

// Both teams touched the ball: whoever had it still has it.
void Counter::count_contest(const PlayTick& tick) {
  if (!last_contest_) ++counted_.duels;
  last_contest_ = tick.tick;
  sender_.reset();
}

// Returns where the straight course of the ball leads, if `team` shoots.
Counter::Course Counter::course_of(const PlayTick& tick, Team team) const {
  const Vec2 velocity = seen_by(tick, team, tick.ball_velocity);
  const Vec2 ball = seen_by(tick, team, tick.ball);
  const double distance = field_.half_length - ball.x();
  if (velocity.norm() < shot_speed || velocity.x() <= 0.0) return Course::elsewhere;
  if (distance < 0.0 || distance > shot_distance_m) return Course::elsewhere;
  const double miss = std::abs(ball.y() + velocity.y() / velocity.x() * distance);
  if (miss < field_.goal_half_width) return Course::on_goal;
  return miss < wide_goals * field_.goal_half_width ? Course::wide : Course::elsewhere;
}

void Counter::count_shot(const PlayTick& tick) {
  if (!holder_) return;
  const Course course = course_of(tick, *holder_);
  if (course == Course::elsewhere) return;
  TeamStatistics& own = counted_.teams[index_of(*holder_)];
  if (!shot_) {
    shot_ = Shot{};
    shot_->team = *holder_;
    shot_->mark = mark_shot(tick.tick, *holder_);
    ++own.shots;
  }
  shot_->last = tick.tick;
  if (course != Course::on_goal) return;
  if (!shot_->on_goal) ++own.shots_on_goal;
  shot_->on_goal = true;
  shot_->last_on_goal = tick.tick;
  counted_.shots[shot_->mark].on_goal = true;
}

// Returns the place of the new mark.
std::size_t Counter::mark_shot(std::uint32_t tick, Team team) {
  counted_.shots.push_back({.tick = tick, .team = team, .place = last_place_[index_of(team)]});
  return counted_.shots.size() - 1;
}

void Counter::end_what_is_over(const PlayTick& tick) {
  if (shot_ && seconds(tick.tick - shot_->last) > shot_pause_s) shot_.reset();
  if (save_ && seconds(tick.tick - save_->tick) > save_s) {
    ++counted_.teams[index_of(save_->team)].saves;
    save_.reset();
  }
  if (last_contest_ && seconds(tick.tick - *last_contest_) > duel_pause_s) end_duel(holder_);
}

void Counter::end_duel(std::optional<Team> winner) {
  if (last_contest_ && winner) ++counted_.teams[index_of(*winner)].duels_won;
  last_contest_.reset();
}

void Counter::count_decisions(const PlayTick& tick) {
  const match::LoggedDecision* restart = nullptr;
  bool is_opening = false;
  for (const match::LoggedDecision& d : tick.decisions) {
    using referee::Verdict;
    const Verdict verdict = d.decision.verdict;
    if (verdict == Verdict::GOAL && d.team && d.credit) count_goal(d);
    const bool restarts = d.decision.restart != referee::Restart::none;
    if (restarts && d.parties.offender) {
      const Team offender = *d.parties.offender;
      ++counted_.teams[index_of(offender)].fouls[at(d.decision.law)];
      counted_.fouls.push_back({tick.tick, offender, d.decision.law, d.decision.restart});
    }
    if (restarts) {
      restart = &d;
      is_opening = verdict == Verdict::KICK_OFF;
    }
    if (verdict == Verdict::MATCH_END) restart = nullptr;
  }
  if (tick.is_play && !tick.goes_on) stop_play(std::nullopt);
  if (restart == nullptr || restart->decision.law == referee::Law::shoot_out) return;
  if (!is_opening) ++counted_.stoppages;
  restart_ = {.kind = restart->decision.restart,
              .law = restart->decision.law,
              .taker = restart->taker,
              .play_ticks = play_ticks_};
}

void Counter::count_goal(const match::LoggedDecision& d) {
  const Team team = *d.team;
  TeamStatistics& own = counted_.teams[index_of(team)];
  const GoalOrigin origin = origin_of(*d.credit);
  ++own.goals[at(origin)];
  counted_.goals.push_back({.tick = d.tick,
                            .team = team,
                            .origin = origin,
                            .scorer = d.credit->scorer,
                            .restart = restart_.kind,
                            .restart_law = restart_.law,
                            .taker = restart_.taker,
                            .since_restart = rounded(seconds(play_ticks_ - restart_.play_ticks)),
                            .loss = last_loss_[index_of(opponent_of(team))]});
  // A ball that was pushed over the line slowly is a shot, too.
  const bool is_shot_on = shot_ && shot_->team == team;
  const bool was_shot = is_shot_on || (save_ && save_->team != team);
  if (origin != GoalOrigin::own_goal) {
    if (!was_shot) ++own.shots;
    if (!was_shot || (is_shot_on && !shot_->on_goal)) ++own.shots_on_goal;
    ShotMark& mark = counted_.shots[!was_shot    ? mark_shot(d.tick, team)
                                    : is_shot_on ? shot_->mark
                                                 : save_->mark];
    mark.on_goal = mark.is_goal = true;
  }
  stop_play(team);
}

void Counter::stop_play(std::optional<Team> scoring) {
  if (save_ && scoring != opponent_of(save_->team)) ++counted_.teams[index_of(save_->team)].saves;
  end_duel(scoring);
  save_.reset();
  shot_.reset();
  holder_.reset();
  sender_.reset();
  last_loss_ = {};
}

LegStatistics Counter::statistics() const {
  Counter ended = *this;
  ended.stop_play(std::nullopt);
  LegStatistics& s = ended.counted_;
  s.play_s = rounded(seconds(play_ticks_));
  s.dead_ball_s = rounded(seconds(dead_ticks_));
  for (const Team team : both_teams) {
    TeamStatistics& own = s.teams[index_of(team)];
    own.possession_s = rounded(seconds(possession_ticks_[index_of(team)]));
    own.opponent_half_s = rounded(seconds(opponent_half_ticks_[index_of(team)]));
    own.distance_m = std::round(own.distance_m * 1e3) / 1e3;
  }
  return s;
}

LegCounter::LegCounter(const match::Leg& leg)
    : watcher_(leg), counter_(leg.field(), leg.setup().control_period) {}

}  // namespace mirocup::statistics
