// SPDX-License-Identifier: MIT
//
// The thoughts of one team as the match server receives them. The inbox takes samples of the
// process that has the seat, each tick once and in order. It counts and drops all other samples.
// Nothing waits for a sample, and the work for one tick is bounded.
#pragma once

#include "server/dds/entity.hpp"
#include "server/dds/thoughts_sample.hpp"

#include <functional>
#include <optional>

namespace mirocup::dds {

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
