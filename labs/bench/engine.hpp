// SPDX-License-Identifier: MIT
//
// The interface of an engine in the comparison: it plays ticks of a scene under wheel commands.
// Each engine has a file; the laws of wheels and rolling that a peer lacks are in kicks.hpp.
#pragma once

#include "core/field/league.hpp"
#include "core/simulator/model/parameters.hpp"
#include "core/simulator/model/state.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace mirocup::bench {

inline constexpr double tick = 0.033;  // s: the control period

// The state at the start of a scene. Every scene has a ball.
struct Start {
  std::optional<RobotLeague> league;  // of the walls around the field; none: a plane without walls
  simulator::Parameters parameters;
  std::vector<simulator::BodyState> robots;
  simulator::BallState ball;
  double period = tick;  // s: what Engine::advance() plays
};

using Commands = std::vector<simulator::WheelCommand>;  // one for each robot

class Engine {
 public:
  virtual ~Engine() = default;

  // Plays one period of its start.
  virtual void advance(std::span<const simulator::WheelCommand> commands) = 0;

  virtual simulator::BodyState robot(int i) const = 0;
  virtual simulator::BallState ball() const = 0;
};

// An engine with its settings at one point of its scale from fast to exact.
struct Contender {
  std::string engine;
  std::string settings;    // a sentence for readers of the results
  std::string point;       // "standard", "1 ms"
  int steps_per_tick = 0;  // 0: it has no steps
  std::function<std::unique_ptr<Engine>(const Start&)> make;
};

// Steps of 0.5, 1, 2, 4, 8, 17 and 33 ms.
inline constexpr int step_counts[] = {66, 33, 16, 8, 4, 2, 1};
inline constexpr int millisecond_steps = 33;

// Return the contenders of each engine; none for a peer that this program was built without.
std::vector<Contender> own_contenders();
std::vector<Contender> box2d_contenders();
std::vector<Contender> chipmunk_contenders();
std::vector<Contender> ode_contenders();
std::vector<Contender> mujoco_contenders();

// A solid box that stands around the field.
struct WallBox {
  Vec2 centre;
  Vec2 half;           // of its length and width
  double angle = 0.0;  // of its length, rad
};
// Returns the walls that a user of a general engine would build. The corner cuts are small, because
// the axis-aligned box around a large tilted wall would meet every body on the field.
std::vector<WallBox> walls_of(RobotLeague league);

// Returns half the length and half the width of a robot: its outline is a rectangle in every scene.
Vec2 half_size(const simulator::Parameters& parameters);

}  // namespace mirocup::bench
