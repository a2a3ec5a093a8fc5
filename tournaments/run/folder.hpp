// SPDX-License-Identifier: MIT
//
// A league is a folder: league.json, journal.jsonl, entries/, records/, site/. Here are its paths
// and how it is made and opened.
#pragma once

#include "tournaments/run/league_state.hpp"

#include <string>

namespace mirocup::league {

struct Folder {
  std::string path;

  std::string config() const { return path + "/league.json"; }
  std::string journal() const { return path + "/journal.jsonl"; }
  std::string entry(const std::string& team, int number) const {
    return path + "/entries/" + team + "/" + std::to_string(number);
  }
  std::string library(const std::string& team, int number) const {
    return entry(team, number) + "/strategy.so";
  }
  std::string record(const Fixture& fixture, int leg, int attempt) const {
    return record_name(fixture, leg, attempt).insert(0, path + "/");
  }
  static std::string record_name(const Fixture& fixture, int leg, int attempt) {
    return "records/" + fixture.id() + "-" + std::to_string(leg) + "-" + std::to_string(attempt) +
           ".json";
  }
  std::string credentials() const { return path + "/credentials"; }
  std::string site() const { return path + "/site"; }
};

// Makes the folder with league.json as given and every team's library as its first entry. Refuses a
// folder that has a league already.
Result<void> init_folder(record::Files& files, const Folder& folder, const LeagueFile& file);

// The league as it stands. `notice` may be set to something that a person should know.
struct OpenLeague {
  Journal journal;
  LeagueState state;
};
Result<OpenLeague> open_folder(record::Files& files, const Folder& folder,
                               std::string* notice = nullptr);

}  // namespace mirocup::league
