// SPDX-License-Identifier: MIT
#include "tournaments/format/schedule.hpp"

#include "core/base/random.hpp"

#include <utility>

namespace mirocup::league {

std::vector<Fixture> round_robin(int teams) {
  // The last place of the circle stays, the others turn by one each round. With an odd number of
  // teams that place is empty: who meets it has the bye.
  const int places = teams + teams % 2;
  std::vector<Fixture> fixtures;
  for (int round = 0; round + 1 < places; ++round) {
    int number = 1;
    for (int pair = 0; pair < places / 2; ++pair) {
      int a = (round + pair) % (places - 1);
      int b = pair == 0 ? places - 1 : (round - pair + places - 1) % (places - 1);
      if (a >= teams || b >= teams) continue;
      const bool swapped = pair == 0 ? round % 2 == 1 : pair % 2 == 1;
      if (swapped) std::swap(a, b);
      fixtures.push_back({round + 1, number++, a, b});
    }
  }
  return fixtures;
}

std::uint64_t fixture_seed(std::uint64_t league_seed, const Fixture& fixture) {
  std::uint64_t seed = mix_seed(league_seed);
  for (const int part : {fixture.round, fixture.home, fixture.away}) {
    seed = mix_seed(seed ^ static_cast<std::uint64_t>(part));
  }
  // JSON readers in other languages hold 53 bits exactly.
  return seed >> 11;
}

}  // namespace mirocup::league
