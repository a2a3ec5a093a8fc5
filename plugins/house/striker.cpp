// SPDX-License-Identifier: MIT
//
// A team that plays to score: a keeper, one attacker that meets the ball where it will be and
// shoots past the opponents' keeper, and supporters behind it that take over lost balls.
#include "mirocup/skills/draw.hpp"
#include "mirocup/skills/laws.hpp"
#include "mirocup/skills/shoot.hpp"
#include "mirocup/strategy.hpp"

namespace {

using namespace mirocup::strategy;

class Striker : public Team {
 public:
  using Team::Team;

  void decide(const Observation& now, Command& command) override {
    command.wheels[0] = keep_goal(setup(), now, now.own[0]);
    draw_role(setup(), now.own[0], "keeps");
    // The kicker of a kick-off stands before the ball, and takes it, whoever else is near.
    attacker_ = must_kick_off(now) ? 1 : choose_attacker(now);
    choose_corner(now);
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
  // Returns the robot that can be behind the ball first. The attacker of the last tick has a bonus,
  // so that it changes only for a clearly better one.
  int choose_attacker(const Observation& now) {
    const auto cost = [&](int i) {
      const Point to = meeting_point(setup(), now, now.own[i]) - position(now.own[i]);
      return length(to) + (to.x < 0.0 ? 0.25 : 0.0) - (i == attacker_ ? 0.1 : 0.0);
    };
    int best = 1;
    for (int i = 2; i < now.robots; ++i) {
      if (cost(i) < cost(best)) best = i;
    }
    return best;
  }

  // Chooses the side of the goal that the opponents' keeper leaves open. A random offset, drawn
  // after each restart, decides close cases.
  void choose_corner(const Observation& now) {
    if (now.state != MIROCUP_PLAY) {
      offset_ = 0.06 * (random().uniform() - 0.5);
      return;
    }
    double keeper_y = 0.0;
    double farthest = -10.0;
    for (int i = 0; i < now.robots; ++i) {
      if (now.opponent[i].x > farthest) {
        farthest = now.opponent[i].x;
        keeper_y = now.opponent[i].y;
      }
    }
    const double open = 0.6 * setup().goal_half_width;
    corner_ = (keeper_y + offset_ > 0.0 ? -open : open) + offset_;
  }

  Wheels attack(const Observation& now, int i) {
    const Robot& robot = now.own[i];
    draw_role(setup(), robot, "attacks");
    if (must_kick_off(now)) return kick_off(setup(), robot);
    if (is_stuck(now)) return free_ball(setup(), now, robot);

    const Point meet = meeting_point(setup(), now, robot);
    const Point goal{setup().half_length + 0.05, corner_};
    draw_shot(setup(), robot, meet, goal);
    const Point shot = unit(goal - meet);
    const Point from_ball = position(robot) - meet;
    const double behind = -dot(from_ball, shot);
    const double aside = from_ball.y * shot.x - from_ball.x * shot.y;

    // Behind the ball and nearly on the line of the shot: drive through the ball.
    if (behind > 0.0 && std::abs(aside) < 0.02 + 0.4 * behind && behind < 0.35) {
      const Point through = meet + 0.3 * shot - (2.0 * aside) * Point{-shot.y, shot.x};
      return drive_to(setup(), robot, keep_out(setup(), i, through), 1.7, 1.7);
    }
    // Otherwise drive to a place behind the ball.
    const Point behind_it = keep_out(setup(), i, inside(setup(), meet - 0.11 * shot));
    return drive_clear(setup(), now, robot, make_way(setup(), now, behind_it), 0.3, 1.7);
  }

  // Waits between the ball and the own goal, fanned out, ready to take over, and stays once there.
  Wheels support(const Observation& now, int i, int rank) {
    const double side = now.ball_y > 0.0 ? -1.0 : 1.0;
    const int row = rank / 2;
    const double x = math::max(-0.3 * setup().half_length, now.ball_x - (0.3 + 0.2 * row));
    const double y = 0.4 * now.ball_y + side * (rank % 2 == 0 ? 0.12 : -0.25);
    const Point place = keep_out(setup(), i, inside(setup(), {x, y}));
    draw_role(setup(), now.own[i], "supports");
    draw_target(setup(), now.own[i], place);
    const bool is_there = length(place - position(now.own[i])) < 0.03;
    return drive_clear(setup(), now, now.own[i], is_there ? place : make_way(setup(), now, place));
  }

  Point spot_{10.0, 0.0};  // of the ball at the last kick of this team, m
  Point aim_;              // of that kick, m
  int attacker_ = 1;
  double corner_ = 0.1;
  double offset_ = 0.0;
};

}  // namespace

MIROCUP_EXPORT_TEAM(Striker, "striker")
