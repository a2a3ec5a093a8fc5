// SPDX-License-Identifier: MIT
#include "tournaments/league/people.hpp"

#include "record/json_reader.hpp"
#include "system/file_lock.hpp"
#include "system/printable.hpp"
#include "system/text.hpp"

#include <set>
#include <unicode/bytestream.h>
#include <unicode/normalizer2.h>

namespace mirocup::league {

namespace {

constexpr std::string_view people_schema = "mirocup/teams/1";
constexpr std::size_t max_display = 60;  // bytes
constexpr std::size_t max_members = 20;

std::string objection_to_display(const std::string& text) {
  if (text.empty() || text.find_first_not_of(' ') == std::string::npos) return "a name is empty";
  if (text.size() > max_display)
    return "a name has at most " + std::to_string(max_display) + " bytes";
  if (system::printable(text) != text) return "a name is one line of text in UTF-8";
  return "";
}

std::string read_name(const record::JsonReader& json) {
  const std::string text = json.text();
  if (const std::string why = objection_to_display(text); !why.empty()) json.complain(why);
  return text;
}

PeopleOfTeams read_teams_file(const record::JsonReader& json) {
  json.expect_object({"schema", "teams"});
  json.expect_schema(people_schema);
  PeopleOfTeams people;
  for (const record::JsonReader& team : json.at("teams").elements(0, 1000)) {
    team.expect_object({"team", "display", "members", "more"});
    People& one = people[team.at("team").text()];
    if (team.has("display")) one.display = read_name(team.at("display"));
    if (team.has("more")) {
      for (const auto& [column, value] : team.at("more").members())
        one.more.emplace_back(column, value.text());
    }
    if (!team.has("members")) continue;
    for (const record::JsonReader& member : team.at("members").elements(0, max_members))
      one.members.push_back(read_name(member));
  }
  return people;
}

// Returns the text without what readers overlook: capitals, width, accents as characters of their
// own (NFKC_Casefold of Unicode), and blanks at which no line ends or of which there are several.
std::string look(const std::string& name) {
  UErrorCode error = U_ZERO_ERROR;
  std::string folded;
  icu::StringByteSink<std::string> sink(&folded);
  if (const auto* fold = icu::Normalizer2::getNFKCCasefoldInstance(error))
    fold->normalizeUTF8(0, name, sink, nullptr, error);
  std::string seen;
  for (const char c : folded) {
    if (c != ' ' || (!seen.empty() && seen.back() != ' ')) seen += c;
  }
  return seen;
}

}  // namespace

std::string objection_to(const People& one) {
  if (one.members.size() > max_members)
    return "a team has at most " + std::to_string(max_members) + " members";
  std::vector<std::string> names = one.members;
  if (!one.display.empty()) names.push_back(one.display);
  for (const std::string& name : names) {
    const std::string hidden = system::hidden_character(name);
    if (!hidden.empty()) return "a name has a character that nobody sees, " + hidden;
    if (std::string why = objection_to_display(name); !why.empty()) return why;
  }
  return "";
}

std::vector<std::string> members_of(const std::string& text) {
  std::vector<std::string> members = parts_of(system::replaced(text, "\n", ";"));
  std::erase(members, "");
  return members;
}

std::vector<std::string> parts_of(const std::string& cell) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= cell.size();) {
    const std::size_t stop = std::min(cell.find(';', at), cell.size());
    std::string& part = parts.emplace_back(cell.substr(at, stop - at));
    part.erase(0, part.find_first_not_of(' '));
    part.erase(part.find_last_not_of(' ') + 1);
    at = stop + 1;
  }
  return parts;
}

std::string looks_like(const PeopleOfTeams& people, const LeagueState& state,
                       const std::string& team, const std::string& display) {
  const std::string own = look(display);
  for (const auto& [other, one] : people) {
    if (other != team && (look(other) == own || look(one.display) == own)) return other;
  }
  for (const TeamConfig& other : state.file.teams) {
    if (other.name != team && look(other.name) == own) return other.name;
  }
  return "";
}

Result<PeopleOfTeams> read_people(system::Files& files, const Folder& folder) {
  MIROCUP_TRY(const auto text,
              files.read_if_there(folder.people(), {.max_size = system::size_limit::league_file}));
  if (!text) return PeopleOfTeams{};
  return record::read_json<PeopleOfTeams>(*text, folder.people(), Errc::input, read_teams_file);
}

Result<void> write_people(system::Files& files, const Folder& folder, const PeopleOfTeams& people) {
  Json teams = Json::array();
  for (const auto& [team, one] : people) {
    Json json{{"team", team}};
    if (!one.display.empty()) json["display"] = one.display;
    if (!one.members.empty()) json["members"] = one.members;
    for (const auto& [column, value] : one.more) json["more"][column] = value;
    teams.push_back(json);
  }
  const Json json{{"schema", people_schema}, {"teams", teams}};
  return files.write(folder.people(), record::json_text(json, 1) + "\n", system::Readers::owner);
}

Result<People> change_people(system::Files& files, const Folder& folder, const LeagueState& state,
                             const std::string& team, const std::function<void(People&)>& change) {
  MIROCUP_TRY(const auto lock, system::FileLock::acquire(folder.lock()));
  MIROCUP_TRY(auto people, read_people(files, folder));
  if (!state.find_team(team) && !people.contains(team))
    return fail(Errc::input, "there is no team " + team);
  People& one = people[team];
  const std::string before = one.display;
  change(one);
  std::string why = objection_to(one);
  if (why.empty() && !one.display.empty() && one.display != before) {
    if (const std::string other = looks_like(people, state, team, one.display); !other.empty())
      why = "people would take \"" + one.display + "\" for " + other;
  }
  if (!why.empty()) return fail(Errc::input, team + ": " + why);
  MIROCUP_TRY_VOID(write_people(files, folder, people));
  return one;
}

// Two teams of one name could not be told apart: then it is followed by their own.
std::vector<std::string> shown_names(const LeagueFile& file, const PeopleOfTeams& people) {
  if (file.is_anonymous || people.empty()) return {};
  std::vector<std::string> names;
  std::multiset<std::string> all;
  for (const TeamConfig& team : file.teams) {
    const auto known = people.find(team.name);
    const bool has = known != people.end() && !known->second.display.empty();
    all.insert(names.emplace_back(has ? known->second.display : team.name));
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (all.count(names[i]) > 1) names[i] += " (" + file.teams[i].name + ")";
  }
  return names;
}

}  // namespace mirocup::league
