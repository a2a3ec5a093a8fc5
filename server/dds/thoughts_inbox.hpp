// SPDX-License-Identifier: MIT
//
// What one team draws, as the match server receives it. The samples of the process that has the
// seat count, each tick once and in order; all others are counted and thrown away. Nothing waits
// for a sample, and the work for one tick is bounded.
#pragma once

#include "server/dds/entity.hpp"
#include "server/dds/thoughts_sample.hpp"

#include <functional>
#include <optional>

namespace mirocup::dds {

// Where the thoughts of a team go.
struct ThoughtSink {
  std::function<void(std::uint32_t tick, const match::Thought&)> add;
  std::function<void(std::uint32_t shapes)> leave_out;  // that were left out before they came here
};

// Numbers of samples; a sample holds what a team drew in one tick.
struct ThoughtCounts {
  std::uint64_t taken = 0;
  std::uint64_t late = 0;       // for a tick too long ago, out of order, or once more
  std::uint64_t foreign = 0;    // from another process than the team's
  std::uint64_t malformed = 0;  // contradict themselves, or are for a tick that has not begun
};

class ThoughtsInbox {
 public:
  ThoughtsInbox() = default;
  ThoughtsInbox(const ThoughtsInbox&) = delete;
  ThoughtsInbox& operator=(const ThoughtsInbox&) = delete;
  ~ThoughtsInbox();

  // Makes the reader. Before that take() has no effect.
  Result<void> open(const Entity& participant, const Entity& subscriber);

  // From now on the thoughts of this process count, and no other's.
  void admit(std::uint64_t nonce, const ParticipantKey& process);

  // Hands over the shapes that have come since the last call, in order, for the ticks up to the
  // present one.
  void take(Team team, std::uint32_t tick, const ThoughtSink& sink);

  const ThoughtCounts& counts() const { return counts_; }

 private:
  bool is_ours(Team team, dds_instance_handle_t writer);
  void sort(std::uint32_t tick, const ThoughtSink& sink);

  Entity topic_, reader_;
  mirocup_v4_Thoughts sample_{};  // DDS allocates what it points to, once for the largest sample
  std::uint64_t nonce_ = 0;       // 0: no process has the seat
  ParticipantKey process_{};
  dds_instance_handle_t writer_ = 0;     // 0: it has not written yet
  std::optional<std::uint32_t> newest_;  // tick of the last sample that was taken
  ThoughtCounts counts_;
};

}  // namespace mirocup::dds
