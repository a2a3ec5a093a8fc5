// SPDX-License-Identifier: MIT
//
// The folder of a league: the paths of league.json, journal.jsonl, entries/, records/ and site/,
// the creation of the folder, and the entries in it.
#pragma once

#include "tournaments/league/league_state.hpp"

#include <string>

namespace mirocup::league {

struct Folder {
  std::string path;

  std::string config() const { return path + "/league.json"; }
  std::string journal() const { return path + "/journal.jsonl"; }
  std::string lock() const { return path + "/.lock"; }  // held while an event is written
  std::string running() const {
    return path + "/.running";
  }  // held by the process that plays the league; the file has its id
  std::string submitting() const { return path + "/.submitting"; }  // held during a check
  std::string entry(const std::string& team, int number) const {
    return path + "/entries/" + team + "/" + std::to_string(number);
  }
  std::string library(const std::string& team, int number) const {
    return entry(team, number) + "/strategy.so";
  }
  std::string verdict(const std::string& team, int number) const {
    return entry(team, number) + "/verdict.json";
  }
  std::string record(const Fixture& fixture, int leg, int version) const {
    return record_name(fixture, leg, version).insert(0, path + "/");
  }
  static std::string record_name(const Fixture& fixture, int leg, int version) {
    return "records/" + fixture.id() + "-" + std::to_string(leg) + "-" + std::to_string(version) +
           ".json";
  }
  std::string credentials() const { return path + "/credentials"; }
  std::string site() const { return path + "/site"; }
};

// Creates the folder with this league.json and each team's library as its first entry. Refuses a
// folder that has a league already.
Result<void> init_folder(system::Files& files, const Folder& folder, const LeagueFile& file);

// Returns the path of the library that the team's source names: a file, or that of a house team.
Result<std::string> library_of(system::Files& files, const TeamConfig& team);

// Stores a library in the folder as the team's entry `number`, with the verdict of its check; "" if
// it was not checked. entry.json is written last: an entry without it is incomplete.
Result<void> add_entry(system::Files& files, const Folder& folder, const std::string& team,
                       int number, const std::string& library, const std::string& verdict = "");

// Return the number of the team's last entry, and of its last entry that the check did not reject;
// 0 if there is none.
int last_entry(system::Files& files, const Folder& folder, const std::string& team);
int last_accepted_entry(system::Files& files, const Folder& folder, const std::string& team);

}  // namespace mirocup::league
