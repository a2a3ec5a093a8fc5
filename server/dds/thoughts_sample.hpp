// SPDX-License-Identifier: MIT
//
// The shapes that a team draws in one tick, as a sample of the topic "Thoughts": a team's process
// fills the sample, and the match server reads it.
#pragma once

#include "core/field/team.hpp"
#include "core/match/thought.hpp"
#include "server/dds/entity.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <mirocup.h>
#include <optional>

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

// The thoughts of one team as the match server receives them. The inbox takes samples of the
// process that has the seat, each tick once and in order. It counts and drops all other samples.
// Nothing waits for a sample, and the work for one tick is bounded.

// The receiver of a team's thoughts.
struct ThoughtSink {
  std::function<void(std::uint32_t tick, const match::Thought&)> add;
  std::function<void(std::uint32_t shapes)> leave_out;  // notes how many shapes the team dropped
};

// Numbers of samples; a sample holds what a team drew in one tick.
struct ThoughtCounts {
  std::uint64_t taken = 0;
  std::uint64_t late = 0;       // samples too old, out of order, or repeated
  std::uint64_t foreign = 0;    // from a process without the seat
  std::uint64_t malformed = 0;  // samples that contradict themselves, or for a future tick
};

class ThoughtsInbox {
 public:
  ThoughtsInbox() = default;
  ThoughtsInbox(const ThoughtsInbox&) = delete;
  ThoughtsInbox& operator=(const ThoughtsInbox&) = delete;
  ~ThoughtsInbox();

  // Makes the reader. Before this call take() has no effect.
  Result<void> open(const Entity& participant, const Entity& subscriber);

  // From now on the inbox takes only the thoughts of this process.
  void admit(std::uint64_t nonce, const ParticipantKey& process);

  // Hands over, in order, the shapes that have come since the last call for ticks up to the present
  // tick.
  void take(Team team, std::uint32_t tick, const ThoughtSink& sink);

  const ThoughtCounts& counts() const { return counts_; }

 private:
  bool is_ours(Team team, dds_instance_handle_t writer);
  void sort(std::uint32_t tick, const ThoughtSink& sink);

  Entity topic_, reader_;
  mirocup_v4_Thoughts sample_{};  // DDS allocates its memory once for the largest sample
  std::uint64_t nonce_ = 0;       // 0: no process has the seat
  ParticipantKey process_{};
  dds_instance_handle_t writer_ = 0;     // 0: the process has not written yet
  std::optional<std::uint32_t> newest_;  // tick of the last sample that was taken
  ThoughtCounts counts_;
};

}  // namespace mirocup::dds
