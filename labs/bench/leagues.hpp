// SPDX-License-Identifier: MIT
//
// A whole league, played by `mirocup league start` with one job and with two: a double round robin
// of eight house teams, 56 legs of ten minutes and their pages.
#pragma once

#include <optional>

namespace mirocup::bench {

inline constexpr int league_teams = 8;

struct LeagueTimes {
  double one_job_seconds = 0.0;  // on the wall
  double two_jobs_seconds = 0.0;

  double gain() const { return one_job_seconds / two_jobs_seconds; }
};

// Takes half a minute. Returns nothing if there is one core only, if the program `mirocup` and the
// house teams are not beside this one, or if a league cannot be played.
std::optional<LeagueTimes> play_leagues();

}  // namespace mirocup::bench
