// SPDX-License-Identifier: MIT
#include "plugins/host/thoughts_page.hpp"

#include <algorithm>
#include <cstring>

namespace mirocup::plugins {

void copy_thoughts(const ThoughtsPage& from, ThoughtsPage& to) {
  const auto at_most = [](std::uint32_t count, std::size_t most) {
    return std::min(count, static_cast<std::uint32_t>(most));
  };
  to.shapes = at_most(from.shapes, from.shape.size());
  to.numbers = at_most(from.numbers, from.number.size());
  to.text = at_most(from.text, from.texts.size());
  to.left_out = from.left_out;
  std::memcpy(to.shape.data(), from.shape.data(), to.shapes * sizeof(ThoughtsPage::Shape));
  std::memcpy(to.number.data(), from.number.data(), to.numbers * sizeof(double));
  std::memcpy(to.texts.data(), from.texts.data(), to.text);
}

std::optional<match::Thought> ThoughtReader::next() {
  if (shape_ == page_.shapes) return std::nullopt;
  const ThoughtsPage::Shape& shape = page_.shape[shape_++];
  if (!match::is_complete(shape.kind, shape.numbers) || page_.numbers - number_ < shape.numbers ||
      page_.text - text_ < shape.text) {
    return std::nullopt;
  }
  const match::Thought thought{.kind = shape.kind,
                               .colour = shape.colour,
                               .layer = {shape.layer, strnlen(shape.layer, match::max_layer_name)},
                               .numbers = {page_.number.data() + number_, shape.numbers},
                               .text = {page_.texts.data() + text_, shape.text}};
  number_ += shape.numbers;
  text_ += shape.text;
  if (!match::is_finite(thought.numbers)) return std::nullopt;
  return thought;
}

}  // namespace mirocup::plugins
