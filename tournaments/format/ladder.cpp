// SPDX-License-Identifier: MIT
#include "tournaments/format/ladder.hpp"

#include "core/base/random.hpp"

#include <algorithm>
#include <utility>

namespace mirocup::league {

std::vector<Fixture> ladder_fixtures(int event, int team, const std::vector<int>& others,
                                     int sample, std::uint64_t league_seed) {
  std::vector<int> drawn = others;
  Random random(mix_seed(league_seed ^ mix_seed(static_cast<std::uint64_t>(event))));
  const int count = std::min<int>(sample, static_cast<int>(drawn.size()));
  std::vector<Fixture> fixtures;
  for (int i = 0; i < count; ++i) {
    const auto other = static_cast<std::size_t>(i) + random.below(drawn.size() - i);
    std::swap(drawn[i], drawn[other]);
    Fixture fixture;
    fixture.round = event;
    fixture.number = i + 1;
    fixture.home = team;
    fixture.away = drawn[i];
    fixtures.push_back(fixture);
  }
  return fixtures;
}

}  // namespace mirocup::league
