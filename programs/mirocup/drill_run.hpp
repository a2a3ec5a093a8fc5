// SPDX-License-Identifier: MIT
//
// Plays the tries of drills, each as a leg with its teams in sandboxed processes, several at once.
#pragma once

#include "core/base/error.hpp"
#include "record/drills/judge.hpp"
#include "server/seats.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace mirocup::app {

struct DrillTeams {
  server::TeamChoice tested;
  server::TeamChoice opponent;
  std::optional<server::TeamChoice> mates;  // empty: the tested team steers all its robots
};

// One drill for one team. The drill belongs to the caller.
struct DrillTask {
  const drills::Drill* drill = nullptr;
  DrillTeams teams;
  int tries = 0;
};

struct PlayedTry {
  std::uint64_t seed = 0;
  drills::TryResult result = {};
  std::string fault = {};  // fault of the tested team; "": none
};

// Returns the code of a fault and its sentence.
std::string fault_text(const match::Fault& fault);

struct DrillTerms {
  std::uint64_t first_seed = 1;
  int jobs = 0;               // tries at once; 0: one for each processor
  std::string replay_folder;  // for record and page of each failed try; "": not kept
};

// Plays all tries and returns the tries of each task in the order of their seeds. The function
// calls `progress` now and then with the number of played tries. An error is a failure of the host,
// a replay that cannot be written, or Errc::interrupted.
Result<std::vector<std::vector<PlayedTry>>> play_drills(const std::vector<DrillTask>& tasks,
                                                        const DrillTerms& terms,
                                                        const std::function<void(int)>& progress);

}  // namespace mirocup::app
