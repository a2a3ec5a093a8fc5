// SPDX-License-Identifier: MIT
//
// The frame of a small team in C++. A team includes this header once and defines
//
//   void TestTeam::decide(const Observation& now, Command& command)
#pragma once

#include "mirocup/strategy.hpp"

namespace {

using namespace mirocup::strategy;

class TestTeam : public Team {
 public:
  using Team::Team;
  void decide(const Observation& now, Command& command) override;
};

}  // namespace

MIROCUP_EXPORT_TEAM(TestTeam, "test")
