// SPDX-License-Identifier: MIT
#include "core/match/camera.hpp"

#include "core/match/disturbances.hpp"

#include <algorithm>
#include <utility>

namespace mirocup::match {

Camera::Camera(const Conditions& conditions, std::uint64_t seed, int robots, double period)
    : conditions_(conditions), robots_(robots), period_(period), pictures_{}, bodies_{} {
  redraw(seed);
}

void Camera::redraw(std::uint64_t seed) {
  ball_.noise = draws_of_ball(seed, Draw::sight);
  ball_.loss = draws_of_ball(seed, Draw::loss_of_sight);
  for (const Team team : both_teams) {
    for (int i = 0; i < robots_; ++i) {
      Body& body = bodies_[index_of(team)][i];
      body.noise = draws_of_robot(seed, Draw::sight, team, i);
      body.loss = draws_of_robot(seed, Draw::loss_of_sight, team, i);
    }
  }
}

void Camera::look(const Snapshot& truth, bool were_placed) {
  placings_ += were_placed ? 1 : 0;
  const int pictures = conditions_.delay_ticks + 1;
  pictures_[taken_ % pictures] = {.tick = truth.tick,
                                  .placing = placings_,
                                  .left = truth.left,
                                  .ball = truth.ball,
                                  .robots = truth.robots};
  ++taken_;
  // The oldest picture that is kept; before there are enough, the first one.
  const Picture& seen = pictures_[taken_ < pictures ? 0 : taken_ % pictures];

  view_ = truth;
  const End blue_end = seen.left == Team::blue ? End::left : End::right;
  see(ball_, seen, seen.ball.position, 0.0, blue_end);
  view_.ball = {ball_.last.position, ball_.velocity};
  view_.ball_age = age_of(ball_, truth.tick);
  for (const Team team : both_teams) {
    const End end = seen.left == team ? End::left : End::right;
    for (int i = 0; i < robots_; ++i) {
      Body& body = bodies_[index_of(team)][i];
      const ObservedRobot& robot = seen.robots[index_of(team)][i];
      see(body, seen, robot.position, robot.heading, end);
      view_.robots[index_of(team)][i] = {.position = body.last.position,
                                         .heading = body.last.heading,
                                         .velocity = body.velocity,
                                         .turn = body.turn,
                                         .age = age_of(body, truth.tick)};
    }
  }
}

// Decides whether the body is found in this picture.
bool Camera::is_seen(Body& body) {
  if (conditions_.unseen_rate <= 0.0) return true;
  const double mean = std::max(conditions_.unseen_mean_ticks, 1.0);
  const double chance = body.is_lost ? 1.0 - 1.0 / mean : conditions_.unseen_rate;
  body.is_lost = body.loss.uniform() < chance;
  return !body.is_lost || !body.last.exists;
}

void Camera::see(Body& body, const Picture& picture, const Vec2& position, double heading,
                 End end) {
  // Drawn in every tick, seen or not, so that the draws of a tick do not depend on earlier losses.
  const double x = conditions_.see_sigma_m * cut_normal(body.noise);
  const double y = conditions_.see_sigma_m * cut_normal(body.noise);
  const double turn = conditions_.see_sigma_rad * cut_normal(body.noise);
  if (!is_seen(body)) return;
  const Sighting now{.position = position + team_frame(end, Vec2{x, y}),
                     .heading = observed_angle(heading + observed_angle(turn)),
                     .tick = picture.tick,
                     .placing = picture.placing,
                     .exists = true};
  const Sighting before = std::exchange(body.last, now);
  const bool has_moved = before.exists && before.placing == now.placing && now.tick > before.tick;
  if (!before.exists || before.placing != now.placing) {
    body.velocity = {0.0, 0.0};
    body.turn = 0.0;
  } else if (has_moved) {
    const double time = static_cast<double>(now.tick - before.tick) * period_;
    body.velocity = (now.position - before.position) / time;
    body.turn = observed_angle(now.heading - before.heading) / time;
  }
}

// Ticks between the picture in which the body was seen last and the tick; 0 without any delay.
int Camera::age_of(const Body& body, std::uint32_t tick) const {
  return static_cast<int>(tick - body.last.tick);
}

}  // namespace mirocup::match
