// SPDX-License-Identifier: MIT
//
// The shapes that a team draws in one tick, as a sample of the topic "Thoughts": a team's process
// fills the sample, and the match server reads it.
#pragma once

#include "core/field/team.hpp"
#include "core/match/thought.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <mirocup.h>

namespace mirocup::dds {

// A sample with room for all shapes of a tick. The object cannot be copied or moved, because the
// sample points into it.
class ThoughtsSample {
 public:
  ThoughtsSample();
  ThoughtsSample(const ThoughtsSample&) = delete;
  ThoughtsSample& operator=(const ThoughtsSample&) = delete;

  // Adds a shape. A shape that is incomplete or not finite, or for which the sample has no room, is
  // dropped and counted. The name of a layer is cut to max_layer_name bytes.
  void add(const match::Thought& thought);

  bool is_empty() const { return sample_.shapes._length == 0 && sample_.left_out == 0; }
  void clear();

  // Returns the sample, to be written as the thoughts of this team's process in a tick. The sample
  // is valid until the next call.
  const mirocup_v4_Thoughts& stamped(Team team, std::uint32_t tick, std::uint64_t nonce);

 private:
  mirocup_v4_Thoughts sample_{};
  std::array<mirocup_v4_Shape, match::max_thoughts> shapes_;
  std::array<double, match::max_thought_numbers> numbers_;
  std::size_t text_ = 0;  // used bytes of the sample's text
};

// Calls `use` with each shape of a sample that a stranger may have written. If the sample
// contradicts itself, returns false and does not call `use`.
bool for_each_thought(const mirocup_v4_Thoughts& sample,
                      const std::function<void(const match::Thought&)>& use);

}  // namespace mirocup::dds
