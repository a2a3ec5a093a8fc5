// SPDX-License-Identifier: MIT
//
// The legs of a team on its private page: result, processor time, its own faults and log. Of the
// opponent a team sees only the result and the replay, which are public.
#pragma once

#include "record/thoughts_file.hpp"
#include "tournaments/league/folder.hpp"
#include "tournaments/publish/snapshot.hpp"

#include <nlohmann/json.hpp>

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mirocup::league {

// The path below which the desk shows replays of legs to their teams and the staff, as NAME.html.
inline constexpr std::string_view own_replays_path = "/hand-in/replays/";

// A decided leg, seen from one of its teams.
struct OwnLeg {
  std::string fixture;  // the id of the fixture
  int leg = 1;          // from 1
  std::string opponent;
  int goals = 0;
  int against = 0;
  char result = 'D';                     // 'W', 'D' or 'L'
  std::optional<std::string> own_fault;  // "crash: ..."
  // Path inside the league's folder; "": the leg was not played.
  std::string record;
  std::string colour;  // "blue" or "yellow"
};

// Returns the decided legs of a team in the order of the schedule; no legs if the league lacks the
// team.
std::vector<OwnLeg> own_legs(const SeenState& seen, const std::string& team);

// The time that a team's process took in a leg, and the team's fouls, from the record. Reads each
// record once. Threads: any.
class LegCosts {
 public:
  explicit LegCosts(system::Files& files, Folder folder)
      : files_(files), folder_(std::move(folder)) {}

  // Returns the keys cpu_seconds, bank_seconds (the processor time that the team was allowed),
  // slowest_tick_ms, late_ticks and fouls (decisions that name the team as offender and give a
  // restart); {} if the record is missing or cannot be read.
  nlohmann::ordered_json of(const OwnLeg& leg);

 private:
  system::Files& files_;
  Folder folder_;
  std::mutex mutex_;                                     // guards known_
  std::map<std::string, nlohmann::ordered_json> known_;  // by record and colour
};

// Returns the sides of a leg whose thoughts and log a team may see: the team's own side.
record::Whose own_side(const OwnLeg& leg);

// Returns the path of the file with the output of the team's process in a leg.
std::string log_path(const Folder& folder, const OwnLeg& leg);

// Returns the name of a leg in the HTTP API: the name of its record.
std::string name_of_leg(const OwnLeg& leg);

// Returns legs in the form of the HTTP API, the last leg of the schedule first.
nlohmann::ordered_json own_legs_json(system::Files& files, const Folder& folder,
                                     const std::vector<OwnLeg>& legs, LegCosts& costs);

}  // namespace mirocup::league
