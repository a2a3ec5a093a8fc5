// SPDX-License-Identifier: MIT
//
// Plays fixed legs of all three leagues without any foreign code and prints one hash of all their
// ticks. Every compiler, optimisation level and machine must print the hash that
// core/golden_hash.txt has for the conditions. Usage: golden_leg [exact|hall|camera]
#include "core/base/random.hpp"
#include "core/match/leg.hpp"
#include "tests/support/controllers.hpp"

#include <cstdio>

using namespace mirocup;

namespace {

std::uint64_t hash_under(match::ConditionsPreset preset) {
  StateHash all;
  for (const League league : {League::small, League::middle, League::large}) {
    auto setup = test_support::short_setup(7, league == League::large ? 6.0 : 20.0, league);
    setup.conditions = match::conditions_of(preset);
    match::Leg match(setup);
    auto hunters = test_support::ball_hunter();
    auto others = test_support::random_team(11);
    test_support::play(match, hunters, others);
    all.add(match.state_hash());
  }
  return all.value();
}

}  // namespace

int main(int count, char** arguments) {
  const auto preset = count > 1 ? from_string<match::ConditionsPreset>(arguments[1]) : std::nullopt;
  const auto conditions = preset.value_or(match::ConditionsPreset::exact);
  std::printf("%s\n", to_hex(hash_under(conditions)).c_str());
}
