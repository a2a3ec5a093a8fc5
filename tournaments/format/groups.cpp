// SPDX-License-Identifier: MIT
#include "tournaments/format/groups.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace mirocup::league {

namespace {

// Returns the seeds of the knockout: first all winners of groups, then all seconds, and so on.
// Seeds of equal places are swapped until no team first meets one of its own group.
std::vector<TeamSource> qualified(const std::vector<std::vector<int>>& groups, int qualifiers) {
  std::vector<TeamSource> seeds;
  for (int place = 0; place < qualifiers; ++place) {
    for (int group = 0; group < static_cast<int>(groups.size()); ++group) {
      if (place < static_cast<int>(groups[group].size()))
        seeds.push_back({TeamSource::Kind::place, group, place});
    }
  }
  const int count = static_cast<int>(seeds.size());
  int size = 1;
  while (size < count) size *= 2;
  // Returns the first opponent of a seed: in the first round, or in the second if both have a bye.
  const auto opponent = [&](int seed) {
    const int other = size - 1 - seed;
    if (other < count) return other;
    const int later = size / 2 - 1 - seed;
    return size - 1 - later < count ? no_team : later;
  };
  const auto clashes = [&](int seed) {
    const int other = opponent(seed);
    return other != no_team && other != seed && seeds[seed].index == seeds[other].index;
  };
  for (int seed = count - 1; seed >= 0; --seed) {
    for (int other = count - 1; other >= 0 && clashes(seed); --other) {
      if (other == seed || seeds[other].place != seeds[seed].place) continue;
      std::swap(seeds[seed], seeds[other]);
      if (clashes(seed) || clashes(other)) std::swap(seeds[seed], seeds[other]);
    }
  }
  return seeds;
}

}  // namespace

std::vector<std::vector<int>> deal_groups(int teams, int groups) {
  std::vector<std::vector<int>> dealt(groups);
  for (int team = 0; team < teams; ++team) {
    const int lap = team / groups;
    const int step = team % groups;
    dealt[lap % 2 == 0 ? step : groups - 1 - step].push_back(team);
  }
  return dealt;
}

std::vector<Fixture> groups_then_knockout(int teams, const GroupsOptions& options) {
  const auto groups = deal_groups(teams, options.groups);
  std::vector<Fixture> fixtures;
  for (int group = 0; group < options.groups; ++group) {
    for (Fixture fixture : round_robin(static_cast<int>(groups[group].size()), options.legs)) {
      fixture.part = Part::group;
      fixture.group = group + 1;
      fixture.home = groups[group][fixture.home];
      fixture.away = groups[group][fixture.away];
      fixtures.push_back(fixture);
    }
  }
  std::stable_sort(fixtures.begin(), fixtures.end(), [](const Fixture& a, const Fixture& b) {
    return std::tie(a.round, a.group) < std::tie(b.round, b.group);
  });
  const auto ties = knockout(qualified(groups, options.qualifiers), options.knockout,
                             static_cast<int>(fixtures.size()));
  fixtures.insert(fixtures.end(), ties.begin(), ties.end());
  return fixtures;
}

}  // namespace mirocup::league
