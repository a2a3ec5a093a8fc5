// SPDX-License-Identifier: MIT
#include "browser/game.hpp"

#include "core/replay/recorded.hpp"
#include "core/replay/verification.hpp"
#include "plugins/abi/convert.hpp"
#include "plugins/abi/drawing.hpp"
#include "record/conditions_json.hpp"
#include "record/json_reader.hpp"
#include "record/pitch_json.hpp"
#include "record/replay_file.hpp"
#include "record/rules_json.hpp"
#include "record/situation_json.hpp"
#include "record/statistics/advice.hpp"

#include <utility>

extern "C" {
// The compiler renames the entry of each team (browser/CMakeLists.txt, which also writes the list
// of the house teams); the sources are unchanged.
#define HOUSE_TEAM(name) const mirocup_strategy* mirocup_entry_##name(void);
#include "house_teams.inc"
#undef HOUSE_TEAM
const mirocup_strategy* mirocup_entry_drill_attacker(void);
const mirocup_strategy* mirocup_entry_drill_crowd(void);
const mirocup_strategy* mirocup_entry_drill_keeper(void);
}

namespace mirocup::browser {

namespace {

match::Setup read_options(const record::JsonReader& json) {
  match::Setup setup;
  json.expect_object(
      {"league", "rules", "stage", "seed", "conditions", "pitch", "situation", "drill", "teams"});
  json.read_if_present("league", setup.league);
  setup.rules = referee::make_rules(referee::Preset::mirosot, setup.league);
  if (json.has("rules")) setup.rules = record::read_rules(json.at("rules"), setup.league);
  json.read_if_present("stage", setup.stage);
  json.read_if_present("seed", setup.seed);
  setup.control_period = match::control_period_of(setup.rules.preset);
  match::PitchSpec pitch = match::pitch_of(match::PitchPreset::mirosot);
  if (json.has("pitch")) pitch = record::read_pitch(json.at("pitch"));
  match::set_pitch(setup, pitch);
  setup.conditions = pitch.conditions.value_or(match::conditions_of(match::default_preset));
  if (json.has("conditions")) setup.conditions = record::read_conditions(json.at("conditions"));
  if (const auto given = json.find("situation")) {
    const record::Situation situation = record::read_situation(*given);
    if (situation.league != setup.league) given->complain("it is of another league");
    setup.start = situation.start;
  }
  return setup;
}

Result<match::Setup> setup_of(const Json& options) {
  std::optional<record::JsonProblem> problem;
  match::Setup setup = read_options(record::JsonReader(options, "", problem));
  if (problem) return tl::unexpected(record::error_of(*problem, "the leg", Errc::input));
  return setup;
}

using Entry = const mirocup_strategy* (*)();
constexpr std::pair<std::string_view, Entry> entries[]{
#define HOUSE_TEAM(name) {#name, mirocup_entry_##name},
#include "house_teams.inc"
#undef HOUSE_TEAM
    {"drill:attacker", mirocup_entry_drill_attacker},
    {"drill:crowd", mirocup_entry_drill_crowd},
    {"drill:keeper", mirocup_entry_drill_keeper},
    {"mine", [] { return outside_team(true); }},
    {"mine, without place()", [] { return outside_team(false); }}};

}  // namespace

Result<record::MatchRecord> read_record(const std::string& text, const std::string& replay,
                                        const std::string& path) {
  MIROCUP_TRY(auto file, record::parse_record(text, path));
  const int robots = field::make_field(file.record.recording.setup.league).robots_per_team;
  MIROCUP_TRY(
      auto unpacked,
      record::read_plain_replay(replay, {.robots = robots, .ticks = file.ticks}, file.replay_name));
  record::add_replay(file.record, std::move(unpacked));
  return std::move(file.record);
}

Result<Json> verify(const std::string& text, const std::string& replay, bool is_whole,
                    const std::string& path) {
  MIROCUP_TRY(const auto record, read_record(text, replay, path));
  std::uint64_t found = 0;
  const auto divergence = replay::verify(record.recording, &found);
  const bool has_other_behaviour = record::has_other_behaviour(record);
  if (!is_whole && (!divergence || has_other_behaviour)) {
    return fail(Errc::damaged, path + ": its text was changed after it was written (sha256)");
  }
  if (divergence && has_other_behaviour)
    return tl::unexpected(record::behaviour_mismatch(path, record, divergence->tick));
  return Json{{"reproduced", !divergence},
              {"tick", divergence ? Json(divergence->tick) : Json()},
              {"what", divergence ? Json(divergence->what) : Json()},
              {"ticks", record.recording.ticks.size()},
              {"state_hash", to_hex(record.recording.state_hash)},
              {"found", to_hex(found)}};
}

void Game::start(const match::Setup& setup) {
  field_ = std::make_unique<field::Field>(field::make_field(setup.league));
  world_ = std::make_unique<simulator::World>(field_.get(), setup.parameters, setup.tolerances,
                                              2 * field_->robots_per_team, true);
  leg_ = std::make_unique<match::Leg>(setup, match::TickLogs::kept, *world_);
}

Result<void> Game::seat(const Json& teams) {
  for (const Team team : both_teams) {
    const auto i = index_of(team);
    const std::string colour(to_string(team));
    std::string name = record::text_in(teams, colour.c_str());
    if (drivers_[i] && name == seated_[i]) continue;
    const bool is_recorded = name == "recorded" && past_ != nullptr;
    const mirocup_strategy* strategy = house_team(name);
    if (!is_recorded && !name.empty() && strategy == nullptr)
      return fail(Errc::input, "teams: " + colour + ": there is no house team \"" + name + "\"");
    const std::string shown = is_recorded ? past_->teams[i].name : name.empty() ? "by hand" : name;
    names_[i] = !drivers_[i] || leg_->tick() == 0 ? shown : names_[i] + ", then " + shown;
    seated_[i] = name;
    drivers_[i] = std::make_unique<Driver>(leg_->briefing(team), strategy,
                                           is_recorded ? &past_->recording : nullptr);
    if (is_watched_) drivers_[i]->watch();
  }
  return {};
}

void Game::take(Team team, int robot, std::optional<simulator::WheelSpeeds> wheels) {
  std::string& name = names_[index_of(team)];
  if (wheels && name.find("by hand") == std::string::npos) name += " and by hand";
  drivers_[index_of(team)]->take(robot, wheels);
}

Result<std::unique_ptr<Game>> Game::make(const Json& options) {
  std::unique_ptr<Game> game(new Game);
  MIROCUP_TRY(auto setup, setup_of(options));
  Json teams = Json::object();
  for (const char* colour : {"blue", "yellow"})
    if (options.contains("teams")) teams[colour] = record::text_in(options["teams"], colour);
  if (const std::string text = record::text_in(options, "drill"); !text.empty()) {
    MIROCUP_TRY(game->drill_, drills::parse_drill(text, "the drill"));
    MIROCUP_TRY(setup, drills::setup_of(*game->drill_, setup.seed));
    teams["yellow"] = game->drill_->opponent;
  }
  game->start(setup);
  MIROCUP_TRY_VOID(game->seat(teams));
  if (game->drill_) game->judge_.emplace(*game->drill_, *game->leg_);
  return game;
}

Result<std::unique_ptr<Game>> Game::go_on(record::MatchRecord past, std::uint32_t tick,
                                          const Json& teams) {
  std::unique_ptr<Game> game(new Game);
  game->past_ = std::make_unique<record::MatchRecord>(std::move(past));
  const replay::Recording& recording = game->past_->recording;
  if (tick >= recording.ticks.size()) return fail(Errc::input, "the leg is over by then");
  game->start(recording.setup);
  match::Leg& leg = *game->leg_;
  while (leg.tick() < tick) {
    const std::uint32_t now = leg.tick();
    leg.advance(replay::recorded_answers(recording, now));
    game->trace_.add(leg);
    if (leg.is_over() || leg.log().back().hash != recording.ticks[now].hash)
      return fail(Errc::damaged, "played again, it differs from tick " + std::to_string(now));
  }
  game->from_ =
      record::PlayedOnFrom{.tick = tick,
                           .state_hash = recording.state_hash,
                           .teams = {game->past_->teams[0].name, game->past_->teams[1].name}};
  MIROCUP_TRY_VOID(game->seat(teams));
  return game;
}

int Game::play(int ticks) {
  int played = 0;
  touches_.impacts.clear();
  for (; played < ticks && !is_over(); ++played) {
    leg_->advance(*drivers_[0], *drivers_[1]);
    trace_.add(*leg_);
    if (judge_) is_decided_ = !judge_->follow();
  }
  return played;
}

void Game::watch() {
  is_watched_ = true;
  world_->set_statistics(&touches_);
  for (const auto& driver : drivers_) driver->watch();
}

void Game::stop() {
  if (!leg_->is_over()) leg_->declare_void("it was stopped by hand");
}

Json Game::situation() const {
  const match::Snapshot now = leg_->snapshot();
  match::Start start{.left = now.left,
                     .ball = now.ball,
                     .robots = {},
                     .restart = {},
                     .phase = now.phase,
                     .clock = now.clock,
                     .score = now.score};
  for (const Team team : both_teams) {
    for (int i = 0; i < leg_->field().robots_per_team; ++i) {
      match::RobotStart& robot = start.robots[index_of(team)][i];
      robot.state = leg_->robot(team, i);
      robot.wheels = leg_->answers()[index_of(team)].speeds(i);
    }
  }
  if (now.state == match::State::READY) {
    start.restart = match::RestartStart{.kind = now.restart,
                                        .taker = now.taker,
                                        .quarter = referee::quarter_of(leg_->restart().spot)};
  }
  return record::to_json(record::Situation{leg_->setup().league, start});
}

Json Game::setup() const {
  const match::Setup& setup = leg_->setup();
  return {{"league", to_string(setup.league)},
          {"rules", record::to_json(setup.rules)},
          {"stage", to_string(setup.stage)},
          {"seed", setup.seed},
          {"conditions", record::to_json(setup.conditions)},
          {"pitch", record::to_json(match::PitchSpec{.name = setup.pitch_name,
                                                     .source = "",
                                                     .parameters = setup.parameters,
                                                     .control_period = setup.control_period,
                                                     .conditions = {}})}};
}

// The referee's counts that may lead to a call (referee::PendingCounts), s.
Json Game::counts() const {
  const match::Snapshot now = leg_->snapshot();
  Json counts{{"stalemate", now.stalemate_s}, {"advantage", now.advantage_s}};
  for (const Team team : both_teams) {
    const referee::TeamCounts& own = now.counts[index_of(team)];
    counts[std::string(to_string(team))] = {{"two defenders in the goal area", own.two_defenders_s},
                                            {"four defenders", own.four_defenders_s},
                                            {"two attackers in the goal area", own.two_attackers_s},
                                            {"ball held by the keeper", own.keeper_hold_s}};
  }
  return counts;
}

Json Game::contacts() const {
  Json impacts = Json::array();
  for (const simulator::Impact& impact : touches_.impacts) {
    impacts.push_back(
        {impact.point.x(), impact.point.y(), impact.normal.x(), impact.normal.y(), impact.impulse});
  }
  Json pressing = Json::array();
  const std::size_t bodies = 2 * static_cast<std::size_t>(field_->robots_per_team) + 1;
  for (std::size_t a = 0; a < bodies; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (touches_.pressing[a][b] || touches_.pressing[b][a]) pressing.push_back({b, a});
    }
    for (std::size_t b = bodies; b < touches_.pressing[a].size(); ++b) {
      if (touches_.pressing[a][b]) pressing.push_back({-1, a});
    }
  }
  return {std::move(impacts), std::move(pressing)};
}

Json Game::status(std::size_t first) const {
  const match::Snapshot now = leg_->snapshot();
  Json decisions = Json::array();
  for (std::size_t i = first; i < leg_->decisions().size(); ++i)
    decisions.push_back(record::to_json(leg_->decisions()[i]));
  Json contacts = this->contacts();
  Json status{{"tick", now.tick},
              {"time", now.time},
              {"clock", now.clock},
              {"state", to_string(now.state)},
              {"phase", to_string(now.phase)},
              {"left", to_string(now.left)},
              {"score", {{"blue", now.score[0]}, {"yellow", now.score[1]}}},
              {"keepers", {now.counts[0].keeper, now.counts[1].keeper}},
              {"counts", counts()},
              {"impacts", std::move(contacts[0])},
              {"pressing", std::move(contacts[1])},
              {"over", is_over()},
              {"decisions", std::move(decisions)}};
  if (leg_->is_over()) status["result"] = record::to_json(leg_->outcome());
  if (judge_) {
    const drills::TryResult result = judge_->result();
    status["drill"] = {{"passed", result.passed},
                       {"marks", result.marks},
                       {"seconds", result.seconds},
                       {"why", result.why}};
  }
  return status;
}

Json Game::advice(Team team) const {
  Json all = Json::array();
  const auto leg = statistics::count_leg("", record());
  if (!leg) return all;
  for (const statistics::TeamTotals& totals : statistics::totals_of({*leg})) {
    if (totals.name != statistics::counted_name(*leg, team)) continue;
    for (const statistics::Advice& one : statistics::advice_for({*leg}, totals))
      all.push_back({{"drill", one.drill},
                     {"why", one.why + (one.moments.empty() ? "" : ": " + one.moments)}});
  }
  return all;
}

record::MatchRecord Game::record() const {
  record::MatchRecord record;
  record.software = record::this_software();
  record.isolation = "none";
  record.from = from_;
  for (const Team team : both_teams) {
    const auto i = index_of(team);
    record.teams[i] = {.name = names_[i], .kind = record::TeamKind::house, .sha256 = {}};
    record.budget[i].late_ticks = leg_->late_ticks()[i];
    record.budget[i].bad_commands = leg_->bad_values()[i];
  }
  record.recording = replay::record(*leg_, trace_);
  return record;
}

const mirocup_strategy* house_team(std::string_view name) {
  for (const auto& [known, entry] : entries) {
    if (known == name) return entry();
  }
  return nullptr;
}

Driver::Driver(const match::Briefing& briefing, const mirocup_strategy* strategy,
               const replay::Recording* recording)
    : team_(briefing.team),
      strategy_(strategy),
      recording_(recording),
      setup_(abi::to_setup(briefing)) {
  give_host();
  if (strategy_ != nullptr) state_ = strategy_->create(&setup_);
}

void Driver::draw(void* driver, const match::Thought& shape) {
  auto& self = *static_cast<Driver*>(driver);
  if (!self.is_watched_ || !match::is_complete(shape.kind, shape.numbers.size()) ||
      !match::is_finite(shape.numbers))
    return;
  self.thoughts_ += self.line_.write(self.now_.tick, shape);
}

void Driver::give_host() {
  setup_.host = this;
  setup_.log = [](void*, const char*) {};
  setup_.parameter = [](void*, const char*, double fallback) { return fallback; };
  abi::give_drawing<draw>(setup_);
}

Driver::~Driver() {
  if (state_ != nullptr && strategy_->destroy != nullptr) strategy_->destroy(state_);
}

void Driver::post(const match::Observation& observation) {
  now_ = abi::to_observation(observation);
  thoughts_.clear();
}

match::Command Driver::own_command() {
  if (state_ == nullptr) {
    if (recording_ == nullptr || now_.tick >= recording_->ticks.size()) return {};
    return std::get<match::Command>(
        replay::recorded_answers(*recording_, now_.tick)[index_of(team_)]);
  }
  std::optional<match::PlacementRequest> poses;
  if (now_.placing != 0 && strategy_->place != nullptr) {
    mirocup_placement placement{};
    placement.ball_x = now_.ball_x;
    placement.ball_y = now_.ball_y;
    for (int i = 0; i < now_.robots; ++i) {
      placement.robots[i] = {now_.own[i].x, now_.own[i].y, now_.own[i].heading};
    }
    strategy_->place(state_, &now_, &placement);
    poses = abi::to_poses(placement);
  }
  mirocup_command decided{};
  strategy_->decide(state_, &now_, &decided);
  match::Command command = abi::to_command(decided);
  command.placement = poses;
  return command;
}

match::Answer Driver::collect() {
  match::Command command = own_command();
  for (std::size_t i = 0; i < by_hand_.size(); ++i) {
    if (by_hand_[i]) command.wheels[i] = *by_hand_[i];
  }
  return command;
}

}  // namespace mirocup::browser
