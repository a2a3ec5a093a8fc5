// SPDX-License-Identifier: MIT
//
// Catches a check that accepts a mistake which loses a leg later, one that refuses it with the
// wrong reason, and one that refuses what is allowed. teams/mistakes.cpp makes one mistake at a
// time.
#include "tests/programs/check/teams/mistakes.hpp"

#include "tests/support/program.hpp"

#include <gtest/gtest.h>

namespace mirocup {
namespace {

using check_test::Mistake;
using namespace test_support;
using Json = nlohmann::ordered_json;

struct Answer {
  int exit_code;
  Json report;
};

Answer check_team_with(Mistake mistake, const char* half = "20") {
  const auto outcome =
      run_mirocup({"check", program("teams/mistakes.so"), "--half", half, "--param",
                   "mistake=" + std::to_string(static_cast<int>(mistake)), "--json"});
  return {outcome.exit_code, Json::parse(outcome.out, nullptr, false)};
}

struct Refused {
  Mistake mistake;
  const char* name;
  const char* check;               // the first that fails
  std::vector<const char*> texts;  // the reason has each of them
};

#define REFUSED(kind, check, ...) (Refused{Mistake::kind, #kind, check, {__VA_ARGS__}})

class Mistakes : public testing::TestWithParam<Refused> {};
INSTANTIATE_TEST_SUITE_P(
    Kinds, Mistakes,
    testing::Values(
        REFUSED(null_pointer_late, "leg_blue", "null pointer", "decide() of tick 901", "gdb"),
        REFUSED(throws_in_second_half, "leg_blue", "second half", "catch the exception"),
        REFUSED(throws_when_trailing, "leg_", "trailing"),
        REFUSED(throws_in_a_shoot_out, "knockout", "shoot-out"),
        REFUSED(throws_in_place, "leg_", "place() threw", "place() of"),
        REFUSED(sleeps, "ticks", "do not sleep or wait"),
        REFUSED(leaks, "leg_", "bad_alloc", "1 GiB"),
        REFUSED(endless_loop, "leg_blue", "loop that does not end", "in decide() of tick "),
        REFUSED(seed_of_time, "repeatable", "a clock"),
        REFUSED(seed_of_process, "repeatable", "number of its process"),
        REFUSED(address, "repeatable", "addresses"),
        REFUSED(writes_behind, "", "behind the end of a block of 24 bytes"),
        REFUSED(writes_freed, "", "that it had freed"), REFUSED(frees_twice, "", "freed twice"),
        REFUSED(heap_not_set, "repeatable", "never written"),
        REFUSED(stack_not_set, "repeatable", "never written"),
        REFUSED(bool_not_set, "repeatable", "never written"),
        REFUSED(recursion, "ticks", "end of its stack", "recursion"),
        REFUSED(division_by_zero, "ticks", "divided by zero"),
        REFUSED(throws_in_noexcept, "ticks", "std::terminate"), REFUSED(exits, "ticks", "exit()"),
        REFUSED(writes_observation, "ticks", "wrote to the observation", "copy"),
        REFUSED(thread, "loads", "asked for a thread"), REFUSED(file, "ticks", "asked for a file"),
        REFUSED(keeps_observation, "repeatable", "keep no pointer"),
        REFUSED(reads_behind, "repeatable", "index out of bounds"),
        REFUSED(writes_behind_command, "memory", "behind the end of its command",
                "index of wheels"),
        REFUSED(throws_a_text, "ticks", "threw: ball lost"),
        REFUSED(thinks_by_the_clock, "repeatable", "a clock"),
        REFUSED(time_stamp_counter, "repeatable", "random numbers"),
        REFUSED(variable_that_is_missing, "loads", "getenv() returned null"),
        REFUSED(program, "ticks", "asked for a program"),
        REFUSED(as_yellow, "leg_yellow", "as yellow"),
        REFUSED(throws_at_own_penalty, "", "no place"),
        REFUSED(throws_at_free_ball, "", "no place"),
        REFUSED(throws_without_keeper, "ticks", "no keeper")),
    [](const auto& c) { return c.param.name; });

TEST_P(Mistakes, AreRefusedWithTheirReason) {
  const Refused& expected = GetParam();
  const Answer examined = check_team_with(expected.mistake);
  EXPECT_EQ(examined.exit_code, 1) << examined.report.dump(1);
  const std::string reason = examined.report.value("reason", Json()).dump();
  EXPECT_EQ(reason.rfind("\"" + std::string(expected.check), 0), 0u) << reason;
  // In T1 the number of a team's process differs from leg to leg, so the check cannot tell it from
  // other chance.
  if (expected.mistake == Mistake::seed_of_process && !why_no_t2().empty()) return;
  for (const char* text : expected.texts) EXPECT_TRUE(contains(reason, text));
}

// 6 ms of processor time for each tick, in a leg that gives 1 ms and something.
TEST(Check, RefusesATeamThatWouldLoseEachLegByItsBudget) {
  const Answer examined = check_team_with(Mistake::slow, "10");
  EXPECT_EQ(examined.exit_code, 1);
  const std::string reason = examined.report["reason"].get<std::string>();
  EXPECT_EQ(reason.rfind("budget: a leg with halves of 10 s would take ", 0), 0u) << reason;
  for (const char* text : {"of processor time", "1 ms"}) {
    EXPECT_TRUE(contains(reason, text));
  }
  EXPECT_GT(examined.report["timing"]["leg_share"], 1.25);
}

// 1.5 ms for each tick: more than a long leg gives, but not more than a short one.
TEST(Check, AcceptsASlowTeamForShortLegs) {
  const Answer examined = check_team_with(Mistake::a_little_slow, "1");
  EXPECT_EQ(examined.exit_code, 0) << examined.report["reason"];
}

// Catches a check that accepts what no goal has asked for: in so short legs none falls.
TEST(Check, LetsGoalsFallForBothTeams) {
  const Answer examined = check_team_with(Mistake::throws_when_trailing, "0.5");
  EXPECT_EQ(examined.exit_code, 1) << examined.report.dump(1);
  const std::string reason = examined.report.value("reason", Json()).dump();
  EXPECT_EQ(reason.rfind("\"knockout", 0), 0u) << reason;
}

struct Allowed {
  Mistake mistake;
  const char* name;
  const char* warning;  // "": there is none
  const char* half = "20";
};

#define ALLOWED(kind, ...) (Allowed{Mistake::kind, #kind, __VA_ARGS__})

class HarmlessTeams : public testing::TestWithParam<Allowed> {};
INSTANTIATE_TEST_SUITE_P(
    Kinds, HarmlessTeams,
    testing::Values(ALLOWED(none, ""), ALLOWED(bad_values, "clamped"),
                    ALLOWED(not_finite, "left wheel of robot 1 in tick 20, "),
                    ALLOWED(wheels_exchanged, "wheel are exchanged", "60"),
                    ALLOWED(wrong_end, "you attack +x in both colours", "60"),
                    ALLOWED(targets_outside, "targets are outside the field", "120"),
                    ALLOWED(never_moves, "never turned a wheel"),
                    ALLOWED(illegal_places, "not legal"),
                    ALLOWED(one_robot_too_many, "robots are 0 to 2"),
                    ALLOWED(turns_in_degrees, "in radians, and not in degrees"),
                    ALLOWED(turns_unwrapped, "is not wrapped", "60"),
                    ALLOWED(axes_exchanged, "x and y are exchanged, in", "60"),
                    ALLOWED(robots_exchanged, "wheels of robot 2 follow robot 1", "60"),
                    ALLOWED(wheels_negated, "sign of all wheels", "60"),
                    ALLOWED(heading_offset, "heading 0 looks along +x", "60"),
                    ALLOWED(ball_in_ticks, "ball_vx and ball_vy are in m/s", "60"),
                    ALLOWED(end_by_colour, "its own goal as yellow", "60"),
                    ALLOWED(keeps_the_first_ball, "kept from an earlier tick", "60"),
                    ALLOWED(drives_opponents, "follow the opponents' robots", "60"),
                    ALLOWED(tries_a_file, "file notes.txt"),
                    ALLOWED(tries_a_thread, "asked for a thread"), ALLOWED(measures_time, ""),
                    ALLOWED(chance_without_seed, "faster than 15 rad/s")),
    [](const auto& c) { return c.param.name; });

TEST_P(HarmlessTeams, AreAccepted) {
  const Answer examined = check_team_with(GetParam().mistake, GetParam().half);
  EXPECT_EQ(examined.exit_code, 0) << examined.report["reason"];
  const std::string warnings = examined.report["warnings"].dump();
  if (*GetParam().warning == '\0') {
    EXPECT_EQ(warnings, "[]");
  } else {
    EXPECT_TRUE(contains(warnings, GetParam().warning));
  }
}

// Catches --trusted that dies of a team without a word.
TEST(Trusted, TellsWhichTeamCrashedWhere) {
  const auto outcome =
      run_mirocup({"match", "--trusted", "--blue", "idle", "--yellow", program("teams/mistakes.so"),
                   "--half", "60", "--yellow-param",
                   "mistake=" + std::to_string(static_cast<int>(Mistake::null_pointer_late))});
  EXPECT_EQ(outcome.exit_code, 128 + 11);
  EXPECT_TRUE(contains(outcome.err,
                       "the yellow team crashed in this process, in decide() of tick 901, by "
                       "Segmentation fault"));
}

}  // namespace
}  // namespace mirocup
