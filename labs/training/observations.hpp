// SPDX-License-Identifier: MIT
//
// The observation of a learner: numbers near [-1, 1], in the frame of its team.
//
// `standard`: the ball (x, y, velocity along x and y); then for each robot of the own team, and
// then of the opponents, x, y, cosine and sine of its heading, velocity along x and y, turn; then
// the taker of the last restart, and the time for which the ball has been stuck. If the learner is
// one robot, this robot comes first in its team.
//
// `relative`: values in the frame of the one robot that learns, in which x points forward: the
// ball; the robot's own velocity and turn; the middles of both goals; then the robot's pose and the
// ball's place on the field; the directions of the ball, of the opponents' goal, and of the place
// behind the ball (behind_ball.hpp), and the nearness of the ball and of this place; the
// shot from the ball to the goal; then for each mate and each opponent x, y, velocity, and cosine
// and sine of its heading; restart and stuck ball as in `standard`.
//
// `vss`: the observation of rSoccer's VSS environment: the ball, the own robots with sine before
// cosine, the opponents without heading.
//
// Under conditions with a camera, observations show the camera's view of the field.
#pragma once

#include "labs/training/config.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace mirocup::training {

// One number of an observation.
struct Quantity {
  std::string name;    // "own_0_x"
  std::string unit;    // unit of value * scale: "m", "m/s", "rad/s", "1", "s"
  double scale = 1.0;  // value * scale is in `unit`
  double low = -1.0;   // the values are clamped to these bounds
  double high = 1.0;
};

class Observer {
 public:
  Observer(const Config& config, const field::Field& field);

  const std::vector<Quantity>& quantities() const { return quantities_; }

  // Writes the observation of a learner of a team. `first` is the robot that comes first in the
  // list of its own team; 0 keeps the order.
  void write(const match::Leg& leg, Team team, int first, std::span<float> to) const;

 private:
  void add(const std::string& name, const char* unit, double scale, double bound);
  void add_field(int robots);
  void add_relative(int robots);
  void write_relative(const match::Leg& leg, const std::optional<match::Snapshot>& view, Team team,
                      int self, std::span<float> to) const;

  ObservationKind kind_;
  double goal_x_ = 1.0;  // x of the opponents' goal, m
  double gap_ = 0.0;     // distance from the ball to the middle of a robot that pushes it, m
  double metre_ = 1.0;   // length that is observed as 1, m
  double speed_ = 1.0;   // speed that is observed as 1, m/s
  double turn_ = 1.0;    // angular velocity that is observed as 1, rad/s
  double bound_ = 1.0;   // bound of positions
  double fast_ = 1.0;    // bound of velocities
  std::vector<Quantity> quantities_;
};

}  // namespace mirocup::training
