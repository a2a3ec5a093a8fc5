// SPDX-License-Identifier: MIT
//
// SIGKILL for the league, a match server and a strategy's host, at any moment: no leg is lost, none
// is booked twice, the pages are the same. A few kills here; MIROCUP_KILLS=200 build/league_tests
// --gtest_filter='Kills.*' for many. Catches a result that only memory knew,
// a team that is blamed for what the host did, half a page that stays.
#include "tests/programs/league/league_command.hpp"

#include <gtest/gtest.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <set>
#include <unistd.h>

namespace mirocup {
namespace {

using namespace test_support;

const std::vector<std::string> teams{"a=house:chaser", "b=house:keeper", "c=house:striker"};

// Generations of processes: the league, its match servers, their strategy hosts.
constexpr std::size_t generations = 3;
using Living = std::array<std::vector<int>, generations>;

void add_living(int pid, std::size_t generation, Living& living) {
  const std::string id = std::to_string(pid);
  // A zombie process is not a victim.
  if (generation >= generations || read_file("/proc/" + id + "/cmdline").empty()) return;
  living[generation].push_back(pid);
  std::istringstream children(read_file("/proc/" + id + "/task/" + id + "/children"));
  for (int child = 0; children >> child;) add_living(child, generation + 1, living);
}

struct Kills {
  std::array<int, generations> of{};

  int all() const { return of[0] + of[1] + of[2]; }
};

// Plays a league to its end; kills it at random moments, each generation in turn, until
// `most` were killed.
void play_with_kills(const std::string& folder, int most, std::mt19937& random, Kills& kills) {
  while (run(league("status", folder)).exit_code != 0) {
    Running running(league("start", folder, {"--jobs", "2"}));
    while (kills.all() < most) {
      // Most kills come early in a leg, some after several legs have been played.
      usleep(static_cast<useconds_t>(random() % (1 + random() % 400'000)));
      Living living;
      add_living(running.pid(), 0, living);
      if (living[0].empty()) break;
      const std::size_t generation = static_cast<std::size_t>(kills.all()) % generations;
      const std::vector<int>& victims = living[generation];
      if (victims.empty() || ::kill(victims[random() % victims.size()], SIGKILL) != 0) continue;
      ++kills.of[generation];
      if (generation == 0) break;
    }
    running.wait();
  }
}

TEST(Kills, ChangeNothing) {
  const char* wanted = std::getenv("MIROCUP_KILLS");
  const int most = wanted != nullptr ? std::atoi(wanted) : 6;
  const TemporaryFolder temporary;
  init_league(temporary / "whole/l", teams, "20");
  ASSERT_EQ(run(league("start", temporary / "whole/l")).exit_code, 0);

  std::mt19937 random(1);
  Kills kills;
  int leagues = 0;
  int voids = 0;
  for (; kills.all() < most; ++leagues) {
    const std::string folder = temporary / ("killed" + std::to_string(leagues) + "/l");
    init_league(folder, teams, "20");
    play_with_kills(folder, most, random, kills);
    // A process that is killed between writing and renaming leaves a temporary file.
    write_file(folder + "/site/replays/r1-1.html.unfinished-" + std::string(32, '1'), "<html>");
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
    voids += count_kind(folder, "void");
    std::filesystem::remove_all(folder);
  }
  std::printf(
      "killed: %d leagues, %d match servers, %d strategies' hosts, in %d plays of a league; %d "
      "attempts void\n",
      kills.of[0], kills.of[1], kills.of[2], leagues, voids);
}

}  // namespace
}  // namespace mirocup
