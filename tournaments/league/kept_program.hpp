// SPDX-License-Identifier: MIT
//
// The copies of match servers in the folder of a league: each program that has played it. What a
// leg looked like is known to the program that played it only: another one may go another way from
// the same commands.
//
// A folder may come from elsewhere. So a copy is run only if this host has kept it, or has said
// that it trusts it: a list outside the folder holds the digests of these copies.
#pragma once

#include "system/descriptor.hpp"
#include "tournaments/league/folder.hpp"

#include <map>
#include <string>
#include <vector>

namespace mirocup::league {

// How large a program may be, bytes: with sanitizers it is a large one.
inline constexpr std::uint64_t max_program = 256u << 20;

// The path at which the copy of the match server of that behaviour (`game` in records) is kept.
std::string kept_program(const Folder& folder, const std::string& game);

// Returns the behaviour of the program that played a record, a path inside the folder; "" if there
// is no such record, or if it is from before the behaviour was written down. Errors: the record
// cannot be read, or is damaged.
Result<std::string> game_of_record(system::Files& files, const Folder& folder,
                                   const std::string& record);

// Whether this host's list holds the program with these bytes. Errors: the list cannot be read, or
// others may write to it.
Result<bool> is_trusted_program(const std::string& bytes);

// Puts the program with these bytes on this host's list, if it is not there.
Result<void> trust_program(const std::string& bytes);

// Puts all programs of the league's folder on this host's list, and returns their paths.
Result<std::vector<std::string>> trust_kept_programs(system::Files& files, const Folder& folder);

// A match server that simulates records again.
struct MatchServer {
  std::string path;                // for people
  std::vector<std::string> words;  // what a command line begins with that runs it
  std::string why_not_kept;        // a sentence if a kept one is there and is not run; ""
};

// The match servers for the records of a league. A kept one is run from a copy in memory: its bytes
// are those of which the digest was on the list. The object lives as long as their processes.
class MatchServers {
 public:
  MatchServers(system::Files& files, const Folder& folder);

  // Returns the match server of that behaviour: the kept one, or that of this program if it behaves
  // alike, if none is kept, or if this host does not trust it.
  const MatchServer& of_game(const std::string& game);

  // The same for a record, a path inside the folder. One whose text is not what was written starts
  // no kept program.
  const MatchServer& of_record(const std::string& record);

  // That of this program.
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
