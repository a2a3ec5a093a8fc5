// SPDX-License-Identifier: MIT
//
// The robot nearest to the ball drives behind it and pushes it towards the opponents' goal, robot 0
// keeps the own goal, and the others wait in their half. A good start for a first team.
#include "mirocup/skills/draw.hpp"
#include "mirocup/strategy.hpp"

namespace {

using namespace mirocup::strategy;

class Chaser : public Team {
 public:
  using Team::Team;

  void decide(const Observation& now, Command& command) override {
    const int chaser = nearest_to_ball(now);
    for (int i = 0; i < now.robots; ++i) {
      command.wheels[i] = i == chaser ? chase(now, i) : wait(now, i);
    }
    avoid_own_goals(setup(), now, command);
    keep_laws(setup(), now, command);
  }

 private:
  // Robot 0 keeps the goal and is never chosen.
  int nearest_to_ball(const Observation& now) const {
    int nearest = 1;
    for (int i = 2; i < now.robots; ++i) {
      if (length(position(now.own[i]) - ball(now)) <
          length(position(now.own[nearest]) - ball(now))) {
        nearest = i;
      }
    }
    return nearest;
  }

  Wheels chase(const Observation& now, int i) {
    const Robot& robot = now.own[i];
    draw_role(setup(), robot, "chases");
    if (must_kick_off(now)) return kick_off(setup(), robot);
    if (is_stuck(now)) return free_ball(setup(), now, robot);

    const Point goal{setup().half_length, 0.0};
    draw_shot(setup(), robot, ball(now), goal);
    const Point towards = unit(goal - ball(now));
    const Point behind = ball(now) - 0.08 * towards;
    const Point from_ball = position(robot) - ball(now);
    const bool is_behind = dot(from_ball, towards) < -0.5 * length(from_ball);
    if (is_behind) {
      const Point through = keep_out(setup(), i, ball(now) + 0.1 * towards);
      return drive_to(setup(), robot, through, 0.8, pace_);
    }
    const Point place = make_way(setup(), now, keep_out(setup(), i, behind));
    return drive_clear(setup(), now, robot, place, 0.0, pace_);
  }

  Wheels wait(const Observation& now, int i) {
    draw_role(setup(), now.own[i], i == 0 ? "keeps" : "waits");
    if (i == 0) return keep_goal(setup(), now, now.own[0]);
    const int row = (i + 1) / 2;
    const double y = 0.2 * (i % 2 == 0 ? 1.0 : -1.0) * row;
    const Point place = keep_out(setup(), i, {-0.4 * setup().half_length, y});
    draw_target(setup(), now.own[i], place);
    return drive_clear(setup(), now, now.own[i], make_way(setup(), now, place));
  }

  double pace_ = 1.3 + 0.3 * random().uniform();  // m/s, of this leg
};

}  // namespace

MIROCUP_EXPORT_TEAM(Chaser, "chaser")
