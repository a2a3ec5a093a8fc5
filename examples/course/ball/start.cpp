// SPDX-License-Identifier: MIT
//
// Sheet "ball": robot 1 drives to the ball, and pushes it to wherever it happens to go.
#include "mirocup/strategy.hpp"

using namespace mirocup::strategy;

class Mine : public Team {
 public:
  using Team::Team;

  void decide(const Observation& now, Command& command) override {
    command.wheels[1] = drive_to(setup(), now.own[1], ball(now), 0.0, 0.35);
  }
};

MIROCUP_EXPORT_TEAM(Mine, "mine")
