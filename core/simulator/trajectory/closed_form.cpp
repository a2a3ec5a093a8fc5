// SPDX-License-Identifier: MIT
#include "core/simulator/trajectory/closed_form.hpp"

#include "core/base/math.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator::trajectory {

namespace {

// Nodes and weights of Gauss-Legendre quadrature on [0, 1]. For a turn by a rad the error is below
// 2e-23 a^17 of the path.
constexpr std::array<double, gauss_nodes> node{
    0.019855071751231884, 0.10166676129318664, 0.2372337950418355, 0.4082826787521751,
    0.591717321247825,    0.7627662049581645,  0.8983332387068134, 0.9801449282487681};
constexpr std::array<double, gauss_nodes> weight{
    0.05061426814518813, 0.11119051722668724, 0.15685332293894363, 0.181341891689181,
    0.181341891689181,   0.15685332293894363, 0.11119051722668724, 0.05061426814518813};

// Returns sine and cosine of the turns at the nodes, by the cheap function if all are small.
SinCosOfSome headings(const std::array<double, gauss_nodes>& angle) {
  double farthest_turn = 0.0;
  for (const double a : angle) farthest_turn = std::max(farthest_turn, std::abs(a));
  if (farthest_turn <= small_angle) return sincos_of_small(angle);
  SinCosOfSome all;
  for (int i = 0; i < gauss_nodes; ++i) {
    const SinCos heading = sincos(angle[i]);
    all.sin[i] = heading.sin;
    all.cos[i] = heading.cos;
  }
  return all;
}

}  // namespace

MotorDecay motor_decay(double time_constant, double span) {
  MotorDecay decay;
  decay.span = span;
  decay.time_constant = time_constant;
  const double rate = span / time_constant;
  for (int i = 0; i < gauss_nodes; ++i) decay.at_node[i] = exp(-rate * node[i]);
  decay.at_end = exp(-rate);
  return decay;
}

bool has_closed_form(const Parameters& p, const BodyState& robot, const DriveReference& drive,
                     double span) {
  if (!drive.wheels_on_ground ||
      std::abs(robot.twist.left) > settings::differential_drive.slip_round_off)
    return false;
  const double turn = fastest(robot.twist.omega, drive.omega);
  if (span * (turn + drive.rate()) > settings::closed_form.max_angle) return false;
  return fastest(robot.twist.forward, drive.forward) * turn < p.grip * gravity;
}

BodyState closed_form_state(const BodyState& robot, const DriveReference& drive,
                            const DriveDecay& decay) {
  const double span = decay.forward.span;
  const double speed_to_lose = robot.twist.forward - drive.forward;
  const double turn_to_lose = robot.twist.omega - drive.omega;
  const double turned_by_motor = turn_to_lose * decay.turn.time_constant;
  std::array<double, gauss_nodes> angle;
  for (int i = 0; i < gauss_nodes; ++i) {
    angle[i] = drive.omega * (span * node[i]) + turned_by_motor * (1.0 - decay.turn.at_node[i]);
  }
  const SinCosOfSome heading = headings(angle);
  double along = 0.0;
  double across = 0.0;
  for (int i = 0; i < gauss_nodes; ++i) {
    const double distance = weight[i] * (drive.forward + speed_to_lose * decay.forward.at_node[i]);
    along += distance * heading.cos[i];
    across += distance * heading.sin[i];
  }
  const double turned = drive.omega * span + turned_by_motor * (1.0 - decay.turn.at_end);
  return {robot.position + robot.heading.to_world({along * span, across * span}),
          robot.heading.turned(sincos(turned)),
          {drive.forward + speed_to_lose * decay.forward.at_end, 0.0,
           drive.omega + turn_to_lose * decay.turn.at_end}};
}

BodyState closed_form_state(const BodyState& robot, const DriveReference& drive, double span) {
  const MotorDecay forward = motor_decay(drive.forward_lag, span);
  if (drive.turn_lag == drive.forward_lag)
    return closed_form_state(robot, drive, {forward, forward});
  return closed_form_state(robot, drive, {forward, motor_decay(drive.turn_lag, span)});
}

}  // namespace mirocup::simulator::trajectory
