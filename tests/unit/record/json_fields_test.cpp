// SPDX-License-Identifier: MIT
#include "record/json_fields.hpp"

#include "record/leg_fields.hpp"
#include "tests/support/is_ok.hpp"

#include <gtest/gtest.h>

namespace mirocup::record {

namespace {

struct Sample {
  int count = 1;
  std::optional<double> share;
  std::vector<match::Touch> touches;
  std::string note;

  bool operator==(const Sample&) const = default;
};

}  // namespace

template <class Fields>
void list_fields(Fields& f, Sample& sample) {
  f("count", sample.count, 0, 9);
  f("share", sample.share, 0.0, 1.0);
  f("touches", sample.touches, 0, 2);
  f.if_set("note", sample.note);
  f.only_written("twice", 2 * sample.count);
}

namespace {

// Returns the problem with a text, "" if it can be read.
std::string problem_with(const std::string& text) {
  return test_support::why_not(read_json<Sample>(text, "f", Errc::input, read_fields<Sample>));
}

// Catches a key that the reader and the writer call differently, and a null that becomes a value.
TEST(JsonFields, ReadsWhatItWrites) {
  const Sample plain;
  EXPECT_EQ(json_text(fields_json(plain)), R"({"count":1,"share":null,"touches":[],"twice":2})");
  const Sample full{
      .count = 3, .share = 0.5, .touches = {{Team::yellow, 2}}, .note = "so \"it\" is"};
  for (const Sample& sample : {plain, full}) {
    const auto read =
        read_json<Sample>(json_text(fields_json(sample)), "f", Errc::input, read_fields<Sample>);
    ASSERT_TRUE(read) << read.error().what;
    EXPECT_EQ(*read, sample);
  }
}

// Catches limits that are not handed on to the reader.
TEST(JsonFields, KeepsTheLimits) {
  EXPECT_EQ(problem_with(R"({"count":10,"share":null,"touches":[]})"),
            "f: /count: 10 is not at most 9");
  EXPECT_EQ(problem_with(R"({"count":1,"share":2,"touches":[]})"), "f: /share: 2 is not at most 1");
  EXPECT_EQ(problem_with(R"({"count":1,"share":null,"touches":[{"team":"red","robot":0}]})"),
            "f: /touches/0/team: one of blue, yellow is expected, not \"red\"");
  EXPECT_EQ(problem_with(R"({"count":1,"share":null,"touches":[1,2,3]})"),
            "f: /touches: 0 to 2 values are expected, not 3");
  EXPECT_EQ(problem_with(R"({"count":1,"touches":[]})"), "f: /share: missing");
}

// Catches a value of another type that ends the program, or wraps around.
TEST(JsonFields, ReadsSingleValuesOfAnyObject) {
  const auto json =
      parse_json(R"({"n": 3, "text": "a", "big": 1e300, "yes": true, "no": null})").value;
  EXPECT_EQ(value_in(json, "n", 0), 3);
  EXPECT_EQ(value_in(json, "text", std::string("b")), "a");
  EXPECT_TRUE(value_in(json, "yes", false));
  EXPECT_EQ(value_in(json, "big", 0.0), 1e300);
  for (const char* key : {"big", "text", "yes", "no", "nothing"})
    EXPECT_EQ(value_in(json, key, 7), 7) << key;
  EXPECT_EQ(value_in<std::optional<double>>(json, "n"), 3.0);
  EXPECT_EQ(value_in<std::optional<double>>(json, "no"), std::nullopt);
  EXPECT_EQ(value_in(json["n"], "n", 7), 7);
  EXPECT_EQ(value_in(JsonReader::Json(), "n", 7), 7);
}

}  // namespace

}  // namespace mirocup::record
