// SPDX-License-Identifier: MIT
#include "mirocup/strategy.hpp"

#include <Eigen/Dense>

namespace {

using namespace mirocup::strategy;

class Honest : public Team {
 public:
  using Team::Team;
  void decide(const Observation& now, Command& command) override {
    Eigen::MatrixXd a = Eigen::MatrixXd::Identity(60, 60);
    a(0, 1) = now.ball_x;
    const Eigen::VectorXd b = a.colPivHouseholderQr().solve(Eigen::VectorXd::Ones(60));
    command.wheels[0] = {20.0 * b(59), 10.0 * b(58)};
    if (now.tick == 0) log("with Eigen");
  }
};

}  // namespace

MIROCUP_EXPORT_TEAM(Honest, "honest")
