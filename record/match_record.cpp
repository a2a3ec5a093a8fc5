// SPDX-License-Identifier: MIT
#include "record/match_record.hpp"

#include "record/conditions_json.hpp"
#include "record/json_fields.hpp"
#include "record/pitch_json.hpp"
#include "record/replay_file.hpp"
#include "record/rules_json.hpp"
#include "record/situation_json.hpp"
#include "record/team_parameters_json.hpp"
#include "record/touch_fields.hpp"
#include "system/digest.hpp"
#include "system/number_of.hpp"

#include <filesystem>
#include <utility>

namespace mirocup::record {

namespace {

constexpr std::string_view schema = "mirocup/match/1";

// Enumerators are written by name. Every one has a name, and the last has its own: an enumerator
// that is added or moved without its name would change the meaning of records.
template <class E>
constexpr bool has_names_up_to(E last, std::string_view name) {
  return enum_names<E>.size() == static_cast<std::size_t>(last) + 1 && to_string(last) == name;
}
static_assert(has_names_up_to(Team::yellow, "yellow"));
static_assert(has_names_up_to(RobotLeague::large, "large"));
static_assert(has_names_up_to(TeamKind::firasim, "firasim"));
static_assert(has_names_up_to(referee::Stage::knockout, "knockout"));
static_assert(has_names_up_to(referee::Verdict::MATCH_END, "MATCH_END"));
static_assert(has_names_up_to(referee::Law::forfeit, "forfeit"));
static_assert(has_names_up_to(referee::Restart::FREE_KICK, "FREE_KICK"));
static_assert(has_names_up_to(match::FaultCode::disconnected, "disconnected"));

Json score_json(const match::ByTeam<int>& score) {
  return {{"blue", score[0]}, {"yellow", score[1]}};
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

match::ByTeam<int> read_score(const JsonReader& json) {
  return {json.at("blue").as<int>(), json.at("yellow").as<int>()};
}

void list_score(auto& f, const char* key, match::ByTeam<int>& score) {
  f.as(
      key, [&] { return score_json(score); },
      [&](const JsonReader& json) { score = read_score(json); });
}

}  // namespace

static void list_fields(auto& f, match::TeamFault& fault) {
  f("team", fault.team);
  f("code", fault.fault.code);
  f("text", fault.fault.text);
}

static void list_fields(auto& f, match::Outcome& result) {
  list_score(f, "score", result.score);
  list_score(f, "played", result.played);
  f.as(
      "shoot_out", [&] { return result.shoot_out ? score_json(*result.shoot_out) : Json(); },
      [&](const JsonReader& json) {
        if (!json.is_null()) result.shoot_out = read_score(json);
      });
  f("winner", result.winner);
  f("end", result.kind);
  f.only_written("fault", result.faults.empty() ? Json() : fields_json(result.faults.front()));
  f("faults", result.faults);
  auto why_void = result.why_void.empty() ? std::nullopt : std::optional(result.why_void);
  f("why_void", why_void);
  result.why_void = why_void.value_or("");
}

static void list_fields(auto& f, match::GoalCredit& credit) {
  f("scorer", credit.scorer);
  f("assist", credit.assist);
  f("own_goal", credit.own_goal);
  f("kind", credit.kind);
}

Json to_json(const match::Outcome& result) {
  return fields_json(result);
}

Json to_json(const match::LoggedDecision& d) {
  const bool restarts = d.decision.restart != referee::Restart::none;
  Json json{{"tick", d.tick},
            {"clock", d.decision.clock},
            {"law", to_string(d.decision.law)},
            {"decision", to_string(d.decision.verdict)},
            {"team", fields_json(d.team)},
            {"robots", robots_json(d.robots)},
            {"reason", d.decision.reason},
            {"ball", {d.decision.ball.x(), d.decision.ball.y()}},
            {"restart", restarts ? Json(to_string(d.decision.restart)) : Json()},
            {"taker", restarts ? Json(to_string(d.taker)) : Json()},
            {"gainer", fields_json(d.parties.gainer)},
            {"offender", fields_json(d.parties.offender)}};
  if (d.credit) json.update(fields_json(*d.credit));
  if (d.score) json["score"] = score_json(*d.score);
  return json;
}

static void list_fields(auto& f, TeamInfo& team) {
  f("name", team.name);
  f("kind", team.kind);
  f("sha256", team.sha256);
  f.as(
      "parameters", [&] { return to_json(team.parameters); },
      [&](const JsonReader& json) { team.parameters = read_team_parameters(json); });
}

static void list_fields(auto& f, BudgetReport& budget) {
  f("cpu_seconds", budget.cpu_seconds);
  f("slowest_tick_ms", budget.slowest_tick_ms);
  f("bank_seconds", budget.bank_seconds);
  f("late_ticks", budget.late_ticks);
  f("bad_commands", budget.bad_commands);
}

namespace {

Json durations_json(const Durations& durations) {
  Json histogram = Json::array();
  for (const auto& range : durations.histogram()) {
    histogram.push_back({range.below, range.count});
  }
  return {{"p50", durations.quantile(0.5)},
          {"p99", durations.quantile(0.99)},
          {"p999", durations.quantile(0.999)},
          {"longest", durations.max()},
          {"histogram", histogram}};
}

Json pace_json(const std::optional<PaceReport>& report) {
  if (!report) return {};
  return {{"period", report->period}, {"lateness", durations_json(report->lateness)}};
}

Json network_json(const std::optional<NetworkReport>& report) {
  if (!report) return {};
  Json absences = Json::array();
  for (const Absence& a : report->absences) {
    absences.push_back({{"tick", a.tick},
                        {"noticed", a.noticed},
                        {"back", a.back ? Json(*a.back) : Json()},
                        {"why", a.has_left ? "left" : "silent"}});
  }
  Json json = {{"in_step", report->in_step},
               {"late", report->late},
               {"late_driven", report->late_driven},
               {"duplicate", report->duplicate},
               {"ahead", report->ahead},
               {"foreign", report->foreign},
               {"processes", report->processes},
               {"absences", absences},
               {"answers", durations_json(report->answers)}};
  if (const auto& datagrams = report->datagrams) {
    json["datagrams"] = {{"received", datagrams->received},
                         {"placements", datagrams->placements},
                         {"stale", datagrams->stale},
                         {"malformed", datagrams->malformed},
                         {"replacements", datagrams->replacements},
                         {"not_finite", datagrams->not_finite},
                         {"unknown_robots", datagrams->unknown_robots}};
  }
  return json;
}

Json network_json(const match::ByTeam<std::optional<NetworkReport>>& reports) {
  return {{"blue", network_json(reports[0])}, {"yellow", network_json(reports[1])}};
}

match::LoggedDecision read_decision(const JsonReader& json) {
  match::LoggedDecision d;
  d.tick = json.at("tick").as<std::uint32_t>();
  d.decision.clock = json.at("clock").number();
  d.decision.law = json.at("law").name<referee::Law>();
  d.decision.verdict = json.at("decision").name<referee::Verdict>();
  d.team = read_fields<std::optional<Team>>(json.at("team"));
  for (const Team team : both_teams) {
    for (const JsonReader& robot : json.at("robots").at(std::string(to_string(team))).elements()) {
      d.robots[index_of(team)].set(
          static_cast<std::size_t>(robot.integer<int>(0, max_robots_per_team - 1)));
    }
  }
  d.decision.reason = json.at("reason").text();
  d.decision.ball = {json.at("ball").at(0).number(), json.at("ball").at(1).number()};
  if (const JsonReader restart = json.at("restart"); !restart.is_null()) {
    d.decision.restart = restart.name<referee::Restart>();
    d.taker = json.at("taker").name<Team>();
  }
  if (json.has("kind")) d.credit = read_fields<match::GoalCredit>(json);
  if (json.has("score")) d.score = read_score(json.at("score"));
  d.parties.gainer = read_fields<std::optional<Team>>(json.at("gainer"));
  d.parties.offender = read_fields<std::optional<Team>>(json.at("offender"));
  return d;
}

match::Setup read_setup(const JsonReader& json) {
  match::Setup setup;
  setup.league = json.at("league").name<RobotLeague>();
  const JsonReader rules = json.at("rules");
  setup.rules = read_rules(rules, setup.league);
  for (const auto& [key, seconds] :
       {std::pair{"half_s", setup.rules.half_s}, std::pair{"ready_s", setup.rules.ready_s}}) {
    if (!(seconds <= max_half_s)) rules.at(key).complain("it is more than 36000 s");
  }
  setup.stage = json.at("stage").name<referee::Stage>();
  setup.seed = json.at("seed").as<std::uint64_t>();
  setup.control_period = json.at("control_period").number(min_control_period, max_control_period);
  setup.conditions = read_conditions(json.at("conditions"));
  const match::PitchSpec pitch = read_pitch(json.at("pitch"));
  setup.pitch_name = pitch.name;
  setup.parameters = pitch.parameters;
  if (const auto given = json.find("situation")) {
    const Situation situation = read_situation(*given);
    if (situation.league != setup.league)
      given->at("league").complain("the situation must be of the leg's league");
    setup.start = situation.start;
  }
  return setup;
}

std::uint64_t read_hash(const JsonReader& json) {
  const std::string digits = json.text();
  const auto hash = system::hexadecimal_of<std::uint64_t>(digits);
  if (!hash || digits.size() != 16)
    json.complain("16 hexadecimal digits are expected, not " + json.quoted());
  return hash.value_or(0);
}

PlayedOnFrom read_from(const JsonReader& json) {
  return {.tick = json.at("tick").as<std::uint32_t>(),
          .state_hash = read_hash(json.at("state_hash")),
          .teams = {json.at("blue").text(), json.at("yellow").text()}};
}

// The file of that name in the folder of `path`; a name with a folder of its own loses it.
std::string beside(const std::string& path, const std::string& name) {
  namespace fs = std::filesystem;
  return (fs::path(path).parent_path() / fs::path(name).filename()).string();
}

RecordFile read_record_file(const JsonReader& json) {
  RecordFile file;
  json.expect_schema(schema);
  MatchRecord& record = file.record;
  const JsonReader software = json.at("software");
  record.software.version = software.at("version").text();
  record.software.build = software.at("build").text();
  record.software.behaviour_hash = software.at("game").text();
  for (const Team team : both_teams) {
    const std::string colour(to_string(team));
    record.teams[index_of(team)] = read_fields<TeamInfo>(json.at("teams").at(colour));
    record.budget[index_of(team)] = read_fields<BudgetReport>(json.at("budget").at(colour));
  }
  record.isolation = json.at("isolation").text();
  record.recording.setup = read_setup(json);
  if (const auto from = json.find("from")) record.from = read_from(*from);
  record.recording.outcome = read_fields<match::Outcome>(json.at("result"));
  for (const JsonReader& decision : json.at("decisions").elements()) {
    record.recording.decisions.push_back(read_decision(decision));
  }
  record.recording.state_hash = read_hash(json.at("state_hash"));
  file.ticks = json.at("ticks").as<std::size_t>();
  if (record.from && record.from->tick > file.ticks) {
    json.at("from").at("tick").complain("the leg does not have so many ticks");
  }
  file.replay_name = json.at("replay").at("file").text();
  file.replay_sha256 = json.at("replay").at("sha256").text();
  return file;
}

// The end of a record: its last key is the digest of `text`, which is everything before it.
std::string checksum_line(const std::string& text) {
  return ",\n \"sha256\": \"" + system::sha256(text) + "\"\n}\n";
}

// `object` is the text of an object with at least one key, one key a line.
std::string with_checksum(std::string object) {
  object.resize(object.rfind("\n}"));
  const std::string line = checksum_line(object);
  return object + line;
}

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

std::string software_version() {
  return MIROCUP_VERSION;
}

Software this_software() {
  return {.version = software_version(),
          .build = software_build(),
          .behaviour_hash = MIROCUP_BEHAVIOUR_HASH};
}

bool has_other_behaviour(const MatchRecord& record) {
  return record.software.behaviour_hash != MIROCUP_BEHAVIOUR_HASH;
}

Error behaviour_mismatch(const std::string& path, const MatchRecord& record, std::uint32_t tick) {
  return {Errc::damaged,
          path + ": it was played by another version of the game (" +
              record.software.behaviour_hash + ", mirocup " + record.software.version +
              "; this program plays " + MIROCUP_BEHAVIOUR_HASH + ") and differs here from tick " +
              std::to_string(tick) +
              " on, which does not mean that the record is wrong: use the program that played it"};
}

std::string replay_path_of(const std::string& record_path) {
  return std::filesystem::path(record_path).replace_extension(".replay.zst").string();
}

Json to_json(const MatchRecord& record) {
  const replay::Recording& r = record.recording;
  Json decisions = Json::array();
  for (const match::LoggedDecision& d : r.decisions) decisions.push_back(to_json(d));
  Json json{{"schema", schema},
            {"software",
             {{"version", record.software.version},
              {"build", record.software.build},
              {"game", record.software.behaviour_hash}}},
            {"league", to_string(r.setup.league)},
            {"rules", to_json(r.setup.rules)},
            {"stage", to_string(r.setup.stage)},
            {"seed", r.setup.seed},
            {"control_period", r.setup.control_period},
            {"conditions", to_json(r.setup.conditions)},
            {"pitch", to_json(match::PitchSpec{.name = r.setup.pitch_name,
                                               .source = "",
                                               .parameters = r.setup.parameters,
                                               .control_period = {},
                                               .conditions = {}})}};
  if (r.setup.start) json["situation"] = to_json(Situation{r.setup.league, *r.setup.start});
  if (record.from) {
    json["from"] = {{"tick", record.from->tick},
                    {"state_hash", to_hex(record.from->state_hash)},
                    {"blue", record.from->teams[0]},
                    {"yellow", record.from->teams[1]}};
  }
  json["teams"] = {{"blue", fields_json(record.teams[0])},
                   {"yellow", fields_json(record.teams[1])}};
  json["result"] = to_json(r.outcome);
  json["decisions"] = decisions;
  json["budget"] = {{"blue", fields_json(record.budget[0])},
                    {"yellow", fields_json(record.budget[1])}};
  json["network"] = network_json(record.network);
  json["pace"] = pace_json(record.pace);
  json["isolation"] = record.isolation;
  json["ticks"] = r.ticks.size();
  json["state_hash"] = to_hex(r.state_hash);
  return json;
}

Result<void> save(system::Files& files, const std::string& path, const MatchRecord& record) {
  const int robots = field::make_field(record.recording.setup.league).robots_per_team;
  const std::string replay = pack_replay(record.recording, robots);
  const std::string replay_path = replay_path_of(path);
  if (!system::is_written_in_place(path)) {
    MIROCUP_TRY_VOID(files.write(replay_path, replay));
  }
  const std::string name = std::filesystem::path(replay_path).filename().string();
  return files.write(path, record_text(record, name, replay));
}

std::string record_text(const MatchRecord& record, const std::string& replay_name,
                        std::string_view replay) {
  Json json = to_json(record);
  json["replay"] = {{"file", replay_name}, {"sha256", system::sha256(replay)}};
  // Names of teams may be any bytes: what is not UTF-8 is replaced.
  return with_checksum(json_text(json, 1));
}

Result<RecordFile> parse_record(const std::string& text, const std::string& path) {
  return read_json<RecordFile>(text, path, Errc::damaged, read_record_file);
}

void add_replay(MatchRecord& record, Replay replay) {
  record.recording.ticks = std::move(replay.ticks);
  record.recording.trace = std::move(replay.trace);
  record.recording.placement_requests = std::move(replay.asked);
}

Result<void> expect_whole(const std::string& text, const std::string& path) {
  const std::size_t begin = text.rfind(",\n");
  if (begin != std::string::npos && text.substr(begin) == checksum_line(text.substr(0, begin)))
    return {};
  return fail(Errc::damaged, path + ": its text was changed after it was written (sha256)");
}

Result<MatchRecord> load(system::Files& files, const std::string& path, ChecksumPolicy policy) {
  MIROCUP_TRY(const auto text, files.read_named(path, system::size_limit::record));
  if (text.find("\"mirocup/match/") == std::string::npos)
    return fail(Errc::damaged, path + ": it is no match record");
  if (policy == ChecksumPolicy::checked) MIROCUP_TRY_VOID(expect_whole(text, path));
  MIROCUP_TRY(auto file, parse_record(text, path));
  std::string replay_path = beside(path, file.replay_name);
  // JSON holds no name that is not UTF-8; the digest tells whether it is the right file.
  if (const std::string same_name = replay_path_of(path);
      !files.exists(replay_path) && files.exists(same_name)) {
    replay_path = same_name;
  }
  MIROCUP_TRY(const auto replay, files.read_named(replay_path, system::size_limit::replay));
  if (system::sha256(replay) != file.replay_sha256)
    return fail(Errc::damaged,
                replay_path + ": it is not the replay that the record was saved with");
  MatchRecord record = std::move(file.record);
  const int robots = field::make_field(record.recording.setup.league).robots_per_team;
  MIROCUP_TRY(auto unpacked,
              unpack_replay(replay, {.robots = robots, .ticks = file.ticks}, replay_path));
  add_replay(record, std::move(unpacked));
  return record;
}

}  // namespace mirocup::record
