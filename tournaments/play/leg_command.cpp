// SPDX-License-Identifier: MIT
#include "tournaments/play/leg_command.hpp"

#include "core/base/random.hpp"
#include "server/record/rules_json.hpp"
#include "server/system/locations.hpp"

#include <nlohmann/json.hpp>

namespace mirocup::league {

namespace {

// Returns the rules that differ from their preset as options of `mirocup match`.
std::vector<std::string> rule_options(const referee::Rules& rules, League league) {
  std::vector<std::string> options{"--rules", std::string(to_string(rules.preset))};
  const Json preset = record::to_json(referee::make_rules(rules.preset, league));
  const Json own = record::to_json(rules);
  for (const auto& [key, value] : own.items()) {
    if (value == preset.at(key)) continue;
    options.push_back("--rule");
    options.push_back(key + "=" + value.dump());
  }
  return options;
}

std::string seat_of(const Folder& folder, const LeagueState& state, int team) {
  const TeamConfig& entry = state.file.teams[team];
  return entry.over_dds ? "dds:" + entry.name : folder.library(entry.name, state.teams[team].entry);
}

}  // namespace

std::vector<int> open_legs(const LeagueState& state, const FixtureState& f) {
  if (!f.fixture.has_both()) return {};
  for (const int team : {f.fixture.home, f.fixture.away}) {
    if (state.teams[team].status != TeamStatus::playing) return {};
  }
  std::vector<int> legs;
  for (int leg = 1; leg <= f.needed(); ++leg) {
    if (!f.legs[leg - 1].played) legs.push_back(leg);
  }
  return legs;
}

std::vector<std::string> leg_command(const Folder& folder, const LeagueState& state,
                                     const LegId& id, const std::string& match_id) {
  const Fixture& fixture = id.fixture;
  const LeagueFile& file = state.file;
  const int blue = blue_team(fixture, id.leg);
  const int yellow = blue == fixture.home ? fixture.away : fixture.home;
  std::vector<std::string> arguments{system::sibling_program("mirocup"),
                                     "match",
                                     "--blue",
                                     seat_of(folder, state, blue),
                                     "--blue-name",
                                     file.teams[blue].name,
                                     "--yellow",
                                     seat_of(folder, state, yellow),
                                     "--yellow-name",
                                     file.teams[yellow].name,
                                     "--league",
                                     std::string(to_string(file.league)),
                                     "--seed",
                                     std::to_string(leg_seed(state, id)),
                                     "--match",
                                     match_id,
                                     "--record",
                                     folder.record(fixture, id.leg, id.version)};
  if (id.leg > fixture.legs) {
    // With golden goal and shoot-out one team wins.
    arguments.insert(arguments.end(), {"--stage", "knockout"});
  }
  const std::vector<std::string> rules = rule_options(file.rules, file.league);
  arguments.insert(arguments.end(), rules.begin(), rules.end());
  return arguments;
}

std::string leg_output(const Folder& folder, const LegId& leg) {
  return folder.record(leg.fixture, leg.leg, leg.version) + ".out";
}

std::uint64_t leg_seed(const LeagueState& state, const LegId& id) {
  const std::uint64_t seed = fixture_seed(state.file.seed, id.fixture);
  // The extra leg of a tie must not repeat the first leg.
  return id.leg > id.fixture.legs ? mix_seed(seed) >> 11 : seed;
}

}  // namespace mirocup::league
