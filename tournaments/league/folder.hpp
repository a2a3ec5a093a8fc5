// SPDX-License-Identifier: MIT
//
// The folder of a league: league.json, journal.jsonl, entries/, records/ and site/. This file has
// its paths and its creation. No link in the folder is followed
// (system::follow_no_links_below).
#pragma once

#include "system/files.hpp"
#include "tournaments/league/league_state.hpp"

#include <set>
#include <string>
#include <vector>

namespace mirocup::league {

struct Folder {
  // `site` is the folder of the pages; "": site/ in the league's folder.
  explicit Folder(std::string folder, std::string site = "");

  std::string path;

  std::string config() const { return path + "/league.json"; }
  std::string journal() const { return path + "/journal.jsonl"; }
  std::string journal_head() const { return path + "/journal.head"; }
  std::string lock() const { return path + "/.lock"; }  // held while an event is written

  std::string people() const { return path + "/teams.json"; }  // people.hpp
  std::string pruned() const { return path + "/pruned.json"; }
  std::string private_reasons() const { return path + "/reasons.txt"; }  // acts.hpp
  std::string notice() const { return path + "/notice.txt"; }

  // The digests of each night for teams and host (publish/night.hpp). Only the host can read this
  // folder.
  std::string nights() const { return path + "/nights"; }

  // The book of hand-ins and friendlies (book.hpp), which is locked while a line is written.
  std::string hand_in_book() const { return path + "/hand-ins.jsonl"; }

  // Locked by the server that takes hand-ins.
  std::string handing_in() const { return path + "/.handing-in"; }

  // The records of the friendlies.
  std::string friendlies(const std::string& team) const {
    return entries() + "/" + team + "/friendlies";
  }
  std::string friendly(const std::string& team, int number) const {
    return path + "/" + friendly_name(team, number);
  }
  static std::string friendly_name(const std::string& team, int number) {
    return "entries/" + team + "/friendlies/" + std::to_string(number) + ".json";
  }
  // The output of `mirocup drill` for an entry.
  std::string drill_marks(const std::string& team, int entry) const {
    return friendlies(team) + "/drills-" + std::to_string(entry) + ".json";
  }

  std::string uploads() const { return entries() + "/.uploads"; }  // files that are arriving

  // The legs that `league grades --decide` plays. A team's mark is there once the host has released
  // it: the values of page/mark.html, with the paths of records inside this league.
  std::string marks() const { return path + "/marks"; }
  std::string released_mark(const std::string& team) const {
    return marks() + "/" + team + ".json";
  }

  std::string sheets() const { return path + "/sheets.json"; }  // sheets.hpp
  std::string released_scores() const { return marks() + "/sheets"; }
  std::string released_scores(const std::string& team) const {
    return released_scores() + "/" + team + ".json";
  }

  // The league of the closing round, if the league has one.
  Folder closing_round() const { return Folder{path + "/final"}; }

  // Locked while the league is played; the text of the file is the id of the process that plays the
  // league.
  std::string running() const { return path + "/.running"; }

  // Locked while an answer or a pin is booked with all that follows from it.
  std::string submitting() const { return path + "/.submitting"; }

  // Locked while `league submit` checks an entry, so that two checks do not slow each other down.
  std::string checking() const { return path + "/.checking"; }

  // Only the host reads the files below.
  std::string entries() const { return path + "/entries"; }
  std::string entry(const std::string& team, int number) const {
    return entries() + "/" + team + "/" + std::to_string(number);
  }
  // For a team in Python this file is the text of the program, not a library.
  std::string library(const std::string& team, int number) const {
    return entry(team, number) + "/strategy.so";
  }
  // The source from which the library was made.
  std::string source(const std::string& team, int number) const {
    return entry(team, number) + "/source";
  }
  // What the programs that compile and check the entry answer (record/answer.hpp), and what they
  // print.
  std::string check_answer(const std::string& team, int number) const {
    return entry(team, number) + "/check.jsonl";
  }
  std::string check_log(const std::string& team, int number) const {
    return entry(team, number) + "/check.log";
  }
  // The record of the leg that the check keeps (EntryReport::gate_leg).
  std::string gate_leg(const std::string& team, int number) const {
    return entry(team, number) + "/gate.json";
  }
  std::string entry_file(const std::string& team, int number) const {
    return entry(team, number) + "/entry.json";
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
  std::string site() const { return site_elsewhere_.empty() ? path + "/site" : site_elsewhere_; }
  bool has_site_elsewhere() const { return !site_elsewhere_.empty(); }

 private:
  std::string site_elsewhere_;
};

// Errors: Errc::input if the folder holds no league, Errc::unavailable if this user may not read
// the folder.
Result<void> expect_league(system::Files& files, const Folder& folder);

// For commands that write into the folder. Error: Errc::unavailable if the league belongs to
// another user, because that user could not change files that this command makes. A folder without
// a league passes.
Result<void> expect_owner(const Folder& folder);

// Reads and writes the pruned nights: the host has removed the pages of their legs to save room
// (league_state.hpp). Without pruned nights there is no file.
Result<std::set<int>> read_pruned_nights(system::Files& files, const Folder& folder);
Result<void> write_pruned_nights(system::Files& files, const Folder& folder,
                                 const std::set<int>& nights);

// Reads and writes the host's notice at the top of the front page; "": none. A person may also
// write the file by hand. Errors of writing: Errc::input if the text is not UTF-8 or longer than
// max_notice.
inline constexpr std::size_t max_notice = 1000;  // bytes
Result<std::string> read_notice(system::Files& files, const Folder& folder);
Result<void> write_notice(system::Files& files, const Folder& folder, const std::string& text);

// Creates the folder with this league.json and with each team's library as the team's entry 1.
// Error: Errc::input if the folder holds a league already.
Result<void> init_folder(system::Files& files, const Folder& folder, const LeagueFile& file);

// Returns the bytes of the library that a team names: a file or a house team. As in `mirocup check`
// and `match`, a link is refused. A relative path begins at `base` ("": the working folder).
Result<std::string> library_of(system::Files& files, const TeamConfig& team,
                               const std::string& base = "");

// Makes the folders of the team's entries, closed to other users.
Result<void> make_entries_folder(system::Files& files, const Folder& folder,
                                 const std::string& team);

// Writes entry.json, which says that all that follows from the answer to an entry is done.
Result<void> write_entry_file(system::Files& files, const Folder& folder, const std::string& team,
                              int number, const std::string& sha256);

}  // namespace mirocup::league
