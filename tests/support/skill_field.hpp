// SPDX-License-Identifier: MIT
//
// A field on which the skills of plugins/include/mirocup/skills are tried: the simulator of a match
// under the commands of a skill, without referee, conditions and delay. Robot 0 is the one that
// plays. The frame is that of the field, which is also its team's.
#pragma once

#include "core/field/field.hpp"
#include "core/match/observation.hpp"
#include "core/referee/rules.hpp"
#include "core/simulator/world.hpp"
#include "mirocup/strategy.hpp"
#include "plugins/abi/convert.hpp"

#include <array>
#include <utility>

namespace mirocup::test_support {

class SkillField {
 public:
  explicit SkillField(RobotLeague league = RobotLeague::small)
      : field_(field::make_field(league)),
        world_(&field_, parameters_, simulator::Tolerances{}, 1, true) {
    const referee::Rules rules;
    const match::Briefing briefing{.field = &field_,
                                   .parameters = &parameters_,
                                   .rules = &rules,
                                   .control_period = 0.033,
                                   .team = Team::blue,
                                   .seed = 1};
    setup_ = abi::to_setup(briefing);
  }

  const strategy::Setup& setup() const { return setup_; }

  // At rest, and nothing is asked of it.
  void put_robot(strategy::Point at, double heading) {
    asked_ = {};
    world_.set_robot(0, {{at.x, at.y}, Heading::from_angle(heading), {}});
  }
  void put_ball(strategy::Point at, strategy::Point velocity = {}) {
    world_.set_ball({{at.x, at.y}, {velocity.x, velocity.y}});
  }

  strategy::Robot robot() const {
    const simulator::BodyState state = world_.robot(0);
    const Vec2 velocity = state.velocity();
    return {.x = state.position.x(),
            .y = state.position.y(),
            .heading = state.heading.angle(),
            .vx = velocity.x(),
            .vy = velocity.y(),
            .turn = state.twist.omega};
  }
  strategy::Point ball() const { return {world_.ball().position.x(), world_.ball().position.y()}; }
  strategy::Point ball_velocity() const {
    return {world_.ball().velocity.x(), world_.ball().velocity.y()};
  }

  // Returns what a team of one robot sees; the opponents are `far` away.
  strategy::Observation observation() const {
    strategy::Observation now{};
    now.size = sizeof now;
    now.state = MIROCUP_PLAY;
    now.robots = 1;
    now.ball_x = ball().x;
    now.ball_y = ball().y;
    now.ball_vx = ball_velocity().x;
    now.ball_vy = ball_velocity().y;
    now.own[0] = robot();
    now.opponent[0].x = setup_.half_length - 0.05;
    return now;
  }

  void tick(strategy::Wheels wheels) {
    const std::array<simulator::WheelCommand, 1> command{
        simulator::WheelSpeeds{.left = wheels.left, .right = wheels.right}};
    world_.advance(command, setup_.control_period);
  }

  // With the delay of a match: drives what was asked for in the tick before, and asks for this.
  void tick_later(strategy::Wheels wheels) { tick(std::exchange(asked_, wheels)); }
  strategy::Wheels asked() const { return asked_; }

 private:
  field::Field field_;
  simulator::Parameters parameters_;
  simulator::World world_;
  strategy::Setup setup_{};
  strategy::Wheels asked_{};
};

}  // namespace mirocup::test_support
