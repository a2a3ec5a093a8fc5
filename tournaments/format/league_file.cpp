// SPDX-License-Identifier: MIT
#include "tournaments/format/league_file.hpp"

#include "server/record/rules_json.hpp"

#include <nlohmann/json.hpp>

#include <set>

namespace mirocup::league {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view schema = "mirocup/league/1";
constexpr std::string_view format = "double_round_robin";

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

// Names become folders, partitions and lines of tables.
bool is_good_name(const std::string& name) {
  if (name.empty() || name.size() > 40 || name[0] == '.' || name[0] == '-') return false;
  for (const char c : name) {
    const bool good = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                      c == '-' || c == '_' || c == '.';
    if (!good) return false;
  }
  return true;
}

TeamEntry team_of(const Json& json, const std::string& at) {
  only_keys(json, at, {"name", "entry", "dds"});
  TeamEntry team;
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

LeagueFile league_of(const Json& json) {
  only_keys(
      json, "",
      {"schema", "title", "format", "league", "rules", "seed", "points", "tie_breaks", "teams"});
  LeagueFile file;
  if (get<std::string>(json, "", "schema", "") != schema) {
    throw Wrong{"/schema", "\"" + std::string(schema) + "\" is expected"};
  }
  if (get<std::string>(json, "", "format", std::string(format)) != format) {
    throw Wrong{"/format", "\"" + std::string(format) + "\" is expected"};
  }
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
  for (const TeamEntry& team : file.teams) {
    Json json{{"name", team.name}, {"entry", team.source}};
    if (team.over_dds) json["dds"] = true;
    teams.push_back(json);
  }
  const Json json{
      {"schema", schema},
      {"title", file.title},
      {"format", format},
      {"league", to_string(file.league)},
      {"rules", record::to_json(file.rules)},
      {"seed", file.seed},
      {"points",
       {{"win", file.points.win}, {"draw", file.points.draw}, {"loss", file.points.loss}}},
      {"tie_breaks", tie_breaks},
      {"teams", teams}};
  return json.dump(2) + "\n";
}

}  // namespace mirocup::league
