// SPDX-License-Identifier: MIT
//
// Catches a journal line that is misread, an event that is written differently than before, and a
// wrong line whose error does not say where it is wrong.
#include "tournaments/league/event.hpp"

#include "tests/support/is_ok.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <vector>

namespace mirocup::league {
namespace {

// The texts of lines as journals have them, without "prev" and "hash".
const std::vector<const char*> line_texts{
    R"({"n":1,"kind":"start","config_sha256":"c0","version":"0.1.0","build":"g++",)"
    R"("game":"0123456789abcdef","conditions":{"preset":"hall",)"
    R"("place_sigma_m":0.002,"place_sigma_rad":0.026,"wheel_gain_sigma":0.01,)"
    R"("wheel_jitter_sigma":0.01,"rolling_sigma":0.1,"see_sigma_m":0.0,"see_sigma_rad":0.0,)"
    R"("delay_ticks":0,"unseen_rate":0.0,"unseen_mean_ticks":0.0,"radio_loss":0.0}})",
    R"({"n":1,"kind":"entry","team":"a","entry":2,"sha256":"9f"})",
    R"({"n":1,"kind":"leg","fixture":"r1-f1","leg":1,"attempt":2,"home":"a","away":"b","blue":"a",)"
    R"("score":{"home":10,"away":0},"winner":"a","end":"forfeit",)"
    R"("fault":{"team":"b","code":"crash","text":"signal 11"},"penalties":{"home":0,"away":3},)"
    R"("record":"records/r1-f1-1-1.json","state_hash":"5f"})",
    R"({"n":1,"kind":"leg","fixture":"k1-f2","leg":3,"attempt":1,"home":"a","away":"b","blue":"a",)"
    R"("score":{"home":1,"away":1},"winner":null,"end":"full_time","fault":null,)"
    R"("penalties":{"home":0,"away":0},"record":"r","state_hash":"5f"})",
    R"({"n":1,"kind":"void","fixture":"r1-f1","leg":1,"attempt":1,"cause":"confirm","why":"slow"})",
    R"({"n":1,"kind":"ruling","fixture":"r1-f1","leg":2,"score":{"home":0,"away":10},)"
    R"("why":"w","by":"H"})",
    R"({"n":1,"kind":"withdraw","results":"annul","team":"a","why":"left","by":"H"})",
    R"({"n":1,"kind":"pause","team":"a","why":"w"})",
    R"({"n":1,"kind":"resume","team":"a","why":""})",
    R"({"n":1,"kind":"void","fixture":"r1-f1","leg":1,"attempt":1,"cause":"ruling","why":"w",)"
    R"("by":"H","at":"2026-11-30T18:00:00Z"})",
    R"({"n":1,"kind":"ruling","fixture":"r1-f1","leg":2,"score":{"home":0,"away":10},)"
    R"("why":"w","by":"H","at":"2026-11-30T18:00:00Z"})",
    R"({"n":1,"kind":"withdraw","results":"keep","team":"a","why":"left",)"
    R"("at":"2026-11-30T18:00:00Z"})",
    R"({"n":1,"kind":"pause","team":"a","why":"w","at":"2026-11-30T18:00:00Z"})",
    R"({"n":1,"kind":"resume","team":"a","why":"","at":"2026-11-30T18:00:00Z"})",
    R"({"n":1,"kind":"pause","team":"a","cause":"strikes","why":"w"})",
    R"({"n":1,"kind":"night","number":2,"entries":[{"team":"a","entry":2,"sha256":"9f"}],)"
    R"("at":"2026-11-30T18:00:00Z"})",
    R"({"n":1,"kind":"extension","team":"a","until":"u",)"
    R"("reason_sha256":"00","why":"w","by":"H"})",
    R"({"n":1,"kind":"freeze","from":"2026-11-30T18:00:00Z","why":"w","by":"H"})",
    R"({"n":1,"kind":"close","why":"w","by":"H"})",
    R"({"n":1,"kind":"release","level":"teams","through":"r3","why":"w"})",
    R"({"n":1,"kind":"undo","line":7,"why":"w","by":"H"})",
    R"({"n":1,"kind":"join","team":"c","source":"house:striker"})"};

std::string error_of_line(const Json& line) {
  return test_support::why_not(read_event(line));
}

TEST(Event, IsWrittenAsItWasRead) {
  for (const char* text : line_texts) {
    const auto event = read_event(Json::parse(text));
    ASSERT_TRUE(test_support::is_ok(event));
    Json again{{"n", 1}, {"kind", kind_of(*event)}};
    again.update(fields_of(*event));
    EXPECT_EQ(again.dump(), text);
  }
}

TEST(Event, NamesLineKeyAndReasonOfAMistake) {
  for (const char* text : line_texts) {
    const Json good = Json::parse(text);
    for (const auto& [key, value] : good.items()) {
      // A line of the program names no person, and the cause of its own pauses.
      if (key == "n" || key == "by" || (key == "at" && good["kind"] != "night") ||
          (key == "cause" && good["kind"] == "pause")) {
        continue;
      }
      Json line = good;
      line.erase(key);
      EXPECT_EQ(error_of_line(line), "line 1: /" + key + ": missing") << text;
      line[key] = Json::array({1});
      EXPECT_EQ(error_of_line(line).rfind("line 1: /" + key, 0), 0u) << error_of_line(line);
    }
  }
}

TEST(Event, OfAnUnknownKindOrOfAWrongNameIsRefused) {
  EXPECT_EQ(error_of_line({{"n", 7}, {"kind", "gift"}}),
            "line 7: /kind: no kind of journal line is called \"gift\"");
  Json line = Json::parse(line_texts[4]);
  line["cause"] = "mood";
  EXPECT_EQ(error_of_line(line),
            "line 1: /cause: one of host, confirm, ruling is expected, not \"mood\"");
}

// Catches goals whose sums overflow.
TEST(Event, HasAtMostAMillionGoals) {
  Json line = Json::parse(line_texts[5]);
  line["score"]["home"] = 2147483647;
  EXPECT_EQ(error_of_line(line), "line 1: /score/home: 2147483647 is not at most 1000000");
}

}  // namespace
}  // namespace mirocup::league
