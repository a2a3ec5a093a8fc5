// SPDX-License-Identifier: MIT
//
// Sheet "roles": all robots attack, nobody keeps the goal, and nobody knows a law.
#include "mirocup/skills/attack.hpp"
#include "mirocup/strategy.hpp"

using namespace mirocup::strategy;

class Mine : public Team {
 public:
  using Team::Team;

  void decide(const Observation& now, Command& command) override {
    for (int i = 0; i < now.robots; ++i)
      command.wheels[i] = attack_ball(setup(), now, i, open_corner(setup(), now));
  }
};

MIROCUP_EXPORT_TEAM(Mine, "mine")
