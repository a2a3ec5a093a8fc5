// SPDX-License-Identifier: MIT
#include "server/dds/thoughts_sample.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace mirocup::dds {
namespace {

using match::Thought;
using match::ThoughtKind;

constexpr double line[] = {1.0, 2.0, 3.0, 4.0};

const mirocup_v4_Thoughts& sample_of(ThoughtsSample& drawn) {
  return drawn.stamped(Team::yellow, 7, 9);
}

// Catches a shape that gets the numbers or the words of another one.
TEST(ThoughtsSample, GivesBackWhatWasDrawn) {
  ThoughtsSample drawn;
  EXPECT_TRUE(drawn.is_empty());
  drawn.add({ThoughtKind::text, 5, "a layer whose name is longer than 31 bytes", {line, 2}, "one"});
  drawn.add({ThoughtKind::line, 0x01020304, "l", line, ""});
  drawn.add({ThoughtKind::text, 6, "", {line + 1, 2}, "three"});
  const mirocup_v4_Thoughts& sample = sample_of(drawn);
  EXPECT_EQ(sample.tick, 7U);
  EXPECT_EQ(sample.nonce, 9U);
  EXPECT_EQ(sample.team, mirocup_v4_COLOUR_YELLOW);
  EXPECT_STREQ(sample.text, "onethree");
  std::vector<std::string> seen;
  EXPECT_TRUE(for_each_thought(sample, [&](const Thought& thought) {
    seen.push_back(std::string(thought.layer) + '/' + std::string(thought.text) + '/' +
                   std::to_string(thought.numbers.size()) + '/' +
                   std::to_string(static_cast<int>(thought.numbers[0])));
  }));
  EXPECT_EQ(seen, (std::vector<std::string>{"a layer whose name is longer th/one/2/1", "l//4/1",
                                            "/three/2/2"}));
  drawn.clear();
  EXPECT_TRUE(drawn.is_empty());
  EXPECT_STREQ(sample_of(drawn).text, "");
}

// Catches a sample that runs over, and one that grows with shapes that are none.
TEST(ThoughtsSample, CountsWhatItDoesNotTake) {
  ThoughtsSample drawn;
  drawn.add({ThoughtKind::text, 0, "t", {line, 2}, std::string(match::max_thought_text + 1, 'x')});
  drawn.add({ThoughtKind::line, 0, "l", {line, 3}, ""});
  const double endless[] = {0.0, 0.0, INFINITY, 0.0};
  drawn.add({ThoughtKind::line, 0, "l", endless, ""});
  EXPECT_EQ(sample_of(drawn).shapes._length, 0U);
  EXPECT_EQ(sample_of(drawn).left_out, 3U);
  EXPECT_FALSE(drawn.is_empty());
  const std::vector<double> corners(2 * match::max_polygon_corners);
  for (int i = 0; i < 300; ++i) drawn.add({ThoughtKind::polygon, 0, "p", corners, ""});
  EXPECT_EQ(sample_of(drawn).shapes._length, match::max_thought_numbers / corners.size());
  for (int i = 0; i < 300; ++i) drawn.add({ThoughtKind::text, 0, "t", {line, 2}, "x"});
  EXPECT_LE(sample_of(drawn).numbers._length, match::max_thought_numbers);
  EXPECT_TRUE(for_each_thought(sample_of(drawn), [](const Thought&) {}));
}

// Catches a server that reads beyond the end of what a stranger sent.
TEST(ThoughtsSample, OfAStrangerIsNotTrusted) {
  const auto is_taken = [](auto spoil) {
    ThoughtsSample drawn;
    drawn.add({ThoughtKind::line, 0, "l", line, ""});
    drawn.add({ThoughtKind::text, 0, "t", {line, 2}, "words"});
    mirocup_v4_Thoughts sample = sample_of(drawn);
    spoil(sample);
    int calls = 0;
    const bool taken = for_each_thought(sample, [&](const Thought&) { ++calls; });
    EXPECT_EQ(calls, taken ? 2 : 0);
    return taken;
  };
  EXPECT_TRUE(is_taken([](auto&) {}));
  EXPECT_FALSE(is_taken([](auto& s) { s.shapes._length = match::max_thoughts + 1; }));
  EXPECT_FALSE(is_taken([](auto& s) { s.numbers._length = match::max_thought_numbers + 1; }));
  EXPECT_FALSE(is_taken([](auto& s) { s.numbers._length = 5; }));
  EXPECT_FALSE(is_taken([](auto& s) { s.text[3] = '\0'; }));
  EXPECT_FALSE(is_taken([](auto& s) { s.shapes._buffer[0].kind = mirocup_v4_SHAPE_POLYGON; }));
  EXPECT_FALSE(is_taken([](auto& s) { s.shapes._buffer[0].text = 1; }));
  EXPECT_FALSE(is_taken([](auto& s) { s.numbers._buffer[5] = NAN; }));
}

}  // namespace
}  // namespace mirocup::dds
