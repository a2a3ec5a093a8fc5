// SPDX-License-Identifier: MIT
//
// A team that drives along fields of directions. In each tick it asks of each robot how soon it can
// be behind the ball; the soonest attacks. It follows a univector field to the place where it meets
// the ball, comes in with the heading of the shot, and drives through. The others stay between the
// ball and the own goal, where a strong team has four of five robots, and fan out in larger
// leagues. The keeper stands in the mouth of its goal and clears to the side.
#include "mirocup/skills/attack.hpp"
#include "mirocup/skills/hold_goal.hpp"
#include "mirocup/skills/laws.hpp"
#include "mirocup/skills/roles.hpp"
#include "mirocup/strategy.hpp"

namespace {

using namespace mirocup::strategy;

class Navigator : public Team {
 public:
  using Team::Team;

  void decide(const Observation& now, Command& command) override {
    command.wheels[0] = hold_goal(setup(), now, BallPath(setup(), moving_ball(now)), now.own[0]);
    draw_role(setup(), now.own[0], "keeps");
    // The kicker of a kick-off stands before the ball, and takes it.
    attacker_ = must_kick_off(now) ? 1 : cheapest_robot(now, 1, attacker_, 0.2, [&](int i) {
      return time_behind(setup(), now, i);
    });
    int rank = 0;
    for (int i = 1; i < now.robots; ++i) {
      command.wheels[i] = i == attacker_ ? attack(now, i) : support(now, i, rank++);
    }
    avoid_own_goals(setup(), now, command);
    keep_laws(setup(), now, command);
    spare_keeper(setup(), now, command);
    if (must_take_kick(now, spot_)) {
      command.wheels[1] = shoot(setup(), now.own[1], ball(now), aim_);
    }
  }

  // At a penalty or free kick robot 1 takes a run-up to the corner that the keeper leaves open.
  void place(const Observation& now, Placement& placement) override {
    if (now.restart != MIROCUP_PENALTY_KICK && now.restart != MIROCUP_FREE_KICK) return;
    if (now.own_restart == 0) return;
    spot_ = ball(now);
    aim_ = open_corner(setup(), now, 0.05, 0.1 * (random().uniform() - 0.5));
    placement.robots[1] = run_up(spot_, aim_);
  }

 private:
  Wheels attack(const Observation& now, int i) {
    draw_role(setup(), now.own[i], "attacks");
    if (must_kick_off(now)) return kick_off(setup(), now.own[i]);
    if (is_stuck(now)) return free_ball(setup(), now, now.own[i]);
    return attack_ball(setup(), now, i, shooting_aim(setup(), now, ball(now)));
  }

  Wheels support(const Observation& now, int i, int rank) {
    const Point place = supporting_place(setup(), now, i, rank);
    draw_role(setup(), now.own[i], "supports");
    draw_target(setup(), now.own[i], place);
    return drive_clear(setup(), now, now.own[i], place);
  }

  Point spot_{10.0, 0.0};  // of the ball at the last kick of this team, m
  Point aim_;              // of that kick, m
  int attacker_ = 1;
};

}  // namespace

MIROCUP_EXPORT_TEAM(Navigator, "navigator")
