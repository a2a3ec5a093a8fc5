// SPDX-License-Identifier: MIT
//
// A league is a folder: league.json, journal.jsonl, entries/, records/, site/. Here are its paths,
// how it is made, and what has been handed in.
#pragma once

#include "tournaments/league/league_state.hpp"

#include <string>

namespace mirocup::league {

struct Folder {
  std::string path;

  std::string config() const { return path + "/league.json"; }
  std::string journal() const { return path + "/journal.jsonl"; }
  std::string lock() const { return path + "/.lock"; }  // while a decision is written
  std::string running() const {
    return path + "/.running";
  }  // while it is played; by which process
  std::string submitting() const { return path + "/.submitting"; }  // while an entry is checked
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

// Makes the folder with league.json as given and every team's library as its first entry. Refuses a
// folder that has a league already.
Result<void> init_folder(system::Files& files, const Folder& folder, const LeagueFile& file);

// The library that a team names: a file, or a house team's.
Result<std::string> library_of(system::Files& files, const TeamConfig& team);

// Puts a library into the folder as the entry of that number, with the verdict of its check, if it
// was checked. The entry is there once entry.json is, which comes last.
Result<void> add_entry(system::Files& files, const Folder& folder, const std::string& team,
                       int number, const std::string& library, const std::string& verdict = "");

// The number of the last entry that was handed in, and of the last that was not rejected; 0: none.
int last_entry(system::Files& files, const Folder& folder, const std::string& team);
int last_accepted_entry(system::Files& files, const Folder& folder, const std::string& team);

}  // namespace mirocup::league
