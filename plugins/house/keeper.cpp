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
        const Point place = keep_out(setup(), i, {post.x, post.y + aside});
        draw_role(setup(), robot, "screens");
        draw_target(setup(), robot, place);
        command.wheels[i] = drive_clear(setup(), now, robot, make_way(setup(), now, place));
      }
    }
    avoid_own_goals(setup(), now, command);
    keep_laws(setup(), now, command);
  }

 private:
  Wheels keep(const Observation& now) {
    const Wheels asked = now.state == MIROCUP_PLAY ? asked_ : Wheels{};
    const Robot soon = when_commanded(setup(), now.own[0], asked);
    asked_ = hold_goal(setup(), now, BallPath(setup(), moving_ball(now)), soon);
    return asked_;
  }

  Wheels asked_{};  // of the keeper, in the last tick
  double distance_ =
      0.22 + 0.08 * random().uniform();  // m, from the goal to the screen in this leg
};

}  // namespace

MIROCUP_EXPORT_TEAM(Keeper, "keeper")
