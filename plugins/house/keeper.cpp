// SPDX-License-Identifier: MIT
//
// A team that only defends. Robot 0 holds the mouth of the goal; the others stand between the ball
// and the goal, and robot 1 clears a ball that comes near.
#include "mirocup/skills/draw.hpp"
#include "mirocup/skills/drive.hpp"
#include "mirocup/skills/hold_goal.hpp"
#include "mirocup/strategy.hpp"

namespace {

using namespace mirocup::strategy;

class Keeper : public Team {
 public:
  using Team::Team;

  void decide(const Observation& now, Command& command) override {
    command.wheels[0] = keep(now);
    draw_role(setup(), now.own[0], "keeps");
    const Point goal{-setup().half_length, 0.0};
    const Point out = unit(ball(now) - goal);
    for (int i = 1; i < now.robots; ++i) {
      const Robot& robot = now.own[i];
      const bool is_near = length(ball(now) - position(robot)) < 0.25 && now.ball_x < 0.0;
      if (i == 1 && must_kick_off(now)) {
        draw_role(setup(), robot, "kicks off");
        command.wheels[i] = kick_off(setup(), robot);
      } else if (i == 1 && is_near && robot.x < now.ball_x) {
        draw_role(setup(), robot, "clears");
        draw_shot(setup(), robot, ball(now), ball(now) + 0.3 * out);
        command.wheels[i] =
            drive_to(setup(), robot, keep_out(setup(), i, ball(now) + 0.1 * out), 1.0);
      } else if (i == 1 && is_near && is_stuck(now)) {
        draw_role(setup(), robot, "frees the ball");
        command.wheels[i] = free_ball(setup(), now, robot);
      } else {
        // The others form a screen across the line from the ball to the goal.
        const int column = i / 2;
        const int row = i / 3;
        const double aside = 0.09 * (i % 2 == 0 ? 1.0 : -1.0) * column;
        const Point post = goal + (distance_ + 0.07 * row) * out;
        double y = post.y + aside;
        // On its straight way home, the taker of a kick-off would knock the ball into the goal.
        if (i == 1 && rolls_home(now)) y = now.ball_y + (robot.y < now.ball_y ? -0.25 : 0.25);
        const Point place = keep_out(setup(), i, {post.x, y});
        draw_role(setup(), robot, "screens");
        draw_target(setup(), robot, place);
        command.wheels[i] = drive_clear(setup(), now, robot, make_way(setup(), now, place));
      }
    }
    avoid_own_goals(setup(), now, command);
    keep_laws(setup(), now, command);
  }

 private:
  // Says whether the ball of an own kick-off rolls before robot 1, which has taken it.
  static bool rolls_home(const Observation& now) {
    const Robot& taker = now.own[1];
    return now.restart == MIROCUP_KICK_OFF && now.own_restart != 0 && now.ball_x < 0.0 &&
           taker.x > now.ball_x && length(ball(now) - position(taker)) < 0.3;
  }

  Wheels keep(const Observation& now) {
    const Wheels asked = now.state == MIROCUP_PLAY ? asked_ : Wheels{};
    const Robot soon = when_commanded(setup(), now.own[0], asked);
    asked_ = lies_before(now, soon)
                 ? drive_to(setup(), soon, ball(now) + 0.2 * unit(ball(now) - position(soon)), 1.0)
                 : hold_goal(setup(), now, BallPath(setup(), moving_ball(now)), soon);
    return asked_;
  }

  // Says whether the ball lies in the goal area, whose arc is 0.05 m deep: there the keeper has to
  // play it before long.
  bool lies_before(const Observation& now, const Robot& keeper) const {
    return length(ball_velocity(now)) < 0.1 && now.ball_x > keeper.x + 0.03 &&
           now.ball_x < -setup().half_length + setup().goal_area_depth + 0.07 &&
           std::abs(now.ball_y) < setup().goal_area_half_width;
  }

  Wheels asked_{};  // of the keeper, in the last tick
  double distance_ =
      0.22 + 0.08 * random().uniform();  // m, from the goal to the screen in this leg
};

}  // namespace

MIROCUP_EXPORT_TEAM(Keeper, "keeper")
