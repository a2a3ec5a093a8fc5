// SPDX-License-Identifier: MIT
#include "server/record/match_record.hpp"

#include "server/record/replay_file.hpp"
#include "server/record/rules_json.hpp"
#include "server/system/digest.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <utility>

namespace mirocup::record {

namespace {

constexpr std::string_view schema = "mirocup/match/1";

// What a program that plays matches can be asked for, s.
constexpr double shortest_period = 1e-3;
constexpr double longest_period = 1.0;
constexpr double longest_half = 36000.0;

Json score_json(const match::ByTeam<int>& score) {
  return {{"blue", score[0]}, {"yellow", score[1]}};
}

Json optional_name(const std::optional<Team>& team) {
  return team ? Json(to_string(*team)) : Json();
}

Json fault_json(const match::TeamFault& f) {
  return {{"team", to_string(f.team)}, {"code", to_string(f.fault.code)}, {"text", f.fault.text}};
}

Json robots_json(const match::ByTeam<referee::RobotSet>& robots) {
  Json json = Json::object();
  for (const Team team : both_teams) {
    Json& list = json[std::string(to_string(team))] = Json::array();
    for (int i = 0; i < max_robots_per_team; ++i) {
      if (robots[index_of(team)][i]) list.push_back(i);
    }
  }
  return json;
}

}  // namespace

Json to_json(const match::Outcome& result) {
  Json faults = Json::array();
  for (const match::TeamFault& f : result.faults) faults.push_back(fault_json(f));
  return {{"score", score_json(result.score)},
          {"played", score_json(result.played)},
          {"shoot_out", result.shoot_out ? score_json(*result.shoot_out) : Json()},
          {"winner", optional_name(result.winner)},
          {"end", to_string(result.kind)},
          {"fault", faults.empty() ? Json() : faults.front()},
          {"faults", faults},
          {"why_void", result.why_void.empty() ? Json() : Json(result.why_void)}};
}

Json to_json(const match::LoggedDecision& d) {
  const bool restarts = d.decision.restart != referee::Restart::none;
  return {{"tick", d.tick},
          {"clock", d.decision.clock},
          {"law", to_string(d.decision.law)},
          {"decision", to_string(d.decision.verdict)},
          {"team", optional_name(d.team)},
          {"robots", robots_json(d.robots)},
          {"reason", d.decision.reason},
          {"ball", {d.decision.ball.x(), d.decision.ball.y()}},
          {"restart", restarts ? Json(to_string(d.decision.restart)) : Json()},
          {"taker", restarts ? Json(to_string(d.taker)) : Json()}};
}

namespace {

Json team_json(const TeamInfo& team) {
  return {{"name", team.name},
          {"kind", to_string(team.kind)},
          {"sha256", team.sha256 ? Json(*team.sha256) : Json()}};
}

Json budget_json(const Budget& b) {
  return {{"cpu_seconds", b.cpu_seconds},
          {"slowest_tick_ms", b.slowest_tick_ms},
          {"bank_seconds", b.bank_seconds},
          {"late_ticks", b.late_ticks},
          {"bad_commands", b.bad_commands}};
}

Json durations_json(const pace::Durations& durations) {
  Json histogram = Json::array();
  for (const auto& range : durations.histogram()) {
    histogram.push_back({range.below, range.count});
  }
  return {{"p50", durations.quantile(0.5)},
          {"p99", durations.quantile(0.99)},
          {"p999", durations.quantile(0.999)},
          {"longest", durations.longest()},
          {"histogram", histogram}};
}

Json pace_json(const std::optional<PaceReport>& report) {
  if (!report) return {};
  return {{"period", report->period}, {"lateness", durations_json(report->lateness)}};
}

Json network_json(const std::optional<NetworkReport>& report) {
  if (!report) return {};
  Json absences = Json::array();
  for (const NetworkReport::Absence& a : report->absences) {
    absences.push_back({{"tick", a.tick},
                        {"noticed", a.noticed},
                        {"back", a.back ? Json(*a.back) : Json()},
                        {"why", a.has_left ? "left" : "silent"}});
  }
  return {{"in_step", report->in_step},     {"late", report->late},
          {"duplicate", report->duplicate}, {"ahead", report->ahead},
          {"foreign", report->foreign},     {"processes", report->processes},
          {"absences", absences},           {"answers", durations_json(report->answers)}};
}

Json network_json(const match::ByTeam<std::optional<NetworkReport>>& reports) {
  return {{"blue", network_json(reports[0])}, {"yellow", network_json(reports[1])}};
}

// What a record says that cannot be; caught in load().
struct Damage {
  std::string where;
};

template <class E>
E named(const Json& json) {
  const auto value = from_string<E>(json.get<std::string>());
  if (!value)
    throw Damage{"\"" + json.get<std::string>() + "\" is not one of " + list_of_names<E>()};
  return *value;
}

match::ByTeam<int> score_of(const Json& json) {
  return {json.at("blue").get<int>(), json.at("yellow").get<int>()};
}

std::optional<Team> optional_team(const Json& json) {
  if (json.is_null()) return std::nullopt;
  return named<Team>(json);
}

match::Outcome result_of(const Json& json) {
  match::Outcome result;
  result.score = score_of(json.at("score"));
  result.played = score_of(json.at("played"));
  if (json.contains("shoot_out") && !json.at("shoot_out").is_null())
    result.shoot_out = score_of(json.at("shoot_out"));
  result.winner = optional_team(json.at("winner"));
  result.kind = named<match::OutcomeKind>(json.at("end"));
  for (const Json& f : json.at("faults")) {
    result.faults.push_back(
        {named<Team>(f.at("team")),
         {named<match::FaultCode>(f.at("code")), f.at("text").get<std::string>()}});
  }
  if (!json.at("why_void").is_null()) result.why_void = json.at("why_void").get<std::string>();
  return result;
}

match::LoggedDecision decision_of(const Json& json) {
  match::LoggedDecision d;
  d.tick = json.at("tick").get<std::uint32_t>();
  d.decision.clock = json.at("clock").get<double>();
  d.decision.law = named<referee::Law>(json.at("law"));
  d.decision.verdict = named<referee::Verdict>(json.at("decision"));
  d.team = optional_team(json.at("team"));
  for (const Team team : both_teams) {
    for (const Json& robot : json.at("robots").at(std::string(to_string(team)))) {
      const int i = robot.get<int>();
      if (i < 0 || i >= max_robots_per_team) throw Damage{"there is no robot " + robot.dump()};
      d.robots[index_of(team)].set(i);
    }
  }
  d.decision.reason = json.at("reason").get<std::string>();
  d.decision.ball = {json.at("ball").at(0).get<double>(), json.at("ball").at(1).get<double>()};
  if (!json.at("restart").is_null()) {
    d.decision.restart = named<referee::Restart>(json.at("restart"));
    d.taker = named<Team>(json.at("taker"));
  }
  return d;
}

TeamInfo team_of(const Json& json) {
  TeamInfo team;
  team.name = json.at("name").get<std::string>();
  team.kind = named<TeamKind>(json.at("kind"));
  if (!json.at("sha256").is_null()) team.sha256 = json.at("sha256").get<std::string>();
  return team;
}

Budget budget_of(const Json& json) {
  return {.cpu_seconds = json.at("cpu_seconds").get<double>(),
          .slowest_tick_ms = json.at("slowest_tick_ms").get<double>(),
          .bank_seconds = json.value("bank_seconds", 0.0),
          .late_ticks = json.at("late_ticks").get<int>(),
          .bad_commands = json.at("bad_commands").get<int>()};
}

match::Setup setup_of(const Json& json) {
  match::Setup setup;
  setup.league = named<League>(json.at("league"));
  Json parameters = json.at("rules");
  // Records from before there was this one were played without it, whatever their preset.
  if (parameters.is_object()) parameters.emplace("kickoff_behind", false);
  auto rules = rules_from_json(parameters, Errc::damaged, setup.league);
  if (!rules) throw Damage{rules.error().what};
  setup.rules = *rules;
  setup.stage = named<referee::Stage>(json.at("stage"));
  setup.seed = json.at("seed").get<std::uint64_t>();
  setup.control_period = json.at("control_period").get<double>();
  if (!(setup.control_period >= shortest_period && setup.control_period <= longest_period)) {
    throw Damage{"/control_period: no match has such ticks"};
  }
  if (!(setup.rules.half_s <= longest_half)) throw Damage{"/rules/half_s: no half is so long"};
  if (!(setup.rules.ready_s <= longest_half)) throw Damage{"/rules/ready_s: no wait is so long"};
  return setup;
}

// The last key of a record is the digest of everything before it.
std::string seal_of(const std::string& text) {
  return ",\n \"sha256\": \"" + system::sha256(text) + "\"\n}\n";
}

// `object` is the text of an object that is not empty.
std::string sealed(std::string object) {
  object.resize(object.rfind("\n}"));
  const std::string seal = seal_of(object);
  return object + seal;
}

bool is_sealed(const std::string& text) {
  const std::size_t begin = text.rfind(",\n");
  return begin != std::string::npos && text.substr(begin) == seal_of(text.substr(0, begin));
}

MatchRecord record_of(const Json& json) {
  if (json.at("schema") != schema) {
    throw Damage{"its schema is " + json.at("schema").dump() + ", this program reads " +
                 std::string(schema)};
  }
  MatchRecord record;
  const Json& software = json.at("software");
  record.software = {.version = software.at("version").get<std::string>(),
                     .build = software.at("build").get<std::string>(),
                     .game = software.value("game", "")};
  for (const Team team : both_teams) {
    const std::string colour(to_string(team));
    record.teams[index_of(team)] = team_of(json.at("teams").at(colour));
    record.budget[index_of(team)] = budget_of(json.at("budget").at(colour));
  }
  record.isolation = json.at("isolation").get<std::string>();
  record.recording.setup = setup_of(json);
  record.recording.outcome = result_of(json.at("result"));
  for (const Json& d : json.at("decisions")) record.recording.decisions.push_back(decision_of(d));
  record.recording.state_hash = std::stoull(json.at("state_hash").get<std::string>(), nullptr, 16);
  return record;
}

}  // namespace

std::string software_version() {
  return MIROCUP_VERSION;
}

namespace {

std::string software_build() {
#if defined(__clang__)
  const std::string compiler = "clang++ " __clang_version__;
#else
  const std::string compiler = "g++ " __VERSION__;
#endif
#if defined(__OPTIMIZE__)
  return compiler + ", optimised";
#else
  return compiler + ", not optimised";
#endif
}

}  // namespace

Software this_software() {
  return {.version = software_version(), .build = software_build(), .game = MIROCUP_GAME};
}

bool is_of_another_game(const MatchRecord& record) {
  return record.software.game != MIROCUP_GAME;
}

Error another_game(const std::string& path, const MatchRecord& record, std::uint32_t tick) {
  const std::string game = record.software.game.empty() ? "unknown" : record.software.game;
  return {Errc::damaged, path + ": it was played by another version of the game (" + game +
                             ", mirocup " + record.software.version + "; this program plays " +
                             MIROCUP_GAME + ") and goes another way here from tick " +
                             std::to_string(tick) +
                             " on, which says nothing against it: use the program that played it"};
}

std::string replay_path_of(const std::string& record_path) {
  return std::filesystem::path(record_path).replace_extension(".replay.zst").string();
}

Json to_json(const MatchRecord& record) {
  const replay::Recording& r = record.recording;
  Json decisions = Json::array();
  for (const match::LoggedDecision& d : r.decisions) decisions.push_back(to_json(d));
  return {{"schema", schema},
          {"software",
           {{"version", record.software.version},
            {"build", record.software.build},
            {"game", record.software.game}}},
          {"league", to_string(r.setup.league)},
          {"rules", to_json(r.setup.rules)},
          {"stage", to_string(r.setup.stage)},
          {"seed", r.setup.seed},
          {"control_period", r.setup.control_period},
          {"teams", {{"blue", team_json(record.teams[0])}, {"yellow", team_json(record.teams[1])}}},
          {"result", to_json(r.outcome)},
          {"decisions", decisions},
          {"budget",
           {{"blue", budget_json(record.budget[0])}, {"yellow", budget_json(record.budget[1])}}},
          {"network", network_json(record.network)},
          {"pace", pace_json(record.pace)},
          {"isolation", record.isolation},
          {"ticks", r.ticks.size()},
          {"state_hash", to_hex(r.state_hash)}};
}

Result<void> save(system::Files& files, const std::string& path, const MatchRecord& record) {
  const int robots = field::make_field(record.recording.setup.league).robots_per_team;
  const std::string replay = pack_replay(record.recording, robots);
  const std::string replay_path = replay_path_of(path);
  if (auto written = files.write(replay_path, replay); !written) return written;

  Json json = to_json(record);
  json["replay"] = {{"file", std::filesystem::path(replay_path).filename().string()},
                    {"sha256", system::sha256(replay)}};
  // Names of teams may be any bytes: what is not UTF-8 is replaced.
  return files.write(path, sealed(json.dump(1, ' ', false, Json::error_handler_t::replace)));
}

Result<MatchRecord> load(system::Files& files, const std::string& path, Seal seal) {
  const auto text = files.read(path);
  if (!text) return tl::unexpected(text.error());
  if (seal == Seal::checked && !is_sealed(*text)) {
    return fail(Errc::damaged, path + ": its text is not what was written (sha256)");
  }
  try {
    const Json json = Json::parse(*text);
    MatchRecord record = record_of(json);
    const std::string name = json.at("replay").at("file").get<std::string>();
    const std::string replay_path =
        (std::filesystem::path(path).parent_path() / std::filesystem::path(name).filename())
            .string();
    const auto replay = files.read(replay_path);
    if (!replay) return tl::unexpected(replay.error());
    if (system::sha256(*replay) != json.at("replay").at("sha256").get<std::string>()) {
      return fail(Errc::damaged,
                  replay_path + ": it is not the replay that the record was saved with");
    }
    const int robots = field::make_field(record.recording.setup.league).robots_per_team;
    auto unpacked = unpack_replay(*replay, robots, replay_path);
    if (!unpacked) return tl::unexpected(unpacked.error());
    if (unpacked->ticks.size() != json.at("ticks").get<std::size_t>()) {
      return fail(Errc::damaged,
                  replay_path + ": it has another number of ticks than the record says");
    }
    record.recording.ticks = std::move(unpacked->ticks);
    record.recording.trace = std::move(unpacked->trace);
    record.recording.placement_requests = std::move(unpacked->asked);
    return record;
  } catch (const Damage& damage) {
    return fail(Errc::damaged, path + ": " + damage.where);
  } catch (const std::exception& e) {
    return fail(Errc::damaged, path + ": " + e.what());
  }
}

}  // namespace mirocup::record
