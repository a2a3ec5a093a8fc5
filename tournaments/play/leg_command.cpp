// SPDX-License-Identifier: MIT
#include "tournaments/play/leg_command.hpp"

#include "core/base/random.hpp"
#include "record/conditions_json.hpp"
#include "record/json_reader.hpp"
#include "record/pitch_json.hpp"
#include "record/rules_json.hpp"
#include "record/team_parameters_json.hpp"
#include "system/locations.hpp"
#include "system/text.hpp"

#include <filesystem>

namespace mirocup::league {

namespace {

void append(std::vector<std::string>& words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
}

// Returns what differs from a preset as options of `mirocup match`: the preset, then KEY=VALUE.
std::vector<std::string> options_of(const std::string& preset_option, const std::string& option,
                                    const Json& own, const Json& preset) {
  std::vector<std::string> options{preset_option, record::text_in(own, "preset")};
  for (const auto& [key, value] : own.items()) {
    if (value == preset.at(key)) continue;
    append(options, {option, key + "=" + record::json_text(value)});
  }
  return options;
}

std::vector<std::string> rule_options(const referee::Rules& rules, RobotLeague league) {
  return options_of("--rules", "--rule", record::to_json(rules),
                    record::to_json(referee::make_rules(rules.preset, league)));
}

std::vector<std::string> condition_options(const match::Conditions& conditions) {
  return options_of("--conditions", "--condition", record::to_json(conditions),
                    record::to_json(match::conditions_of(conditions.preset)));
}

std::string seat_of(const Folder& folder, const LeagueState& state, int team) {
  const TeamConfig& entry = state.file.teams[team];
  if (entry.is_firasim()) return entry.source;
  return entry.over_dds ? "dds:" + entry.name : folder.library(entry.name, state.teams[team].entry);
}

// A team that joins over the network gets its parameters from `mirocup join`.
std::vector<std::string> seat_parameters(const TeamConfig& team, const std::string& option) {
  return team.is_on_network() ? std::vector<std::string>()
                              : record::parameter_options(team.parameters, option);
}

// Returns the parameters of a team as options; none if the league lacks the team.
std::vector<std::string> parameters_of(const LeagueState& state, const std::string& team,
                                       const std::string& option) {
  const auto index = state.find_team(team);
  return index ? seat_parameters(state.file.teams[*index], option) : std::vector<std::string>();
}

// Returns the options of a team that speaks FIRASim's protocol; none for others.
std::vector<std::string> program_options(const Folder& folder, const TeamConfig& team,
                                         const std::string& option) {
  if (team.program.run.empty()) return {};
  const std::filesystem::path place = std::filesystem::path(folder.path) / team.program.folder;
  return {option,
          "cd " + system::shell_word(std::filesystem::absolute(place).lexically_normal().string()) +
              " && " + team.program.run};
}

// Returns where such teams find their match. One that people start looks for it at the addresses of
// the league; those that the match starts are told any that are free.
std::vector<std::string> firasim_options(const LeagueFile& file, const TeamConfig& blue,
                                         const TeamConfig& yellow) {
  if (!blue.is_firasim() && !yellow.is_firasim()) return {};
  const FirasimPlace& place = file.firasim;
  std::vector<std::string> options;
  if (blue.is_started_by_people() || yellow.is_started_by_people()) {
    options = {"--firasim-instance", std::to_string(place.instance),
               "--interface",        place.interface,
               "--join-within",      record::json_text(place.join_within)};
    const auto add = [&](const char* option, const std::string& address) {
      if (!address.empty()) append(options, {option, address});
    };
    add("--firasim-vision", place.vision);
    add("--firasim-command", place.command);
    add("--firasim-referee", place.referee);
    add("--firasim-placement", place.placement);
  } else {
    options = {"--firasim-instance", "auto"};
  }
  if (!blue.lives_by_the_clock() && !yellow.lives_by_the_clock()) options.push_back("--lockstep");
  return options;
}

// Returns the beginning of a command that plays a leg, in which each side has a library or a seat.
std::vector<std::string> match_command(const LeagueFile& file, const FriendlyTerms::Side& blue,
                                       const FriendlyTerms::Side& yellow, std::uint64_t seed) {
  std::vector<std::string> words{system::sibling_program("mirocup"), "match"};
  append(words, {"--blue", blue.library, "--blue-name", blue.name});
  append(words, {"--yellow", yellow.library, "--yellow-name", yellow.name});
  append(words, {"--league", std::string(to_string(file.league)), "--seed", std::to_string(seed)});
  return words;
}

std::vector<std::string> pitch_option(const LeagueFile& file) {
  if (!file.pitch) return {};
  return {"--pitch", record::json_text(record::to_json(*file.pitch))};
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
  const auto [blue, yellow] = fixture.colours(id.leg);
  std::vector<std::string> words =
      match_command(file, {seat_of(folder, state, blue), file.teams[blue].name},
                    {seat_of(folder, state, yellow), file.teams[yellow].name}, leg_seed(state, id));
  append(words, {"--match", match_id, "--record", folder.record(fixture, id.leg, id.version)});
  if (file.keeps_thoughts) words.push_back("--thoughts");
  // With golden goal and shoot-out one team wins.
  if (id.leg > fixture.legs) append(words, {"--stage", "knockout"});
  append(words, rule_options(file.rules, file.league));
  append(words, condition_options(state.conditions));
  append(words, pitch_option(file));
  append(words, seat_parameters(file.teams[blue], "--blue-param"));
  append(words, seat_parameters(file.teams[yellow], "--yellow-param"));
  append(words, program_options(folder, file.teams[blue], "--blue-program"));
  append(words, program_options(folder, file.teams[yellow], "--yellow-program"));
  append(words, firasim_options(file, file.teams[blue], file.teams[yellow]));
  return words;
}

std::vector<std::string> term_options(const LeagueState& state) {
  const LeagueFile& file = state.file;
  const match::Conditions conditions =
      state.is_started ? state.conditions : file.conditions.value_or(default_conditions());
  std::vector<std::string> options = rule_options(file.rules, file.league);
  append(options, condition_options(conditions));
  append(options, pitch_option(file));
  return options;
}

std::vector<std::string> friendly_command(const LeagueState& state, const FriendlyTerms& terms) {
  const LeagueFile& file = state.file;
  std::vector<std::string> words = match_command(file, terms.blue, terms.yellow, terms.seed);
  append(words, {"--record", terms.record});
  if (file.keeps_thoughts) words.push_back("--thoughts");
  append(words, term_options(state));
  append(words, parameters_of(state, terms.blue.name, "--blue-param"));
  append(words, parameters_of(state, terms.yellow.name, "--yellow-param"));
  return words;
}

std::vector<std::string> drills_command(const LeagueState& state, const FriendlyTerms::Side& entry,
                                        const std::string& marks) {
  std::vector<std::string> words{system::sibling_program("mirocup"), "drill", "all"};
  words.push_back(entry.name + "=" + entry.library);
  append(words, {"--tries", "3", "--jobs", "1", "--answer", marks});
  append(words, parameters_of(state, entry.name, "--param"));
  return words;
}

std::string leg_output(const Folder& folder, const LegId& leg) {
  return folder.record(leg.fixture, leg.leg, leg.version) + ".out";
}

std::string leg_answer(const Folder& folder, const LegId& leg) {
  return folder.record(leg.fixture, leg.leg, leg.version) + ".answer";
}

std::uint64_t leg_seed(const LeagueState& state, const LegId& id) {
  std::uint64_t seed = fixture_seed(state.file.seed, id.fixture);
  if (const auto fixture = state.find_fixture(id.fixture.id())) {
    const int number = state.fixtures[*fixture].legs[id.leg - 1].new_seeds;
    for (int i = 0; i < number; ++i) seed = mix_seed(~seed) >> 11;
  }
  // The extra leg of a tie must not repeat the first leg.
  return id.leg > id.fixture.legs ? mix_seed(seed) >> 11 : seed;
}

}  // namespace mirocup::league
