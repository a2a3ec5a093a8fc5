// SPDX-License-Identifier: MIT
//
// The command line that plays one leg of a league, equal for processes of this host, for GNU
// parallel and for a cluster. The result of the leg is the record that the command writes.
#pragma once

#include "tournaments/league/folder.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace mirocup::league {

// An attempt to play a leg.
struct LegId {
  Fixture fixture;
  int leg = 1;      // from 1
  int version = 1;  // number of the record in its file's name
  int attempt = 1;  // number of the attempt in the journal
};

// Returns the legs (from 1) of a fixture that can be played now, in order. A leg can be played if
// it is not decided and both teams are known, not paused and not withdrawn.
std::vector<int> open_legs(const LeagueState& state, const FixtureState& fixture);

// Returns the seed of a leg: the seed of its fixture. A leg that decides a level tie, or that was
// voided with a new seed, has another seed.
std::uint64_t leg_seed(const LeagueState& state, const LegId& id);

// Returns the command line that plays a leg in any working folder. Teams that join over DDS find
// the match by `match_id`.
std::vector<std::string> leg_command(const Folder& folder, const LeagueState& state,
                                     const LegId& leg, const std::string& match_id);

// Returns the options of `mirocup match` for the rules, the conditions and the pitch of a league.
std::vector<std::string> term_options(const LeagueState& state);

// A leg that counts for nothing, under the conditions of the league.
struct FriendlyTerms {
  struct Side {
    std::string library;  // the path of the library
    std::string name;
  };
  Side blue;
  Side yellow;
  std::uint64_t seed = 0;
  std::string record;  // path of the record that the leg writes
};
std::vector<std::string> friendly_command(const LeagueState& state, const FriendlyTerms& terms);

// Returns the command line of `mirocup` that tries each drill three times with an entry, with the
// same seeds for all entries. The command takes 2 to 10 s of processor time. Its answer, in the
// file `marks`, is what --json prints (record/answer.hpp).
std::vector<std::string> drills_command(const LeagueState& state, const FriendlyTerms::Side& entry,
                                        const std::string& marks);

// Returns the path of the file for the output of the match server, which is for people.
std::string leg_output(const Folder& folder, const LegId& leg);

// Returns the path of the file in which the match server of Runner tells the port of its live page,
// {"port": 1234}, or its error (record/answer.hpp). The file is there while the leg is played.
std::string leg_answer(const Folder& folder, const LegId& leg);

}  // namespace mirocup::league
