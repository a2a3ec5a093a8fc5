// SPDX-License-Identifier: MIT
#include "record/drills/judge.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::drills {

namespace {

constexpr double save_holds_s = 0.5;      // so long after a save no goal may fall
constexpr double pass_min_length = 0.15;  // m that the ball rolls between the two contacts
constexpr double save_min_speed = 0.2;    // m/s of the ball
constexpr double contact_gap_ticks = 1;   // a longer pause begins another contact

}  // namespace

Judge::Judge(const Drill& drill, const match::Leg& leg)
    : drill_(drill),
      leg_(leg),
      states_(drill.success.size()),
      begin_(leg.referee().clock()),
      last_clock_(begin_),
      decisions_(leg.decisions().size()),
      ball_before_(leg.ball()) {}

double Judge::now() const {
  return leg_.referee().clock() - begin_;
}

bool Judge::follow() {
  see_touch();
  see_decisions();
  see_save();
  see_places();
  ball_before_ = leg_.ball();
  last_clock_ = leg_.referee().clock();
  return !leg_.is_over() && !is_decided();
}

// Counts something that has happened in this tick, by a touch of the team if one is given.
void Judge::count(EventKind kind, const match::Touch* touch) {
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const Event& event = drill_.success[i];
    State& state = states_[i];
    if (event.kind != kind || state.at || now() > event.by) continue;
    if (touch != nullptr && event.robot.value_or(touch->robot) != touch->robot) continue;
    if (event.first && touched_by_opponent_) continue;
    if (++state.count >= event.count) state.at = now();
  }
}

void Judge::see_decisions() {
  const auto& all = leg_.decisions();
  for (; decisions_ < all.size(); ++decisions_) {
    const match::LoggedDecision& d = all[decisions_];
    if (d.decision.verdict == referee::Verdict::GOAL) {
      if (d.team == tested) {
        count(EventKind::goal);
      } else {
        ++conceded_;
        saved_at_.reset();
      }
    }
    const bool is_call = d.decision.restart != referee::Restart::none;
    if (is_call && d.parties.offender == tested) ++fouls_;
    if (!is_call) continue;
    was_stopped_ = true;
    contact_.reset();  // bodies are placed anew
    if (saved_at_) end_save();
  }
}

void Judge::see_touch() {
  const auto touch = leg_.last_touch();
  const bool is_in_play = leg_.judged().has_value();
  if (!touch || !is_in_play) return;
  const std::uint32_t tick = leg_.tick();
  const bool goes_on =
      contact_ && contact_->who == *touch && tick - contact_->tick <= 1 + contact_gap_ticks;
  if (!goes_on && touch->team == tested) {
    count(EventKind::touch, &*touch);
    const bool is_pass =
        contact_ && contact_->who.team == tested && contact_->who.robot != touch->robot &&
        (contact_->ball - leg_.ball().position).squaredNorm() > pass_min_length * pass_min_length;
    if (is_pass) count(EventKind::pass);
    const End own_end = leg_.end_of(tested);
    const double towards_goal =
        own_end == End::left ? -ball_before_.velocity.x() : ball_before_.velocity.x();
    if (towards_goal > save_min_speed &&
        match::would_go_in(ball_before_, own_end, leg_.field(), leg_.setup().parameters,
                           leg_.setup().control_period)) {
      saved_at_ = now();
    }
  }
  touched_by_opponent_ = touched_by_opponent_ || touch->team != tested;
  contact_ = Contact{*touch, tick, leg_.ball().position};
}

void Judge::see_save() {
  if (!saved_at_) return;
  if (leg_.is_over() || now() >= *saved_at_ + save_holds_s) end_save();
}

void Judge::end_save() {
  saved_at_.reset();
  count(EventKind::save);
}

void Judge::see_places() {
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const Event& event = drill_.success[i];
    if (event.kind == EventKind::pose) hold(event, states_[i], is_in_pose(event));
    if (event.kind == EventKind::in_area) hold(event, states_[i], is_in_area(event));
  }
}

void Judge::hold(const Event& event, State& state, bool is_there) {
  if (state.at || now() > event.by) return;
  state.held = is_there ? state.held + leg_.referee().clock() - last_clock_ : 0.0;
  if (is_there && state.held >= event.hold) state.at = now();
}

bool Judge::is_in_pose(const Event& event) const {
  const End end = leg_.end_of(tested);
  Pose wanted = event.pose;
  if (event.frame == Frame::ball) {
    const Vec2 ball = team_frame(end, leg_.ball().position);
    const Vec2 to_goal = Vec2{leg_.field().half_length, 0.0} - ball;
    const double length = std::sqrt(to_goal.squaredNorm());
    if (length == 0.0) return false;
    const Heading axis{to_goal.x() / length, to_goal.y() / length};
    wanted = {ball + axis.to_world(event.pose.position),
              {axis.cos * event.pose.heading.cos - axis.sin * event.pose.heading.sin,
               axis.sin * event.pose.heading.cos + axis.cos * event.pose.heading.sin}};
  }
  for (int i = 0; i < leg_.field().robots_per_team; ++i) {
    if (event.robot.value_or(i) != i) continue;
    const simulator::BodyState robot = leg_.robot(tested, i);
    const Pose pose = team_frame(end, robot);
    const double off = std::sqrt((pose.position - wanted.position).squaredNorm());
    // A robot drives both ways, so its back may be its front.
    const double turn = std::abs(pose.heading.seen_from(wanted.heading).angle());
    const double turned = std::min(turn, 3.141592653589793 - turn);
    if (off <= event.within && turned <= event.within_angle) return true;
  }
  return false;
}

bool Judge::is_in_area(const Event& event) const {
  const End end = leg_.end_of(tested);
  const auto is_inside = [&event](const Vec2& at) {
    return at.x() >= event.area[0] && at.x() <= event.area[2] && at.y() >= event.area[1] &&
           at.y() <= event.area[3];
  };
  if (event.is_of_ball) return is_inside(team_frame(end, leg_.ball().position));
  for (int i = 0; i < leg_.field().robots_per_team; ++i) {
    if (event.robot.value_or(i) != i) continue;
    if (is_inside(team_frame(end, leg_.robot(tested, i).position))) return true;
  }
  return false;
}

bool Judge::is_true(const Event& event, const State& state) const {
  if (event.kind == EventKind::no_goal) return conceded_ <= event.most;
  if (event.kind == EventKind::no_foul) return fouls_ <= event.most;
  return state.at.has_value();
}

// A try is decided when all has come true that has to happen, when nothing more can, when it is
// spoiled, or when play was stopped.
bool Judge::is_decided() const {
  if (was_stopped_ && !drill_.plays_on) return true;
  bool any_has_to_happen = false;
  bool any_is_open = false;
  bool any_is_spoiled = false;
  bool any_holds = false;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const Event& event = drill_.success[i];
    if (!event.has_to_happen()) {
      (is_true(event, states_[i]) ? any_holds : any_is_spoiled) = true;
      continue;
    }
    any_has_to_happen = true;
    if (!states_[i].at && now() <= event.by) any_is_open = true;
  }
  if (!any_has_to_happen) return any_is_spoiled && !any_holds;
  return any_is_spoiled || (!any_is_open && !saved_at_);
}

TryResult Judge::result() const {
  TryResult result{.passed = true, .marks = 0.0, .seconds = now(), .why = ""};
  const bool anything_has_to_happen =
      std::any_of(drill_.success.begin(), drill_.success.end(),
                  [](const Event& event) { return event.has_to_happen(); });
  bool is_spoiled = false;
  double all = 0.0;
  double latest = 0.0;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const Event& event = drill_.success[i];
    const bool came_true = is_true(event, states_[i]);
    if (!came_true && result.passed) result.why = to_string(event.kind);
    result.passed = result.passed && came_true;
    if (anything_has_to_happen && !event.has_to_happen()) {
      is_spoiled = is_spoiled || !came_true;
      continue;
    }
    all += event.marks;
    if (came_true) result.marks += event.marks;
    latest = std::max(latest, states_[i].at.value_or(0.0));
  }
  result.marks = is_spoiled ? 0.0 : result.marks / all;
  result.marks *= 1.0 - drill_.deductions.time * std::min(latest / drill_.seconds, 1.0);
  result.marks = std::max(0.0, result.marks - drill_.deductions.foul * fouls_);
  return result;
}

}  // namespace mirocup::drills
