// SPDX-License-Identifier: MIT
//
// A team that drives to the ball and draws each kind of shape in each tick. Its parameter "shapes"
// is a number of further lines.
#include "mirocup/strategy.hpp"

using namespace mirocup::strategy;

class Draws : public Team {
 public:
  using Team::Team;

  void decide(const Observation& now, Command& command) override {
    for (int i = 0; i < now.robots; ++i) {
      command.wheels[i] = drive_to(setup(), now.own[i], ball(now));
      draw_line("plan", 0xff8000ff, position(now.own[i]), ball(now));
    }
    draw_circle("target", 0xffffffff, ball(now), 0.03);
    draw_polygon("zone", 0xff000080, {{0.2, 0.2}, {0.4, 0.2}, {0.3, 0.4}});
    draw_text("words", 0xffffffff, {0.0, 0.5}, "the \"ball\" <is> \x1b[2J here");
    draw_value("distance", length(ball(now) - position(now.own[1])));
    draw_line("nowhere", 0, {0.0, 0.0}, {pi / 0.0, 0.0});
    for (int i = 0; i < shapes_; ++i)
      draw_line("more", 0x00ff00ff, {0.0, 0.01 * i}, {1.0, 0.01 * i});
  }

 private:
  const int shapes_ = static_cast<int>(parameter("shapes", 0.0));
};

MIROCUP_EXPORT_TEAM(Draws, "draws")
