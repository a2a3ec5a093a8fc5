// SPDX-License-Identifier: MIT
//
// Catches a journal that loses a line, also at its end, accepts a changed one, or cannot be opened
// after the machine stopped while a line was written.
#include "tournaments/journal/journal.hpp"

#include "system/digest.hpp"
#include "tests/support/is_ok.hpp"
#include "tests/support/memory_files.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace mirocup::league {
namespace {

using test_support::MemoryFiles;

Journal opened(MemoryFiles& files) {
  auto journal = Journal::open(files, "journal.jsonl");
  EXPECT_TRUE(test_support::is_ok(journal));
  return std::move(*journal);
}

void write_three_lines(MemoryFiles& files) {
  Journal journal = opened(files);
  EXPECT_TRUE(journal.append("start", {{"config_sha256", "abc"}}));
  EXPECT_TRUE(journal.append("leg", {{"fixture", "r1-f1"}, {"leg", 1}}));
  EXPECT_TRUE(journal.append("leg", {{"fixture", "r1-f1"}, {"leg", 2}}));
}

// Catches a bound for each line where there is none for all: a file of 256 MiB took 15 GiB.
TEST(Journal, AllLinesTogetherHaveABound) {
  MemoryFiles files;
  write_three_lines(files);
  constexpr std::size_t line = 6;  // values: the object, n, kind, prev, hash, and one of its own
  EXPECT_TRUE(Journal::open(files, "journal.jsonl", nullptr, 3 * line + 2));
  const auto too_large = Journal::open(files, "journal.jsonl", nullptr, 3 * line + 1);
  ASSERT_FALSE(too_large);
  EXPECT_EQ(too_large.error().code, Errc::damaged);
  EXPECT_EQ(too_large.error().what.find("journal.jsonl: line 3: with this line"), 0u)
      << too_large.error().what;
  auto full = Journal::open(files, "journal.jsonl", nullptr, 4 * line + 1);
  ASSERT_TRUE(full);
  EXPECT_FALSE(full->append("leg", {{"fixture", "r1-f2"}, {"leg", 1}})) << "nobody could read it";
  EXPECT_TRUE(full->append("stop", {}));
  EXPECT_TRUE(Journal::open(files, "journal.jsonl", nullptr, 4 * line + 1));
}

TEST(Journal, SurvivesBeingCutOffAtAnyByte) {
  MemoryFiles whole;
  write_three_lines(whole);
  const std::string text = *whole.read("journal.jsonl");
  for (std::size_t size = 0; size <= text.size(); ++size) {
    MemoryFiles files;
    ASSERT_TRUE(files.write("journal.jsonl", text.substr(0, size)));
    std::string notice;
    auto journal = Journal::open(files, "journal.jsonl", &notice);
    ASSERT_TRUE(journal) << "cut to " << size << " bytes: " << journal.error().what;
    const std::size_t whole_lines =
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(size), '\n');
    EXPECT_EQ(journal->lines().size(), whole_lines);
    const bool torn = size > 0 && text[size - 1] != '\n';
    EXPECT_EQ(!notice.empty(), torn);
    // Lines can be appended after the cut, and then the whole journal can be read.
    ASSERT_TRUE(journal->append("void", {{"why", "test"}}));
    EXPECT_EQ(opened(files).lines().size(), whole_lines + 1);
  }
}

TEST(Journal, FindsEveryChangedByte) {
  MemoryFiles whole;
  write_three_lines(whole);
  const std::string text = *whole.read("journal.jsonl");
  // A last line without a line feed counts as torn, not as damaged.
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {
    MemoryFiles files;
    std::string changed = text;
    changed[i] ^= 1;
    ASSERT_TRUE(files.write("journal.jsonl", changed));
    const auto journal = Journal::open(files, "journal.jsonl");
    ASSERT_FALSE(journal) << "byte " << i;
    EXPECT_EQ(journal.error().code, Errc::damaged);
    EXPECT_NE(journal.error().what.find("line "), std::string::npos);
  }
}

TEST(Journal, FindsALineThatIsMissing) {
  MemoryFiles whole;
  write_three_lines(whole);
  const std::string text = *whole.read("journal.jsonl");
  const std::size_t second = text.find('\n') + 1;
  const std::size_t third = text.find('\n', second) + 1;
  for (const std::string& rest :
       {text.substr(second), text.substr(0, second) + text.substr(third), text + text.substr(third),
        "\n" + text, text + "{}\n", text + "{\"n\":\"4\"}\n", text + "[]\n"}) {
    MemoryFiles files;
    ASSERT_TRUE(files.write("journal.jsonl", rest));
    const auto journal = Journal::open(files, "journal.jsonl");
    ASSERT_FALSE(journal) << rest;
    EXPECT_EQ(journal.error().code, Errc::damaged);
  }
}

TEST(Journal, IsReadWhileItIsWritten) {
  MemoryFiles files;
  Journal reader = opened(files);
  Journal writer = opened(files);
  EXPECT_TRUE(writer.append("start", {{"config_sha256", "abc"}}));
  EXPECT_TRUE(reader.refresh());
  EXPECT_EQ(reader.lines().size(), 1u);
  // A half-written line is neither read nor removed.
  EXPECT_TRUE(files.append("journal.jsonl", "{\"n\":2,"));
  EXPECT_TRUE(reader.refresh());
  EXPECT_EQ(reader.lines().size(), 1u);
  EXPECT_NE(files.read("journal.jsonl")->find("{\"n\":2,"), std::string::npos);
  EXPECT_TRUE(reader.append("leg", {{"fixture", "r1-f1"}}));
  EXPECT_TRUE(writer.refresh());
  ASSERT_EQ(writer.lines().size(), 2u);
  EXPECT_EQ(writer.lines()[0]["prev"], "");
  EXPECT_EQ(writer.lines()[1]["fixture"], "r1-f1");
}

TEST(Journal, IsAsBeforeWhenTheDiskIsFull) {
  MemoryFiles files;
  write_three_lines(files);
  Journal journal = opened(files);
  files.fail_after(0);
  EXPECT_FALSE(journal.append("leg", {{"fixture", "r1-f2"}}));
  EXPECT_EQ(journal.lines().size(), 3u);
  files.fail_after(-1);
  EXPECT_TRUE(journal.append("leg", {{"fixture", "r1-f2"}}));
  EXPECT_EQ(opened(files).lines().size(), 4u);
}

// A journal of one line, which has these keys besides those that every line has.
std::string line_with(const std::string& fields) {
  const std::string text = "{\"n\":1," + fields + ",\"prev\":\"\"";
  return text + ",\"hash\":\"" + system::sha256(text) + "\"}\n";
}

// Catches a line with right hashes that takes the stack or the memory of who reads it.
TEST(Journal, NamesTheLineThatIsLargerThanAnyOfOurs) {
  MemoryFiles files;
  const auto error_of = [&files](const std::string& fields) {
    (void)files.write("journal.jsonl", line_with(fields));
    const auto journal = Journal::open(files, "journal.jsonl");
    if (journal) return std::string("none");
    EXPECT_EQ(journal.error().code, Errc::damaged);
    return journal.error().what;
  };
  EXPECT_EQ(error_of("\"kind\":\"start\""), "none");
  EXPECT_EQ(
      error_of("\"kind\":" + std::string(200'000, '[') + std::string(200'000, ']')).substr(0, 29),
      "journal.jsonl: line 1: /kind/");
  EXPECT_EQ(error_of("\"kind\":\"a\\u0000\""),
            "journal.jsonl: line 1: /kind: a text may not have the character U+0000");
  EXPECT_EQ(error_of("\"why\":\"" + std::string(9u << 20, 'x') + "\""),
            "journal.jsonl: line 1: /: it has 9437284 bytes; at most 8388608 are read");
}

// Catches a line that is written and can never be read again.
TEST(Journal, WritesNoLineThatItWouldRefuse) {
  MemoryFiles files;
  write_three_lines(files);
  Journal journal = opened(files);
  const auto written = journal.append("void", {{"why", std::string("a\0b", 3)}});
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, Errc::input);
  EXPECT_FALSE(journal.append("void", {{"why", std::string(2u << 20, 'x')}}));
  EXPECT_TRUE(journal.append("void", {{"why", "test"}}));
  EXPECT_EQ(opened(files).lines().size(), 4u);
}

// A journal with a head, and what is done to its two files.
class JournalHead : public testing::Test {
 protected:
  Journal opened() {
    auto journal = Journal::open(files_, path_, nullptr, Journal::max_values, head_);
    EXPECT_TRUE(test_support::is_ok(journal));
    return std::move(*journal);
  }

  void append(int lines) {
    Journal journal = opened();
    for (int i = 0; i < lines; ++i) EXPECT_TRUE(journal.append("leg", {{"leg", i}}));
  }

  // Returns the number of lines that the head knows, or the error of a journal that has lost some.
  // Nothing is then appended to it.
  std::string known() {
    Journal journal = opened();
    const auto lines = journal.known_lines();
    if (lines) return std::to_string(*lines);
    EXPECT_EQ(lines.error().code, Errc::damaged);
    EXPECT_NE(lines.error().what.find("journal.head from the last copy that league backup made"),
              std::string::npos);
    const std::string before = text();
    EXPECT_FALSE(journal.append("leg", {{"leg", 9}}));
    EXPECT_EQ(text(), before);
    return lines.error().what;
  }

  std::string text() { return files_.read(path_).value_or(""); }
  std::string without_last_line() {
    const std::string all = text();
    return all.substr(0, all.rfind('\n', all.size() - 2) + 1);
  }

  const std::string path_ = "journal.jsonl";
  const std::string head_ = "journal.head";
  MemoryFiles files_;
};

// Catches a journal whose chain of hashes is whole, since lines are lost at its end only.
TEST_F(JournalHead, NamesTheLineThatIsLost) {
  append(4);
  EXPECT_EQ(known(), "4");
  const std::string whole = text();
  (void)files_.write(path_, whole.substr(0, whole.size() - 10));
  EXPECT_EQ(known().find("journal.jsonl: it ends before line 4, the last line by journal.head"), 0u)
      << "the last line is cut, which a machine that stops does not do after the head";
  (void)files_.write(path_, whole);
  const std::string old = without_last_line();
  for (const std::string& shorter : {old, old.substr(0, old.find('\n') + 1), std::string()}) {
    (void)files_.write(path_, shorter);
    EXPECT_EQ(known().find("journal.jsonl: it ends before line 4"), 0u) << known();
  }
  (void)files_.remove(path_);
  EXPECT_EQ(known().find("journal.jsonl: it ends before line 4"), 0u) << "it is gone";
}

// Catches a comparison of numbers alone: an old copy that was played on has as many lines.
TEST_F(JournalHead, NamesTheLineThatIsAnother) {
  append(3);
  const std::string old = text();
  const std::string old_head = *files_.read(head_);
  append(2);
  const std::string head = *files_.read(head_);
  for (const int more : {2, 3}) {
    (void)files_.write(path_, old);
    (void)files_.write(head_, old_head);
    Journal journal = opened();
    for (int i = 0; i < more; ++i) EXPECT_TRUE(journal.append("void", {{"leg", i}}));
    (void)files_.write(head_, head);
    EXPECT_EQ(known().find("journal.jsonl: line 5 is another line than the one that journal.head"),
              0u)
        << known();
  }
}

// Catches an alarm after a stop between the two files, and for a league that has no head yet.
TEST_F(JournalHead, MayBeBehind) {
  append(2);
  const std::string behind = *files_.read(head_);
  append(1);
  (void)files_.write(head_, behind);
  EXPECT_EQ(known(), "2");
  append(1);
  EXPECT_EQ(known(), "4");
  (void)files_.write(head_, behind);
  EXPECT_EQ(known(), "2") << "a copy that was made while lines were written";
  (void)files_.remove(head_);
  EXPECT_EQ(known(), "0");
  append(1);
  EXPECT_EQ(known(), "5");
}

TEST_F(JournalHead, ThatIsDamagedIsNamed) {
  append(2);
  const std::string whole = *files_.read(head_);
  for (const std::string& damaged :
       {std::string(), whole.substr(0, whole.size() / 2), std::string("{\"n\":0,\"hash\":\"\"}\n"),
        std::string("{\"n\":-1,\"hash\":\"\"}"), std::string("[]"),
        std::string("{\"n\":1e99,\"hash\":1}"), std::string("{\"n\":2}")}) {
    (void)files_.write(head_, damaged);
    EXPECT_EQ(known().find("journal.head: "), 0u) << damaged << ": " << known();
  }
}

// Catches a reader that looks at the head last: a league that is played would seem to lose lines.
TEST_F(JournalHead, IsNoAlarmWhileAnotherProcessWrites) {
  append(1);
  Journal reader = opened();
  append(2);
  EXPECT_EQ(reader.known_lines(), 1u);
  ASSERT_TRUE(reader.refresh());
  EXPECT_EQ(reader.known_lines(), 3u);
}

// Catches a head that falls behind by several lines on a full disk, and a line that counts as not
// written because only its head is not.
TEST_F(JournalHead, IsBehindByOneLineAtMost) {
  append(2);
  Journal journal = opened();
  files_.fail_after(1);  // the line is written, the head is not
  EXPECT_TRUE(journal.append("leg", {{"leg", 3}}));
  EXPECT_EQ(journal.lines().size(), 3u);
  files_.fail_after(0);
  EXPECT_FALSE(journal.append("leg", {{"leg", 4}})) << "its head comes first";
  EXPECT_EQ(journal.lines().size(), 3u);
  files_.fail_after(-1);
  EXPECT_EQ(known(), "2");
  EXPECT_TRUE(journal.append("leg", {{"leg", 4}}));
  EXPECT_EQ(known(), "4");
}

}  // namespace
}  // namespace mirocup::league
