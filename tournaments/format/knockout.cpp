// SPDX-License-Identifier: MIT
#include "tournaments/format/knockout.hpp"

#include "core/base/assert.hpp"

namespace mirocup::league {

std::vector<int> bracket_order(int size) {
  MIROCUP_ASSERT(size > 0 && (size & (size - 1)) == 0);
  // In every round the best left meets the worst left: the pairs of each seed add up to one less
  // than the number of places.
  std::vector<int> order{0};
  while (static_cast<int>(order.size()) < size) {
    const int places = 2 * static_cast<int>(order.size());
    std::vector<int> next;
    for (std::size_t i = 0; i < order.size(); ++i) {
      const int seed = order[i];
      const int other = places - 1 - seed;
      next.push_back(i % 2 == 0 ? seed : other);
      next.push_back(i % 2 == 0 ? other : seed);
    }
    order = next;
  }
  return order;
}

std::vector<Fixture> knockout(const std::vector<TeamSource>& seeds, const KnockoutOptions& options,
                              int first) {
  MIROCUP_ASSERT(seeds.size() >= 2);
  int size = 1;
  while (size < static_cast<int>(seeds.size())) size *= 2;
  std::vector<TeamSource> places;
  for (const int seed : bracket_order(size)) {
    places.push_back(seed < static_cast<int>(seeds.size()) ? seeds[seed] : TeamSource{});
  }
  const auto is_bye = [](const TeamSource& source) {
    return source.kind == TeamSource::Kind::team && source.index == no_team;
  };

  std::vector<Fixture> ties;
  const auto add = [&](int round, int number, const TeamSource& home, const TeamSource& away) {
    Fixture tie;
    tie.round = round;
    tie.number = number;
    tie.part = Part::knockout;
    tie.legs = options.legs;
    tie.home_source = home;
    tie.away_source = away;
    tie.home = home.kind == TeamSource::Kind::team ? home.index : unknown_team;
    tie.away = away.kind == TeamSource::Kind::team ? away.index : unknown_team;
    ties.push_back(tie);
    return first + static_cast<int>(ties.size()) - 1;
  };
  for (int round = 1; places.size() > 1; ++round) {
    std::vector<TeamSource> next;
    int number = 1;
    const bool is_final = places.size() == 2;
    for (std::size_t i = 0; i < places.size(); i += 2) {
      if (is_bye(places[i]) || is_bye(places[i + 1])) {
        next.push_back(is_bye(places[i]) ? places[i + 1] : places[i]);
      } else {
        next.push_back({.kind = TeamSource::Kind::winner,
                        .index = add(round, number, places[i], places[i + 1])});
      }
      ++number;
    }
    const bool are_winners =
        places[0].kind == TeamSource::Kind::winner && places[1].kind == TeamSource::Kind::winner;
    if (is_final && options.third_place && are_winners) {
      add(round, 2, {TeamSource::Kind::loser, places[0].index, 0},
          {TeamSource::Kind::loser, places[1].index, 0});
    }
    places = next;
  }
  return ties;
}

}  // namespace mirocup::league
