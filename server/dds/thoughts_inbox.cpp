// SPDX-License-Identifier: MIT
#include "server/dds/thoughts_inbox.hpp"

#include "server/dds/inbox.hpp"

namespace mirocup::dds {

ThoughtsInbox::~ThoughtsInbox() {
  dds_sample_free(&sample_, &mirocup_v4_Thoughts_desc, DDS_FREE_CONTENTS);
}

Result<void> ThoughtsInbox::open(const Entity& participant, const Entity& subscriber) {
  MIROCUP_TRY(topic_, make_topic(participant, mirocup_v4_Thoughts_desc, idl::thoughts));
  MIROCUP_TRY(reader_, make_reader(subscriber, topic_, idl::thoughts));
  return {};
}

void ThoughtsInbox::admit(std::uint64_t nonce, const ParticipantKey& process) {
  nonce_ = nonce;
  process_ = process;
  writer_ = 0;
}

void ThoughtsInbox::take(Team team, std::uint32_t tick, const ThoughtSink& sink) {
  if (reader_.get() == 0) return;
  // A process that writes faster than this loop reads cannot keep the match here.
  for (std::int32_t i = 0; i < idl::thoughts.read_depth; ++i) {
    dds_instance_handle_t writer = 0;
    if (!dds::take(reader_, sample_, &writer)) return;
    if (is_ours(team, writer)) {
      sort(tick, sink);
    } else {
      ++counts_.foreign;
    }
  }
}

// As for commands: an ordinary program can read the nonce of another, but not write as it.
bool ThoughtsInbox::is_ours(Team team, dds_instance_handle_t writer) {
  if (nonce_ == 0 || sample_.nonce != nonce_ || static_cast<int>(sample_.team) != index_of(team)) {
    return false;
  }
  if (writer_ == 0 && participant_of(reader_, writer) == process_) writer_ = writer;
  return writer == writer_;
}

void ThoughtsInbox::sort(std::uint32_t tick, const ThoughtSink& sink) {
  const std::uint32_t own = sample_.tick;
  if (own > tick) {
    ++counts_.malformed;
    return;
  }
  if (tick - own > max_late_ticks || (newest_ && own <= *newest_)) {
    ++counts_.late;
    return;
  }
  const auto add = [&](const match::Thought& thought) { sink.add(own, thought); };
  if (!for_each_thought(sample_, add)) {
    ++counts_.malformed;
    return;
  }
  sink.leave_out(sample_.left_out);
  newest_ = own;
  ++counts_.taken;
}

}  // namespace mirocup::dds
