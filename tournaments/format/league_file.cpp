// SPDX-License-Identifier: MIT
#include "tournaments/format/league_file.hpp"

#include "record/conditions_json.hpp"
#include "record/json_reader.hpp"
#include "record/pitch_json.hpp"
#include "record/rules_json.hpp"
#include "record/team_parameters_json.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

namespace mirocup::league {

namespace {

using record::JsonReader;
using Json = JsonReader::Json;

constexpr std::string_view schema = "mirocup/league/1";
constexpr int max_name_length = 40;

// Sets `count` to the member of that key, if there is one; it must be in [min, max].
void read_count(const JsonReader& json, const std::string& key, int min, int max, int& count) {
  if (json.has(key)) count = json.at(key).integer(min, max);
}

TeamConfig read_team(const JsonReader& json) {
  json.expect_object({"name", "entry", "dds", "parameters", "run", "folder", "lockstep"});
  TeamConfig team;
  json.read_if_present("name", team.name);
  json.read_if_present("entry", team.source);
  json.read_if_present("dds", team.over_dds);
  if (json.has("parameters")) {
    team.parameters = record::read_team_parameters(json.at("parameters"));
  }
  if (!is_good_name(team.name)) {
    json.at("name").complain("a name of letters, digits, '-', '_' and '.' is expected, at most " +
                             std::to_string(max_name_length));
  }
  json.read_if_present("run", team.program.run);
  json.read_if_present("folder", team.program.folder);
  json.read_if_present("lockstep", team.program.lockstep);
  if (team.source.empty() || team.source == TeamConfig::firasim_prefix) {
    json.at("entry").complain(
        "\"house:NAME\", the path of a library, \"submitted\" or \"firasim:NAME\" is expected");
  }
  for (const char* key : {"run", "folder", "lockstep"}) {
    if (json.has(key) && !team.is_firasim())
      json.at(key).complain("only a team whose entry is \"firasim:NAME\" has it");
  }
  for (const char* key : {"dds", "parameters"}) {
    if (json.has(key) && team.is_firasim())
      json.at(key).complain("a team whose entry is \"firasim:NAME\" has none");
  }
  return team;
}

FirasimPlace read_firasim(const JsonReader& json) {
  json.expect_object(
      {"instance", "interface", "vision", "command", "referee", "placement", "join_within"});
  FirasimPlace place;
  read_count(json, "instance", 0, 9999, place.instance);
  json.read_if_present("interface", place.interface);
  json.read_if_present("vision", place.vision);
  json.read_if_present("command", place.command);
  json.read_if_present("referee", place.referee);
  json.read_if_present("placement", place.placement);
  if (json.has("join_within")) place.join_within = json.at("join_within").number(0.0, 1e6);
  return place;
}

// Writes the settings that differ from the defaults.
Json firasim_json(const FirasimPlace& place) {
  const FirasimPlace plain;
  Json json = Json::object();
  if (place.instance != plain.instance) json["instance"] = place.instance;
  if (place.interface != plain.interface) json["interface"] = place.interface;
  if (!place.vision.empty()) json["vision"] = place.vision;
  if (!place.command.empty()) json["command"] = place.command;
  if (!place.referee.empty()) json["referee"] = place.referee;
  if (!place.placement.empty()) json["placement"] = place.placement;
  if (place.join_within != plain.join_within) json["join_within"] = place.join_within;
  return json;
}

Json team_json(const TeamConfig& team) {
  Json json{{"name", team.name}, {"entry", team.source}};
  if (team.over_dds) json["dds"] = true;
  if (!team.parameters.empty()) json["parameters"] = record::to_json(team.parameters);
  if (!team.program.run.empty()) json["run"] = team.program.run;
  if (!team.program.folder.empty()) json["folder"] = team.program.folder;
  if (team.program.lockstep) json["lockstep"] = true;
  return json;
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
  format.kind = json.at("kind").name<FormatKind>();
  const bool is_knockout = format.kind == FormatKind::knockout;
  read_count(json, "legs", 1, is_knockout ? legs_per_fixture : 100, format.legs);
  read_count(json, "groups", 1, 500, format.groups);
  read_count(json, "qualifiers", 1, 500, format.qualifiers);
  read_count(json, "rounds", 0, 500, format.rounds);
  read_count(json, "sample", 1, 1000, format.sample);
  read_count(json, "opponents", 0, 1000, format.opponents);
  json.read_if_present("third_place", format.third_place);
  return format;
}

// Writes the settings that differ from the defaults of the format.
Json format_json(const Format& format) {
  const Format plain;
  Json json{{"kind", to_string(format.kind)}};
  if (format.legs != plain.legs) json["legs"] = format.legs;
  if (format.groups != plain.groups) json["groups"] = format.groups;
  if (format.qualifiers != plain.qualifiers) json["qualifiers"] = format.qualifiers;
  if (format.third_place != plain.third_place) json["third_place"] = format.third_place;
  if (format.rounds != plain.rounds) json["rounds"] = format.rounds;
  if (format.sample != plain.sample) json["sample"] = format.sample;
  if (format.opponents != plain.opponents) json["opponents"] = format.opponents;
  return json.size() == 1 ? json["kind"] : json;
}

// Reads the name of a time zone and finds it.
void read_zone(const JsonReader& json, LeagueFile& file) {
  file.zone = json.text();
  if (file.zone.empty()) return;
  auto zone = system::TimeZone::find(file.zone);
  if (zone) {
    file.time_zone = *zone;
  } else {
    json.complain(zone.error().what);
  }
}

std::string read_time(const JsonReader& json, const LeagueFile& file) {
  const std::string text = json.text();
  if (text.empty()) return text;
  const auto time = utc_of(text, file);
  // Leagues of before took such a time, and must be read as they were.
  const auto local = file.has_former_rules() ? system::parse_time(text) : std::nullopt;
  if (!time && local && local->is_local) return utc_text(file.time_zone.from_local(local->at));
  if (!time) json.complain(time.error().what);
  return time.value_or("");
}

// A leg without a time to play would never end, and one of no time has no football.
referee::Rules read_rules_of(const JsonReader& json, League league) {
  const referee::Rules rules = record::read_rules(json, league);
  if (json.has("half_s") &&
      !(rules.half_s >= record::min_half_s && rules.half_s <= record::max_half_s))
    json.at("half_s").complain("a half of a league has 0.1 to 36000 seconds");
  return rules;
}

Points read_points(const JsonReader& json) {
  json.expect_object({"win", "draw", "loss"});
  Points points;
  read_count(json, "win", -max_points, max_points, points.win);
  read_count(json, "draw", -max_points, max_points, points.draw);
  read_count(json, "loss", -max_points, max_points, points.loss);
  return points;
}

LeagueFile read_league(const JsonReader& json, int rules_version) {
  json.expect_object({"schema", "title", "format", "league", "rules", "conditions", "pitch", "seed",
                      "points", "tie_breaks", "rules_version", "zone", "freeze", "strikes",
                      "anonymous", "thoughts", "firasim", "teams"});
  json.expect_schema(schema);
  LeagueFile file;
  file.rules_version = rules_version;
  read_count(json, "rules_version", former_rules, current_rules, file.rules_version);
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
    for (const JsonReader& rule : json.at("tie_breaks").elements(0, enum_names<TieBreak>.size())) {
      file.tie_breaks.push_back(rule.name<TieBreak>());
    }
  } else if (file.format.kind == FormatKind::swiss) {
    // Among teams of equal points, the one with stronger opponents ranks higher.
    file.tie_breaks.insert(file.tie_breaks.begin(), TieBreak::opponents_points);
  }
  if (json.has("zone")) read_zone(json.at("zone"), file);
  if (json.has("freeze")) file.freeze = read_time(json.at("freeze"), file);
  json.read_if_present("anonymous", file.is_anonymous);
  json.read_if_present("thoughts", file.keeps_thoughts);
  read_count(json, "strikes", 0, 1000, file.strikes);
  if (json.has("firasim")) file.firasim = read_firasim(json.at("firasim"));
  if (json.has("teams")) file.teams = read_teams(json.at("teams"));
  return file;
}

}  // namespace

match::Conditions default_conditions() {
  return match::conditions_of(match::default_preset);
}

bool is_time(const std::string& text) {
  const std::string pattern = "dddd-dd-ddTdd:dd:ddZ";
  return text.size() == pattern.size() &&
         std::equal(text.begin(), text.end(), pattern.begin(), [](char c, char expected) {
           return expected == 'd' ? c >= '0' && c <= '9' : c == expected;
         });
}

std::string utc_text(std::int64_t at) {
  return system::utc_text(at);
}

Result<std::string> utc_of(const std::string& text, const LeagueFile& file) {
  const auto in_words = [](std::int64_t shown) {
    std::string words = utc_text(shown);
    words.pop_back();  // the Z
    return words;
  };
  const auto time = system::parse_time(text);
  if (!time) {
    return fail(Errc::input,
                "a time like \"2026-11-30T18:00:00Z\", "
                "\"2026-11-30T19:00:00+01:00\" or, in the league's zone, "
                "\"2026-11-30T19:00:00\" is expected");
  }
  const auto gap = time->is_local ? file.time_zone.gap_at(time->at) : std::nullopt;
  if (gap) {
    return fail(Errc::input, "\"" + text + "\" does not exist in " + file.zone +
                                 ": clocks go from \"" + in_words(gap->first) + "\" to \"" +
                                 in_words(gap->second) + "\"; choose one of the two");
  }
  return utc_text(time->is_local ? file.time_zone.from_local(time->at) : time->at);
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
  for (const char c : name) {
    const bool good = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                      c == '-' || c == '_' || c == '.';
    if (!good) return false;
  }
  return true;
}

Result<LeagueFile> parse_league_file(const std::string& text, const std::string& path,
                                     int rules_version) {
  return record::read_json<LeagueFile>(
      text, path, Errc::input,
      [rules_version](const JsonReader& json) { return read_league(json, rules_version); });
}

std::string print_firasim_team(const TeamConfig& team) {
  return record::json_text(team_json(team), 2) + "\n";
}

std::string print_league_file(const LeagueFile& file) {
  Json tie_breaks = Json::array();
  for (const TieBreak rule : file.tie_breaks) tie_breaks.push_back(to_string(rule));
  Json teams = Json::array();
  for (const TeamConfig& team : file.teams) teams.push_back(team_json(team));
  Json json{{"schema", schema},
            {"title", file.title},
            {"format", format_json(file.format)},
            {"league", to_string(file.league)},
            {"rules", record::to_json(file.rules)}};
  if (file.conditions) json["conditions"] = record::to_json(*file.conditions);
  if (file.pitch) json["pitch"] = record::to_json(*file.pitch);
  json.update({{"seed", file.seed},
               {"points",
                {{"win", file.points.win}, {"draw", file.points.draw}, {"loss", file.points.loss}}},
               {"tie_breaks", tie_breaks},
               {"strikes", file.strikes}});
  if (!file.has_former_rules()) json["rules_version"] = file.rules_version;
  if (!file.zone.empty()) json["zone"] = file.zone;
  if (!file.freeze.empty()) json["freeze"] = file.freeze;
  if (file.is_anonymous) json["anonymous"] = true;
  if (file.keeps_thoughts) json["thoughts"] = true;
  if (const Json firasim = firasim_json(file.firasim); !firasim.empty()) json["firasim"] = firasim;
  json["teams"] = teams;
  return record::json_text(json, 2) + "\n";
}

}  // namespace mirocup::league
