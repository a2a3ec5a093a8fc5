// SPDX-License-Identifier: MIT
//
// Two teams of this kind break one law after the other. Each kind of restart has a list of acts.
// Both teams count the restarts, so both know the present act and which team offends in it. For the
// middle league.
#include "mirocup/strategy.hpp"

#include <array>

namespace {

using namespace mirocup::strategy;

class Fouls : public Team {
 public:
  using Team::Team;

  void place(const Observation& now, Placement& p) override {
    look(now);
    switch (now.restart) {
      case MIROCUP_KICK_OFF:
        place_kick_off(p);
        break;
      case MIROCUP_FREE_BALL:
        place_free_ball(now, p);
        break;
      case MIROCUP_GOAL_KICK:
        if (mine_ && act_ == 7) place_by_the_wall(p);
        break;
      case MIROCUP_PENALTY_KICK:
        if (!mine_ && lets_in(now.opponent_score, now.own_score)) p.robots[0].y = 0.15;
        break;
      default:
        break;
    }
  }

  void decide(const Observation& now, Command& c) override {
    look(now);
    switch (now.restart) {
      case MIROCUP_KICK_OFF:
        if (mine_) kick_off_badly(now, c);
        break;
      case MIROCUP_FREE_BALL:
        push_or_block(now, c);
        break;
      case MIROCUP_GOAL_KICK:
        if (mine_) {
          crowd_the_own_goal(now, c);
        } else {
          crowd_the_other_goal(now, c);
        }
        break;
      case MIROCUP_PENALTY_KICK:
        if (mine_ && shoots(now)) go(now, c, 1, {1.3, 0.0}, 1.5);
        break;
      default:
        break;
    }
  }

 private:
  // Counts the restarts of each kind.
  void look(const Observation& now) {
    if (now.state == MIROCUP_READY && !was_ready_) act_ = counts_[now.restart]++;
    was_ready_ = now.state == MIROCUP_READY;
    mine_ = now.own_restart != 0;
    is_shoot_out_ = now.phase == MIROCUP_SHOOT_OUT;
  }

  void go(const Observation& now, Command& c, int i, Point to, double pace) {
    c.wheels[i] = drive_to(setup(), now.own[i], to, pace, pace);
  }
  void stop_at(const Observation& now, Command& c, int i, Point to) {
    c.wheels[i] = drive_to(setup(), now.own[i], to, 0.0, 1.0);
  }

  // The first penalty passes the keeper and the second is shot at it. After that only the team that
  // is behind scores, so a knock-out match ends level. Blue wins its shoot-out.
  bool lets_in(int kickers_score, int keepers_score) const {
    return act_ == 0 || kickers_score < keepers_score || is_shoot_out_;
  }
  bool shoots(const Observation& now) const {
    if (is_shoot_out_) return setup().team == MIROCUP_BLUE;
    return act_ == 1 || lets_in(now.own_score, now.opponent_score);
  }

  // Places the robots away from the ball's path; the last one is requested off the field.
  void place_kick_off(Placement& p) {
    const double y[] = {0.0, 0.0, 0.7, -0.7, 0.5};
    for (int i = mine_ ? 2 : 1; i < 5; ++i)
      p.robots[i] = {-0.5 - 0.05 * i, i == 1 ? -0.5 : y[i], 0.0};
    if (mine_ && act_ == 0) {
      p.robots[1] = {-0.09, 0.0, 0.0};
      p.robots[4] = {-3.0, 0.0, 0.0};
    }
    if (mine_ && act_ == 2) p.robots[0] = {-0.9, -0.5, 0.0};
  }

  // Acts: the ball goes forwards; too late; into the own goal; then a legal kick-off.
  void kick_off_badly(const Observation& now, Command& c) {
    if (act_ == 0) go(now, c, 1, {0.5, 0.0}, 1.0);
    if (act_ == 2) go(now, c, 1, {-1.3, 0.0}, 1.3);
    if (act_ >= 3 && must_kick_off(now)) c.wheels[1] = kick_off(setup(), now.own[1]);
  }

  // Two robots face each other on the side of the field without the ball.
  void place_free_ball(const Observation& now, Placement& p) {
    const double aside = now.ball_y > 0.0 ? -1.0 : 1.0;
    const bool block = act_ >= 2;
    if (mine_) {
      if (block) p.robots[0] = {-1.0, 0.1 * aside, 0.0};
      if (!block) p.robots[2] = {0.1, 0.5 * aside, 0.0};
    } else {
      const Robot& other = now.opponent[block ? 0 : 2];
      p.robots[2] = {other.x - (block ? 0.081 : 0.4), other.y, 0.0};
    }
  }

  // Acts: the defenders push; the attackers push; an attacker blocks the keeper.
  void push_or_block(const Observation& now, Command& c) {
    if (act_ < 2 && mine_ == (act_ == 0)) {
      go(now, c, 2, {now.own[2].x + 0.5, now.own[2].y}, 1.5);
    } else if (act_ >= 2 && mine_) {
      c.wheels[0] = wheels_for(setup(), 0.07, 0.0);
    }
  }

  // Places the ball beside the post and the keeper beside the ball.
  static void place_by_the_wall(Placement& p) {
    p.ball_x = -1.03;
    p.ball_y = 0.235;
    p.robots[0] = {-1.03, 0.173, 0.0};
  }

  void crowd_the_other_goal(const Observation& now, Command& c) {
    switch (act_) {
      case 0:  // two in the goal area
        stop_at(now, c, 1, {1.03, -0.17});
        stop_at(now, c, 2, {1.03, 0.17});
        break;
      case 1:  // four in the penalty area
        stop_at(now, c, 1, {0.85, -0.13});
        stop_at(now, c, 2, {0.85, 0.13});
        stop_at(now, c, 3, {0.85, 0.0});
        stop_at(now, c, 4, {0.85, -0.3});
        break;
      case 2:  // a robot drives at the keeper, past the ball
        go(now, c, 1, now.own[1].x < 0.9 ? Point{1.0, -0.25} : Point{1.06, 0.0}, 1.0);
        break;
      case 3:  // a robot only stays near the ball
        stop_at(now, c, 1, {0.885, 0.0});
        break;
      case 7:  // at the ball by the wall
        if (now.own[2].x < 1.01) {
          stop_at(now, c, 2, {1.03, -0.42});
        } else {
          c.wheels[2] = drive_to(setup(), now.own[2], {1.03, -0.296}, 0.0, 0.15);
        }
        break;
      default:
        break;
    }
  }

  void crowd_the_own_goal(const Observation& now, Command& c) {
    if (act_ == 4) stop_at(now, c, 1, {-1.03, 0.17});
    if (act_ == 5) {
      stop_at(now, c, 1, {-0.85, 0.3});
      stop_at(now, c, 2, {-0.85, -0.3});
      stop_at(now, c, 3, {-0.85, 0.15});
    }
  }

  std::array<int, 6> counts_{};
  int act_ = 0;
  bool was_ready_ = false;
  bool mine_ = false;
  bool is_shoot_out_ = false;
};

}  // namespace

MIROCUP_EXPORT_TEAM(Fouls, "fouls")
