// SPDX-License-Identifier: MIT
//
// Runs mirocup check as its users do. Catches a report that does not name the first check that
// fails, or gives no advice.
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

namespace mirocup {
namespace {

using namespace test_support;
using Json = nlohmann::ordered_json;

struct Examined {
  int exit_code;
  Json report;
};

Examined check(const std::string& library, const std::vector<std::string>& more = {},
               const std::string& half = "20") {
  std::vector<std::string> words{program("mirocup"), "check", library, "--json", "--half", half};
  words.insert(words.end(), more.begin(), more.end());
  const Outcome outcome = run(words);
  return {outcome.exit_code, Json::parse(outcome.out, nullptr, false)};
}

std::string hostile(const std::string& name) {
  return program("hostile/" + name + ".so");
}

// Catches a check that plays without the parameters of the league that the entry is for.
TEST(Check, GivesTheTeamItsParameters) {
  const Examined examined =
      check(program("teams/tuned.so"), {"--param", "speed=4.5", "--param", "spede=1"});
  EXPECT_EQ(examined.exit_code, 0) << examined.report.dump();
  EXPECT_EQ(examined.report["log"], "team 0 turns at 4.5\n");
  EXPECT_EQ(examined.report["unknown_parameters"], (Json{{"spede", 1.0}}));
}

TEST(Check, AcceptsTheHouseTeams) {
  for (const char* name :
       {"idle", "chaser", "keeper", "striker", "navigator", "tactician", "planner"}) {
    for (const char* league : {"small", "large"}) {
      const Examined examined =
          check(program("house/" + std::string(name) + ".so"), {"--league", league}, "8");
      EXPECT_EQ(examined.exit_code, 0) << examined.report.dump();
      EXPECT_EQ(examined.report["accepted"], true);
      EXPECT_EQ(examined.report["sha256"].get<std::string>().size(), 64u);
      for (const Json& one : examined.report["checks"]) EXPECT_EQ(one["passed"], true);
      EXPECT_GT(examined.report["timing"]["mean_tick_ms"], 0.0);
      EXPECT_GT(examined.report["peak_memory_bytes"], 100'000);
    }
  }
}

void expect_rejected(const std::string& library, const std::string& first_failed,
                     const std::string& text) {
  const Examined examined = check(library);
  EXPECT_EQ(examined.exit_code, 1) << library;
  EXPECT_EQ(examined.report["accepted"], false);
  const std::string reason = examined.report["reason"].get<std::string>();
  EXPECT_EQ(reason.rfind(first_failed + ": ", 0), 0u) << reason;
  EXPECT_TRUE(contains(reason, text));
  // All checks before the failed one passed, and none was run after it.
  bool has_failed = false;
  for (const Json& one : examined.report["checks"]) {
    if (one["passed"] == false) {
      EXPECT_EQ(one["name"], first_failed);
      has_failed = true;
    } else if (has_failed) {
      EXPECT_TRUE(one["passed"].is_null());
    } else {
      EXPECT_EQ(one["passed"], true);
    }
  }
}

TEST(Check, NamesTheFirstCheckThatFails) {
  const TemporaryFolder folder;
  write_file(folder / "text.so", "not a library\n");
  expect_rejected(folder / "text.so", "complete", "hand in the shared library");
  write_file(folder / "cut.so", read_file(program("house/chaser.so")).substr(0, 9000));
  expect_rejected(folder / "cut.so", "complete", "copy it again");
  write_file(folder / "empty.so", "");
  expect_rejected(folder / "empty.so", "file", "empty");
  expect_rejected(program("mirocup-plugin-host"), "complete", "-shared");
  expect_rejected(hostile("no_entry"), "entry", "MIROCUP_EXPORT_TEAM");
  expect_rejected(hostile("ld_runpath"), "libraries", "link it statically");
  expect_rejected(hostile("other_version"), "loads", "strategy.h of this version");
  expect_rejected(hostile("init_refuses"), "loads", "null: 'there is no plan for this field'");
  expect_rejected(hostile("ctor_exit"), "loads", "ended itself");
  expect_rejected(hostile("crash_segv"), "ticks", "gdb --args mirocup match --trusted");
  expect_rejected(hostile("slow_bank"), "ticks", "ms of processor time");
  expect_rejected(hostile("call_bpf"), "ticks", "bpf");
  expect_rejected(hostile("clock_random"), "repeatable", "tick 25");
}

// Catches an archive, a text or a source that is told to be something else, or not what to do.
TEST(Check, TellsFilesThatAreNoTeamsApart) {
  using namespace std::literals;
  const struct {
    std::string bytes;
    const char* told;
  } files[] = {{"Rar!\x1a\x07\0"s, "RAR archive, which is not taken"},
               {"BZh91AY"s, "packed with bzip2"},
               {"\xff\xfe#\0i\0"s, "save it as UTF-8"},
               {"\xef\xbb\xbf#include <cmath>\n"s, "mirocup compile"},
               {"class A:\n    pass\n"s, "from mirocup.team import Team"},
               {"package main\n\nimport \"fmt\"\n"s, "another language"},
               {"<!DOCTYPE html>\n"s, "a page of the web"},
               {"{\"cells\": []}"s, "a notebook"}};
  const TemporaryFolder folder;
  for (const auto& file : files) {
    write_file(folder / "team.rar", file.bytes);
    expect_rejected(folder / "team.rar", "complete", file.told);
  }
  write_file(folder / "team.zip", files[0].bytes);
  const Outcome compiled = run_mirocup({"compile", folder / "team.zip", "-o", folder / "team.so"});
  if (!why_no_t2().empty()) return;
  EXPECT_EQ(compiled.exit_code, 1);
  EXPECT_TRUE(contains(compiled.out, "RAR archive"));
}

// Catches an answer without its four parts, and a check that does not tell the score.
TEST(Check, TellsTheScoreAndTheFourPartsOfAnAnswer) {
  const Examined played = check(program("house/striker.so"));
  ASSERT_EQ(played.report["legs"].size(), 2u) << played.report.dump(1);
  for (const Json& leg : played.report["legs"]) {
    EXPECT_EQ(leg["opponent"], "striker");
    EXPECT_EQ(leg["score"].size(), 2u);
    for (const char* share : {"standing", "turning", "backwards"}) {
      EXPECT_GE(leg[share], 0.0);
      EXPECT_LE(leg[share], 1.0);
    }
  }
  EXPECT_TRUE(played.report["where"].is_null());
  EXPECT_TRUE(played.report["cure"].is_null());
  EXPECT_EQ(played.report["notes"].dump(), "[]");
  const Examined laddered = check(program("house/chaser.so"), {"--ladder"}, "60");
  EXPECT_EQ(laddered.report["ladder"].size(), 14u);
  EXPECT_TRUE(contains(laddered.report["strength"].dump(), "as strong as `"));
  const Outcome text = run_mirocup({"check", program("house/striker.so"), "--half", "2"});
  EXPECT_TRUE(contains(text.out, " against striker as yellow"));
  const Examined crashed = check(hostile("crash_segv"));
  EXPECT_TRUE(contains(crashed.report["where"].get<std::string>(), "ticks, tick "));
  EXPECT_TRUE(contains(crashed.report["cure"].get<std::string>(), "gdb"));
  const Outcome refused = run_mirocup({"check", hostile("crash_segv")});
  for (const char* part : {"\nwhat:  ", "\nwhere: ticks", "\ndo:    ", "\nplays: "})
    EXPECT_TRUE(contains(refused.out, part));
}

// Each time, although both legs are played in the same second.
TEST(Check, RefusesMovesThatDependOnTheTimeOfDay) {
  for (int i = 0; i < 3; ++i) expect_rejected(hostile("clock_seed"), "repeatable", "tick 25");
}

TEST(Check, AcceptsATeamThatMeasuresTime) {
  EXPECT_EQ(check(program("honest/clocks.so")).exit_code, 0);
}

TEST(Check, ReportsAnErrorForAMissingFile) {
  expect_exit(3, run_mirocup({"check", "/no/such/file.so"}), "/no/such/file.so");
}

}  // namespace
}  // namespace mirocup
