// SPDX-License-Identifier: MIT
//
// One leg that an entry plays in the sandbox so that `mirocup check` can look at it.
#pragma once

#include "core/replay/recording.hpp"
#include "programs/check/check_plan.hpp"
#include "programs/check/entry_advice.hpp"
#include "programs/check/leg_story.hpp"

#include <cstddef>
#include <set>

namespace mirocup::app {

struct TrialTerms {
  match::Setup setup;
  const plugins::SealedEntry* opponent = nullptr;
  Team team = Team::blue;  // the colour of the entry
  match::TeamParameters parameters;
  std::uint32_t max_ticks = UINT32_MAX;
  // The entry's share of the processor time of the check, s, without loading. A leg of a team that
  // is quick enough does not stop there, see CheckPlan::most_use().
  double max_seconds = CheckPlan::longest;
  Trick trick = {};
  plugins::Isolation isolation = plugins::Isolation::T2;
  plugins::Surroundings surroundings = {};
  bool is_recorded = false;
  bool is_careful = false;  // true: played by mirocup-careful-host
};

// A restart, and whether the entry took that restart.
using MetRestart = std::pair<referee::Restart, bool>;

// The result of a trial leg. A leg that was stopped early has no fault.
struct TrialLeg {
  std::optional<FaultEvidence> fault;
  bool has_begun = false;  // true: the team was asked for its first answer
  std::vector<match::TickLog> log;
  int moved_placements = 0;                    // requested places that were not legal
  double start_seconds = 0.0;                  // processor time to load and create the team
  double playing_seconds = 0.0;                // processor time
  double slowest_tick_ms = 0.0;                // processor time
  std::uint32_t places = 0;                    // number of calls of place()
  double slept_seconds = 0.0;                  // sleep; waiting for a processor does not count
  double used_seconds = 0.0;                   // as CheckPlan counts, loading included
  double used_to_start = 0.0;                  // the part of used_seconds before the first tick
  bool is_whole = false;                       // true: the leg was played to its end
  std::size_t memory_at_start = 0;             // memory when the team was created, bytes
  std::size_t peak_memory = 0;                 // bytes
  std::set<MetRestart> restarts;               // restarts with a call of place()
  std::optional<replay::Recording> recording;  // only of a leg that was played to its end
  LegStory story;                              // without the opponent's name
  std::string output;
  std::string requests;  // lines of ProcessController::requests()
  std::uint32_t asked_parameters = 0;

  std::uint32_t ticks() const { return static_cast<std::uint32_t>(log.size()); }
};

// Plays the leg, or as much of it as the terms allow. An error is a failure of the host.
Result<TrialLeg> play_trial(const plugins::SealedEntry& entry, const TrialTerms& terms);

}  // namespace mirocup::app
