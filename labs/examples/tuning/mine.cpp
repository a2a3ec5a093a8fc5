// SPDX-License-Identifier: MIT
//
// README's first team with five numbers to tune. With the defaults it plays as README's does, move
// for move. labs/docs/tuning.md says how its numbers are tuned.
#include "mirocup/skills/attack.hpp"
#include "mirocup/strategy.hpp"

using namespace mirocup::strategy;

class Mine : public Team {
 public:
  using Team::Team;
  void decide(const Observation& now, Command& command) override {
    command.wheels[0] = keep_goal(setup(), now, now.own[0]);
    attacker_ = choose_attacker(now);
    command.wheels[attacker_] = attack(now, now.own[attacker_]);
    int rank = 0;
    for (int i = 1; i < now.robots; ++i) {  // the others wait behind the ball
      if (i == attacker_) continue;
      const Point post{now.ball_x - wait_ - 0.2 * rank++, side_ * now.ball_y};
      const Point legal = make_way(setup(), now, keep_out(setup(), i, inside(setup(), post)));
      command.wheels[i] = drive_clear(setup(), now, now.own[i], legal);
    }
    avoid_own_goals(setup(), now, command);
    keep_laws(setup(), now, command);  // no pushing
  }

 private:
  // The attacker stays the attacker until another robot is nearer to the place behind the ball.
  int choose_attacker(const Observation& now) const {
    const Point behind = ball(now) - Point{0.1, 0.0};
    int best = attacker_;
    double least = length(position(now.own[attacker_]) - behind) - swap_;
    for (int i = 1; i < now.robots; ++i) {
      const double way = length(position(now.own[i]) - behind);
      if (i == attacker_ || way >= least) continue;
      best = i;
      least = way;
    }
    return best;
  }

  Wheels attack(const Observation& now, const Robot& robot) const {
    if (must_kick_off(now)) return kick_off(setup(), robot);
    if (is_stuck(now)) return free_ball(setup(), now, robot);
    const Point corner = open_corner(setup(), now, corner_);
    return attack_ball(setup(), now, attacker_, corner, {.speed = speed_});
  }

  int attacker_ = 1;
  const double wait_ = parameter("wait", 0.45);      // how far behind the ball the others are, m
  const double side_ = parameter("side", -0.5);      // and how far aside, in shares of the ball's y
  const double speed_ = parameter("speed", 1.8);     // of the attacker, m/s
  const double corner_ = parameter("corner", 0.05);  // from a post to where it aims, m
  const double swap_ = parameter("swap", 9.0);       // how much nearer another attacker must be, m
};

MIROCUP_EXPORT_TEAM(Mine, "mine")
