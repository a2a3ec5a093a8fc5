// SPDX-License-Identifier: MIT
//
// The copies of match servers in the folder of a league: each program that has played it. Only the
// program that played a leg surely simulates it again: another program may take another course from
// the same commands.
//
// A folder may come from another host. So a copy is run only if its digest is on a list outside the
// folder: this host has kept the copy, or its user has said that it is trusted.
#pragma once

#include "system/descriptor.hpp"
#include "tournaments/league/folder.hpp"

#include <map>
#include <string>
#include <vector>

namespace mirocup::league {

// The largest size of a program, bytes; with sanitizers, programs are large.
inline constexpr std::uint64_t max_program = 256u << 20;

// The path at which the copy of the match server of that behaviour (`game` in records) is kept.
std::string kept_program(const Folder& folder, const std::string& game);

// The files of that program's module for browsers (browser/), beside its copy, if they were built.
inline constexpr const char* kept_module_files[] = {"mirocup.js", "mirocup.wasm"};
std::string kept_module(const Folder& folder, const std::string& game, const std::string& file);

// Returns the behaviour of the program that played a record, a path inside the folder; "" if there
// is no such record, or if it is from before the behaviour was written down. Errors: the record
// cannot be read, or is damaged.
Result<std::string> game_of_record(system::Files& files, const Folder& folder,
                                   const std::string& record);

// True if this host's list holds the program with these bytes. Errors: the list cannot be read, or
// others may write to it.
Result<bool> is_trusted_program(const std::string& bytes);

// Puts the program with these bytes on this host's list, if it is not there.
Result<void> trust_program(const std::string& bytes);

// Puts all programs of the league's folder, with their modules, on this host's list, and returns
// the programs' paths.
Result<std::vector<std::string>> trust_kept_programs(system::Files& files, const Folder& folder);

// A match server that simulates records again.
struct MatchServer {
  std::string path;                // for people
  std::vector<std::string> words;  // the beginning of a command line that runs it
  std::string why_not_kept;        // why a kept program is not run, a sentence; ""
};

// The match servers for the records of a league. A kept program is run from a copy in memory, whose
// bytes have the digest that was on the list. The object lives as long as their processes.
class MatchServers {
 public:
  MatchServers(system::Files& files, const Folder& folder);

  // Returns the match server of that behaviour: the kept program. Returns this program's own server
  // if it behaves alike, if no program is kept, or if this host does not trust the kept one.
  const MatchServer& of_game(const std::string& game);

  // The same for a record, a path inside the folder. If the record is damaged, returns this
  // program's own server.
  const MatchServer& of_record(const std::string& record);

  // Returns the match server of this program.
  const MatchServer& own() const { return own_; }

 private:
  MatchServer open_kept(const std::string& path);

  system::Files& files_;
  Folder folder_;
  MatchServer own_;
  std::map<std::string, MatchServer> by_game_;
  std::vector<system::Descriptor> copies_;
};

}  // namespace mirocup::league
