// SPDX-License-Identifier: MIT
#include "record/match_record.hpp"

#include "record/conditions_json.hpp"
#include "record/json_fields.hpp"
#include "record/leg_fields.hpp"
#include "record/pitch_json.hpp"
#include "record/replay_file.hpp"
#include "record/rules_json.hpp"
#include "record/situation_json.hpp"
#include "record/team_parameters_json.hpp"
#include "system/digest.hpp"

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

}  // namespace

static void list_fields(auto& f, match::TeamFault& fault) {
  f("team", fault.team);
  f("code", fault.fault.code);
  f("text", fault.fault.text);
}

static void list_fields(auto& f, match::Outcome& result) {
  f("score", result.score);
  f("played", result.played);
  f("shoot_out", result.shoot_out);
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

static void list_fields(auto& f, match::LoggedDecision& d) {
  using referee::Restart;
  f("tick", d.tick);
  f("clock", d.decision.clock);
  f("law", d.decision.law);
  f("decision", d.decision.verdict);
  f("team", d.team);
  f("robots", d.robots);
  f("reason", d.decision.reason);
  f("ball", d.decision.ball);
  const bool restarts = d.decision.restart != Restart::none;
  auto restart = restarts ? std::optional(d.decision.restart) : std::nullopt;
  f("restart", restart);
  d.decision.restart = restart.value_or(Restart::none);
  if (restart)
    f("taker", d.taker);
  else
    f.only_written("taker", Json());
  f("gainer", d.parties.gainer);
  f("offender", d.parties.offender);
  f.merged("kind", d.credit);
  f.if_set("score", d.score);
}

Json to_json(const match::LoggedDecision& decision) {
  return fields_json(decision);
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

}  // namespace

// The reports of network and pace are written and not read.
static void list_fields(auto& f, Absence& absence) {
  f("tick", absence.tick);
  f("noticed", absence.noticed);
  f("back", absence.back);
  f.only_written("why", absence.has_left ? "left" : "silent");
}

static void list_fields(auto& f, DatagramCounts& datagrams) {
  f("received", datagrams.received);
  f("placements", datagrams.placements);
  f("stale", datagrams.stale);
  f("malformed", datagrams.malformed);
  f("replacements", datagrams.replacements);
  f("not_finite", datagrams.not_finite);
  f("unknown_robots", datagrams.unknown_robots);
}

static void list_fields(auto& f, NetworkReport& report) {
  f("in_step", report.in_step);
  f("late", report.late);
  f("late_driven", report.late_driven);
  f("duplicate", report.duplicate);
  f("ahead", report.ahead);
  f("foreign", report.foreign);
  f("processes", report.processes);
  f("absences", report.absences);
  f.only_written("answers", durations_json(report.answers));
  f.if_set("datagrams", report.datagrams);
}

static void list_fields(auto& f, PaceReport& report) {
  f("period", report.period);
  f.only_written("lateness", durations_json(report.lateness));
}

static void list_fields(auto& f, Software& software) {
  f("version", software.version);
  f("build", software.build);
  f("game", software.behaviour_hash);
}

static void list_fields(auto& f, PlayedOnFrom& from) {
  f("tick", from.tick);
  list_hash(f, "state_hash", from.state_hash);
  f("blue", from.teams[0]);
  f("yellow", from.teams[1]);
}

static void list_fields(auto& f, match::Setup& setup) {
  f("league", setup.league);
  f.as(
      "rules", [&] { return to_json(setup.rules); },
      [&](const JsonReader& json) {
        setup.rules = read_rules(json, setup.league);
        for (const auto& [key, seconds] :
             {std::pair{"half_s", setup.rules.half_s}, std::pair{"ready_s", setup.rules.ready_s}}) {
          if (!(seconds <= max_half_s)) json.at(key).complain("it is more than 36000 s");
        }
      });
  f("stage", setup.stage);
  f("seed", setup.seed);
  f("control_period", setup.control_period, min_control_period, max_control_period);
  f.as(
      "conditions", [&] { return to_json(setup.conditions); },
      [&](const JsonReader& json) { setup.conditions = read_conditions(json); });
  f.as(
      "pitch",
      [&] {
        match::PitchSpec pitch;
        pitch.name = setup.pitch_name;
        pitch.parameters = setup.parameters;
        return to_json(pitch);
      },
      [&](const JsonReader& json) {
        const match::PitchSpec pitch = read_pitch(json);
        setup.pitch_name = pitch.name;
        setup.parameters = pitch.parameters;
      });
  f.as_if_set(
      setup.start.has_value(), "situation",
      [&] {
        return to_json(Situation{setup.league, *setup.start});
      },
      [&](const JsonReader& json) {
        const Situation situation = read_situation(json);
        if (situation.league != setup.league)
          json.at("league").complain("the situation must be of the leg's league");
        setup.start = situation.start;
      });
}

static void list_fields(auto& f, RecordFile& file) {
  MatchRecord& record = file.record;
  f.only_written("schema", schema);
  f("software", record.software);
  list_fields(f, record.recording.setup);
  f.if_set("from", record.from);
  f("teams", record.teams);
  f("result", record.recording.outcome);
  f("decisions", record.recording.decisions);
  f("budget", record.budget);
  f.only_written("network", fields_json(record.network));
  f.only_written("pace", fields_json(record.pace));
  f("isolation", record.isolation);
  f("ticks", file.ticks);
  list_hash(f, "state_hash", record.recording.state_hash);
}

namespace {

// The file of that name in the folder of `path`; a name with a folder of its own loses it.
std::string beside(const std::string& path, const std::string& name) {
  namespace fs = std::filesystem;
  return (fs::path(path).parent_path() / fs::path(name).filename()).string();
}

RecordFile read_record_file(const JsonReader& json) {
  json.expect_schema(schema);
  auto file = read_fields<RecordFile>(json);
  if (file.record.from && file.record.from->tick > file.ticks)
    json.at("from").at("tick").complain("the leg does not have so many ticks");
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
  RecordFile file{record, "", "", record.recording.ticks.size()};
  FieldWriter fields;
  list_fields(fields, file);
  return fields.object();
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
