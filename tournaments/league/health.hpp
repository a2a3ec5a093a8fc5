// SPDX-License-Identifier: MIT
//
// Says whether a person has to look at a league: its last night, the hand-ins that wait, the disk.
#pragma once

#include "tournaments/league/hand_ins.hpp"
#include "tournaments/league/league_store.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace mirocup::league {

// The disk space of a league's files, bytes.
struct DiskUse {
  std::uintmax_t all = 0;
  std::uintmax_t records = 0;  // with replay files and thoughts
  std::uintmax_t pages = 0;    // site/
  std::uintmax_t entries = 0;
  std::uintmax_t left = 0;  // still free for this user
};

// Looks at each file of the league. Files that vanish meanwhile, or that this user cannot see,
// count as empty.
DiskUse disk_use(const Folder& folder);

// Returns "142 MiB used (records 37, pages 71, entries 29), 12000 MiB left".
std::string in_words(const DiskUse& disk);
Json disk_json(const DiskUse& disk);

struct Health {
  int night = 0;                      // number of the last night; 0: no night yet
  std::string night_at;               // start of the last night, UTC
  int open_legs = 0;                  // legs of the whole league that are not decided
  bool is_playing = false;            // the league is being played now
  int waiting = 0;                    // hand-ins over the network without an answer
  std::int64_t waits_s = 0;           // wait of the oldest hand-in without an answer, s
  std::vector<std::string> problems;  // sentences, each with a remedy
};

// Examines a league. `now` is in s since 1970. Errors: those of gaps().
Result<Health> health(system::Files& files, const LeagueStore& store, const HandIns& hand_ins,
                      std::int64_t now);

}  // namespace mirocup::league
