// A keeper, one robot that kicks to the opponents' goal, and the others behind the ball.
#include "mirocup/strategy.hpp"

using namespace mirocup::strategy;

class Mine : public Team {
 public:
  using Team::Team;

  void decide(const Observation& now, Command& command) override {
    if (now.tick == 0) log("%d robots a side, seed %llu", now.robots, seed());
    command.wheels[0] = keep_goal(setup(), now, now.own[0]);
    const int kicker = nearest(now);
    for (int i = 1; i < now.robots; ++i) {
      command.wheels[i] = i == kicker ? kick(now, now.own[i]) : wait(now, i);
    }
  }

 private:
  // How far behind the ball the others wait, m. To try another value: --param wait=0.4
  const double wait_ = parameter("wait", 0.45);

  unsigned long long seed() const { return setup().seed; }

  // Returns the robot nearest to the ball; robot 0 stays in the goal and is never chosen.
  static int nearest(const Observation& now) {
    int best = 1;
    for (int i = 2; i < now.robots; ++i) {
      if (length(position(now.own[i]) - ball(now)) < length(position(now.own[best]) - ball(now)))
        best = i;
    }
    return best;
  }

  Wheels kick(const Observation& now, const Robot& robot) const {
    if (must_kick_off(now)) return kick_off(setup(), robot);
    return kick_to(setup(), now, robot, {setup().half_length, 0.0});
  }

  Wheels wait(const Observation& now, int i) const {
    const double side = i % 2 == 0 ? 0.2 : -0.2;
    const Point post = inside(setup(), {now.ball_x - wait_, side});
    return drive_clear(setup(), now, now.own[i], keep_out(setup(), i, post));
  }
};

MIROCUP_EXPORT_TEAM(Mine, "mine")
