// SPDX-License-Identifier: MIT
//
// Prediction with the match's own simulator. Four questions, from cheap to expensive:
//
//   the ball alone     rolled() in skills/ball_path.hpp: closed form with walls; needs no library
//   a robot alone      robot_after(): closed form; knows neither walls nor other bodies
//   the last tick      driven_wheels(), Tracker: which wheel speeds a robot drove
//   everything         Simulator: all bodies, walls and contacts, bit for bit as in a match
//
//   Scene scene = scene_of(now);
//   Command mine = tracker.in_flight();            // the answer that is driven in this tick
//   for (int tick = 0; tick < 20; ++tick) {
//     simulator.advance(scene, mine, tracker.opponents());
//     mine = ...;                                  // what you would answer to `scene`
//   }
//
// Scenes are plain structs: copy one to try several futures from it. An advance() allocates
// nothing. A simulator has no referee: after a goal the ball lies in the goal, and play continues.
//
// How exact it is
//   From a scene that a simulator made, or from robots and a ball that were just put down, a
//   simulator computes the next ticks of a match under `exact` conditions to the last bit, if you
//   give it the commands of both teams. An observation lacks the last tick's contact memory and the
//   opponents' commands: the memory matters little, the commands most. Under `hall` each wheel
//   turns up to 4 % faster or slower than commanded. Under `camera` an observation is late and its
//   velocities are noisy: a prediction is only as good as the observation.
//
// Link mirocup::predict (CMake), or libmirocup_predict.a. Frames and units are those of strategy.h.
#pragma once

#include "mirocup/skills/ball_path.hpp"
#include "mirocup/strategy.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>

namespace mirocup::strategy {

// A robot in the form of the simulator. The heading is a unit vector, and the velocities are in the
// robot's own frame: `left` differs from 0 only while the wheels slide sideways.
struct Body {
  Point at;                     // m
  double cos = 1.0, sin = 0.0;  // of the heading
  double forward = 0.0;         // m/s
  double left = 0.0;            // m/s
  double turn = 0.0;            // rad/s
};

// Convert a robot between the observed form and the form of the simulator. A speed to the left that
// comes only from rounding becomes 0.
Body body_of(const Robot& robot);
Robot robot_of(const Body& body);

// The simulator's memory of contacts from one tick to the next. It is opaque; while few bodies
// touch, a copy takes little time.
class ContactMemory {
 public:
  ContactMemory() = default;
  ContactMemory(const ContactMemory& from) { *this = from; }
  ContactMemory& operator=(const ContactMemory& from) {
    used_ = from.used_;
    if (used_ > 0) std::memmove(bytes_, from.bytes_, used_);
    return *this;
  }

 private:
  friend class Simulator;
  std::size_t used_ = 0;  // 0: nothing is remembered
  alignas(8) std::byte bytes_[14336];
};

// All bodies at one instant, in your own frame. If you move bodies by hand, set `memory` to {}, and
// do not let bodies overlap: the simulator would push them apart.
struct Scene {
  int robots = 0;  // number of each team's robots
  MovingBall ball;
  std::array<Body, MIROCUP_MAX_ROBOTS> own;
  std::array<Body, MIROCUP_MAX_ROBOTS> opponent;
  ContactMemory memory;
};

// Returns the observed scene.
Scene scene_of(const Observation& now);

// Write the scene into an observation, so that functions that decide from an observation can also
// decide in a predicted scene. The first function gives your team's view; the second gives the
// opponents' view in their own frame, with own and opponent exchanged and all bodies turned by 180
// degrees. Scores, clocks and counts of `now` stay unchanged.
void show(const Scene& scene, Observation& now);
void show_to_opponents(const Scene& scene, Observation& now);

// Returns the wheel speeds that a robot drives if commanded `wheels`: rounded and clamped.
Wheels sent_wheels(const Setup& setup, Wheels wheels);

// Returns a robot after `seconds` under these wheel speeds if it meets neither walls nor bodies.
// The result is exact for any time. The function takes ten times longer for sliding wheels than for
// rolling wheels.
Body robot_after(const Setup& setup, const Body& robot, Wheels wheels, double seconds);

// Returns the wheel speeds, rad/s, that took a robot from one observation to the next: the motors'
// equation, solved for their targets. The result is wrong if the robot hit something or slid in
// that tick.
Wheels driven_wheels(const Setup& setup, const Robot& before, const Robot& after);

// Remembers from tick to tick which commands the robots drive, for predictions. Call saw() at the
// start of decide() and sent() at its end.
class Tracker {
 public:
  explicit Tracker(const Setup& setup) : setup_(setup) {}

  void saw(const Observation& now);
  void sent(const Command& command) { sent_ = command; }

  // Returns your answer to the observation before the present one. That answer is driven in the
  // tick that begins with the present observation; your next answer is driven one tick later.
  const Command& in_flight() const { return sent_; }

  // Returns the wheel speeds of the opponents in the last tick, which are the best guess for this
  // tick. All speeds are zero after a restart.
  const Command& opponents() const { return opponents_; }

 private:
  Setup setup_;
  Command sent_{};
  Command opponents_{};
  Observation before_{};
  bool has_before_ = false;
};

// The precision of contacts. `match` gives the same bits as a match. `coarse` takes half the time
// of `match` in play at 3 a side, and a quarter at 11. If a robot kicks the ball in ten predicted
// ticks, `coarse` puts the ball 2 mm off in the median, and at least 3 cm off in one case of ten.
enum class Precision { match, coarse };

// The events of a predicted tick. Bit i of a set is robot i.
struct PredictedTick {
  std::uint32_t own_touched_ball = 0;
  std::uint32_t opponent_touched_ball = 0;
  // Set of opponents touched by each own robot.
  std::array<std::uint32_t, MIROCUP_MAX_ROBOTS> touched_opponent{};
  // The robot that touched the ball last: i + 1 for own robot i, -i - 1 for opponent i, 0 for none.
  int last_touch = 0;
  // Number of collisions and changes of motion; measures the cost of a tick without a clock.
  int events = 0;
};

// The physics of a match in the frame of your team. A Simulator allocates some hundred KiB when it
// is constructed. Only one thread may use it at a time.
class Simulator {
 public:
  explicit Simulator(const Setup& setup, Precision precision = Precision::match);
  ~Simulator();
  Simulator(const Simulator&) = delete;
  Simulator& operator=(const Simulator&) = delete;

  // Plays one tick, of control_period, and changes the scene in place. Commands are rounded and
  // clamped as in a match; opponent.wheels[j] drives scene.opponent[j]. If `ticks` is above 1, the
  // commands hold for this number of ticks, which are played as one long tick: this takes less time
  // than single ticks, and gives the same result up to rounding, but not the same bits.
  PredictedTick advance(Scene& scene, const Command& own, const Command& opponent, int ticks = 1);

 private:
  struct Physics;
  std::unique_ptr<Physics> physics_;
};

}  // namespace mirocup::strategy
