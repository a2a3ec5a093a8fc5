// SPDX-License-Identifier: MIT
//
// Plays a recording again, tick by tick, without the teams: the recorded commands go in, and
// simulator and referee do the rest.
//
// Threads: none of its own. The recording belongs to the caller and outlives its playback.
#pragma once

#include "core/replay/recording.hpp"

#include <optional>
#include <string>

namespace mirocup::replay {

// The first difference between a recording and its playback.
struct Divergence {
  std::uint32_t tick = 0;
  std::string what;  // a sentence with both values
};

class Playback {
 public:
  explicit Playback(const Recording& recording);

  // The leg as it stands: before the first tick, or after the last tick that advance() played.
  const match::Leg& leg() const { return leg_; }

  // Plays the next tick and compares its hash. Returns false when there is no next tick, or if the
  // hashes differ.
  bool advance();

  // The first difference found, if any: a tick's hash, or the number of ticks.
  const std::optional<Divergence>& divergence() const { return divergence_; }

 private:
  bool differs(std::uint32_t tick, std::string what);

  const Recording& recording_;
  match::Leg leg_;
  std::optional<Divergence> divergence_;
};

}  // namespace mirocup::replay
