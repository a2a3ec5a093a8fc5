// SPDX-License-Identifier: MIT
//
// Catches a problem that is not reported, one that is reported at the wrong place, and a value that
// a parser gets although it is out of its range.
#include "record/json_reader.hpp"

#include "core/field/league.hpp"
#include "tests/support/is_ok.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace mirocup::record {
namespace {

// Returns the error of a parser that reads `text`; "" if it reports none.
std::string error_text(const std::string& text,
                       const std::function<void(const JsonReader&)>& read) {
  const auto done = read_json<bool>(text, "f.json", Errc::damaged, [&](const JsonReader& json) {
    read(json);
    return true;
  });
  if (done) return "";
  EXPECT_EQ(done.error().code, Errc::damaged);
  return done.error().what;
}

TEST(JsonReader, ReadsEveryTypeThatAParserAsksFor) {
  struct Values {
    double ratio = 0.0;
    int count = 7;
    std::uint64_t seed = 0;
    bool is_open = false;
    std::string title;
    RobotLeague league = RobotLeague::small;
    std::vector<int> list;
  };
  const auto values = read_json<Values>(
      R"({"ratio": 1.5, "seed": 18446744073709551615, "is_open": true, "title": "t",
          "league": "large", "list": [1, -2, 3.0]})",
      "f.json", Errc::input, [](const JsonReader& json) {
        Values v;
        v.ratio = json.at("ratio").number();
        json.read_if_present("count", v.count);
        v.seed = json.at("seed").as<std::uint64_t>();
        v.is_open = json.at("is_open").boolean();
        v.title = json.at("title").text();
        v.league = json.at("league").name<RobotLeague>();
        for (const JsonReader& e : json.at("list").elements(1, 3)) v.list.push_back(e.as<int>());
        return v;
      });
  ASSERT_TRUE(test_support::is_ok(values));
  EXPECT_EQ(values->ratio, 1.5);
  EXPECT_EQ(values->count, 7) << "a missing key leaves the value as it was";
  EXPECT_EQ(values->seed, UINT64_MAX);
  EXPECT_TRUE(values->is_open);
  EXPECT_EQ(values->title, "t");
  EXPECT_EQ(values->league, RobotLeague::large);
  EXPECT_EQ(values->list, (std::vector<int>{1, -2, 3}));
}

TEST(JsonReader, NamesFilePointerAndReason) {
  const auto read_count = [](const JsonReader& json) { (void)json.at("a").at("n/").as<int>(); };
  EXPECT_EQ(error_text(R"({"a": {"n/": 1}})", read_count), "");
  EXPECT_EQ(error_text(R"({"a": {}})", read_count), "f.json: /a/n~1: missing");
  EXPECT_EQ(error_text(R"({"a": {"n/": 1.5}})", read_count),
            "f.json: /a/n~1: a whole number is expected, not 1.5");
  EXPECT_EQ(error_text(R"({"a": {"n/": 3000000000}})", read_count),
            "f.json: /a/n~1: 3000000000 is not at most 2147483647");
  EXPECT_EQ(error_text(R"({"a": {"n/": 1e300}})", read_count),
            "f.json: /a/n~1: a whole number is expected, not 1e+300");
  EXPECT_EQ(error_text(R"({"a": {"n/": [[1]]}})", read_count),
            "f.json: /a/n~1: a whole number is expected, not an array");
  EXPECT_EQ(error_text("{\"a\":", read_count).find("f.json: /: not JSON: "), 0u);
}

TEST(JsonReader, KeepsTheFirstProblem) {
  EXPECT_EQ(error_text(R"({"a": 1, "b": 2})",
                       [](const JsonReader& json) {
                         (void)json.at("a").text();
                         (void)json.at("b").text();
                       }),
            "f.json: /a: a string is expected, not 1");
}

TEST(JsonReader, RefusesKeysThatAParserDoesNotKnow) {
  EXPECT_EQ(error_text(R"({"a": 1, "c": 2})",
                       [](const JsonReader& json) {
                         (void)json.expect_object({"a", "b"});
                       }),
            "f.json: /c: there is no such key; known are a, b");
  EXPECT_EQ(error_text("[]", [](const JsonReader& json) { (void)json.members(); }),
            "f.json: /: an object is expected");
}

TEST(JsonReader, GivesNoValueOutOfItsRange) {
  (void)error_text(R"([5000, -1, -1, "x", 2.5])", [](const JsonReader& json) {
    EXPECT_EQ(json.at(0).integer<std::uint8_t>(), 255);
    EXPECT_EQ(json.at(1).integer<unsigned>(), 0u);
    EXPECT_EQ(json.at(2).integer(3, 9), 3);
    EXPECT_EQ(json.at(3).integer(3, 9), 3);
    EXPECT_EQ(json.at(3).number(1.0, 2.0), 1.0);
    EXPECT_EQ(json.at(4).number(0.0, 2.0), 2.0);
    EXPECT_EQ(json.at(7).text(), "") << "there is no such element";
    EXPECT_EQ(json.at(3).name<RobotLeague>(), RobotLeague::small);
  });
}

TEST(JsonReader, SaysWhichSchemaItReads) {
  const auto read = [](const JsonReader& json) { json.expect_schema("a/1"); };
  EXPECT_EQ(error_text(R"({"schema": "a/1"})", read), "");
  EXPECT_EQ(error_text(R"({"schema": "a/2"})", read),
            "f.json: /schema: \"a/1\" is expected, not \"a/2\"");
  EXPECT_EQ(error_text("{}", read), "f.json: /schema: missing");
}

// Catches a message that breaks a character in two: JSON that contains it could not be written.
TEST(JsonReader, QuotesLongTextsInPart) {
  std::string umlauts;
  for (int i = 0; i < 100; ++i) umlauts += "ä";
  for (const std::string& start : {std::string(), std::string("x")}) {
    const std::string error = error_text("[\"" + start + umlauts + "\"]",
                                         [](const JsonReader& j) { (void)j.at(0).number(); });
    EXPECT_LT(error.size(), 120u);
    EXPECT_NO_THROW((void)nlohmann::json(error).dump());
  }
}

std::string nested(std::size_t depth) {
  return std::string(depth, '[') + std::string(depth, ']');
}

// Catches a document that takes the stack, the memory or the time of who reads it, and a problem
// that is not named at its place.
TEST(JsonReader, RefusesWhatIsLargerThanItsLimits) {
  const auto problem_of = [](const std::string& text, const JsonLimits& limits = {}) {
    const auto parsed = parse_json(text, limits);
    return parsed.problem ? parsed.problem->pointer + ": " + parsed.problem->reason : "none";
  };
  EXPECT_EQ(problem_of(nested(64)), "none");
  for (const std::size_t depth : {65u, 200'000u}) {
    EXPECT_NE(problem_of(nested(depth)).find("at most 64 deep"), std::string::npos);
  }
  std::string objects;
  for (int i = 0; i < 100'000; ++i) objects += "{\"a\":";
  EXPECT_NE(problem_of(objects).find("/a/a/a/a"), std::string::npos);
  EXPECT_NE(problem_of(objects).find("at most 64 deep"), std::string::npos);
  EXPECT_LT(problem_of(objects).size(), 500u);

  EXPECT_EQ(problem_of("[1,2,[3]]", {.values = 5}), "none");
  EXPECT_EQ(problem_of("[1,2,[3]]", {.values = 4}), "/2/0: a document has at most 4 values");
  std::string keys = "{\"key\":{";
  for (int i = 0; i < 257; ++i) keys += (i > 0 ? ",\"" : "\"") + std::to_string(i) + "\":0";
  EXPECT_EQ(problem_of(keys + "}}"), "/key/256: an object has at most 256 keys");
  EXPECT_EQ(problem_of("{\"n\":[0,0." + std::string(1'000'000, '9') + "]}"),
            "/n/1: a number has at most 1024 characters, not 1000002");
  EXPECT_EQ(problem_of("[0.12345]", {.number = 7}), "none");
  EXPECT_EQ(problem_of("{\"t\":\"abcde\"}", {.text = 4}), "/t: a text has at most 4 bytes, not 5");
  EXPECT_EQ(problem_of("{\"abcde\":1}", {.text = 4}), "/abcde: a text has at most 4 bytes, not 5");
  EXPECT_EQ(problem_of("[1, 2]", {.bytes = 5}), "/: it has 6 bytes; at most 5 are read");
}

// Catches a key of which one reader takes the first value and another one the last, and texts that
// end early where they are paths.
TEST(JsonReader, RefusesWhatReadersMayTakeDifferently) {
  EXPECT_EQ(parse_json(R"({"a":{"b":1,"c":2,"b":3}})").problem->pointer, "/a/b");
  EXPECT_EQ(parse_json(R"({"a":{"b":1,"c":2,"b":3}})").problem->reason, "the key is there twice");
  EXPECT_EQ(parse_json(R"(["x\u0000y"])").problem->pointer, "/0");
  EXPECT_EQ(parse_json(R"({"x\u0000y":1})").problem->pointer, "/x\\x00y");
}

// Catches a text of the library in a message, and one that does not say where.
TEST(JsonReader, SaysWhereATextIsNotJson) {
  const auto reason_of = [](const std::string& text) { return parse_json(text).problem->reason; };
  EXPECT_EQ(reason_of("{\n  \"a\": ]"), "not JSON: wrong at line 2, column 8");
  EXPECT_EQ(reason_of("{\"a\":"), "not JSON: it ends too early, in line 1, column 5");
  EXPECT_EQ(reason_of(""), "not JSON: it ends too early, in line 1, column 0");
  EXPECT_EQ(reason_of("[1e999]"), "line 1, column 6: the number is too large");
  EXPECT_EQ(reason_of("[" + std::string(1'000'000, '9') + "]"),
            "line 1, column 1000001: the number is too large");
  for (const char* text : {"[\"\\ud800\"]", "[\"\xff\"]", "[01]", "[1] 2", "nul", "\"\x01\""}) {
    EXPECT_EQ(reason_of(text).find("not JSON: "), 0u) << text;
    EXPECT_EQ(reason_of(text).find("exception"), std::string::npos) << text;
  }
}

// Catches a message that repeats a document, or writes to a terminal control characters or those
// that turn the direction of writing.
TEST(JsonReader, QuotesKeysAndReasonsInPart) {
  const std::string key(100'000, 'k');
  const std::string text = "{\"a\\u001b[31m\":{\"" + key + "\":1}}";
  const std::string error = error_text(text, [](const JsonReader& json) {
    for (const auto& [name, member] : json.members()) (void)member.expect_object({"b"});
  });
  EXPECT_EQ(error.find("f.json: /a\\x1b[31m/kkk"), 0u) << error.substr(0, 100);
  EXPECT_LT(error.size(), 200u);
  EXPECT_LT(error_text("[]", [&](const JsonReader& json) { json.complain(key + "\x1b"); }).size(),
            1000u);
  const std::string turned = R"({"a~\u202eb/":1})";
  EXPECT_EQ(error_text(turned, [](const JsonReader& json) { (void)json.expect_object({"c"}); }),
            "f.json: /a~0\\xe2\\x80\\xaeb~1: there is no such key; known are c");
}

// Catches an exception where a path or a name is not UTF-8.
TEST(JsonText, IsAlwaysJson) {
  EXPECT_EQ(json_text({{"path", "a\xff"}}), "{\"path\":\"a\xef\xbf\xbd\"}");
}

}  // namespace
}  // namespace mirocup::record
