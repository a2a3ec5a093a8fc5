// SPDX-License-Identifier: MIT
#include "tournaments/league/roster.hpp"

#include "record/json_reader.hpp"
#include "system/locations.hpp"
#include "tournaments/league/apply.hpp"
#include "tournaments/league/submission.hpp"

#include <algorithm>
#include <map>

namespace mirocup::league {

std::string RosterRow::state() const {
  if (handed_in.empty()) return last_entry > 0 ? "given by the host" : "nothing handed in";
  if (!has_ended) return "waits for its check";
  return was_accepted ? "accepted" : "refused";
}

std::string RosterRow::standing() const {
  const std::string next = ", entry " + std::to_string(last_accepted);
  std::string words;
  if (playing_entry > 0) words += ", plays with entry " + std::to_string(playing_entry);
  if (last_accepted > 0 && last_accepted != playing_entry)
    words += next + (playing_entry > 0 ? " from the next night on" : " will play");
  if (!has_joined) words += ", not in the league";
  if (status == TeamStatus::paused) words += ", paused: " + why;
  if (status == TeamStatus::withdrawn) words += ", has withdrawn";
  return words;
}

std::vector<std::string> RosterRow::told() const {
  std::vector<std::string> told;
  if (is_missing()) told.push_back("nothing was handed in");
  if (!has_ended) told.push_back("the last hand-in waits for its check");
  if (was_refused()) {
    const std::string name = team + ": ";
    told.push_back(message.starts_with(name) ? message.substr(name.size()) : message);
  }
  told.insert(told.end(), notes.begin(), notes.end());
  return told;
}

namespace {

// The warnings that the check gave about an entry; none about an entry that the host gave.
std::vector<std::string> warnings_about(system::Files& files, const Folder& folder,
                                        const std::string& team, int entry) {
  std::vector<std::string> warnings;
  const auto verdict = read_verdict(files, folder, team, entry);
  if (!verdict || !verdict->contains("notes")) return warnings;
  for (const Json& note : (*verdict)["notes"]) warnings.push_back(record::text_in(note, "text"));
  return warnings;
}

// The legs of a team that count.
struct CountedLegs {
  int played = 0;
  int lost = 0;
  int faults = 0;     // legs that it lost by its own faults
  std::string fault;  // the last of these
};

std::vector<CountedLegs> counted_legs(const LeagueState& state) {
  std::vector<CountedLegs> teams(state.teams.size());
  const auto add = [&](const PlayedLeg& leg, int team, bool counts) {
    if (!counts) return;
    CountedLegs& legs = teams[team];
    ++legs.played;
    if (leg.result.both_lose || leg.result.difference(team) < 0) ++legs.lost;
    if (!leg.fault || leg.fault->team != state.name(team)) return;
    ++legs.faults;
    legs.fault = leg.fault->code + ": " + leg.fault->text;
  };
  for (const FixtureState& f : state.fixtures) {
    for (const LegState& leg : f.legs) {
      if (f.is_annulled || !leg.played) continue;
      const LegResult& result = leg.played->result;
      add(*leg.played, result.home, result.home_entry_still_plays);
      add(*leg.played, result.away, result.away_entry_still_plays);
    }
  }
  return teams;
}

// Returns the rank of each team; 0: it has none.
std::map<std::string, int> ranks(const LeagueState& state) {
  std::map<std::string, int> ranks;
  for (const TableRow& row : state.table()) ranks[state.name(row.team)] = row.rank;
  return ranks;
}

// Returns by how many ranks each team has fallen since the last night began.
Result<std::map<std::string, int>> falls(const LeagueStore& store) {
  std::map<std::string, int> falls;
  const LeagueState& state = store.state();
  if (state.nights.size() < 2) return falls;
  const auto& lines = store.journal().lines();
  std::size_t night = lines.size() - 1;
  while (night > 0 && record::text_in(lines[night], "kind") != NightBegan::kind) --night;
  MIROCUP_TRY(const auto before, state_from_lines(state.file, store.journal(), night));
  const auto now = ranks(state);
  for (const auto& [team, rank] : ranks(before)) {
    if (rank > 0 && now.at(team) > 0) falls[team] = now.at(team) - rank;
  }
  return falls;
}

// The sources of the teams that `mirocup new` writes, before and behind the team's name.
using Templates = std::vector<std::pair<std::string, std::string>>;

Templates read_templates(system::Files& files) {
  constexpr std::string_view name = "@NAME@";
  Templates templates;
  const std::string folder = system::team_kit().templates;
  for (const char* path : {"/c++/team.cpp", "/c/team.c", "/python/team.py"}) {
    const auto text = files.read_named(folder + path, system::size_limit::note);
    const std::size_t at = text ? text->find(name) : std::string::npos;
    if (at != std::string::npos)
      templates.emplace_back(text->substr(0, at), text->substr(at + name.size()));
  }
  return templates;
}

// True if the source of an entry is that of a new team.
bool is_template(system::Files& files, const Templates& templates, const Folder& folder,
                 const HandedIn& entry) {
  constexpr std::uint64_t longest = 64u << 10;  // bytes
  auto source = files.read(folder.source(entry.team, entry.entry), {.max_size = longest});
  if (!source) source = files.read(folder.library(entry.team, entry.entry), {.max_size = longest});
  return source && std::ranges::any_of(templates, [&source](const auto& one) {
           return source->starts_with(one.first) && source->ends_with(one.second);
         });
}

// Returns the last entry that came late, is accepted, and could play; 0: none.
int last_late(const HandIns& hand_ins, const std::string& team) {
  int last = 0;
  for (const auto& [number, handed] : hand_ins.of_team(team)) {
    if (handed.is_late && handed.is_accepted() && number > hand_ins.playing(team)) last = number;
  }
  return last;
}

// Returns what the legs of a team say of it.
std::vector<std::string> notes_on_legs(const CountedLegs& legs, int fall) {
  constexpr int told_losses = 6;  // a team that has lost all of so many legs needs help
  constexpr int told_fall = 10;   // ranks
  std::vector<std::string> notes;
  if (legs.played >= told_losses && legs.lost == legs.played)
    notes.push_back("it has lost all " + std::to_string(legs.played) + " legs");
  if (legs.faults > 0)
    notes.push_back("it has lost " + std::to_string(legs.faults) + " of " +
                    std::to_string(legs.played) + " legs by its own faults, the last by " +
                    legs.fault);
  if (fall >= told_fall)
    notes.push_back("it has fallen by " + std::to_string(fall) +
                    " ranks since the last night began");
  return notes;
}

}  // namespace

Result<PeopleOfTeams> everybody(system::Files& files, const LeagueStore& store) {
  MIROCUP_TRY(auto people, read_people(files, store.folder()));
  MIROCUP_TRY(const auto names, files.names_if_there(store.folder().entries()));
  for (const std::string& name : names) {
    if (is_good_name(name)) people.try_emplace(name);
  }
  for (const TeamConfig& team : store.state().file.teams) people.try_emplace(team.name);
  return people;
}

Result<std::vector<RosterRow>> roster(system::Files& files, const LeagueStore& store,
                                      const HandIns& hand_ins) {
  const LeagueState& state = store.state();
  MIROCUP_TRY(const auto people, everybody(files, store));
  MIROCUP_TRY(auto fallen, falls(store));
  const auto legs = counted_legs(state);
  std::vector<RosterRow> rows;
  for (int i = 0; i < static_cast<int>(state.teams.size()); ++i) {
    RosterRow row;
    row.team = state.name(i);
    row.is_house = state.file.teams[i].is_house();
    row.status = state.teams[i].status;
    row.why = state.teams[i].why;
    row.playing_entry = state.teams[i].entry;
    if (!row.is_house) row.notes = notes_on_legs(legs[i], fallen[row.team]);
    rows.push_back(std::move(row));
  }
  for (const auto& [name, one] : people) {
    if (state.find_team(name)) continue;
    RosterRow row;
    row.team = name;
    row.has_joined = false;
    rows.push_back(std::move(row));
  }
  const Templates templates = read_templates(files);
  std::map<std::string, std::vector<std::size_t>> by_file;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    RosterRow& row = rows[i];
    row.people = people.at(row.team);
    row.last_entry = hand_ins.last_kept(row.team);
    row.last_accepted = hand_ins.playing(row.team);
    if (const HandedIn* playing = hand_ins.find(row.team, row.last_accepted)) {
      row.sha256 = playing->library;
      const auto warnings = warnings_about(files, store.folder(), row.team, row.last_accepted);
      row.notes.insert(row.notes.end(), warnings.begin(), warnings.end());
      if (is_template(files, templates, store.folder(), *playing)) {
        row.notes.push_back("it is the team that mirocup new writes, unchanged");
      } else {
        by_file[row.sha256].push_back(i);
      }
    }
    if (const int late = last_late(hand_ins, row.team); late > 0)
      row.notes.push_back("entry " + std::to_string(late) +
                          " came after the deadline: the host decides about it");
    const HandedIn* last = hand_ins.last_try(row.team);
    if (last == nullptr) continue;
    row.handed_in = utc_text(last->at);
    row.was_accepted = last->state == HandInState::accepted;
    row.has_ended = is_final(last->state);
    row.message = row.has_ended ? last->message : row.team + " waits for its check";
  }
  for (const auto& [sha256, same] : by_file) {
    for (const std::size_t one : same) {
      for (const std::size_t other : same) {
        if (one != other) rows[one].same_as.push_back(rows[other].team);
      }
    }
  }
  return rows;
}

std::string last_leg_at(const Journal& journal) {
  for (std::size_t i = journal.lines().size(); i-- > 0;) {
    const Json& line = journal.lines()[i];
    if (record::text_in(line, "kind") != LegPlayed::kind) continue;
    return record::text_in(line, "at");
  }
  return "";
}

Json roster_json(const std::vector<RosterRow>& rows) {
  Json teams = Json::array();
  for (const RosterRow& row : rows) {
    teams.push_back({{"team", row.team},
                     {"display", record::or_null(row.people.display)},
                     {"members", row.people.members},
                     {"house", row.is_house},
                     {"joined", row.has_joined},
                     {"status", row.status == TeamStatus::playing  ? "playing"
                                : row.status == TeamStatus::paused ? "paused"
                                                                   : "withdrawn"},
                     {"plays_with", row.playing_entry > 0 ? Json(row.playing_entry) : Json()},
                     {"last_accepted", row.last_accepted > 0 ? Json(row.last_accepted) : Json()},
                     {"state", row.state()},
                     {"handed_in", record::or_null(row.handed_in)},
                     {"message", record::or_null(row.message)},
                     {"sha256", record::or_null(row.sha256)},
                     {"same_file_as", row.same_as},
                     {"notes", row.notes}});
  }
  return teams;
}

}  // namespace mirocup::league
