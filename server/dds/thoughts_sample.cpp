// SPDX-License-Identifier: MIT
#include "server/dds/thoughts_sample.hpp"

#include "server/dds/convert.hpp"
#include "server/dds/inbox.hpp"

#include <algorithm>
#include <cstring>
#include <optional>

namespace mirocup::dds {

using match::ThoughtKind;

// The numbers of the IDL are those of the core, whose limits both ways of drawing have.
static_assert(mirocup_v4_MAX_SHAPES == match::max_thoughts &&
              mirocup_v4_MAX_SHAPE_NUMBERS == match::max_thought_numbers &&
              mirocup_v4_MAX_SHAPE_TEXT == match::max_thought_text &&
              sizeof(mirocup_v4_Shape{}.layer) == match::max_layer_name + 1);
static_assert(enum_names<ThoughtKind>.size() == 4 &&
              static_cast<int>(ThoughtKind::line) == mirocup_v4_SHAPE_LINE &&
              static_cast<int>(ThoughtKind::circle) == mirocup_v4_SHAPE_CIRCLE &&
              static_cast<int>(ThoughtKind::polygon) == mirocup_v4_SHAPE_POLYGON &&
              static_cast<int>(ThoughtKind::text) == mirocup_v4_SHAPE_TEXT);

ThoughtsSample::ThoughtsSample() {
  sample_.shapes = {._maximum = mirocup_v4_MAX_SHAPES,
                    ._length = 0,
                    ._buffer = shapes_.data(),
                    ._release = false};
  sample_.numbers = {._maximum = mirocup_v4_MAX_SHAPE_NUMBERS,
                     ._length = 0,
                     ._buffer = numbers_.data(),
                     ._release = false};
}

void ThoughtsSample::clear() {
  sample_.shapes._length = 0;
  sample_.numbers._length = 0;
  sample_.left_out = 0;
  text_ = 0;
}

void ThoughtsSample::add(const match::Thought& thought) {
  const std::uint32_t used = sample_.numbers._length;
  const bool has_room = sample_.shapes._length < shapes_.size() &&
                        used + thought.numbers.size() <= numbers_.size() &&
                        text_ + thought.text.size() <= match::max_thought_text;
  if (!has_room || !match::is_complete(thought.kind, thought.numbers.size()) ||
      !match::is_finite(thought.numbers)) {
    ++sample_.left_out;
    return;
  }
  mirocup_v4_Shape& shape = shapes_[sample_.shapes._length++];
  shape.kind = static_cast<std::uint8_t>(thought.kind);
  shape.numbers = static_cast<std::uint8_t>(thought.numbers.size());
  shape.text = static_cast<std::uint16_t>(thought.text.size());
  shape.colour = thought.colour;
  copy_text(shape.layer, thought.layer);
  std::copy(thought.numbers.begin(), thought.numbers.end(), numbers_.begin() + used);
  sample_.numbers._length = used + shape.numbers;
  text_ += thought.text.copy(sample_.text + text_, match::max_thought_text - text_);
}

const mirocup_v4_Thoughts& ThoughtsSample::stamped(Team team, std::uint32_t tick,
                                                   std::uint64_t nonce) {
  sample_.nonce = nonce;
  sample_.tick = tick;
  sample_.team = static_cast<std::uint8_t>(team);
  sample_.text[text_] = '\0';
  return sample_;
}

namespace {

// Goes through the shapes of a sample, and ends where the next one cannot be.
class ShapeReader {
 public:
  explicit ShapeReader(const mirocup_v4_Thoughts& sample)
      : sample_(sample), bytes_(strnlen(sample.text, sizeof sample.text)) {}

  bool is_at_end() const { return shape_ == sample_.shapes._length; }

  std::optional<match::Thought> next() {
    const mirocup_v4_Shape& shape = sample_.shapes._buffer[shape_++];
    const auto kind = static_cast<ThoughtKind>(shape.kind);
    if (!match::is_complete(kind, shape.numbers) ||
        sample_.numbers._length - number_ < shape.numbers || bytes_ - text_ < shape.text ||
        (kind != ThoughtKind::text && shape.text > 0)) {
      return std::nullopt;
    }
    const match::Thought thought{.kind = kind,
                                 .colour = shape.colour,
                                 .layer = {shape.layer, strnlen(shape.layer, sizeof shape.layer)},
                                 .numbers = {sample_.numbers._buffer + number_, shape.numbers},
                                 .text = {sample_.text + text_, shape.text}};
    number_ += shape.numbers;
    text_ += shape.text;
    if (!match::is_finite(thought.numbers)) return std::nullopt;
    return thought;
  }

 private:
  const mirocup_v4_Thoughts& sample_;
  std::size_t bytes_;  // of its text
  std::uint32_t shape_ = 0;
  std::size_t number_ = 0;
  std::size_t text_ = 0;
};

}  // namespace

bool for_each_thought(const mirocup_v4_Thoughts& sample,
                      const std::function<void(const match::Thought&)>& use) {
  if (sample.shapes._length > match::max_thoughts ||
      sample.numbers._length > match::max_thought_numbers) {
    return false;
  }
  for (ShapeReader trial(sample); !trial.is_at_end();) {
    if (!trial.next()) return false;
  }
  for (ShapeReader shapes(sample); !shapes.is_at_end();) use(*shapes.next());
  return true;
}

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
