// SPDX-License-Identifier: MIT
//
// SIGKILL for the league, a match server or a strategy's host, at any moment: no leg is lost, none is
// booked twice, the pages are the same. A few kills here; MIROCUP_KILLS=200 build/league_tests
// --gtest_filter='Kills.*' for many. Catches a result that only memory knew, a team that is blamed
// for what the host did.
#include "tests/league/league_command.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <random>
#include <set>
#include <unistd.h>

namespace mirocup {
namespace {

using test_support::expect_same_site;
using test_support::init_league;
using test_support::journal_of;
using test_support::league;
using test_support::read_file;
using test_support::run;
using test_support::Running;
using test_support::TemporaryFolder;

const std::vector<std::string> teams{"a=house:chaser", "b=house:keeper", "c=house:striker"};

void add_children(int pid, std::vector<int>& list) {
  const std::string id = std::to_string(pid);
  std::istringstream children(read_file("/proc/" + id + "/task/" + id + "/children"));
  for (int child = 0; children >> child;) {
    list.push_back(child);
    add_children(child, list);
  }
}

// Plays a league to its end; somebody kills `most` times, one of those who live.
int play_with_kills(const std::string& folder, int most, std::mt19937& random) {
  int kills = 0;
  while (run(league("status", folder)).exit_code != 0) {
    Running running(league("start", folder, {"--jobs", "2"}));
    while (kills < most) {
      usleep(static_cast<useconds_t>(random() % 60'000));
      std::vector<int> alive{running.pid()};
      add_children(running.pid(), alive);
      const int victim = alive[random() % alive.size()];
      // Whoever has ended but was not waited for is no victim.
      if (read_file("/proc/" + std::to_string(running.pid()) + "/cmdline").empty()) break;
      if (::kill(victim, SIGKILL) == 0) ++kills;
      if (victim == running.pid()) break;
    }
    running.wait();
  }
  return kills;
}

TEST(Kills, ChangeNothing) {
  const char* wanted = std::getenv("MIROCUP_KILLS");
  const int most = wanted != nullptr ? std::atoi(wanted) : 6;
  const TemporaryFolder temporary;
  init_league(temporary / "whole/l", teams, "20");
  ASSERT_EQ(run(league("start", temporary / "whole/l")).exit_code, 0);

  std::mt19937 random(1);
  int kills = 0;
  for (int number = 0; kills < most; ++number) {
    const std::string folder = temporary / ("killed" + std::to_string(number) + "/l");
    init_league(folder, teams, "20");
    kills += play_with_kills(folder, most - kills, random);
    ASSERT_EQ(run(league("start", folder)).exit_code, 0);
    std::set<std::string> legs;
    for (const auto& line : journal_of(folder)) {
      if (line["kind"] != "leg") continue;
      const std::string leg = line["fixture"].get<std::string>() + "/" + line["leg"].dump();
      EXPECT_TRUE(legs.insert(leg).second) << leg << " is booked twice";
      EXPECT_TRUE(line["fault"].is_null()) << line;
    }
    EXPECT_EQ(legs.size(), 6u);
    expect_same_site(folder, temporary / "whole/l");
    std::filesystem::remove_all(folder);
  }
  std::printf("%d kills\n", kills);
}

}  // namespace
}  // namespace mirocup
