// SPDX-License-Identifier: MIT
//
// What a team reads of its own legs on its private page: result, processor time, faults, its log.
// Of the opponent it reads what everybody does: result and replay.
#pragma once

#include "record/own_texts.hpp"
#include "tournaments/league/folder.hpp"

#include <nlohmann/json_fwd.hpp>

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mirocup::league {

// Where the desk shows the replay of a leg to its teams and the staff: NAME.html follows.
inline constexpr std::string_view own_replays_path = "/hand-in/replays/";

// A leg of a team that is decided, seen from that team.
struct OwnLeg {
  std::string fixture;  // its id
  int leg = 1;          // from 1
  std::string opponent;
  int goals = 0;
  int against = 0;
  char result = 'D';                     // 'W', 'D' or 'L'
  std::optional<std::string> own_fault;  // "crash: ..."
  std::string record;                    // path inside the league's folder; "": it was not played
  std::string colour;                    // "blue" or "yellow"
};

// Returns the decided legs of a team in the order of the schedule; none if there is no such team.
std::vector<OwnLeg> own_legs(const LeagueState& state, const std::string& team);

// What the team's process took in a leg, from the record.
struct LegCost {
  double cpu_seconds = 0.0;
  double bank_seconds = 0.0;  // that it was allowed
  double slowest_tick_ms = 0.0;
  int late_ticks = 0;
};

// Reads records once. Threads: any.
class LegCosts {
 public:
  explicit LegCosts(system::Files& files, Folder folder)
      : files_(files), folder_(std::move(folder)) {}

  // Nothing if the record is not there or cannot be read.
  std::optional<LegCost> of(const OwnLeg& leg);

 private:
  system::Files& files_;
  Folder folder_;
  std::mutex mutex_;                      // guards known_
  std::map<std::string, LegCost> known_;  // by record and colour
};

// Returns the team of a leg whose thoughts and log it may see: its own.
record::Whose own_side(const OwnLeg& leg);

// Returns the path of what the team's process printed in a leg.
std::string log_path(const Folder& folder, const OwnLeg& leg);

// Returns the name by which the HTTP API knows a leg, that of its record.
std::string name_of_leg(const OwnLeg& leg);

// Returns the legs as the HTTP API has them, the latest of the schedule first.
nlohmann::ordered_json own_legs_json(system::Files& files, const Folder& folder,
                                     const std::vector<OwnLeg>& legs, LegCosts& costs);

}  // namespace mirocup::league
