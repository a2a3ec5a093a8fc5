// SPDX-License-Identifier: MIT
//
// A recorded team as a controller: it gives the answers that were recorded, then what ended the
// leg.
#pragma once

#include "core/replay/recording.hpp"

namespace mirocup::replay {

// The recording outlives it.
class Recorded final : public match::Controller {
 public:
  Recorded(const Recording& recording, Team team) : recording_(recording), team_(team) {}

  void post(const match::Observation& observation) override { tick_ = observation.tick; }
  match::Answer collect() override;

 private:
  match::Command command(std::uint32_t tick) const;

  const Recording& recording_;
  Team team_;
  std::uint32_t tick_ = 0;
};

}  // namespace mirocup::replay
