// SPDX-License-Identifier: MIT
#include "mirocup/strategy.hpp"

namespace {

class Nothing : public mirocup::strategy::Team {
 public:
  using Team::Team;
  void decide(const mirocup::strategy::Observation&, mirocup::strategy::Command&) override {}
};

}  // namespace

MIROCUP_EXPORT_TEAM(Nothing, "nothing")
