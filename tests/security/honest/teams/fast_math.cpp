// SPDX-License-Identifier: MIT
#include "mirocup/strategy.hpp"

namespace {

using namespace mirocup::strategy;

class Honest : public Team {
 public:
  using Team::Team;
  void decide(const Observation& now, Command& command) override {
    // Built with -Ofast, which switches denormal numbers off for whoever loads it.
    const volatile double tiny = 1e-310;
    command.wheels[0] = {tiny * 1e305 > 1e-6 ? 20.0 : 10.0, 15.0};
    if (now.tick == 0) log("with -Ofast");
  }
};

}  // namespace

MIROCUP_EXPORT_TEAM(Honest, "honest")
