// SPDX-License-Identifier: MIT
#include "programs/check/leg_story.hpp"

#include "system/text.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::app {

namespace {

// A slower robot stands, or turns in place: m/s, rad/s.
constexpr double least_speed = 0.03;
constexpr double least_turn = 0.5;

}  // namespace

void LegWatch::look() {
  for (int i = 0; i < leg_.field().robots_per_team; ++i) {
    const auto wheels = leg_.answers()[index_of(team_)].speeds(i);
    const double faster = std::max(std::abs(wheels.left), std::abs(wheels.right));
    sums_.fastest_wheel = std::max(sums_.fastest_wheel, faster);
    if (wheels.left != 0.0) sums_.told_left |= 1U << static_cast<unsigned>(i);
    if (wheels.right != 0.0) sums_.told_right |= 1U << static_cast<unsigned>(i);
  }
  if (leg_.state() == match::State::PLAY) {
    look_at_robots();
    look_at_ball();
  }
  ball_before_ = leg_.ball();
}

void LegWatch::look_at_robots() {
  for (int i = 0; i < leg_.field().robots_per_team; ++i) {
    const simulator::Twist twist = leg_.robot(team_, i).twist;
    ++robot_ticks_;
    if (std::hypot(twist.forward, twist.left) < least_speed) {
      (std::abs(twist.omega) < least_turn ? sums_.standing : sums_.turning) += 1.0;
    } else if (twist.forward < -least_speed) {
      sums_.backwards += 1.0;
    }
  }
}

void LegWatch::look_at_ball() {
  const auto touch = leg_.last_touch();
  if (!touch || touch->team != team_) return;
  const double ahead = leg_.end_of(team_) == End::left ? 1.0 : -1.0;
  const double given = ahead * (leg_.ball().velocity.x() - ball_before_.velocity.x());
  (given > 0.0 ? towards_opponent_ : towards_own_) += std::abs(given);
}

LegStory LegWatch::story() const {
  LegStory story = sums_;
  story.team = team_;
  const auto score = leg_.snapshot().score;
  story.score = {score[index_of(team_)], score[1 - index_of(team_)]};
  for (const match::LoggedDecision& logged : leg_.decisions()) {
    const auto& credit = logged.credit;
    if (credit && credit->own_goal && credit->scorer && credit->scorer->team == team_)
      ++story.own_goals;
  }
  const auto share = [](double part, double all) { return all > 0.0 ? part / all : 0.0; };
  const auto all = static_cast<double>(robot_ticks_);
  story.standing = share(story.standing, all);
  story.turning = share(story.turning, all);
  story.backwards = share(story.backwards, all);
  story.given_speed = towards_own_ + towards_opponent_;
  story.towards_own_end = share(towards_own_, story.given_speed);
  return story;
}

std::string text_of(const LegStory& story) {
  const auto percent = [](double share) { return 100.0 * share; };
  const std::string own_goals = story.own_goals == 0
                                    ? ""
                                    : ", " + std::to_string(story.own_goals) + " own goal" +
                                          (story.own_goals == 1 ? "" : "s");
  return system::formatted(
      "%d : %d against %.40s as %s%s; its robots stood in %.0f %% of play, turned in "
      "place in %.0f %%, drove backwards in %.0f %%",
      story.score[0], story.score[1], story.opponent.c_str(), to_string(story.team).data(),
      own_goals.c_str(), percent(story.standing), percent(story.turning), percent(story.backwards));
}

}  // namespace mirocup::app
