// SPDX-License-Identifier: MIT
#include "tournaments/format/league_file.hpp"

#include "server/record/rules_json.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

namespace mirocup::league {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view schema = "mirocup/league/1";

// What a league file says that cannot be; caught in parse_league_file().
struct Wrong {
  std::string where;
  std::string why;
};

template <class T>
T get(const Json& object, const std::string& at, const std::string& key, T fallback) {
  if (!object.contains(key)) return fallback;
  try {
    return object.at(key).get<T>();
  } catch (const Json::exception&) {
    throw Wrong{at + "/" + key, object.at(key).dump() + " is of the wrong type"};
  }
}

void only_keys(const Json& object, const std::string& at, const std::set<std::string>& known) {
  if (!object.is_object()) throw Wrong{at, "an object is expected"};
  for (const auto& [key, value] : object.items()) {
    if (known.count(key) == 0) throw Wrong{at + "/" + key, "there is no such key"};
  }
}

TeamConfig team_of(const Json& json, const std::string& at) {
  only_keys(json, at, {"name", "entry", "dds"});
  TeamConfig team;
  team.name = get<std::string>(json, at, "name", "");
  team.source = get<std::string>(json, at, "entry", "");
  team.over_dds = get<bool>(json, at, "dds", false);
  if (!is_good_name(team.name)) {
    throw Wrong{at + "/name",
                "a name of letters, digits, '-', '_' and '.' is expected, at most 40"};
  }
  if (team.source.empty())
    throw Wrong{at + "/entry", "\"house:NAME\" or the path of a library is expected"};
  return team;
}

int count_of(const Json& json, const std::string& at, const std::string& key, int fallback, int min,
             int max) {
  const int value = get<int>(json, at, key, fallback);
  if (value < min || value > max) {
    throw Wrong{at + "/" + key, std::to_string(min) + " to " + std::to_string(max) +
                                    " is expected, not " + std::to_string(value)};
  }
  return value;
}

FormatKind kind_of(const std::string& name, const std::string& at) {
  const auto kind = from_string<FormatKind>(name);
  if (!kind) {
    throw Wrong{at, "\"" + name + "\" is not one of " + list_of_names<FormatKind>()};
  }
  return *kind;
}

// A name alone, or an object with its settings.
Format format_of(const Json& json) {
  const std::string at = "/format";
  Format format;
  if (json.is_string()) {
    format.kind = kind_of(json.get<std::string>(), at);
    return format;
  }
  only_keys(json, at, {"kind", "legs", "groups", "qualifiers", "third_place", "rounds", "sample"});
  format.kind = kind_of(get<std::string>(json, at, "kind", ""), at + "/kind");
  const bool is_knockout = format.kind == FormatKind::knockout;
  format.legs = count_of(json, at, "legs", format.legs, 1, is_knockout ? legs_per_fixture : 100);
  format.groups = count_of(json, at, "groups", format.groups, 1, 500);
  format.qualifiers = count_of(json, at, "qualifiers", format.qualifiers, 1, 500);
  format.rounds = count_of(json, at, "rounds", format.rounds, 0, 500);
  format.sample = count_of(json, at, "sample", format.sample, 1, 1000);
  format.third_place = get<bool>(json, at, "third_place", format.third_place);
  return format;
}

// The settings that differ from those of a format's name alone.
Json format_json(const Format& format) {
  const Format plain;
  Json json{{"kind", to_string(format.kind)}};
  if (format.legs != plain.legs) json["legs"] = format.legs;
  if (format.groups != plain.groups) json["groups"] = format.groups;
  if (format.qualifiers != plain.qualifiers) json["qualifiers"] = format.qualifiers;
  if (format.third_place != plain.third_place) json["third_place"] = format.third_place;
  if (format.rounds != plain.rounds) json["rounds"] = format.rounds;
  if (format.sample != plain.sample) json["sample"] = format.sample;
  return json.size() == 1 ? json["kind"] : json;
}

bool is_time(const std::string& text) {
  const std::string pattern = "dddd-dd-ddTdd:dd:ddZ";
  return text.size() == pattern.size() &&
         std::equal(text.begin(), text.end(), pattern.begin(), [](char c, char expected) {
           return expected == 'd' ? c >= '0' && c <= '9' : c == expected;
         });
}

LeagueFile league_of(const Json& json) {
  only_keys(json, "",
            {"schema", "title", "format", "league", "rules", "seed", "points", "tie_breaks",
             "freeze", "strikes", "teams"});
  LeagueFile file;
  if (get<std::string>(json, "", "schema", "") != schema) {
    throw Wrong{"/schema", "\"" + std::string(schema) + "\" is expected"};
  }
  if (json.contains("format")) file.format = format_of(json["format"]);
  file.freeze = get<std::string>(json, "", "freeze", "");
  if (!file.freeze.empty() && !is_time(file.freeze)) {
    throw Wrong{"/freeze", "a time like \"2026-11-30T18:00:00Z\" is expected"};
  }
  file.strikes = count_of(json, "", "strikes", file.strikes, 0, 1000);
  file.title = get<std::string>(json, "", "title", file.title);
  const auto league = from_string<League>(get<std::string>(json, "", "league", "small"));
  if (!league) throw Wrong{"/league", "one of " + list_of_names<League>() + " is expected"};
  file.league = *league;
  file.seed = get<std::uint64_t>(json, "", "seed", file.seed);
  if (json.contains("rules")) {
    auto rules = record::rules_from_json(json["rules"], Errc::input, file.league);
    if (!rules) throw Wrong{"", rules.error().what};
    file.rules = *rules;
  }
  if (json.contains("points")) {
    only_keys(json["points"], "/points", {"win", "draw", "loss"});
    file.points.win = get<int>(json["points"], "/points", "win", file.points.win);
    file.points.draw = get<int>(json["points"], "/points", "draw", file.points.draw);
    file.points.loss = get<int>(json["points"], "/points", "loss", file.points.loss);
  }
  if (file.format.kind == FormatKind::swiss) {
    // Who met stronger opponents for the same points did more.
    file.tie_breaks.insert(file.tie_breaks.begin(), TieBreak::opponents_points);
  }
  if (json.contains("tie_breaks")) {
    file.tie_breaks.clear();
    for (const std::string& name : get<std::vector<std::string>>(json, "", "tie_breaks", {})) {
      const auto rule = from_string<TieBreak>(name);
      if (!rule) {
        throw Wrong{"/tie_breaks", "\"" + name + "\" is not one of " + list_of_names<TieBreak>()};
      }
      file.tie_breaks.push_back(*rule);
    }
  }
  const Json teams = json.value("teams", Json::array());
  if (!teams.is_array()) throw Wrong{"/teams", "a list is expected"};
  std::set<std::string> names;
  for (std::size_t i = 0; i < teams.size(); ++i) {
    const std::string at = "/teams/" + std::to_string(i);
    file.teams.push_back(team_of(teams[i], at));
    if (!names.insert(file.teams.back().name).second) {
      throw Wrong{at + "/name", "two teams are called \"" + file.teams.back().name + "\""};
    }
  }
  return file;
}

}  // namespace

bool is_good_name(const std::string& name) {
  if (name.empty() || name.size() > 40 || name[0] == '.' || name[0] == '-') return false;
  for (const char c : name) {
    const bool good = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                      c == '-' || c == '_' || c == '.';
    if (!good) return false;
  }
  return true;
}

Result<LeagueFile> parse_league_file(const std::string& text, const std::string& path) {
  try {
    return league_of(Json::parse(text));
  } catch (const Wrong& wrong) {
    return fail(Errc::input,
                path + ": " + wrong.where + (wrong.where.empty() ? "" : ": ") + wrong.why);
  } catch (const Json::exception& e) {
    return fail(Errc::input, path + ": " + e.what());
  }
}

std::string print_league_file(const LeagueFile& file) {
  Json tie_breaks = Json::array();
  for (const TieBreak rule : file.tie_breaks) tie_breaks.push_back(to_string(rule));
  Json teams = Json::array();
  for (const TeamConfig& team : file.teams) {
    Json json{{"name", team.name}, {"entry", team.source}};
    if (team.over_dds) json["dds"] = true;
    teams.push_back(json);
  }
  Json json{{"schema", schema},
            {"title", file.title},
            {"format", format_json(file.format)},
            {"league", to_string(file.league)},
            {"rules", record::to_json(file.rules)},
            {"seed", file.seed},
            {"points",
             {{"win", file.points.win}, {"draw", file.points.draw}, {"loss", file.points.loss}}},
            {"tie_breaks", tie_breaks},
            {"strikes", file.strikes}};
  if (!file.freeze.empty()) json["freeze"] = file.freeze;
  json["teams"] = teams;
  return json.dump(2) + "\n";
}

}  // namespace mirocup::league
