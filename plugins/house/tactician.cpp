// SPDX-License-Identifier: MIT
//
// A team with roles. The keeper stands in the mouth of its goal. The robot that is soonest behind
// the ball attacks; it drives along a field of directions, turns on the spot where that is quicker,
// and goes through the ball. The others stay between the ball and their goal.
#include "mirocup/skills/attack.hpp"
#include "mirocup/skills/drive.hpp"
#include "mirocup/skills/hold_goal.hpp"
#include "mirocup/skills/laws.hpp"
#include "mirocup/skills/penalty.hpp"
#include "mirocup/skills/roles.hpp"
#include "mirocup/strategy.hpp"

#include <array>

namespace {

using namespace mirocup::strategy;

class Tactician : public Team {
 public:
  using Team::Team;

  void decide(const Observation& now, Command& command) override {
    predict_bodies(now);
    const BallPath path(setup(), moving_ball(now));
    command.wheels[0] = hold_goal(setup(), now, path, soon_[0]);
    draw_role(setup(), now.own[0], "keeps");
    attacker_ = must_kick_off(now) ? 1 : cheapest_robot(now, 1, attacker_, 0.2, [&](int i) {
      return time_behind(path, now.own[i]);
    });
    int rank = 0;
    for (int i = 1; i < now.robots; ++i) {
      command.wheels[i] = i == attacker_ ? attack(now, path, i) : support(now, i, rank++);
    }
    avoid_own_goals(setup(), now, command);
    keep_laws(setup(), now, command);
    spare_keeper(setup(), now, command);
    if (must_take_kick(now, spot_)) {
      command.wheels[1] = now.restart == MIROCUP_PENALTY_KICK
                              ? penalty_.drive(setup(), now, soon_[1])
                              : shoot(setup(), now.own[1], ball(now), aim_);
    }
    asked_ = command;
  }

  // At a penalty or free kick robot 1 takes a run-up.
  void place(const Observation& now, Placement& placement) override {
    if (now.restart != MIROCUP_PENALTY_KICK && now.restart != MIROCUP_FREE_KICK) return;
    if (now.own_restart == 0) return;
    spot_ = ball(now);
    const double bias = 0.1 * (random().uniform() - 0.5);
    aim_ = open_corner(setup(), now, 0.05, bias);
    placement.robots[1] = now.restart == MIROCUP_PENALTY_KICK ? penalty_.stand(setup(), now, bias)
                                                              : run_up(spot_, aim_);
  }

 private:
  // Where the robots will be when the commands of this tick begin.
  void predict_bodies(const Observation& now) {
    for (int i = 0; i < now.robots; ++i) {
      const Wheels asked = now.state == MIROCUP_PLAY ? asked_.wheels[i] : Wheels{};
      soon_[i] = when_commanded(setup(), now.own[i], asked);
    }
  }

  Wheels attack(const Observation& now, const BallPath& path, int i) {
    draw_role(setup(), now.own[i], "attacks");
    if (must_kick_off(now)) return kick_off(setup(), now.own[i]);
    if (is_stuck(now)) return free_ball(setup(), now, soon_[i]);

    const Point meet = intercept(path, now.own[i]).ball.at;
    const Point aim = shooting_aim(setup(), now, ball(now));
    draw_shot(setup(), now.own[i], meet, aim);
    const Shot shot = shot_of(now.own[i], meet, aim);
    if (shot.is_on_line) {
      return drive_quickly(setup(), soon_[i], keep_out(setup(), i, through(shot)), 1.8);
    }
    const Target target = pose_at_ball(setup(), i, shot);
    const Point here = position(soon_[i]) + 0.03 * Point{soon_[i].vx, soon_[i].vy};
    const double course = field_heading(field_, here, target);
    return head_for(setup(), soon_[i], round_others(now, i, soon_[i], target.at, course), 1.8);
  }

  Wheels support(const Observation& now, int i, int rank) {
    const Point place = supporting_place(setup(), now, i, rank);
    draw_role(setup(), now.own[i], "supports");
    draw_target(setup(), now.own[i], place);
    const Point to = place - position(soon_[i]);
    if (length(to) < 0.02) return turn_quickly(setup(), soon_[i], squared(soon_[i].heading));
    const double course = round_others(now, i, soon_[i], place, math::atan2(to.y, to.x));
    return head_for(setup(), soon_[i], course, 1.8, length(to));
  }

  UnivectorField field_;
  Command asked_{};
  std::array<Robot, MIROCUP_MAX_ROBOTS> soon_{};
  Point spot_{10.0, 0.0};  // of the ball at the last kick of this team, m
  Point aim_;              // of that kick, m
  PenaltyTaker penalty_;
  int attacker_ = 1;
};

}  // namespace

MIROCUP_EXPORT_TEAM(Tactician, "tactician")
