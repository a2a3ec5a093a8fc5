// SPDX-License-Identifier: MIT
//
// A team that drives along fields of directions. In each tick it asks of each robot how soon it can
// be behind the ball; the soonest attacks. It follows a univector field to the place where it meets
// the ball, comes in with the heading of the shot, and drives through. The others stay between the
// ball and the own goal, where a strong team has four of five robots, and fan out in larger
// leagues. The keeper covers the angle of the shot and clears to the side.
#include "mirocup/skills/intercept.hpp"
#include "mirocup/skills/keeper.hpp"
#include "mirocup/skills/laws.hpp"
#include "mirocup/skills/shoot.hpp"
#include "mirocup/skills/univector_field.hpp"
#include "mirocup/strategy.hpp"

#include <array>

namespace {

using namespace mirocup::strategy;

class Navigator : public Team {
 public:
  using Team::Team;

  void decide(const Observation& now, Command& command) override {
    command.wheels[0] = guard_goal(setup(), now, now.own[0]);
    choose_attacker(now);
    int rank = 0;
    for (int i = 1; i < now.robots; ++i) {
      command.wheels[i] = i == attacker_ ? attack(now, i) : support(now, i, rank++);
    }
    avoid_own_goals(setup(), now, command);
    keep_laws(setup(), now, command);
    spare_keeper(setup(), now, command);
    if (must_take_kick(now, spot_)) {
      command.wheels[1] = shoot(setup(), now.own[1], ball(now), aim_);
    }
  }

  // At a penalty or free kick robot 1 takes a run-up to the corner that the keeper leaves open.
  void place(const Observation& now, Placement& placement) override {
    if (now.restart != MIROCUP_PENALTY_KICK && now.restart != MIROCUP_FREE_KICK) return;
    if (now.own_restart == 0) return;
    spot_ = ball(now);
    aim_ = open_corner(setup(), now, 0.05, 0.1 * (random().uniform() - 0.5));
    placement.robots[1] = run_up(spot_, aim_);
  }

 private:
  // The robot that is soonest behind the ball. A robot before the ball has to drive round it, and
  // the attacker of the last tick keeps its role unless another one is clearly sooner.
  // The kicker of a kick-off stands before the ball, and takes it.
  void choose_attacker(const Observation& now) {
    if (must_kick_off(now)) {
      attacker_ = 1;
      return;
    }
    const auto cost = [&](int i) {
      const Interception meet = intercept(setup(), now, now.own[i]);
      const bool is_before = now.own[i].x > meet.ball.at.x - 0.03;
      return meet.seconds + (is_before ? 0.35 : 0.0) - (i == attacker_ ? 0.2 : 0.0);
    };
    int best = 1;
    double least = cost(1);
    for (int i = 2; i < now.robots; ++i) {
      const double c = cost(i);
      if (c < least) {
        best = i;
        least = c;
      }
    }
    attacker_ = best;
  }

  Wheels attack(const Observation& now, int i) {
    const Robot& robot = now.own[i];
    if (must_kick_off(now)) return kick_off(setup(), robot);
    if (is_stuck(now)) return free_ball(setup(), now, robot);

    const Point aim = aim_from(now, ball(now));
    const MovingBall meet = intercept(setup(), now, robot).ball;
    const Point along = unit(aim - meet.at);
    const Point from_ball = position(robot) - meet.at;
    const double behind = -dot(from_ball, along);
    const double aside = along.x * from_ball.y - along.y * from_ball.x;
    if (behind > 0.0 && behind < 0.4 && std::abs(aside) < 0.02 + 0.35 * behind) {
      const Point through = meet.at + 0.3 * along - (2.0 * aside) * Point{-along.y, along.x};
      return drive_to(setup(), robot, keep_out(setup(), i, through), 1.8, 1.8);
    }
    const Point place = keep_out(setup(), i, inside(setup(), meet.at, 0.04));
    const Target target{place, std::atan2(along.y, along.x)};
    return drive(now, i, target);
  }

  // Where to shoot from a place: the open corner of the goal, or along a wall.
  Point aim_from(const Observation& now, Point from) const {
    const double wall = setup().half_width - 0.05;
    const bool is_at_wall = std::abs(from.y) > wall && from.x < setup().half_length - 0.25;
    if (is_at_wall) return {from.x + 1.0, from.y};
    const bool is_at_own_end = from.x < -setup().half_length + 0.06;
    if (is_at_own_end) return {from.x + 0.2, from.y + (from.y > 0.0 ? 1.0 : -1.0)};
    return open_corner(setup(), now, 0.06);
  }

  // Stays between the ball and the own goal; the second of these covers the other side.
  Wheels support(const Observation& now, int i, int rank) {
    const double side = now.ball_y > 0.0 ? -1.0 : 1.0;
    const int row = rank / 2;
    const double back = 0.3 + 0.25 * row;
    const double x = std::max(-0.75 * setup().half_length, now.ball_x - back);
    const double part = (x + setup().half_length) / (now.ball_x + setup().half_length + 0.01);
    const double spread = rank % 2 == 0 ? 0.0 : side * (0.3 + 0.1 * row);
    const double y = std::clamp(part, 0.0, 1.0) * now.ball_y + spread;
    const Point place = keep_out(setup(), i, inside(setup(), {x, y}));
    return drive_clear(setup(), now, now.own[i], make_way(setup(), now, place));
  }

  // Follows the field to a target, round all other robots.
  Wheels drive(const Observation& now, int i, const Target& target) {
    std::array<Obstacle, 2 * MIROCUP_MAX_ROBOTS> obstacles;
    std::size_t count = 0;
    const auto add = [&](const Robot& other) {
      if (length(position(other) - target.at) < 0.1) return;  // it is at the ball itself
      obstacles[count++] = {position(other), {other.vx, other.vy}};
    };
    for (int j = 0; j < now.robots; ++j) {
      add(now.opponent[j]);
      if (j != i) add(now.own[j]);
    }
    return follow_field(setup(), now.own[i], target, 1.8, {obstacles.data(), count});
  }

  Point spot_{10.0, 0.0};  // of the ball at the last kick of this team, m
  Point aim_;              // of that kick, m
  int attacker_ = 1;
};

}  // namespace

MIROCUP_EXPORT_TEAM(Navigator, "navigator")
