// SPDX-License-Identifier: MIT
#include "labs/training/rewards.hpp"

#include "labs/training/behind_ball.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::training {

namespace {

// How fast a wheel turns that is told `speed`, in either direction: one that is not finite is 0.
double driven(double speed) {
  return std::isfinite(speed) ? std::abs(speed) : 0.0;
}

double& of(Terms& terms, Term term) {
  return terms[static_cast<std::size_t>(term)];
}

// The potential of the ball in rSoccer's VSS environment: 0 at the opponents' end, -1 at the own.
double vss_potential(const field::Field& field, const Vec2& ball) {
  const double half = field.half_length + field.goal_depth;
  const double attack = half - ball.x();
  const double defence = half + ball.x();
  const double square = 2.0 * ball.y() * ball.y();
  const double difference =
      std::sqrt(defence * defence + square) - std::sqrt(attack * attack + square);
  return (difference / (2.0 * field.half_length) - 1.0) / 2.0;
}

int first_robot(const Learner& learner) {
  int first = 0;
  while (!learner.robots[static_cast<std::size_t>(first)]) ++first;
  return first;
}

}  // namespace

TermText text_of(Term term) {
  switch (term) {
    case Term::goal:
      return {"1", "goals of the own team minus goals of the opponents"};
    case Term::ball_to_goal:
      return {"m", "by how much the ball came nearer to the middle of the opponents' goal"};
    case Term::robot_to_ball:
      return {"m", "by how much the distance from the learner's nearest robot to the ball fell"};
    case Term::behind_ball:
      return {"m",
              "by how much the distance from the learner's nearest robot to the place behind the "
              "ball fell"};
    case Term::touch:
      return {"1", "ticks in which a robot of the learner was the last to touch the ball"};
    case Term::foul:
      return {"1", "calls against the opponents minus calls against the own team"};
    case Term::energy:
      return {"s",
              "minus the product of the time and the mean of |command| / speed limit over the "
              "learner's wheels"};
    case Term::time:
      return {"s", "minus time"};
    case Term::vss_goal:
      return {"1", "rSoccer: goal for or against, 1 or -1"};
    case Term::vss_ball_grad:
      return {"1", "rSoccer: gradient of the ball's potential, in [-5, 5]"};
    case Term::vss_move:
      return {"1",
              "rSoccer: speed of the learner's first robot towards the ball / 0.4 m/s, in [-5, 5]"};
    case Term::vss_energy:
      return {"rad/s",
              "rSoccer: minus the sum of |command| over the wheels of the learner's first robot"};
  }
  return {};
}

RewardMeter::Ways RewardMeter::ways(const match::Leg& leg, const Learner& learner) {
  const End end = leg.end_of(learner.team);
  const Vec2 goal{leg.field().half_length, 0.0};
  const Vec2 ball = team_frame(end, leg.ball().position);
  const Vec2 behind = behind_ball(ball, goal, pushing_gap(leg.setup().parameters));
  double to_ball = infinity;
  double to_behind = infinity;
  for (int i = 0; i < leg.field().robots_per_team; ++i) {
    if (!learner.robots[static_cast<std::size_t>(i)]) continue;
    const Vec2 robot = team_frame(end, leg.robot(learner.team, i).position);
    to_ball = std::min(to_ball, (robot - ball).squaredNorm());
    to_behind = std::min(to_behind, (robot - behind).squaredNorm());
  }
  return {.ball_to_goal = (goal - ball).norm(),
          .robot_to_ball = std::sqrt(to_ball),
          .behind_ball = std::sqrt(to_behind)};
}

void RewardMeter::start(const match::Leg& leg, const Learner& learner) {
  *this = {};
  ways_ = ways(leg, learner);
}

void RewardMeter::add_tick(const match::Leg& leg, const Learner& learner,
                           const std::array<simulator::WheelSpeeds, max_robots_per_team>& command,
                           std::size_t decisions) {
  const double period = leg.setup().control_period;
  const Ways now = ways(leg, learner);
  if (leg.state() == match::State::READY) {
    has_potential_ = false;  // the bodies have just been placed
  } else {
    of(now_, Term::ball_to_goal) += ways_.ball_to_goal - now.ball_to_goal;
    of(now_, Term::robot_to_ball) += ways_.robot_to_ball - now.robot_to_ball;
    of(now_, Term::behind_ball) += ways_.behind_ball - now.behind_ball;
  }
  ways_ = now;

  for (std::size_t i = decisions; i < leg.decisions().size(); ++i) {
    const match::LoggedDecision& d = leg.decisions()[i];
    if (d.decision.verdict == referee::Verdict::GOAL && d.team) {
      of(now_, Term::goal) += *d.team == learner.team ? 1.0 : -1.0;
    } else if (d.parties.offender && d.decision.restart != referee::Restart::none) {
      of(now_, Term::foul) += *d.parties.offender == learner.team ? -1.0 : 1.0;
    }
  }
  if (const auto touch = leg.last_touch()) {
    const bool is_own =
        touch->team == learner.team && learner.robots[static_cast<std::size_t>(touch->robot)];
    of(now_, Term::touch) += is_own ? 1.0 : 0.0;
  }

  double wheels = 0.0;
  int robots = 0;
  wheel_sum_ = 0.0;
  for (int i = 0; i < leg.field().robots_per_team; ++i) {
    if (!learner.robots[static_cast<std::size_t>(i)]) continue;
    const simulator::WheelSpeeds& w = command[static_cast<std::size_t>(i)];
    const double sum = driven(w.left) + driven(w.right);
    if (robots == 0) wheel_sum_ = sum;
    wheels += sum;
    ++robots;
  }
  const double limit = leg.setup().parameters.wheel_speed_limit;
  of(now_, Term::energy) -= period * wheels / (2.0 * limit * robots);
  of(now_, Term::time) -= period;
}

Terms RewardMeter::take_step(const match::Leg& leg, const Learner& learner, double step_s) {
  constexpr double most = 5.0;
  constexpr double fast = 0.4;  // m/s
  const double goal = of(now_, Term::goal);
  of(now_, Term::vss_goal) = goal;
  if (goal == 0.0) {
    const End end = leg.end_of(learner.team);
    const Vec2 ball = team_frame(end, leg.ball().position);
    const double potential = vss_potential(leg.field(), ball);
    if (has_potential_) {
      of(now_, Term::vss_ball_grad) =
          std::clamp((potential - potential_) * 3.0 / step_s, -most, most);
    }
    potential_ = potential;
    has_potential_ = true;

    const simulator::BodyState robot = leg.robot(learner.team, first_robot(learner));
    const Vec2 velocity =
        team_frame(end, robot.heading.to_world({robot.twist.forward, robot.twist.left}));
    const Vec2 way = ball - team_frame(end, robot.position);
    of(now_, Term::vss_move) = std::clamp(way.dot(velocity) / way.norm() / fast, -most, most);
    of(now_, Term::vss_energy) = -wheel_sum_;
  }
  const Terms step = now_;
  now_ = {};
  return step;
}

}  // namespace mirocup::training
