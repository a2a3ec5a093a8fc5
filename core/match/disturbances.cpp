// SPDX-License-Identifier: MIT
#include "core/match/disturbances.hpp"

#include "core/base/assert.hpp"
#include "core/base/math.hpp"

namespace mirocup::match {

namespace {

constexpr double cut = 2.0;  // sigma

// Sets the draws of disturbances apart from the other uses of a leg's seed.
constexpr std::uint64_t domain = 0x636f6e646974696fULL;

constexpr int ball_number = 2 * max_robots_per_team;

Random draws(std::uint64_t seed, Draw kind, int body) {
  const std::uint64_t stream = static_cast<std::uint64_t>(kind) * 64 + static_cast<unsigned>(body);
  return Random(mix_seed(mix_seed(seed ^ domain) + stream));
}

double factor(Random& random, double sigma) {
  return sigma > 0.0 ? 1.0 + sigma * cut_normal(random) : 1.0;
}

}  // namespace

double cut_normal(Random& random) {
  for (;;) {
    const double x = random.uniform(-cut, cut);
    const double height = random.uniform();
    const double half_square = 0.5 * x * x;
    // exp(-h) >= 1 - h, so most draws are accepted without the exponential.
    if (height < 1.0 - half_square || height < exp(-half_square)) return x;
  }
}

Random draws_of_robot(std::uint64_t seed, Draw kind, Team team, int robot) {
  MIROCUP_ASSERT(0 <= robot && robot < max_robots_per_team);
  return draws(seed, kind, index_of(team) * max_robots_per_team + robot);
}

Random draws_of_ball(std::uint64_t seed, Draw kind) {
  return draws(seed, kind, ball_number);
}

Disturbances::Disturbances(const Conditions& conditions, std::uint64_t seed, int robots)
    : conditions_(conditions), robots_in_team_(robots), robots_{} {
  redraw(seed);
  Random rolling = draws_of_ball(seed, Draw::rolling);
  rolling_factor_ = factor(rolling, conditions_.rolling_sigma);
  for (const Team team : both_teams) {
    for (int i = 0; i < robots; ++i) {
      Random gain = draws_of_robot(seed, Draw::gain, team, i);
      Robot& robot = robots_[index_of(team)][i];
      robot.left_gain = factor(gain, conditions_.wheel_gain_sigma);
      robot.right_gain = factor(gain, conditions_.wheel_gain_sigma);
    }
  }
}

void Disturbances::redraw(std::uint64_t seed) {
  ball_placing_ = draws_of_ball(seed, Draw::placing);
  for (const Team team : both_teams) {
    for (int i = 0; i < robots_in_team_; ++i) {
      Robot& robot = robots_[index_of(team)][i];
      robot.placing = draws_of_robot(seed, Draw::placing, team, i);
      robot.jitter = draws_of_robot(seed, Draw::jitter, team, i);
      robot.radio = draws_of_robot(seed, Draw::radio, team, i);
    }
  }
}

PlacingError Disturbances::put_down_robot(Team team, int robot) {
  Random& random = robots_[index_of(team)][robot].placing;
  PlacingError error;
  const double x = cut_normal(random);
  const double y = cut_normal(random);
  error.offset = conditions_.place_sigma_m * Vec2{x, y};
  error.turn = conditions_.place_sigma_rad * cut_normal(random);
  return error;
}

Vec2 Disturbances::put_down_ball() {
  const double x = cut_normal(ball_placing_);
  const double y = cut_normal(ball_placing_);
  return conditions_.place_sigma_m * Vec2{x, y};
}

simulator::WheelSpeeds Disturbances::drive(Team team, int robot,
                                           const simulator::WheelSpeeds& command) {
  Robot& r = robots_[index_of(team)][robot];
  const bool is_lost = conditions_.radio_loss > 0.0 && r.radio.uniform() < conditions_.radio_loss;
  if (!is_lost) r.received = command;
  const double left = r.left_gain * factor(r.jitter, conditions_.wheel_jitter_sigma);
  const double right = r.right_gain * factor(r.jitter, conditions_.wheel_jitter_sigma);
  return {r.received.left * left, r.received.right * right};
}

void Disturbances::stop_robots() {
  for (auto& team : robots_) {
    for (Robot& robot : team) robot.received = {};
  }
}

}  // namespace mirocup::match
