// SPDX-License-Identifier: MIT
#include "core/match/gain.hpp"

namespace mirocup::match {

Parties parties_of(const referee::Decision& decision, std::optional<Team> team, Team taker) {
  using referee::Law;
  using referee::Restart;
  using referee::Verdict;
  switch (decision.verdict) {
    case Verdict::GOAL:
    case Verdict::MATCH_END:
      return {.gainer = team, .offender = std::nullopt};
    case Verdict::KICK_OFF:
      return {.gainer = taker, .offender = std::nullopt};
    case Verdict::FORFEIT:
      return {.gainer = team ? std::optional(opponent_of(*team)) : std::nullopt, .offender = team};
    case Verdict::ATTEMPT_END:
      return {.gainer = decision.scored ? team : std::nullopt, .offender = std::nullopt};
    case Verdict::NONE:
      return {.gainer = std::nullopt, .offender = team};
    case Verdict::HALF_END:
    case Verdict::PHASE:
    case Verdict::PLACEMENT_FIXED:
    case Verdict::RESTART:
    case Verdict::TIME_OUT:
    case Verdict::SUBSTITUTION:
    case Verdict::REJECTED:
      return {};
    case Verdict::FREE_BALL:
      // At a free ball both teams contend; the other team gains if one offended.
      return {.gainer = team ? std::optional(opponent_of(*team)) : std::nullopt, .offender = team};
    case Verdict::KICK_OFF_VIOLATION:
    case Verdict::PENALTY_KICK:
    case Verdict::GOAL_KICK:
    case Verdict::FREE_KICK: {
      // A keeper that catches the ball is named, but takes the goal kick itself.
      const bool offended = team && *team != taker;
      return {.gainer = taker, .offender = offended ? team : std::nullopt};
    }
  }
  return {};
}

}  // namespace mirocup::match
