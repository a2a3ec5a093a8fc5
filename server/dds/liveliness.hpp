// SPDX-License-Identifier: MIT
//
// Is a team that plays over the network there? The rule alone, without the network: what happened
// at which wall time (s) goes in, what follows comes out.
//
// A team that leaves a question without an answer for `notice` seconds, or whose process has left
// the network, is away until it answers again. The time that it is away is added up over the leg.
#pragma once

#include "server/pace/absence.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace mirocup::dds {

class Liveliness {
 public:
  explicit Liveliness(double notice) : notice_(notice) {}

  // A tick waits for its answer from now on.
  void asked(double now) {
    if (!asked_at_) asked_at_ = now;
  }

  // The answer to `tick` is there. True if the team was away.
  bool answered(std::uint32_t tick, double now);

  // No answer to `tick` yet. True if the team is found to be away at this moment.
  bool silent(std::uint32_t tick, double now, bool has_left);

  bool is_away() const { return away_since_.has_value(); }

  // Seconds of this leg, this absence with them.
  double away(double now) const { return away_ + (away_since_ ? now - *away_since_ : 0.0); }

  // The first ones; the list is bounded.
  const std::vector<pace::Absence>& absences() const { return absences_; }

 private:
  double notice_;
  std::optional<double> asked_at_;  // of the first tick without an answer
  std::uint32_t next_tick_ = 0;     // after the last one that was answered
  std::optional<double> away_since_;
  double away_ = 0.0;  // in absences that are over
  bool is_listed_ = false;
  std::vector<pace::Absence> absences_;
};

}  // namespace mirocup::dds
