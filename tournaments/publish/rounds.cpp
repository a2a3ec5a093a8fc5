// SPDX-License-Identifier: MIT
#include "tournaments/publish/rounds.hpp"

#include <algorithm>
#include <map>

namespace mirocup::league {

namespace {

std::string title_of(const LeagueState& state, const Fixture& f) {
  if (f.part == Part::group) return "Round " + std::to_string(f.round) + " of the groups";
  return round_in_words(state, f);
}

}  // namespace

std::string fixture_link(const Fixture& fixture) {
  return "rounds/" + fixture.round_key() + ".html#" + fixture.id();
}

std::vector<RoundView> rounds_of(const Overview& o) {
  std::map<std::string, std::vector<const LegView*>> legs;
  for (const LegView& leg : o.legs) legs[leg.fixture].push_back(&leg);
  std::vector<const FixtureState*> fixtures;
  for (const FixtureState& f : o.state.fixtures) fixtures.push_back(&f);
  std::ranges::stable_sort(fixtures, {},
                           [](const FixtureState* f) { return f->fixture.round_order(); });
  std::vector<RoundView> rounds;
  for (const FixtureState* f : fixtures) {
    const std::string key = f->fixture.round_key();
    if (rounds.empty() || rounds.back().key != key) {
      rounds.emplace_back();
      rounds.back().key = key;
      rounds.back().title = title_of(o.state, f->fixture);
    }
    RoundView& round = rounds.back();
    if (!f->fixture.has_both()) continue;
    round.fixtures.push_back({f, legs[f->fixture.id()]});
    for (const LegView* leg : round.fixtures.back().legs) {
      ++round.legs;
      if (leg->played == nullptr) continue;
      ++round.decided;
      round.goals += leg->played->result.home_goals + leg->played->result.away_goals;
    }
  }
  return rounds;
}

}  // namespace mirocup::league
