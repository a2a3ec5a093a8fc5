// SPDX-License-Identifier: MIT
//
// A team whose wheels turn at its parameter "speed", rad/s, which it also logs.
#include "mirocup/strategy.hpp"

using namespace mirocup::strategy;

class Tuned : public Team {
 public:
  explicit Tuned(const Setup& setup) : Team(setup) {
    log("team %d turns at %g", static_cast<int>(setup.team), speed_);
  }
  void decide(const Observation& now, Command& command) override {
    for (int i = 0; i < now.robots; ++i) command.wheels[i] = {-speed_, speed_};
  }

 private:
  const double speed_ = parameter("speed", 3.0);
};

MIROCUP_EXPORT_TEAM(Tuned, "tuned")
