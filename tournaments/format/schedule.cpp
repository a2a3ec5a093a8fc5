// SPDX-License-Identifier: MIT
#include "tournaments/format/schedule.hpp"

#include "core/base/random.hpp"

#include <algorithm>
#include <utility>

namespace mirocup::league {

std::string Fixture::id() const {
  const std::string text = round_key() + "-f" + std::to_string(number);
  return part == Part::group ? "g" + std::to_string(group) + "-" + text : text;
}

std::string Fixture::round_key() const {
  return (part == Part::knockout ? "k" : "r") + std::to_string(round);
}

std::vector<Fixture> round_robin(int teams) {
  // The last place of the circle stays, the others turn by one place each round. With an odd number
  // of teams that place is empty: the team opposite to it has the bye.
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
      Fixture fixture;
      fixture.round = round + 1;
      fixture.number = number++;
      fixture.home = a;
      fixture.away = b;
      fixtures.push_back(fixture);
    }
  }
  return fixtures;
}

std::vector<Fixture> round_robin(int teams, int legs) {
  const std::vector<Fixture> once = round_robin(teams);
  const int rounds = once.empty() ? 0 : once.back().round;
  std::vector<Fixture> fixtures;
  for (int time = 0; time * legs_per_fixture < legs; ++time) {
    for (Fixture fixture : once) {
      fixture.round += time * rounds;
      fixture.legs = std::min(legs_per_fixture, legs - time * legs_per_fixture);
      if (time % 2 == 1) std::swap(fixture.home, fixture.away);
      fixtures.push_back(fixture);
    }
  }
  return fixtures;
}

std::uint64_t fixture_seed(std::uint64_t league_seed, const Fixture& fixture) {
  std::uint64_t seed = mix_seed(league_seed);
  for (const int part : {fixture.round, fixture.home, fixture.away}) {
    seed = mix_seed(seed ^ static_cast<std::uint64_t>(part));
  }
  // Teams that met in a group meet again with another seed.
  if (fixture.part == Part::knockout) seed = mix_seed(~seed);
  // JSON readers in other languages store numbers as doubles, which are exact up to 53 bits.
  return seed >> 11;
}

std::vector<Fixture> night_fixtures(int night, const std::vector<int>& teams, int opponents) {
  const int count = static_cast<int>(teams.size());
  std::vector<Fixture> fixtures;
  if (count < 2) return fixtures;
  const int rounds = count % 2 == 0 ? count - 1 : count;
  const int wanted = opponents == 0 ? rounds : std::min(opponents, rounds);
  const std::int64_t first = std::int64_t{night - 1} * wanted % rounds;
  for (Fixture fixture : round_robin(count)) {
    if (fixture.away == no_team || fixture.home == no_team) continue;
    if ((fixture.round - 1 - first + rounds) % rounds >= wanted) continue;
    fixture.round = night;
    fixture.number = static_cast<int>(fixtures.size()) + 1;
    fixture.home = teams[fixture.home];
    fixture.away = teams[fixture.away];
    fixtures.push_back(fixture);
  }
  return fixtures;
}

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
