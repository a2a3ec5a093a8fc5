// SPDX-License-Identifier: MIT
#include "record/thoughts_file.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>
#include <zstd.h>

namespace mirocup::record {
namespace {

match::Thought line_with(std::span<const double> numbers) {
  return {.kind = match::ThoughtKind::line,
          .colour = 0xff,
          .layer = "l",
          .numbers = numbers,
          .text = {}};
}

TEST(ThoughtsFile, HasOneLineForEachShape) {
  ThoughtsWriter writer;
  const double numbers[] = {-0.00004, 0.00006, -1.25, 1e9};
  writer.add(7, line_with(numbers));
  EXPECT_EQ(
      unpacked_thoughts(writer.packed(), "x").value(),
      "{\"tick\":7,\"layer\":\"l\",\"colour\":\"#000000ff\",\"line\":[0,0.0001,-1.25,1000]}\n");
}

// Catches a part of the shape before that is kept where the next one has another, and a polygon
// without its brackets.
TEST(ThoughtsFile, HasWhatEachShapeHas) {
  ThoughtsWriter writer;
  const double circle[] = {0.5, -12.0625, 0.1};
  const double corners[] = {0.0, 0.1, 0.2, 0.3, -0.00995, 100.0};
  const auto add = [&](std::uint32_t tick, match::ThoughtKind kind, std::uint32_t colour,
                       std::string_view layer, std::span<const double> numbers) {
    writer.add(tick, {kind, colour, layer, numbers, {}});
  };
  add(1, match::ThoughtKind::circle, 0xff0000ff, "a", circle);
  add(1, match::ThoughtKind::circle, 0xff0000ff, "a", circle);
  add(1, match::ThoughtKind::circle, 0x00ff00ff, "a", circle);
  add(1, match::ThoughtKind::circle, 0x00ff00ff, "b", circle);
  add(1, match::ThoughtKind::polygon, 0x00ff00ff, "b", corners);
  add(2, match::ThoughtKind::polygon, 0x00ff00ff, "b", corners);
  const std::string at = "[0.5,-12.0625,0.1]}\n";
  const std::string area = "[[0,0.1],[0.2,0.3],[-0.01,100]]}\n";
  EXPECT_EQ(unpacked_thoughts(writer.packed(), "x").value(),
            "{\"tick\":1,\"layer\":\"a\",\"colour\":\"#ff0000ff\",\"circle\":" + at +
                "{\"tick\":1,\"layer\":\"a\",\"colour\":\"#ff0000ff\",\"circle\":" + at +
                "{\"tick\":1,\"layer\":\"a\",\"colour\":\"#00ff00ff\",\"circle\":" + at +
                "{\"tick\":1,\"layer\":\"b\",\"colour\":\"#00ff00ff\",\"circle\":" + at +
                "{\"tick\":1,\"layer\":\"b\",\"colour\":\"#00ff00ff\",\"polygon\":" + area +
                "{\"tick\":2,\"layer\":\"b\",\"colour\":\"#00ff00ff\",\"polygon\":" + area);
}

// Catches lines that are no JSON, whatever a team calls its layers.
TEST(ThoughtsFile, EscapesForeignBytes) {
  ThoughtsWriter writer;
  std::string every;
  for (int c = 1; c < 256; ++c) every += static_cast<char>(c);
  const double at[] = {0.0, 0.0};
  writer.add(0, {.kind = match::ThoughtKind::text,
                 .colour = 0,
                 .layer = "\"\\\n",
                 .numbers = at,
                 .text = every});
  const auto lines = unpacked_thoughts(writer.packed(), "x").value();
  EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 1);
  EXPECT_TRUE(nlohmann::json::accept(lines)) << lines;
}

// Catches a leg that fills the disk, and one that does not say what is missing.
TEST(ThoughtsFile, EndsAtItsBound) {
  ThoughtsWriter writer;
  const double numbers[] = {0.1, 0.2, 0.3, 0.4};
  for (std::uint32_t tick = 0; writer.left_out() < 3; ++tick) writer.add(tick, line_with(numbers));
  writer.count_left_out(2);
  const auto lines = unpacked_thoughts(writer.packed(), "x").value();
  EXPECT_LE(lines.size(), match::max_thought_bytes + 200);
  EXPECT_NE(lines.find("5 shapes of the leg were left out"), std::string::npos);
}

TEST(ThoughtsFile, RefusesOtherBytes) {
  EXPECT_EQ(unpacked_thoughts("", "x.zst").error().code, Errc::damaged);
  EXPECT_EQ(unpacked_thoughts("no zstd", "x.zst").error().code, Errc::damaged);
  EXPECT_TRUE(unpacked_thoughts(ThoughtsWriter().packed(), "x.zst").value().empty());
}

// A long leg is packed in parts, and the file does not say how long its text is. Catches a file
// that is cut, has something behind its end, or unpacks to more than a leg can have.
TEST(ThoughtsFile, OfALongLegIsReadToItsEndAndNoFurther) {
  ThoughtsWriter writer;
  const double numbers[] = {0.1, 0.2, 0.3, 0.4};
  constexpr std::uint32_t ticks = 20'000;
  for (std::uint32_t tick = 0; tick < ticks; ++tick) writer.add(tick, line_with(numbers));
  const std::string whole = writer.packed();
  const std::string lines = unpacked_thoughts(whole, "x.zst").value();
  EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), ticks);
  EXPECT_TRUE(lines.ends_with("[0.1,0.2,0.3,0.4]}\n"));
  for (const std::size_t size : {whole.size() - 1, whole.size() / 2, std::size_t{10}}) {
    EXPECT_FALSE(unpacked_thoughts(whole.substr(0, size), "x.zst")) << size;
  }
  EXPECT_FALSE(unpacked_thoughts(whole + "x", "x.zst"));
  EXPECT_FALSE(unpacked_thoughts(whole + whole, "x.zst"));

  const std::unique_ptr<ZSTD_CCtx, std::size_t (*)(ZSTD_CCtx*)> packer(ZSTD_createCCtx(),
                                                                       ZSTD_freeCCtx);
  const std::string zeros(1 << 20, '\0');
  std::string bomb;
  for (int i = 0; i <= 40; ++i) {
    std::string part(ZSTD_compressBound(zeros.size()), '\0');
    ZSTD_inBuffer in{zeros.data(), zeros.size(), 0};
    ZSTD_outBuffer out{part.data(), part.size(), 0};
    ZSTD_compressStream2(packer.get(), &out, &in, i < 40 ? ZSTD_e_flush : ZSTD_e_end);
    bomb.append(part, 0, out.pos);
  }
  EXPECT_FALSE(unpacked_thoughts(bomb, "x.zst"));
}

}  // namespace
}  // namespace mirocup::record
