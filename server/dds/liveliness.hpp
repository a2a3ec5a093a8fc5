// SPDX-License-Identifier: MIT
//
// The liveliness of a team that plays over the network. The class is the rule alone: it is told
// what happened and when, in seconds of wall time, and knows neither the network nor a clock.
//
// A team is away from when it has left a tick unanswered for `notice` seconds, or its process has
// left the network, until it answers a tick again. Its absences are added up over the leg.
#pragma once

#include "server/pace/absence.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace mirocup::dds {

class Liveliness {
 public:
  explicit Liveliness(double notice) : notice_(notice) {}

  // Tells that a tick waits for its answer from now on.
  void asked(double now) {
    if (!asked_at_) asked_at_ = now;
  }

  // Tells that the answer to `tick` has come. Returns true if the team was away.
  bool answered(std::uint32_t tick, double now);

  // Tells that there is no answer to `tick` yet. Returns true if the team is away from this moment
  // on. `has_left`: its process has left the network.
  bool silent(std::uint32_t tick, double now, bool has_left);

  bool is_away() const { return away_since_.has_value(); }

  // Returns how long the team has been away in this leg, s, the present absence included.
  double away(double now) const { return away_ + (away_since_ ? now - *away_since_ : 0.0); }

  // Returns the first absences of the leg, at most 100.
  const std::vector<pace::Absence>& absences() const { return absences_; }

 private:
  double notice_;
  std::optional<double> asked_at_;  // since when a tick has waited for its answer
  std::uint32_t next_tick_ = 0;     // the one after the last answered tick
  std::optional<double> away_since_;
  double away_ = 0.0;  // sum of the absences that are over, s
  bool is_listed_ = false;
  std::vector<pace::Absence> absences_;
};

}  // namespace mirocup::dds
