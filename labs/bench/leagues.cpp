// SPDX-License-Identifier: MIT
#include "labs/bench/leagues.hpp"

#include "labs/bench/programs.hpp"
#include "system/locations.hpp"
#include "tests/support/temporary_folder.hpp"

#include <array>
#include <filesystem>
#include <unistd.h>

namespace mirocup::bench {

namespace {

constexpr std::array<const char*, 3> houses{"striker", "chaser", "keeper"};

// Wall time from the first leg to the last page, s.
std::optional<double> play_league(const std::string& program, const std::string& folder, int jobs) {
  std::vector<std::string> init{program, "league", "init", folder, "--half", "300", "--seed", "1"};
  for (int i = 0; i < league_teams; ++i) {
    const std::string house = houses[static_cast<std::size_t>(i) % houses.size()];
    init.push_back("--team");
    init.push_back("t" + std::to_string(i) + "=" + system::house_team(house));
  }
  if (!run(std::move(init), Cores::all)) return std::nullopt;
  const auto times =
      run({program, "league", "start", folder, "--jobs", std::to_string(jobs)}, Cores::all);
  if (!times) return std::nullopt;
  return times->wall_seconds;
}

}  // namespace

std::optional<LeagueTimes> play_leagues() {
  const std::string program = system::sibling_program("mirocup");
  if (sysconf(_SC_NPROCESSORS_ONLN) < 2 || !std::filesystem::exists(program)) return std::nullopt;
  const test_support::TemporaryFolder folder;
  const auto one = play_league(program, folder / "one", 1);
  const auto two = play_league(program, folder / "two", 2);
  if (!one || !two) return std::nullopt;
  return LeagueTimes{*one, *two};
}

}  // namespace mirocup::bench
