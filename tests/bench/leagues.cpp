// SPDX-License-Identifier: MIT
#include "tests/bench/leagues.hpp"

#include "tests/bench/programs.hpp"

#include <array>
#include <unistd.h>

namespace mirocup::bench {

namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 3> houses{"striker", "chaser", "keeper"};

// Seconds on the wall from the first leg to the last page.
std::optional<double> play_league(const std::string& program, const fs::path& teams,
                                  const fs::path& folder, int jobs) {
  std::vector<std::string> init{program,  "league", "init",   folder.string(),
                                "--half", "300",    "--seed", "1"};
  for (int i = 0; i < league_teams; ++i) {
    const std::string house = houses[static_cast<std::size_t>(i) % houses.size()];
    init.push_back("--team");
    init.push_back("t" + std::to_string(i) + "=" + (teams / (house + ".so")).string());
  }
  if (!run(std::move(init), Cores::all)) return std::nullopt;
  const auto times = run(
      {program, "league", "start", folder.string(), "--jobs", std::to_string(jobs)}, Cores::all);
  if (!times) return std::nullopt;
  return times->wall_seconds;
}

}  // namespace

std::optional<LeagueTimes> play_leagues() {
  const fs::path program = program_beside("mirocup");
  const fs::path teams = program_beside("house");
  const ScratchFolder folder;
  if (sysconf(_SC_NPROCESSORS_ONLN) < 2 || !fs::exists(program) || !fs::exists(teams) ||
      folder.path().empty()) {
    return std::nullopt;
  }
  const auto one = play_league(program, teams, folder.path() / "one", 1);
  const auto two = play_league(program, teams, folder.path() / "two", 2);
  if (!one || !two) return std::nullopt;
  return LeagueTimes{*one, *two};
}

}  // namespace mirocup::bench
