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
using test_support::program;
using Json = nlohmann::ordered_json;

struct Answer {
  int exit_code;
  Json report;
};

Answer check_team_with(Mistake mistake, const char* half = "20") {
  const auto outcome = test_support::run(
      {program("mirocup"), "check", program("teams/mistakes.so"), "--half", half, "--param",
       "mistake=" + std::to_string(static_cast<int>(mistake)), "--json"});
  return {outcome.exit_code, Json::parse(outcome.out, nullptr, false)};
}

// With sanitizers a leg takes twenty times as long, and the team has none: a few kinds are enough.
bool is_left_out([[maybe_unused]] Mistake mistake) {
#ifdef MIROCUP_SANITIZED
  constexpr int one_of = 10;
  return static_cast<int>(mistake) % one_of != 0;
#else
  return false;
#endif
}

struct Refused {
  Mistake mistake;
  const char* name;
  const char* check;               // the first that fails
  std::vector<const char*> texts;  // the reason has each of them
};

class Mistakes : public testing::TestWithParam<Refused> {};
INSTANTIATE_TEST_SUITE_P(
    Kinds, Mistakes,
    testing::Values(
        Refused{Mistake::null_pointer_late,
                "null_pointer_late",
                "leg_blue",
                {"null pointer", "decide() of tick 901", "gdb"}},
        Refused{Mistake::throws_in_second_half,
                "throws_in_second_half",
                "leg_blue",
                {"second half", "catch the exception"}},
        Refused{Mistake::throws_when_trailing, "throws_when_trailing", "leg_", {"trailing"}},
        Refused{Mistake::throws_after_a_goal, "throws_after_a_goal", "leg_", {"range_check"}},
        Refused{Mistake::throws_in_a_shoot_out, "throws_in_a_shoot_out", "knockout", {"shoot-out"}},
        Refused{
            Mistake::throws_in_place, "throws_in_place", "leg_", {"place() threw", "place() of"}},
        Refused{Mistake::sleeps, "sleeps", "ticks", {"do not sleep or wait"}},
        Refused{Mistake::leaks, "leaks", "leg_", {"bad_alloc", "1 GiB"}},
        Refused{Mistake::endless_loop,
                "endless_loop",
                "leg_blue",
                {"loop that does not end", "in decide() of tick "}},
        Refused{Mistake::seed_of_time, "seed_of_time", "repeatable", {"a clock"}},
        Refused{
            Mistake::seed_of_process, "seed_of_process", "repeatable", {"number of its process"}},
        Refused{Mistake::random_device, "random_device", "repeatable", {"std::random_device"}},
        Refused{Mistake::address, "address", "repeatable", {"addresses"}},
        Refused{Mistake::processor, "processor", "repeatable", {}},
        Refused{
            Mistake::writes_behind, "writes_behind", "", {"behind the end of a block of 24 bytes"}},
        Refused{Mistake::writes_before,
                "writes_before",
                "",
                {"before the beginning of a block of 24 bytes"}},
        Refused{Mistake::writes_freed, "writes_freed", "", {"that it had freed"}},
        Refused{Mistake::frees_twice, "frees_twice", "", {"freed twice"}},
        Refused{Mistake::reads_freed, "reads_freed", "repeatable", {"never written"}},
        Refused{Mistake::heap_not_set, "heap_not_set", "repeatable", {"never written"}},
        Refused{Mistake::stack_not_set, "stack_not_set", "repeatable", {"never written"}},
        Refused{Mistake::recursion, "recursion", "ticks", {"end of its stack", "recursion"}},
        Refused{Mistake::division_by_zero, "division_by_zero", "ticks", {"divided by zero"}},
        Refused{Mistake::throws_in_noexcept, "throws_in_noexcept", "ticks", {"std::terminate"}},
        Refused{Mistake::assertion, "assertion", "ticks", {"assert()"}},
        Refused{Mistake::exits, "exits", "ticks", {"exit()"}},
        Refused{Mistake::wild_pointer, "wild_pointer", "ticks", {"not valid", "out of bounds"}},
        Refused{Mistake::writes_observation,
                "writes_observation",
                "ticks",
                {"wrote to the observation", "copy"}},
        Refused{Mistake::thread, "thread", "loads", {"asked for a thread"}},
        Refused{Mistake::file, "file", "ticks", {"asked for a file"}},
        Refused{Mistake::counts_processors,
                "counts_processors",
                "repeatable",
                {"number of its process, thread or processor"}},
        Refused{Mistake::integral_not_set, "integral_not_set", "repeatable", {"never written"}},
        Refused{
            Mistake::unset_in_second_half, "unset_in_second_half", "repeatable", {"never written"}},
        Refused{Mistake::keeps_observation, "keeps_observation", "repeatable", {"keep no pointer"}},
        Refused{Mistake::reads_behind, "reads_behind", "repeatable", {"index out of bounds"}},
        Refused{Mistake::reads_before, "reads_before", "repeatable", {"index out of bounds"}},
        Refused{Mistake::grown_vector, "grown_vector", "", {"that it had freed"}},
        Refused{Mistake::dangling_capture, "dangling_capture", "repeatable", {"keep no pointer"}},
        Refused{
            Mistake::text_too_long, "text_too_long", "", {"behind the end of a block of 24 bytes"}},
        Refused{Mistake::writes_behind_command,
                "writes_behind_command",
                "memory",
                {"behind the end of its command", "index of wheels"}},
        Refused{Mistake::throws_a_text, "throws_a_text", "ticks", {"threw: ball lost"}},
        Refused{Mistake::number_as_text, "number_as_text", "leg_blue", {"decide() of tick 901"}},
        Refused{Mistake::derivative_by_the_clock,
                "derivative_by_the_clock",
                "repeatable",
                {"a clock", "now.time"}},
        Refused{Mistake::waits_by_the_clock, "waits_by_the_clock", "repeatable", {"a clock"}},
        Refused{Mistake::waits_by_its_processor_time,
                "waits_by_its_processor_time",
                "repeatable",
                {"a clock"}},
        Refused{Mistake::thinks_by_the_clock, "thinks_by_the_clock", "repeatable", {"a clock"}},
        Refused{
            Mistake::time_stamp_counter, "time_stamp_counter", "repeatable", {"random numbers"}},
        Refused{Mistake::variable_that_is_missing,
                "variable_that_is_missing",
                "loads",
                {"getenv() returned null"}},
        Refused{Mistake::locale, "locale", "loads", {"the locale \\\"C\\\""}},
        Refused{Mistake::program, "program", "ticks", {"asked for a program"}},
        Refused{Mistake::alarm, "alarm", "loads", {"not allowed: alarm"}},
        Refused{Mistake::as_yellow, "as_yellow", "leg_yellow", {"as yellow"}},
        Refused{Mistake::endless_angle, "endless_angle", "leg_blue", {"loop that does not end"}},
        Refused{Mistake::throws_at_own_penalty, "throws_at_own_penalty", "", {"no place"}},
        Refused{Mistake::throws_at_penalty_against, "throws_at_penalty_against", "", {"no place"}},
        Refused{Mistake::throws_at_own_free_kick, "throws_at_own_free_kick", "", {"no place"}},
        Refused{
            Mistake::throws_at_free_kick_against, "throws_at_free_kick_against", "", {"no place"}},
        Refused{Mistake::throws_at_own_goal_kick, "throws_at_own_goal_kick", "", {"no place"}},
        Refused{
            Mistake::throws_at_goal_kick_against, "throws_at_goal_kick_against", "", {"no place"}},
        Refused{Mistake::throws_at_free_ball, "throws_at_free_ball", "", {"no place"}},
        Refused{Mistake::throws_in_a_corner, "throws_in_a_corner", "", {"in a corner"}},
        Refused{Mistake::throws_without_keeper, "throws_without_keeper", "ticks", {"no keeper"}}),
    [](const auto& c) { return c.param.name; });

TEST_P(Mistakes, AreRefusedWithTheirReason) {
  const Refused& expected = GetParam();
  if (is_left_out(expected.mistake)) GTEST_SKIP() << "with sanitizers";
  const Answer examined = check_team_with(expected.mistake);
  EXPECT_EQ(examined.exit_code, 1) << examined.report.dump(1);
  const std::string reason = examined.report.value("reason", Json()).dump();
  EXPECT_EQ(reason.rfind("\"" + std::string(expected.check), 0), 0u) << reason;
  // In T1 the number of a team's process differs from leg to leg, so the check cannot tell it from
  // other chance.
  if (expected.mistake == Mistake::seed_of_process && !test_support::why_no_t2().empty()) return;
  for (const char* text : expected.texts) EXPECT_NE(reason.find(text), std::string::npos) << reason;
}

// 6 ms of processor time for each tick, in a leg that gives 1 ms and something.
TEST(Check, RefusesATeamThatWouldLoseEachLegByItsBudget) {
  const Answer examined = check_team_with(Mistake::slow, "10");
  EXPECT_EQ(examined.exit_code, 1);
  const std::string reason = examined.report["reason"].get<std::string>();
  EXPECT_EQ(reason.rfind("budget: a leg with halves of 10 s would take ", 0), 0u) << reason;
  for (const char* text : {"of processor time", "1 ms"}) {
    EXPECT_NE(reason.find(text), std::string::npos) << reason;
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
  for (const Mistake mistake : {Mistake::throws_when_trailing, Mistake::throws_after_a_goal}) {
    const Answer examined = check_team_with(mistake, "0.5");
    EXPECT_EQ(examined.exit_code, 1) << examined.report.dump(1);
    const std::string reason = examined.report.value("reason", Json()).dump();
    EXPECT_EQ(reason.rfind("\"knockout", 0), 0u) << reason;
  }
}

struct Allowed {
  Mistake mistake;
  const char* name;
  const char* warning;  // "": there is none
};

class HarmlessTeams : public testing::TestWithParam<Allowed> {};
INSTANTIATE_TEST_SUITE_P(
    Kinds, HarmlessTeams,
    testing::Values(Allowed{Mistake::none, "none", ""},
                    Allowed{Mistake::bad_values, "bad_values", "zeroed or clamped"},
                    Allowed{Mistake::never_moves, "never_moves", "never turned a wheel"},
                    Allowed{Mistake::illegal_places, "illegal_places", "not legal"},
                    Allowed{Mistake::places_in_degrees, "places_in_degrees", "are in radians"},
                    Allowed{Mistake::one_robot_too_many, "one_robot_too_many", "robots are 0 to 2"},
                    Allowed{Mistake::one_wheel, "one_wheel", "to turn its right wheel"},
                    Allowed{Mistake::turns_in_degrees, "turns_in_degrees", "look at angles"},
                    Allowed{Mistake::long_log, "long_log", "logs so much"},
                    Allowed{Mistake::asks_for_a_variable, "asks_for_a_variable",
                            "variable TEAM_MODE"},
                    Allowed{Mistake::tries_a_file, "tries_a_file", "file notes.txt"},
                    Allowed{Mistake::tries_a_thread, "tries_a_thread", "asked for a thread"},
                    Allowed{Mistake::keeps_much_memory, "keeps_much_memory", ""},
                    Allowed{Mistake::measures_time, "measures_time", ""},
                    Allowed{Mistake::not_a_number, "not_a_number", "zeroed or clamped"},
                    Allowed{Mistake::small_counter, "small_counter", "zeroed or clamped"},
                    Allowed{Mistake::opponent_that_is_not_there, "opponent_that_is_not_there", ""},
                    Allowed{Mistake::chance_without_seed, "chance_without_seed", ""},
                    Allowed{Mistake::sets_locale, "sets_locale", ""},
                    Allowed{Mistake::writes_a_file, "writes_a_file", "file notes.txt"},
                    Allowed{Mistake::tries_a_connection, "tries_a_connection", "a connection"},
                    Allowed{Mistake::tries_a_program, "tries_a_program", "program hostname"},
                    Allowed{Mistake::reads_input, "reads_input", "standard input"},
                    Allowed{Mistake::leaks_a_little, "leaks_a_little", ""}),
    [](const auto& c) { return c.param.name; });

TEST_P(HarmlessTeams, AreAccepted) {
  if (is_left_out(GetParam().mistake)) GTEST_SKIP() << "with sanitizers";
  const Answer examined = check_team_with(GetParam().mistake);
  EXPECT_EQ(examined.exit_code, 0) << examined.report["reason"];
  const std::string warnings = examined.report["warnings"].dump();
  if (*GetParam().warning == '\0') {
    EXPECT_EQ(warnings, "[]");
  } else {
    EXPECT_NE(warnings.find(GetParam().warning), std::string::npos) << warnings;
  }
}

// Catches --trusted that dies of a team without a word.
TEST(Trusted, TellsWhichTeamCrashedWhere) {
#ifdef MIROCUP_SANITIZED
  GTEST_SKIP() << "the sanitizer tells it";
#endif
  const auto outcome = test_support::run(
      {program("mirocup"), "match", "--trusted", "--blue", "idle", "--yellow",
       program("teams/mistakes.so"), "--half", "60", "--yellow-param",
       "mistake=" + std::to_string(static_cast<int>(Mistake::null_pointer_late))});
  EXPECT_EQ(outcome.exit_code, 128 + 11);
  EXPECT_NE(outcome.err.find("the yellow team crashed in this process, in decide() of tick 901, by "
                             "Segmentation fault"),
            std::string::npos)
      << outcome.err;
}

}  // namespace
}  // namespace mirocup
