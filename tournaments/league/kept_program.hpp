// SPDX-License-Identifier: MIT
//
// The copies of match servers in the folder of a league: one of each program that has played the
// league. Only the program that played a leg is certain to repeat the course of the leg. In another
// program the same commands may give another course.
//
// A folder may come from another host. So a copy is run only if its digest is on a list outside the
// folder. This host lists a copy that it has kept itself, or that its user has called trusted.
#pragma once

#include "system/descriptor.hpp"
#include "tournaments/league/folder.hpp"

#include <map>
#include <string>
#include <vector>

namespace mirocup::league {

// The largest size of a program, bytes. Programs with sanitizers are large.
inline constexpr std::uint64_t max_program = 256u << 20;

// Returns the path of the kept match server with the behaviour `game`, as in records.
std::string kept_program(const Folder& folder, const std::string& game);

// The files of the browser module (browser/) of a kept program, and their paths. The files exist
// only if they were built.
inline constexpr const char* kept_module_files[] = {"mirocup.js", "mirocup.wasm"};
std::string kept_module(const Folder& folder, const std::string& game, const std::string& file);

// Returns the behaviour of the program that played the record at a path inside the folder; "" if
// the record does not exist or names no behaviour. It is an error if the record cannot be read or
// is damaged.
Result<std::string> game_of_record(system::Files& files, const Folder& folder,
                                   const std::string& record);

// True if this host's list holds the program with these bytes. It is an error if the list cannot be
// read, or if others may write to it.
Result<bool> is_trusted_program(const std::string& bytes);

// Puts the program with these bytes on this host's list, unless the list has it.
Result<void> trust_program(const std::string& bytes);

// Puts all programs of the league's folder, with their modules, on this host's list, and returns
// the programs' paths.
Result<std::vector<std::string>> trust_kept_programs(system::Files& files, const Folder& folder);

// A match server that simulates records again.
struct MatchServer {
  std::string path;                // the server's path, for messages
  std::vector<std::string> words;  // the beginning of a command line that runs the server
  std::string why_not_kept;        // why a kept program is not run, a sentence; "": no reason
};

// The match servers for the records of a league. A kept program is run from a copy in memory, whose
// digest is on the list. The object must outlive the processes of the servers.
class MatchServers {
 public:
  MatchServers(system::Files& files, const Folder& folder);

  // Returns the kept match server with a behaviour. Returns this program's own server if it has
  // that behaviour, if no such program is kept, or if this host does not trust the kept program.
  const MatchServer& of_game(const std::string& game);

  // Returns the match server for the record at a path inside the folder. If the record is damaged,
  // returns this program's own server.
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
