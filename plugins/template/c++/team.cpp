// A keeper, one robot that kicks to the opponents' goal, and the others behind the ball.
#include "mirocup/skills/attack.hpp"
#include "mirocup/strategy.hpp"

using namespace mirocup::strategy;

class Mine : public Team {
 public:
  using Team::Team;
  void decide(const Observation& now, Command& command) override {
    command.wheels[0] = keep_goal(setup(), now, now.own[0]);  // you always attack +x
    command.wheels[1] = must_kick_off(now) ? kick_off(setup(), now.own[1])
                        : is_stuck(now)    ? free_ball(setup(), now, now.own[1])
                                        : attack_ball(setup(), now, 1, open_corner(setup(), now));
    for (int i = 2; i < now.robots; ++i) {  // the others wait behind the ball
      const Point post{now.ball_x - wait_ - 0.2 * (i - 2), -0.5 * now.ball_y};
      const Point legal = make_way(setup(), now, keep_out(setup(), i, inside(setup(), post)));
      command.wheels[i] = drive_clear(setup(), now, now.own[i], legal);
    }
    avoid_own_goals(setup(), now, command);
    keep_laws(setup(), now, command);  // no pushing
  }

 private:
  const double wait_ = parameter("wait", 0.45);  // how far behind, m
};

MIROCUP_EXPORT_TEAM(Mine, "@NAME@")
