// SPDX-License-Identifier: MIT
//
// Catches tasks of another league that are cancelled or waited for, and a queue that is misread.
#include "tournaments/play/slurm.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace mirocup::league {
namespace {

bool has(const CommandLine& command, const std::string& word) {
  return std::find(command.begin(), command.end(), word) != command.end();
}

TEST(Slurm, FindsTheTasksOfItsLeagueInTheQueue) {
  const auto tasks = parse_queue(
      "mirocup-0123456789ab-2     17     3     RUNNING     0\n"
      "mirocup-0123456789ab-2     17     4     PENDING     1\n"
      "mirocup-ffffffffffff-2     18     1     RUNNING     0\n"
      "simulation                 19     1     RUNNING     0\n"
      "mirocup-0123456789ab-x     20     1     RUNNING     0\n"
      "mirocup-0123456789ab-3     21     N/A   RUNNING     0\n"
      "squeue: error: something else was on its mind\n"
      "\n",
      "0123456789ab");
  ASSERT_EQ(tasks.size(), 2u);
  EXPECT_EQ(tasks[0].id, "17_3");
  EXPECT_EQ(tasks[0].plan, 2);
  EXPECT_EQ(tasks[0].line, 3);
  EXPECT_TRUE(tasks[0].is_running);
  EXPECT_FALSE(tasks[1].is_running);
  EXPECT_EQ(tasks[1].restarts, 1);
}

TEST(Slurm, IsToldWhatToRunAndWhere) {
  const CommandLine command = sbatch_command({.league = "0123456789ab",
                                              .plan = 2,
                                              .tasks = 7,
                                              .max_running = 3,
                                              .log = "/l/100%/cluster/2",
                                              .shard = {"shard.sh", "a b"}});
  EXPECT_TRUE(has(command, "--requeue"));
  EXPECT_TRUE(has(command, "--job-name=mirocup-0123456789ab-2"));
  EXPECT_TRUE(has(command, "--array=1-7%3"));
  EXPECT_TRUE(has(command, "--output=/l/100%%/cluster/2-%a.log")) << "the folder's % stays one";
  EXPECT_EQ(command.back(), "a b");
}

TEST(Slurm, IsInterruptedOnlyWhereALegMayComeToItsEnd) {
  EXPECT_TRUE(has(scancel_command({"17_3"}, CancelScope::after_leg), "--signal=INT"));
  EXPECT_TRUE(has(scancel_command({"17_3"}, CancelScope::pending), "--state=PENDING"));
  EXPECT_EQ(scancel_command({"17_3"}, CancelScope::all), (CommandLine{"scancel", "17_3"}));
}

TEST(Slurm, SaysHowManyProcessorsCanPlay) {
  EXPECT_EQ(parse_processors("4/8/2/14\n"), 12);
  EXPECT_EQ(parse_processors("0/2/0/2\n1/3/0/4\n"), 4);
  EXPECT_EQ(parse_processors("sinfo: no\n"), 0);
}

}  // namespace
}  // namespace mirocup::league
