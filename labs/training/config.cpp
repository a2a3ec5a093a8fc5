// SPDX-License-Identifier: MIT
#include "labs/training/config.hpp"

#include "record/conditions_json.hpp"
#include "record/json_reader.hpp"
#include "record/parameters_json.hpp"
#include "record/pitch_json.hpp"
#include "record/rules_json.hpp"
#include "record/situation_json.hpp"
#include "record/team_parameters_json.hpp"
#include "system/files.hpp"
#include "system/locations.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>

namespace mirocup::training {

namespace {

using record::JsonReader;

constexpr int max_matches = 1 << 20;
constexpr int max_threads = 1024;
constexpr int max_ticks_per_step = 1000;

// The name of the configuration in messages.
constexpr const char* what = "configuration";

// Only goals count, and the clock: no call of the referee stops play, and restarts take no time.
void leave_goals_alone(referee::Rules& rules) {
  using referee::off;
  rules.ready_s = 0.0;
  rules.def_max = rules.pa_def_max = rules.att_max = rules.pa_att_max = 0;
  rules.keeper_hold_s = off;
  rules.charge_s = rules.charge_speed_mps = off;
  rules.push_in_m = off;
  rules.block_s = off;
  rules.stalemate_s = off;
  rules.push_dist_m = off;
  rules.collision_mps = off;
  rules.hide_m = off;
  rules.wall_push = false;
  rules.hand_penalty = false;
  rules.kickoff_backward_required = false;
  rules.kickoff_limit_s = off;
}

// The library of a team: a house team, or a file.
std::string library_of(const JsonReader& json, const std::string& team, const std::string& folder) {
  std::string library = system::house_team(team, folder);
  if (!library.empty()) return library;
  std::error_code none;
  if (std::filesystem::exists(team, none)) {
    return team.find('/') == std::string::npos ? "./" + team : team;
  }
  json.complain("\"agent\", \"noise\", a house team or the file of a library is expected, not " +
                json.quoted());
  return "";
}

// "agent", a team, or {"learners": "all" or [0, …], "mates": TEAM, "parameters": {…}}.
Side read_side(const JsonReader& json, int robots, const std::string& folder) {
  Side side;
  const auto everybody = [&] {
    for (int i = 0; i < robots; ++i) side.learners.push_back(i);
  };
  if (json.is_string()) {
    const std::string team = json.text();
    if (team == "agent") {
      everybody();
    } else {
      side.mates = team;
    }
    if (!side.learns() && team != "noise") side.library = library_of(json, team, folder);
    return side;
  }
  json.expect_object({"learners", "mates", "parameters"});
  if (const auto learners = json.find("learners"); learners && learners->is_string()) {
    if (learners->text() == "all") {
      everybody();
    } else {
      learners->complain("\"all\" or a list of robots is expected, not " + learners->quoted());
    }
  } else if (learners) {
    for (const JsonReader& robot : learners->elements(0, static_cast<std::size_t>(robots))) {
      side.learners.push_back(robot.integer<int>(0, robots - 1));
    }
    std::sort(side.learners.begin(), side.learners.end());
    if (std::adjacent_find(side.learners.begin(), side.learners.end()) != side.learners.end()) {
      learners->complain("a robot is named twice");
    }
  }
  json.read_if_present("mates", side.mates);
  if (static_cast<int>(side.learners.size()) < robots && side.mates != "noise") {
    const JsonReader at = json.has("mates") ? json.at("mates") : json;
    side.library = library_of(at, side.mates, folder);
  }
  if (const auto parameters = json.find("parameters")) {
    side.parameters = record::read_team_parameters(*parameters);
    if (side.library.empty())
      parameters->complain("only a library asks for parameters, but no library plays");
  }
  return side;
}

Weights read_weights(const JsonReader& json) {
  Weights weights{};
  for (const auto& [key, value] : json.members()) {
    if (const auto term = from_string<Term>(key)) {
      weights[static_cast<std::size_t>(*term)] = value.number();
    } else {
      value.complain("no term has this name; the terms are " + list_of_names<Term>());
    }
  }
  return weights;
}

referee::Rules read_all_rules(const JsonReader& json, RobotLeague league) {
  const auto rules = json.find("rules");
  if (!rules) return referee::make_rules(referee::Preset::mirosot, league);
  if (rules->is_string()) return referee::make_rules(rules->name<referee::Preset>(), league);
  return record::read_rules(*rules, league);
}

match::Setup read_setup(const JsonReader& json, bool ends_at_goal) {
  constexpr double min_period = 1e-3;
  constexpr double max_period = 1.0;
  match::Setup setup;
  json.read_if_present("league", setup.league);
  setup.rules = read_all_rules(json, setup.league);
  if (json.has("referee")) {
    const JsonReader referee = json.at("referee");
    const std::string kind = referee.text();
    if (kind == "goals") {
      leave_goals_alone(setup.rules);
    } else if (kind != "laws") {
      referee.complain("\"laws\" or \"goals\" is expected, not " + referee.quoted());
    }
  }
  // The law that ends a lopsided leg ends an episode, too.
  if (ends_at_goal) setup.rules.mercy_goal_diff = 1;
  setup.control_period = match::control_period_of(setup.rules.preset);
  if (json.has("pitch") && json.at("pitch").is_string()) {
    match::set_pitch(setup, record::read_pitch(json.at("pitch")));
  }
  if (const auto period = json.find("control_period")) {
    setup.control_period = period->number(min_period, max_period);
  }
  setup.conditions = json.has("conditions") ? record::read_conditions(json.at("conditions"))
                                            : match::conditions_of(match::default_preset);
  return setup;
}

void read_episode(const JsonReader& json, Config& config) {
  json.expect_object({"seconds", "steps", "ends_at_goal"});
  if (json.has("seconds")) {
    const JsonReader seconds = json.at("seconds");
    config.episode_s = seconds.is_null() ? infinity : seconds.positive_number();
  }
  if (const auto steps = json.find("steps"); steps && !steps->is_null()) {
    config.max_steps = steps->integer<std::uint64_t>(1);
  }
  json.read_if_present("ends_at_goal", config.ends_at_goal);
}

// The number in the place of each range: `low` says which end.
nlohmann::ordered_json end_of(const nlohmann::ordered_json& json, const char* end) {
  if (json.is_object() && json.size() == 2 && json.contains("from") && json.contains("to")) {
    return json[end];
  }
  nlohmann::ordered_json result = json;
  for (auto& member : result) {
    if (member.is_structured()) member = end_of(member, end);
  }
  return result;
}

// Both ends of all ranges have to be parameters of the physics.
nlohmann::ordered_json read_pitch_ranges(const JsonReader& json) {
  for (const char* end : {"from", "to"}) {
    const nlohmann::ordered_json numbers = end_of(json.json(), end);
    std::optional<record::JsonProblem> problem;
    simulator::Parameters parameters;
    record::read_physics(JsonReader(numbers, "", problem), parameters);
    if (problem) json.complain(problem->pointer + ": " + problem->reason);
  }
  return json.json();
}

Config read_config(const JsonReader& json, const std::string& folder) {
  Config config;
  json.expect_object({"matches", "threads", "league", "rules", "referee", "control_period",
                      "conditions", "pitch", "blue", "yellow", "agents", "observation", "action",
                      "ticks_per_step", "skip_stops", "episode", "start", "rewards", "autoreset"});
  if (json.has("matches")) config.matches = json.at("matches").integer<int>(1, max_matches);
  if (json.has("threads")) config.threads = json.at("threads").integer<int>(0, max_threads);
  if (const auto episode = json.find("episode")) read_episode(*episode, config);
  config.setup = read_setup(json, config.ends_at_goal);
  if (const auto start = json.find("start")) {
    config.starts = read_starts(*start, config.setup.league, config.ends_at_goal, folder);
  }
  const auto pitch = json.find("pitch");
  if (pitch && !pitch->is_string()) config.pitch = read_pitch_ranges(*pitch);
  json.read_if_present("agents", config.agents);
  json.read_if_present("observation", config.observation);
  json.read_if_present("action", config.action);
  json.read_if_present("autoreset", config.autoreset);
  json.read_if_present("skip_stops", config.skips_stops);
  if (json.has("ticks_per_step")) {
    config.ticks_per_step = json.at("ticks_per_step").integer<int>(1, max_ticks_per_step);
  }
  if (const auto rewards = json.find("rewards")) config.weights = read_weights(*rewards);

  const int robots = field::make_field(config.setup.league).robots_per_team;
  const JsonReader::Json defaults[] = {"agent", "idle"};
  for (const Team team : both_teams) {
    const std::string key(to_string(team));
    std::optional<record::JsonProblem> none;
    const JsonReader other(defaults[index_of(team)], "", none);
    const JsonReader side = json.has(key) ? json.at(key) : other;
    config.sides[index_of(team)] = read_side(side, robots, folder);
    if (none)
      json.complain("the house team idle is missing: the installation of mirocup is not complete");
  }
  const auto& [blue, yellow] = config.sides;
  if (!blue.learns() && !yellow.learns()) json.complain("no robot learns");
  if (config.agents == Agents::team && blue.learns() && yellow.learns() &&
      blue.learners.size() != yellow.learners.size()) {
    json.complain("both teams learn, but with different numbers of robots");
  }
  if (config.observation == ObservationKind::relative && config.agents == Agents::team &&
      std::max(blue.learners.size(), yellow.learners.size()) > 1) {
    json.complain(
        "the observation \"relative\" describes one robot, so it needs \"agents\": \"robot\"");
  }
  return config;
}

using record::JsonReader;
using StartJson = JsonReader::Json;

constexpr std::string_view drill_schema = "mirocup/drill/1";

// The file of a start that is given as text: a path, or the name of a drill.
std::string file_of(const std::string& word, const std::string& folder) {
  system::Disk disk;
  if (word.find('/') == std::string::npos) {
    const std::string drill =
        (std::filesystem::path(system::drill_folder(folder)) / (word + ".json")).string();
    if (disk.exists(drill)) return drill;
  }
  return disk.exists(word) ? word : "";
}

// The league that a document names, and the situation of a drill or the document itself.
StartJson situation_of(const StartJson& document) {
  if (record::text_in(document, "schema") != drill_schema) return document;
  StartJson situation =
      document.contains("situation") ? document["situation"] : StartJson::object();
  if (document.contains("league") && situation.is_object())
    situation["league"] = document["league"];
  return situation;
}

StartRanges read_file(const JsonReader& json, const std::string& folder) {
  StartRanges start{.name = json.text(), .situation = StartJson::object()};
  const std::string path = file_of(start.name, folder);
  if (path.empty()) {
    json.complain("a situation, the name of a drill or a file of one of them is expected, not " +
                  json.quoted());
    return start;
  }
  system::Disk disk;
  const auto text = disk.read_named(path, system::size_limit::note);
  if (!text) {
    json.complain(text.error().what);
    return start;
  }
  record::ParsedJson parsed = record::parse_json(*text);
  if (parsed.problem) {
    json.complain(record::error_of(*parsed.problem, path, Errc::input).what);
    return start;
  }
  start.situation = situation_of(parsed.value);
  return start;
}

StartRanges read_start(const JsonReader& json, const std::string& folder) {
  if (json.is_string()) return read_file(json, folder);
  StartRanges start{.name = "start", .situation = StartJson::object()};
  if (json.expect_object()) start.situation = situation_of(json.json());
  return start;
}

void check(const JsonReader& json, const StartRanges& start, RobotLeague league, bool is_even) {
  Random random(1);
  const auto once = record::draw_situation(start.situation, league, random, start.name);
  if (!once) return json.complain(once.error().what);
  if (once->league != league) json.complain("its situation is of another league than the matches");
  const auto& score = once->start.score;
  if (is_even && score[0] != score[1]) {
    json.complain("with ends_at_goal the score at the start has to be level");
  }
}

}  // namespace

Result<Config> parse_config(std::string_view json, const std::string& folder) {
  record::ParsedJson parsed = record::parse_json(json);
  if (parsed.problem) return tl::unexpected(record::error_of(*parsed.problem, what, Errc::input));
  std::optional<record::JsonProblem> problem;
  Config config = read_config(JsonReader(parsed.value, "", problem), folder);
  if (problem) return tl::unexpected(record::error_of(*problem, what, Errc::input));
  parsed.value.erase("matches");
  parsed.value.erase("threads");
  config.text = record::json_text(parsed.value);
  return config;
}

Result<match::Setup> setup_of(const Config& config, std::uint64_t seed) {
  match::Setup setup = config.setup;
  setup.seed = seed;
  Random random(mix_seed(~seed));  // the leg draws from mix_seed(seed)
  if (!config.starts.empty()) {
    MIROCUP_TRY(setup.start, draw_start(config.starts, setup.league, random));
  }
  if (!config.pitch.is_null()) {
    const nlohmann::ordered_json numbers = record::drawn(config.pitch, random);
    std::optional<record::JsonProblem> none;
    record::read_physics(JsonReader(numbers, "", none), setup.parameters);
    setup.pitch_name = "drawn";  // records keep its numbers
  }
  return setup;
}

std::vector<StartRanges> read_starts(const JsonReader& json, RobotLeague league, bool is_even,
                                     const std::string& folder) {
  std::vector<StartRanges> starts;
  const auto add = [&](const JsonReader& one) {
    starts.push_back(read_start(one, folder));
    check(one, starts.back(), league, is_even);
  };
  if (json.json().is_array()) {
    for (const JsonReader& one : json.elements(1)) add(one);
  } else {
    add(json);
  }
  return starts;
}

Result<match::Start> draw_start(const std::vector<StartRanges>& starts, RobotLeague league,
                                Random& random) {
  const StartRanges& start = starts[random.below(starts.size())];
  MIROCUP_TRY(auto situation, record::draw_situation(start.situation, league, random, start.name));
  return situation.start;
}

}  // namespace mirocup::training
