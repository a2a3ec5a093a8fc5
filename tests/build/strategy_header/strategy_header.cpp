// SPDX-License-Identifier: MIT
//
// strategy.hpp compiles alone, with every warning, and log() with every kind of call that teams
// make. With WRONG_FORMAT it must not compile: a value has another type than its format says.
#include "mirocup/strategy.hpp"

namespace {

class Nothing : public mirocup::strategy::Team {
 public:
  using Team::Team;
  void decide(const mirocup::strategy::Observation& now, mirocup::strategy::Command&) override {
    log("100 %");
    const char* text = "a text that is no literal";
    log(text);
    log("%s: tick %u, ball at %.2f", text, now.tick, now.ball_x);
#ifdef WRONG_FORMAT
    log("%d", now.ball_x);
#endif
  }
};

}  // namespace

MIROCUP_EXPORT_TEAM(Nothing, "nothing")
