// SPDX-License-Identifier: MIT
//
// The liveliness of a team that plays over the network. The class has only the rule: the caller
// passes each event with its wall time in seconds, so the class needs neither the network nor a
// clock.
//
// An absence begins when the team has been silent for `notice` seconds while a state waited for its
// answer, or when its process has left the network. An absence ends when the team answers again,
// also with a late answer. The absences of a leg are added up.
#pragma once

#include "record/absence.hpp"
#include "server/dds/presence.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace mirocup::dds {

class Liveliness {
 public:
  // `limit`: the longest time of all absences of a leg together, s.
  Liveliness(double notice, double limit) : notice_(notice), limit_(limit) {}

  // To be called when the server begins to wait for the answer to a tick.
  void asked(double now) {
    if (!owes_) silent_since_ = now;
    owes_ = true;
  }

  // To be called when the answer to the present tick, `tick`, has come. Returns true if the team
  // was away.
  bool answered(std::uint32_t tick, double now);

  // To be called in the tick `present` when a late command to `tick` has come. `tick` is newer than
  // the ticks of all earlier commands. Returns true if the team was away.
  bool answered_late(std::uint32_t tick, std::uint32_t present, double now);

  // To be called when the answer to the present tick has come again. A team must answer whenever
  // the server sends the state again.
  void repeated(double now) {
    if (!owes_) silent_since_ = heard_ = now;
  }

  // To be called while no answer to the present tick, `tick`, has come. Returns true if the team is
  // away from this moment on. `has_left`: the team's process has left the network.
  bool silent(std::uint32_t tick, double now, bool has_left);

  bool is_away() const { return away_since_.has_value(); }

  // Returns how long the team has been away in this leg, s, the present absence included.
  double away(double now) const { return away_ + (away_since_ ? now - *away_since_ : 0.0); }

  // Returns the team's presence at this moment, and whether it has lost by absence.
  Standing standing(double now) const;

  // Returns the first absences of the leg, at most 100.
  const std::vector<record::Absence>& absences() const { return absences_; }

 private:
  bool end_absence(std::uint32_t tick, double now);
  std::optional<double> lost_at(double now) const;

  double notice_;
  double limit_;
  bool owes_ = false;                   // a tick waits for the team's answer
  std::optional<double> silent_since_;  // empty before the first tick
  double heard_ = 0.0;
  std::uint32_t next_tick_ = 0;  // the tick after the last answered tick
  std::optional<double> away_since_;
  record::Absence present_;  // the absence that began at away_since_
  double away_ = 0.0;        // sum of the absences that are over, s
  std::optional<double> lost_at_;
  bool is_listed_ = false;
  std::vector<record::Absence> absences_;
};

}  // namespace mirocup::dds
