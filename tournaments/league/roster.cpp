// SPDX-License-Identifier: MIT
#include "tournaments/league/roster.hpp"

#include "record/json_reader.hpp"
#include "tournaments/league/book.hpp"
#include "tournaments/league/submission.hpp"

#include <map>

namespace mirocup::league {

std::string RosterRow::state() const {
  if (handed_in.empty()) return last_entry > 0 ? "given by the host" : "nothing handed in";
  if (!has_ended) return "waits for its check";
  return was_accepted ? "accepted" : "refused";
}

std::vector<std::string> RosterRow::told() const {
  std::vector<std::string> told;
  if (last_entry == 0 && handed_in.empty()) told.push_back("nothing was handed in");
  if (!handed_in.empty() && !was_accepted && has_ended) told.push_back(message);
  told.insert(told.end(), notes.begin(), notes.end());
  return told;
}

namespace {

constexpr int told_losses = 6;  // a team that has lost all of so many legs needs help

// The warnings that the check gave about an entry; none about an entry that the host gave.
std::vector<std::string> warnings_about(system::Files& files, const Folder& folder,
                                        const std::string& team, int entry) {
  std::vector<std::string> warnings;
  const auto verdict = read_verdict(files, folder, team, entry);
  if (!verdict || !verdict->contains("notes")) return warnings;
  for (const Json& note : (*verdict)["notes"]) warnings.push_back(record::text_in(note, "text"));
  return warnings;
}

// The numbers of legs that count for each team, and of those that it lost.
struct Losses {
  std::vector<int> played, lost;

  explicit Losses(const LeagueState& state) : played(state.teams.size()), lost(state.teams.size()) {
    for (const LegResult& leg : state.results()) {
      if (leg.away == no_team) continue;
      add(leg.home, leg.counts_for_home, leg.both_lose || leg.home_goals < leg.away_goals);
      add(leg.away, leg.counts_for_away, leg.both_lose || leg.away_goals < leg.home_goals);
    }
  }
  void add(int team, bool counts, bool loses) {
    played[team] += counts ? 1 : 0;
    lost[team] += counts && loses ? 1 : 0;
  }
};

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

Result<std::vector<RosterRow>> roster(system::Files& files, const LeagueStore& store) {
  const LeagueState& state = store.state();
  MIROCUP_TRY(const auto people, everybody(files, store));
  MIROCUP_TRY(const auto book, Book::open(files, store.folder()));
  const HandIns& hand_ins = book.hand_ins();
  std::vector<RosterRow> rows;
  const Losses losses(state);
  for (std::size_t i = 0; i < state.teams.size(); ++i) {
    RosterRow row;
    row.team = state.file.teams[i].name;
    row.is_house = state.file.teams[i].is_house();
    row.status = state.teams[i].status;
    row.why = state.teams[i].why;
    row.playing_entry = state.teams[i].entry;
    if (losses.played[i] >= told_losses && losses.lost[i] == losses.played[i])
      row.notes.push_back("it has lost all " + std::to_string(losses.played[i]) + " legs");
    rows.push_back(std::move(row));
  }
  for (const auto& [name, one] : people) {
    if (state.find_team(name)) continue;
    RosterRow row;
    row.team = name;
    row.has_joined = false;
    rows.push_back(std::move(row));
  }
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
      by_file[row.sha256].push_back(i);
    }
    const HandedIn* last = hand_ins.last_try(row.team);
    if (last == nullptr) continue;
    if (last->is_late)
      row.notes.push_back("entry " + std::to_string(last->entry) +
                          " came after the deadline: league take lets it play");
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
