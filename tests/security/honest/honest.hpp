// SPDX-License-Identifier: MIT
//
// The frame of an honest team in C++. A team includes this header once and defines
//
//   void Honest::decide(const Observation& now, Command& command)
//
// which writes the words that honest_test.cpp expects into the log.
#pragma once

#include "mirocup/strategy.hpp"

namespace {

using namespace mirocup::strategy;

class Honest : public Team {
 public:
  using Team::Team;
  void decide(const Observation& now, Command& command) override;
};

}  // namespace

MIROCUP_EXPORT_TEAM(Honest, "honest")
