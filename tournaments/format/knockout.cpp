// SPDX-License-Identifier: MIT
#include "tournaments/format/knockout.hpp"

namespace mirocup::league {

std::vector<int> bracket_order(int size) {
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

std::vector<Fixture> knockout(const std::vector<Slot>& seeds, const KnockoutOptions& options,
                              int first) {
  int size = 1;
  while (size < static_cast<int>(seeds.size())) size *= 2;
  std::vector<Slot> places;
  for (const int seed : bracket_order(size)) {
    places.push_back(seed < static_cast<int>(seeds.size()) ? seeds[seed] : Slot{});
  }
  const auto is_bye = [](const Slot& slot) {
    return slot.from == Slot::From::team && slot.index == nobody;
  };

  std::vector<Fixture> ties;
  const auto add = [&](int round, int number, const Slot& home, const Slot& away) {
    Fixture tie;
    tie.round = round;
    tie.number = number;
    tie.part = Part::knockout;
    tie.legs = options.legs;
    tie.home_from = home;
    tie.away_from = away;
    tie.home = home.from == Slot::From::team ? home.index : unknown;
    tie.away = away.from == Slot::From::team ? away.index : unknown;
    ties.push_back(tie);
    return first + static_cast<int>(ties.size()) - 1;
  };
  for (int round = 1; places.size() > 1; ++round) {
    std::vector<Slot> next;
    int number = 1;
    const bool is_final = places.size() == 2;
    for (std::size_t i = 0; i < places.size(); i += 2) {
      if (is_bye(places[i]) || is_bye(places[i + 1])) {
        next.push_back(is_bye(places[i]) ? places[i + 1] : places[i]);
      } else {
        next.push_back({Slot::From::winner, add(round, number, places[i], places[i + 1]), 0});
      }
      ++number;
    }
    const bool are_winners =
        places[0].from == Slot::From::winner && places[1].from == Slot::From::winner;
    if (is_final && options.third_place && are_winners) {
      add(round, 2, {Slot::From::loser, places[0].index, 0},
          {Slot::From::loser, places[1].index, 0});
    }
    places = next;
  }
  return ties;
}

}  // namespace mirocup::league
