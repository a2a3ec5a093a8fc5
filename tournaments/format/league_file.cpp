// SPDX-License-Identifier: MIT
#include "tournaments/format/league_file.hpp"

#include "record/conditions_json.hpp"
#include "record/json_fields.hpp"
#include "record/pitch_json.hpp"
#include "record/rules_json.hpp"
#include "record/team_parameters_json.hpp"
#include "system/printable.hpp"
#include "system/text.hpp"

#include <algorithm>
#include <set>

namespace mirocup::league {

namespace {

using record::JsonReader;
using Json = JsonReader::Json;

constexpr std::string_view schema = "mirocup/league/1";
constexpr int max_name_length = 40;

}  // namespace

// The settings that differ from the defaults.
static void list_fields(auto& f, FirasimPlace& place) {
  const FirasimPlace plain;
  f.unless(plain.instance, "instance", place.instance, 0, 9999);
  f.unless(plain.interface, "interface", place.interface);
  f.if_set("vision", place.vision);
  f.if_set("command", place.command);
  f.if_set("referee", place.referee);
  f.if_set("placement", place.placement);
  f.unless(plain.join_within, "join_within", place.join_within, 0.0, 1e6);
}

static void list_fields(auto& f, TeamConfig& team) {
  f.optional("name", team.name);
  f.optional("entry", team.source);
  f.if_set("dds", team.over_dds);
  f.as_if_set(
      !team.parameters.empty(), "parameters", [&] { return record::to_json(team.parameters); },
      [&](const JsonReader& json) { team.parameters = record::read_team_parameters(json); });
  f.if_set("run", team.program.run);
  f.if_set("folder", team.program.folder);
  f.if_set("lockstep", team.program.lockstep);
}

// The settings that differ from the defaults of the format.
static void list_fields(auto& f, Format& format) {
  const Format plain;
  f("kind", format.kind);
  const bool is_knockout = format.kind == FormatKind::knockout;
  f.unless(plain.legs, "legs", format.legs, 1, is_knockout ? legs_per_fixture : 100);
  f.unless(plain.groups, "groups", format.groups, 1, 500);
  f.unless(plain.qualifiers, "qualifiers", format.qualifiers, 1, 500);
  f.unless(plain.third_place, "third_place", format.third_place);
  f.unless(plain.rounds, "rounds", format.rounds, 0, 500);
  f.unless(plain.sample, "sample", format.sample, 1, 1000);
  f.unless(plain.opponents, "opponents", format.opponents, 0, 1000);
}

static void list_fields(auto& f, Points& points) {
  f.optional("win", points.win, -max_points, max_points);
  f.optional("draw", points.draw, -max_points, max_points);
  f.optional("loss", points.loss, -max_points, max_points);
}

namespace {

TeamConfig read_team(const JsonReader& json) {
  json.expect_object({"name", "entry", "dds", "parameters", "run", "folder", "lockstep"});
  const auto team = record::read_fields<TeamConfig>(json);
  if (!is_good_name(team.name)) {
    json.at("name").complain("a name of letters, digits, '-', '_' and '.' is expected, at most " +
                             std::to_string(max_name_length));
  }
  if (team.source.empty() || team.source == TeamConfig::firasim_prefix) {
    json.at("entry").complain(
        "\"house:NAME\", the path of a library, \"submitted\" or \"firasim:NAME\" is expected");
  }
  for (const char* key : {"run", "folder", "lockstep"}) {
    if (json.has(key) && !team.is_firasim())
      json.at(key).complain("only a team whose entry is \"firasim:NAME\" may have this key");
  }
  for (const char* key : {"dds", "parameters"}) {
    if (json.has(key) && team.is_firasim())
      json.at(key).complain("a team whose entry is \"firasim:NAME\" may not have this key");
  }
  return team;
}

FirasimPlace read_firasim(const JsonReader& json) {
  json.expect_object(
      {"instance", "interface", "vision", "command", "referee", "placement", "join_within"});
  return record::read_fields<FirasimPlace>(json);
}

// Reads the teams; their names must differ.
std::vector<TeamConfig> read_teams(const JsonReader& json) {
  std::vector<TeamConfig> teams;
  std::set<std::string> names;
  for (const JsonReader& element : json.elements(0, max_teams)) {
    const TeamConfig& team = teams.emplace_back(read_team(element));
    if (!names.insert(team.name).second) {
      element.at("name").complain("two teams are called \"" + team.name + "\"");
    }
  }
  return teams;
}

// Reads a format, which is a name or an object with settings.
Format read_format(const JsonReader& json) {
  Format format;
  if (json.is_string()) {
    format.kind = json.name<FormatKind>();
    return format;
  }
  json.expect_object(
      {"kind", "legs", "groups", "qualifiers", "third_place", "rounds", "sample", "opponents"});
  return record::read_fields<Format>(json);
}

Json format_json(const Format& format) {
  const Json json = record::fields_json(format);
  return json.size() == 1 ? json["kind"] : json;
}

// Reads the name of a time zone and finds it.
void read_zone(const JsonReader& json, LeagueFile& file) {
  file.zone = json.text();
  if (file.zone.empty()) return;
  auto zone = system::TimeZone::find(file.zone);
  if (zone) {
    file.time_zone = *zone;
  } else if (zone.error().code == Errc::input) {
    json.complain(zone.error().what);
  }
}

std::string read_time_or_none(const JsonReader& json, const LeagueFile& file) {
  return json.text().empty() ? "" : read_time(json, file);
}

// A leg without a time to play would never end, and one of no time has no football.
referee::Rules read_rules_of(const JsonReader& json, RobotLeague league) {
  const referee::Rules rules = record::read_rules(json, league);
  if (json.has("half_s") &&
      !(rules.half_s >= record::min_half_s && rules.half_s <= record::max_half_s))
    json.at("half_s").complain("a half of a league has 0.1 to 36000 seconds");
  return rules;
}

Points read_points(const JsonReader& json) {
  json.expect_object({"win", "draw", "loss"});
  return record::read_fields<Points>(json);
}

LeagueFile read_league(const JsonReader& json) {
  json.expect_object({"schema",        "title",    "format", "league",    "rules",
                      "conditions",    "pitch",    "seed",   "points",    "tie_breaks",
                      "rules_version", "zone",     "freeze", "strikes",   "extensions",
                      "anonymous",     "thoughts", "proofs", "processor", "firasim",
                      "site",          "teams"});
  json.expect_schema(schema);
  LeagueFile file;
  record::FieldReader fields(json);
  fields.optional("rules_version", file.rules_version, 1, current_rules);
  json.read_if_present("title", file.title);
  if (json.has("format")) file.format = read_format(json.at("format"));
  json.read_if_present("league", file.league);
  if (json.has("rules")) file.rules = read_rules_of(json.at("rules"), file.league);
  if (json.has("conditions")) file.conditions = record::read_conditions(json.at("conditions"));
  if (json.has("pitch")) file.pitch = record::read_pitch(json.at("pitch"));
  json.read_if_present("seed", file.seed);
  if (json.has("points")) file.points = read_points(json.at("points"));
  if (json.has("tie_breaks")) {
    file.tie_breaks.clear();
    fields("tie_breaks", file.tie_breaks, 0, enum_names<TieBreak>.size());
  } else if (file.format.kind == FormatKind::swiss) {
    // Among teams of equal points, the one with stronger opponents ranks higher.
    file.tie_breaks.insert(file.tie_breaks.begin(), TieBreak::opponents_points);
  }
  if (json.has("zone")) read_zone(json.at("zone"), file);
  if (json.has("freeze")) file.freeze = read_time_or_none(json.at("freeze"), file);
  if (json.has("extensions")) {
    for (const auto& [team, until] : json.at("extensions").members())
      file.extensions[team] = read_time_or_none(until, file);
  }
  json.read_if_present("anonymous", file.is_anonymous);
  json.read_if_present("thoughts", file.keeps_thoughts);
  json.read_if_present("proofs", file.has_proofs);
  json.read_if_present("processor", file.processor);
  fields.optional("strikes", file.strikes, 0, 1000);
  if (json.has("firasim")) file.firasim = read_firasim(json.at("firasim"));
  json.read_if_present("site", file.site);
  if (!file.site.empty() && !file.site.starts_with('/'))
    json.at("site").complain("the absolute path of a folder is expected");
  if (json.has("teams")) file.teams = read_teams(json.at("teams"));
  return file;
}

}  // namespace

match::Conditions default_conditions() {
  return match::conditions_of(match::default_preset);
}

bool is_time(const std::string& text) {
  return text.ends_with('Z') && system::parse_time(text);
}

std::string utc_text(std::int64_t at) {
  return system::utc_text(at);
}

// Returns a time that a person typed in the form of parse_time(), with T, seconds and a colon in
// the offset. Another text becomes one that is no time.
static std::string as_written(std::string text) {
  constexpr std::size_t day = 10, minutes = 16, seconds = 19, with_offset = 24;  // lengths
  if (text.size() < minutes) return text;
  if (text[day] == ' ') text[day] = 'T';
  if (text.substr(minutes, 1) != ":") text.insert(minutes, ":00");
  if (text.size() > seconds && text[seconds] == ' ') text.erase(seconds, 1);
  return text.size() == with_offset ? text.insert(seconds + 3, ":") : text;
}

Result<std::string> utc_of(const std::string& text, const LeagueFile& file) {
  const auto in_words = [](std::int64_t shown) {
    std::string words = utc_text(shown);
    words.pop_back();  // the Z
    return words;
  };
  const auto time = system::parse_time(as_written(text));
  if (!time) {
    return fail(Errc::input,
                system::in_quotes(text) +
                    " is no time: one like \"2026-11-30 19:00\" in the league's zone (" +
                    (file.zone.empty() ? "UTC" : file.zone) +
                    ") is expected, or with its own, as in \"2026-11-30 19:00+01:00\" or "
                    "\"2026-11-30 18:00Z\"");
  }
  const auto gap = time->is_local ? file.time_zone.gap_at(time->at) : std::nullopt;
  if (gap) {
    return fail(Errc::input, "\"" + text + "\" does not exist in " + file.zone +
                                 ": clocks go from \"" + in_words(gap->first) + "\" to \"" +
                                 in_words(gap->second) + "\"; choose one of the two");
  }
  return utc_text(time->is_local ? file.time_zone.from_local(time->at) : time->at);
}

std::string read_time(const JsonReader& json, const LeagueFile& file) {
  const auto time = utc_of(json.text(), file);
  if (!time) json.complain(time.error().what);
  return time.value_or("");
}

std::string shown_time(const LeagueFile& file, const std::string& utc) {
  const std::string local = system::in_zone(file.time_zone, utc);
  return file.zone.empty() || file.zone == "UTC" || !is_time(utc)
             ? local
             : local + " (" + utc.substr(11, 5) + " UTC)";
}

bool is_good_name(const std::string& name) {
  if (name.empty() || name.size() > max_name_length || name[0] == '.' || name[0] == '-')
    return false;
  return std::ranges::all_of(name, system::is_plain);
}

Result<LeagueFile> parse_league_file(const std::string& text, const std::string& path) {
  auto file = record::read_json<LeagueFile>(text, path, Errc::input, read_league);
  if (!file || file->zone.empty()) return file;
  // The file is right, but the computer may know no zones.
  auto zone = system::TimeZone::find(file->zone);
  return zone ? file : fail(zone.error().code, path + ": /zone: " + zone.error().what);
}

std::string without_site(std::string text) {
  constexpr std::string_view key = "\"site\"";
  const auto next = [&text](std::size_t from) {
    return std::min(text.find_first_not_of(" \t\r\n", from), text.size());
  };
  for (std::size_t at = text.find(key); at != std::string::npos; at = text.find(key, at + 1)) {
    const std::size_t colon = next(at + key.size());
    const std::size_t value = next(colon + 1);
    if (text[colon] != ':' || text[value] != '"') continue;
    const std::size_t end = text.find('"', value + 1) + 1;
    const std::size_t comma = next(end);
    // The comma after the key goes with it, or the comma before the last key.
    const std::size_t before = std::min(text.find_last_of(",{", at), at);
    return text[comma] == ',' ? text.erase(before + 1, comma - before)
                              : text.erase(before, end - before);
  }
  return text;
}

std::string print_firasim_team(const TeamConfig& team) {
  return record::json_text(record::fields_json(team), 2) + "\n";
}

std::string print_league_file(const LeagueFile& file) {
  Json json{{"schema", schema},
            {"title", file.title},
            {"format", format_json(file.format)},
            {"league", to_string(file.league)},
            {"rules", record::to_json(file.rules)}};
  if (file.conditions) json["conditions"] = record::to_json(*file.conditions);
  if (file.pitch) json["pitch"] = record::to_json(*file.pitch);
  json.update({{"seed", file.seed},
               {"points", record::fields_json(file.points)},
               {"tie_breaks", record::fields_json(file.tie_breaks)},
               {"strikes", file.strikes},
               {"rules_version", file.rules_version}});
  if (!file.zone.empty()) json["zone"] = file.zone;
  if (!file.freeze.empty()) json["freeze"] = file.freeze;
  if (!file.extensions.empty()) json["extensions"] = file.extensions;
  if (file.is_anonymous) json["anonymous"] = true;
  if (file.keeps_thoughts) json["thoughts"] = true;
  if (!file.has_proofs) json["proofs"] = false;
  if (!file.site.empty()) json["site"] = file.site;
  if (file.processor != LeagueFile().processor) json["processor"] = to_string(file.processor);
  if (const Json firasim = record::fields_json(file.firasim); !firasim.empty())
    json["firasim"] = firasim;
  json["teams"] = record::fields_json(file.teams);
  return record::json_text(json, 2) + "\n";
}

}  // namespace mirocup::league
