// SPDX-License-Identifier: MIT
//
// Plays fixed legs of all three leagues without any foreign code and prints one hash of all their
// ticks. Every compiler, optimisation level and machine must print the hash in
// core/golden_hash.txt.
#include "core/base/random.hpp"
#include "core/match/leg.hpp"
#include "tests/support/controllers.hpp"

#include <cstdio>

using namespace mirocup;

int main() {
  StateHash all;
  for (const League league : {League::small, League::middle, League::large}) {
    match::Leg match(test_support::short_setup(7, league == League::large ? 6.0 : 20.0, league));
    auto hunters = test_support::ball_hunter();
    auto others = test_support::random_team(11);
    test_support::play(match, hunters, others);
    all.add(match.state_hash());
  }
  std::printf("%s\n", to_hex(all.value()).c_str());
}
