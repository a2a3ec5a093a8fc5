// SPDX-License-Identifier: MIT
//
// drill:crowd runs at the ball: the robot nearest to it drives behind it and pushes it towards the
// opponents' goal, robot 0 keeps the goal, the others wait in their half.
#include "drill_team.hpp"

namespace {

using namespace mirocup::drill_teams;

class Crowd : public DrillTeam {
 public:
  using DrillTeam::DrillTeam;

 private:
  void before_steering() override {
    nearest_ = 1;
    for (int i = 2; i < now->robots; ++i) {
      if (length(position(now->own[i]) - ball) < length(position(now->own[nearest_]) - ball))
        nearest_ = i;
    }
  }

  Wheels steer(int i, const Robot& robot) override {
    if (i != nearest_) {
      const int row = (i + 1) / 2;
      const double y = 0.2 * (i % 2 == 0 ? 1.0 : -1.0) * row;
      return drive_clear(robot, make_way(keep_out({-0.4 * setup().half_length, y})));
    }
    if (must_kick_off()) return kick_off(robot);
    if (is_stuck()) return free_ball(robot);
    const Point towards = unit(Point{setup().half_length, 0.0} - ball);
    const Point from_ball = position(robot) - ball;
    if (dot(from_ball, towards) < -0.5 * length(from_ball)) {
      return drive_to(robot, keep_out(ball + 0.1 * towards), 0.8, pace_);
    }
    return drive_clear(robot, make_way(keep_out(ball - 0.08 * towards)), 0.0, pace_);
  }

  int nearest_ = 1;                               // to the ball, besides the keeper
  double pace_ = 1.3 + 0.3 * random().uniform();  // m/s, of this leg
};

}  // namespace

MIROCUP_EXPORT_TEAM(Crowd, "drill:crowd")
