// SPDX-License-Identifier: MIT
#include "core/match/goal_credit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirocup::match {

namespace {

// A ball that rolls for longer goes nowhere near the goal any more.
constexpr double max_roll_s = 30.0;

GoalKind kind_of(referee::Restart restart) {
  constexpr std::array kinds{GoalKind::open_play, GoalKind::kick_off,  GoalKind::goal_kick,
                             GoalKind::penalty,   GoalKind::free_ball, GoalKind::free_kick};
  static_assert(kinds.size() == enum_names<referee::Restart>.size());
  return kinds[static_cast<std::size_t>(restart)];
}

using Contact = BallContacts::Contact;

// Returns the contact of a team that ended last; null if there is none. It may have begun before
// the newest one.
const Contact* last_to_end(const BallContacts& contacts, Team team) {
  const Contact* last = nullptr;
  for (const Contact& c : contacts.all()) {
    if (c.who.team == team && (last == nullptr || c.last > last->last)) last = &c;
  }
  return last;
}

std::optional<Touch> assist_to(const BallContacts& contacts, const Contact& scorer) {
  for (const Contact& c : contacts.all()) {
    if (c.first >= scorer.first || c.who == scorer.who) continue;
    if (c.who.team != scorer.who.team) return std::nullopt;
    return c.who;
  }
  return std::nullopt;
}

}  // namespace

void BallContacts::add(std::uint32_t tick, const Touch& who, const simulator::BallState& before) {
  for (Contact& c : std::span(contacts_).first(count_)) {
    if (c.who == who && c.last + 1 >= tick) {
      c.last = tick;
      return;
    }
  }
  count_ = std::min(count_ + 1, capacity);
  std::shift_right(contacts_.data(), contacts_.data() + count_, 1);
  contacts_[0] = {.who = who, .first = tick, .last = tick, .before = before};
}

bool would_go_in(const simulator::BallState& ball, End end, const field::Field& field,
                 const simulator::Parameters& parameters, double control_period) {
  simulator::World alone(&field, parameters, simulator::Tolerances{}, 0, true);
  alone.set_ball(ball);
  const double out = -attack_sign(end);
  const double line = field.half_length + parameters.ball_radius;
  for (double time = 0.0; time < max_roll_s; time += control_period) {
    const simulator::BallState now = alone.ball();
    if (out * now.position.x() > line && std::abs(now.position.y()) < field.goal_half_width) {
      return true;
    }
    if (now.velocity.squaredNorm() == 0.0) return false;
    alone.advance({}, control_period);
  }
  return false;
}

namespace {

GoalKind kind_of(const Goal& goal, const BallContacts& contacts, const Contact& scorer,
                 const field::Field& field, const simulator::Parameters& parameters) {
  const auto all = contacts.all();
  const auto opposed = std::ranges::find_if(
      all, [&](const Contact& c) { return c.who.team != goal.scoring && c.first < scorer.first; });
  const bool takes = goal.taker == goal.scoring || goal.restart == referee::Restart::FREE_BALL;
  if (opposed == all.end()) return takes ? kind_of(goal.restart) : GoalKind::open_play;
  const bool is_rebound =
      opposed->last < scorer.first &&
      (scorer.first - opposed->last) * goal.control_period < rebound_s &&
      would_go_in(opposed->before, goal.end, field, parameters, goal.control_period);
  return is_rebound ? GoalKind::rebound : GoalKind::open_play;
}

}  // namespace

GoalCredit credit_of(const Goal& goal, const BallContacts& contacts, const field::Field& field,
                     const simulator::Parameters& parameters) {
  const Contact* attacker = last_to_end(contacts, goal.scoring);
  const Contact* defender = last_to_end(contacts, opponent_of(goal.scoring));
  GoalCredit credit;
  if (attacker == nullptr && defender == nullptr) return credit;
  if (attacker != nullptr && defender != nullptr && defender->last > attacker->last) {
    const bool both_held = attacker->last >= defender->first;
    if (!both_held &&
        !would_go_in(defender->before, goal.end, field, parameters, goal.control_period)) {
      credit.own_goal = true;
    }
  } else if (attacker == nullptr) {
    credit.own_goal = true;
  }
  const Contact& scorer = credit.own_goal ? *defender : *attacker;
  credit.scorer = scorer.who;
  if (credit.own_goal) return credit;
  credit.assist = assist_to(contacts, scorer);
  credit.kind = kind_of(goal, contacts, scorer, field, parameters);
  return credit;
}

}  // namespace mirocup::match
