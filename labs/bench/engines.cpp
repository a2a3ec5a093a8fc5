// SPDX-License-Identifier: MIT
//
// The simulator itself as an engine, and empty lists for the peers that are not installed.
#include "core/simulator/world.hpp"
#include "labs/bench/engine.hpp"

#include <cmath>

namespace mirocup::bench {

namespace {

using simulator::Accuracy;

class Own final : public Engine {
 public:
  Own(const Start& start, Accuracy accuracy)
      : field_(field::make_field(start.league.value_or(RobotLeague::small))),
        world_(start.league ? &field_ : nullptr, start.parameters,
               simulator::tolerances_of(accuracy), static_cast<int>(start.robots.size()), true),
        period_(start.period) {
    for (std::size_t i = 0; i < start.robots.size(); ++i) {
      world_.set_robot(static_cast<int>(i), start.robots[i]);
    }
    world_.set_ball(start.ball);
  }

  void advance(std::span<const simulator::WheelCommand> commands) override {
    world_.advance(commands, period_);
  }
  simulator::BodyState robot(int i) const override { return world_.robot(i); }
  simulator::BallState ball() const override { return world_.ball(); }

 private:
  field::Field field_;
  simulator::World world_;
  double period_;
};

}  // namespace

std::vector<Contender> own_contenders() {
  std::vector<Contender> all;
  for (const Accuracy accuracy : {Accuracy::coarse, Accuracy::standard, Accuracy::reference}) {
    all.push_back(
        {"mirocup", "events in continuous time, double", std::string(to_string(accuracy)), 0,
         [accuracy](const Start& start) { return std::make_unique<Own>(start, accuracy); }});
  }
  return all;
}

Vec2 half_size(const simulator::Parameters& p) {
  if (p.robot_corners.corners == 0) return {p.robot_side / 2.0, p.robot_side / 2.0};
  Vec2 half{0.0, 0.0};
  for (int i = 0; i < p.robot_corners.corners; ++i) {
    const Vec2 corner = p.robot_corners.corner(i);
    half = {std::max(half.x(), std::abs(corner.x())), std::max(half.y(), std::abs(corner.y()))};
  }
  return half;
}

std::vector<WallBox> walls_of(RobotLeague league) {
  constexpr double thick = 0.5;  // m
  const field::Field f = field::make_field(league);
  const double x = f.half_length, y = f.half_width;
  const double back = x + f.goal_depth;
  const double beside = 0.5 * (y - f.goal_half_width);  // half an end wall
  std::vector<WallBox> walls;
  for (const double side : {-1.0, 1.0}) {
    walls.push_back({{0.0, side * (y + thick / 2.0)}, {back, thick / 2.0}});
    walls.push_back({{side * (back + thick / 2.0), 0.0}, {thick / 2.0, f.goal_half_width}});
    for (const double up : {-1.0, 1.0}) {
      walls.push_back({{side * (x + thick / 2.0), up * (y - beside)}, {thick / 2.0, beside}});
      const double across = f.corner_leg / std::sqrt(2.0);  // half of the cut, and how deep it is
      const double out = 0.5 * f.corner_leg - 0.5 * across / std::sqrt(2.0);
      walls.push_back({{side * (x - out), up * (y - out)},
                       {across, 0.5 * across},
                       side * up > 0.0 ? -pi / 4.0 : pi / 4.0});
    }
  }
  return walls;
}

#ifndef MIROCUP_BENCH_BOX2D
std::vector<Contender> box2d_contenders() {
  return {};
}
#endif
#ifndef MIROCUP_BENCH_CHIPMUNK
std::vector<Contender> chipmunk_contenders() {
  return {};
}
#endif
#ifndef MIROCUP_BENCH_ODE
std::vector<Contender> ode_contenders() {
  return {};
}
#endif
#ifndef MIROCUP_BENCH_MUJOCO
std::vector<Contender> mujoco_contenders() {
  return {};
}
#endif

}  // namespace mirocup::bench
