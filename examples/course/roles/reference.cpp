// SPDX-License-Identifier: MIT
//
// Sheet "roles": the reference, 100 on the scale of the sheet.
#include "mirocup/skills/attack.hpp"
#include "mirocup/skills/keeper.hpp"
#include "mirocup/skills/laws.hpp"
#include "mirocup/skills/roles.hpp"
#include "mirocup/strategy.hpp"

using namespace mirocup::strategy;

class Reference : public Team {
 public:
  using Team::Team;

  void decide(const Observation& now, Command& command) override {
    command.wheels[0] = guard_goal(setup(), now, now.own[0]);
    // The robot that can be behind the ball first attacks. It keeps the role unless another robot
    // is clearly faster. At a kick-off robot 1 stands before the ball.
    attacker_ = must_kick_off(now) ? 1 : cheapest_robot(now, 1, attacker_, 0.2, [&](int i) {
      return time_behind(setup(), now, i);
    });
    int rank = 0;
    for (int i = 1; i < now.robots; ++i)
      command.wheels[i] = i == attacker_ ? attack(now, i) : support(now, i, rank++);
    avoid_own_goals(setup(), now, command);
    keep_laws(setup(), now, command);
    spare_keeper(setup(), now, command);
  }

 private:
  Wheels attack(const Observation& now, int i) const {
    if (must_kick_off(now)) return kick_off(setup(), now.own[i]);
    if (is_stuck(now)) return free_ball(setup(), now, now.own[i]);
    return attack_ball(setup(), now, i, shooting_aim(setup(), now, ball(now)));
  }

  // Waits behind the ball, where the robot takes over a lost ball.
  Wheels support(const Observation& now, int i, int rank) const {
    return drive_clear(setup(), now, now.own[i], supporting_place(setup(), now, i, rank));
  }

  int attacker_ = 1;
};

MIROCUP_EXPORT_TEAM(Reference, "reference")
