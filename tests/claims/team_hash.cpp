// SPDX-License-Identifier: MIT
//
// Prints the hash of what each house team decides in moments that are drawn, as JSON: teams of the
// small and the middle league, under the rules of each preset. Usage: team_hash FOLDER
#include "core/base/state_hash.hpp"
#include "plugins/abi/convert.hpp"
#include "plugins/host/team_host.hpp"
#include "tests/support/controllers.hpp"
#include "tests/support/moments.hpp"

#include <cstdio>
#include <filesystem>
#include <set>
#include <string>

using namespace mirocup;

namespace {

constexpr int moments = 200;

std::uint64_t hash_in(RobotLeague league, referee::Preset preset, const std::string& library) {
  match::Setup rules = test_support::short_setup(7, 60.0, league);
  rules.rules = referee::make_rules(preset, league);
  rules.control_period = match::control_period_of(preset);
  const match::Leg leg(rules);
  mirocup_setup setup = abi::to_setup(leg.briefing(Team::blue));
  plugins::ParameterTable parameters{};
  plugins::AskedRows asked{};
  plugins::TeamHost host{.table = &parameters, .asked = &asked};
  plugins::give_host(setup, host);
  auto team = plugins::Plugin::load(library, setup);
  return team ? test_support::hash_of_decisions(*team, setup.robots, moments) : 0;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return std::fprintf(stderr, "usage: team_hash FOLDER\n"), 2;
  std::set<std::filesystem::path> libraries;
  for (const auto& entry : std::filesystem::directory_iterator(arguments[1])) {
    if (entry.path().extension() == ".so") libraries.insert(entry.path());
  }
  const char* before = "{";
  for (const auto& path : libraries) {
    StateHash all;
    for (const RobotLeague league : {RobotLeague::small, RobotLeague::middle}) {
      for (std::size_t preset = 0; preset < enum_names<referee::Preset>.size(); ++preset) {
        const std::uint64_t hash =
            hash_in(league, static_cast<referee::Preset>(preset), path.string());
        if (hash == 0) return std::fprintf(stderr, "%s does not play\n", path.c_str()), 1;
        all.add(hash);
      }
    }
    std::printf("%s\"%s\": {\"hash\": \"%s\"}", before, path.stem().c_str(),
                to_hex(all.value()).c_str());
    before = ", ";
  }
  std::printf("}\n");
}
