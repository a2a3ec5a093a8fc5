// SPDX-License-Identifier: MIT
//
// The study of a goal: until when one robot of the conceding team could have prevented it.
#pragma once

#include "programs/coach/rehearsal.hpp"
#include "programs/coach/search.hpp"
#include "record/clock_words.hpp"

#include <vector>

namespace mirocup::coach {

// The number of the first of the futures that an answer counts. Those of the search are lower.
inline constexpr int first_counted = 1000;

// The last moment at which a substitute of one robot prevents the goal in at least 8 of 10 futures.
struct Prevention {
  int robot = 0;
  std::uint32_t tick = 0;  // from which the substitute decides
  Share share = {};        // of 100 futures, which the search has not used
  Share as_played = {};    // of 100 futures without a substitute, from the same tick
  double to_ball = 0.0;    // distance of the robot from the ball, m
  Vec2 ball{0.0, 0.0};     // in the frame of the team, which attacks +x
};

struct GoalStudy {
  int number = 0;           // among the goals that the team conceded in the leg, from 1
  std::uint32_t tick = 0;   // in which the goal fell
  record::ClockTime clock;  // then
  std::uint32_t first = 0;  // the earliest tick of the search: play had begun
  std::optional<Prevention> prevention;  // empty: no robot alone could prevent the goal
  // From this tick on no substitute prevents the goal in more than 2 of 10 futures.
  std::uint32_t hopeless = 0;
  match::ByTeam<bool> decides{};  // Rehearsal::decides() at `first`
};

// Returns the goals that a team conceded in a leg, in their order; without those of a shoot-out.
std::vector<match::LoggedDecision> goals_against(const replay::Recording& recording, Team team);

// Studies these goals, all if `only` is empty, or the one of this number, from 1. Uses several
// processes at once; call it in a process with one thread. Preconditions: as for
// Rehearsal::begin(). Errors: those of begin(), and Errc::host if a copy of this process could not
// run to its end.
Result<std::vector<GoalStudy>> study_goals(const record::MatchRecord& record, const Cast& cast,
                                           std::optional<int> only);

}  // namespace mirocup::coach
