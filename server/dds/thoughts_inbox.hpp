// SPDX-License-Identifier: MIT
//
// The thoughts of one team as the match server receives them. It takes samples of the process that
// has the seat, each tick once and in order; it counts and drops all others. Nothing waits for a
// sample, and the work for one tick is bounded.
#pragma once

#include "server/dds/entity.hpp"
#include "server/dds/thoughts_sample.hpp"

#include <functional>
#include <optional>

namespace mirocup::dds {

// The receiver of a team's thoughts.
struct ThoughtSink {
  std::function<void(std::uint32_t tick, const match::Thought&)> add;
  std::function<void(std::uint32_t shapes)> leave_out;  // notes shapes that the team dropped
};

// Numbers of samples; a sample holds what a team drew in one tick.
struct ThoughtCounts {
  std::uint64_t taken = 0;
  std::uint64_t late = 0;       // for a tick too long ago, out of order, or repeated
  std::uint64_t foreign = 0;    // from a process that is not the team's
  std::uint64_t malformed = 0;  // contradict themselves, or are for a tick that has not begun
};

class ThoughtsInbox {
 public:
  ThoughtsInbox() = default;
  ThoughtsInbox(const ThoughtsInbox&) = delete;
  ThoughtsInbox& operator=(const ThoughtsInbox&) = delete;
  ~ThoughtsInbox();

  // Makes the reader. Without it take() has no effect.
  Result<void> open(const Entity& participant, const Entity& subscriber);

  // From now on only the thoughts of this process count.
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
