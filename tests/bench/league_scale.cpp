// SPDX-License-Identifier: MIT
//
// How schedule, journal state and table grow with the number of teams: build/bench/league_scale. A
// double round robin of made-up results, in seconds.
#include "core/base/random.hpp"
#include "tournaments/league/apply.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>

using namespace mirocup;
using namespace mirocup::league;

namespace {

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

std::vector<LegResult> season(const std::vector<Fixture>& fixtures) {
  Random random(1);
  std::vector<LegResult> results;
  for (const Fixture& f : fixtures) {
    for (int leg = 0; leg < f.legs; ++leg) {
      LegResult r;
      r.home = f.home;
      r.away = f.away;
      r.home_goals = static_cast<int>(random.below(4));
      r.away_goals = static_cast<int>(random.below(4));
      results.push_back(r);
    }
  }
  return results;
}

void measure(int teams) {
  auto begin = std::chrono::steady_clock::now();
  const std::vector<Fixture> fixtures = round_robin(teams);
  const double schedule = seconds_since(begin);

  const std::vector<LegResult> results = season(fixtures);
  begin = std::chrono::steady_clock::now();
  const auto table = make_table(all_teams(teams), results, {});
  const double ranking = seconds_since(begin);

  LeagueFile file;
  for (int i = 0; i < teams; ++i)
    file.teams.push_back({"t" + std::to_string(i), "house:idle", false});
  begin = std::chrono::steady_clock::now();
  const LeagueState state = new_league(file);
  const double opened = seconds_since(begin);
  std::printf("%6d %10d %10.4f %10.4f %10.4f\n", teams, state.legs(), schedule, ranking, opened);
}

}  // namespace

int main() {
  std::printf("%6s %10s %10s %10s %10s\n", "teams", "legs", "schedule", "table", "open");
  for (const int teams : {30, 100, 300, 1000}) measure(teams);
  return EXIT_SUCCESS;
}
