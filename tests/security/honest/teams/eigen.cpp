// SPDX-License-Identifier: MIT
#include "tests/security/honest/honest.hpp"

#include <Eigen/Dense>

void Honest::decide(const Observation& now, Command& command) {
  Eigen::MatrixXd a = Eigen::MatrixXd::Identity(60, 60);
  a(0, 1) = now.ball_x;
  const Eigen::VectorXd b = a.colPivHouseholderQr().solve(Eigen::VectorXd::Ones(60));
  command.wheels[0] = {20.0 * b(59), 10.0 * b(58)};
  if (now.tick == 0) log("with Eigen");
}
