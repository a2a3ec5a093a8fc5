// SPDX-License-Identifier: MIT
//
// The folder of a league: league.json, journal.jsonl, entries/, records/ and site/. This file has
// its paths, its creation and its kept entries. No link in the folder is followed
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

  // The book of hand-ins over the network and their answers (handin/book.hpp).
  std::string hand_in_book() const { return path + "/hand-ins.jsonl"; }

  // The book of the friendlies (handin/book.hpp), and the folder of their records.
  std::string friendly_book() const { return path + "/friendlies.jsonl"; }
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

  // Locked while the league is played; the text of the file is the id of the process that plays the
  // league.
  std::string running() const { return path + "/.running"; }

  // Locked while a hand-in gets its number, and while an answer to a hand-in is booked.
  std::string submitting() const { return path + "/.submitting"; }

  // Locked while `league submit` checks an entry, so that two checks do not slow each other down.
  std::string checking() const { return path + "/.checking"; }

  // Only the host reads the files below.
  std::string entries() const { return path + "/entries"; }
  std::string hand_ins(const std::string& team) const {
    return entries() + "/" + team + "/hand-ins.json";
  }
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

// Stores the libraries that league.json names, for teams without an entry and for house teams whose
// library has changed. So a person may add teams to league.json after `init`. Relative paths begin
// at the league's folder. Returns the names of the teams whose library was stored.
Result<std::vector<std::string>> adopt_libraries(system::Files& files, const Folder& folder,
                                                 const LeagueFile& file);

// Stores a library in the folder as the entry `number`, with the verdict of its check if it was
// checked. Files and folders of the entry are closed to other users. entry.json is written last: an
// entry without this file does not exist.
Result<void> add_entry(system::Files& files, const Folder& folder, const std::string& team,
                       int number, const std::string& library, const std::string& verdict = "");

// Makes the folders of the team's entries, closed to other users.
Result<void> make_entries_folder(system::Files& files, const Folder& folder,
                                 const std::string& team);

// Returns the numbers of the kept entries of a team in the order of the hand-ins.
Result<std::vector<int>> entries_of(system::Files& files, const Folder& folder,
                                    const std::string& team);

// Returns the number of the next entry: one more than the highest number of a kept entry or of an
// entry whose check has not ended.
Result<int> next_entry(system::Files& files, const Folder& folder, const std::string& team);

// Returns the SHA-256 of a kept entry; "" if no entry has the number.
Result<std::string> sha256_of_entry(system::Files& files, const Folder& folder,
                                    const std::string& team, int number);

// True if the entry passed its check, or if the host stored it without a check. A verdict that
// cannot be read is an error, because the entry may be the one that plays.
Result<bool> is_accepted_entry(system::Files& files, const Folder& folder, const std::string& team,
                               int number);

// Return the number of the last entry that was handed in, and of the last accepted entry; 0 if the
// team has no such entry.
Result<int> last_entry(system::Files& files, const Folder& folder, const std::string& team);
Result<int> last_accepted_entry(system::Files& files, const Folder& folder,
                                const std::string& team);

}  // namespace mirocup::league
