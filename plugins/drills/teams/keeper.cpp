// SPDX-License-Identifier: MIT
//
// drill:keeper only defends. Robot 0 keeps the goal; the others stand between the ball and the
// goal, and robot 1 clears a ball that comes near.
#include "drill_team.hpp"

namespace {

using namespace mirocup::drill_teams;

class Keeper : public DrillTeam {
 public:
  using DrillTeam::DrillTeam;

 private:
  Wheels steer(int i, const Robot& robot) override {
    const Point goal{-setup().half_length, 0.0};
    const Point out = unit(ball - goal);
    const bool is_near = length(ball - position(robot)) < 0.25 && ball.x < 0.0;
    if (i == 1 && must_kick_off()) return kick_off(robot);
    if (i == 1 && is_near && robot.x < ball.x) {
      return drive_to(robot, keep_out(ball + 0.1 * out), 1.0);
    }
    if (i == 1 && is_near && is_stuck()) return free_ball(robot);
    // The others form a screen across the line from the ball to the goal.
    const int column = i / 2;
    const int row = i / 3;
    const double aside = 0.09 * (i % 2 == 0 ? 1.0 : -1.0) * column;
    const Point post = goal + (distance_ + 0.07 * row) * out;
    return drive_clear(robot, make_way(keep_out({post.x, post.y + aside})));
  }

  double distance_ =
      0.22 + 0.08 * random().uniform();  // m, from the goal to the screen in this leg
};

}  // namespace

MIROCUP_EXPORT_TEAM(Keeper, "drill:keeper")
