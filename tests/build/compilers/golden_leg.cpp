// SPDX-License-Identifier: MIT
//
// Plays fixed legs of all three leagues without any foreign code and prints one hash of all their
// ticks. Every compiler, optimisation level and machine must print the hash that
// core/golden_hash.txt has for the conditions, or for teams that ask for places at restarts, many
// of them illegal. Usage: golden_leg [exact|hall|camera|requests]
#include "core/base/random.hpp"
#include "core/match/leg.hpp"
#include "tests/support/controllers.hpp"

#include <cstdio>
#include <string_view>
#include <variant>

using namespace mirocup;

namespace {

// The same team, which in its turn also asks for places near its default ones.
test_support::Scripted with_requests(test_support::Scripted team, std::uint64_t seed) {
  return test_support::Scripted(
      [team, random = Random(seed)](const match::Observation& o) mutable -> match::Answer {
        team.post(o);
        match::Answer answer = team.collect();
        if (!o.placing) return answer;
        auto& command = std::get<match::Command>(answer);
        command.placement = unchanged_request(o);
        for (int i = 0; i < o.robots; ++i) {
          command.placement->robots[i].x += random.uniform(-0.4, 0.4);
          command.placement->robots[i].y += random.uniform(-0.2, 0.2);
        }
        return answer;
      });
}

std::uint64_t hash_of(match::ConditionsPreset preset, bool requests) {
  StateHash all;
  for (const RobotLeague league : {RobotLeague::small, RobotLeague::middle, RobotLeague::large}) {
    auto setup = test_support::short_setup(7, league == RobotLeague::large ? 6.0 : 20.0, league);
    setup.conditions = match::conditions_of(preset);
    if (requests) setup.rules.stalemate_s = 0.5;  // many restarts, of every kind
    match::Leg match(setup);
    auto hunters = test_support::ball_hunter();
    auto others = test_support::random_team(11);
    if (requests) {
      hunters = with_requests(hunters, 5);
      others = with_requests(others, 6);
    }
    test_support::play(match, hunters, others);
    all.add(match.state_hash());
  }
  return all.value();
}

}  // namespace

int main(int count, char** arguments) {
  const std::string_view what = count > 1 ? arguments[1] : "exact";
  const auto preset = from_string<match::ConditionsPreset>(what);
  const auto conditions = preset.value_or(match::ConditionsPreset::exact);
  std::printf("%s\n", to_hex(hash_of(conditions, what == "requests")).c_str());
}
