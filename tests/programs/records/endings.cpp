// SPDX-License-Identifier: MIT
#include "tests/programs/records/endings.hpp"

#include "tests/support/controllers.hpp"

namespace mirocup::test_support {

namespace {

using match::Answer;
using match::Observation;
using match::OutcomeKind;

constexpr std::uint32_t last_tick = 20;  // of a team that ends the leg itself
constexpr std::uint64_t most_tries = 100;

match::Setup setup_for(OutcomeKind end, std::uint64_t seed) {
  match::Setup setup = short_setup(seed, 1.0);
  switch (end) {
    case OutcomeKind::mercy:
      setup.rules.half_s = 30.0;
      setup.rules.mercy_goal_diff = 1;
      break;
    case OutcomeKind::golden_goal:
      setup.stage = referee::Stage::knockout;
      setup.rules.golden_goal_s = 60.0;
      break;
    case OutcomeKind::shoot_out:
      setup.stage = referee::Stage::knockout;
      setup.rules.golden_goal_s = 0.0;
      setup.rules.attempt_s = 1.0;
      setup.rules.shoot_out_most_rounds = 4;
      break;
    default:
      break;
  }
  return setup;
}

Scripted team_for(OutcomeKind end, Team team, std::uint64_t seed) {
  const bool both = end == OutcomeKind::double_forfeit;
  if (end == OutcomeKind::void_ || both || (end == OutcomeKind::forfeit && team == Team::yellow)) {
    return Scripted([end](const Observation& o) -> Answer {
      if (o.tick < last_tick) return both_wheels(10.0, 12.0);
      if (end == OutcomeKind::void_) return match::HostFailure{"the disk is full"};
      return match::Fault{match::FaultCode::crash, "died of a \"signal\"\n"};
    });
  }
  if (team == Team::blue) return ball_hunter();
  // Beside a team that stands all seeds would play the same leg.
  return end == OutcomeKind::golden_goal || end == OutcomeKind::mercy ? random_team(seed)
                                                                      : idle_team();
}

}  // namespace

replay::Recording leg_that_ends(OutcomeKind end) {
  for (std::uint64_t seed = 1;; ++seed) {
    match::Leg match(setup_for(end, seed));
    Scripted blue = team_for(end, Team::blue, seed);
    Scripted yellow = team_for(end, Team::yellow, seed);
    replay::StateTrace trace;
    while (!match.is_over()) {
      match.advance(blue, yellow);
      trace.add(match);
    }
    if (match.outcome().kind == end || seed == most_tries) return replay::record(match, trace);
  }
}

}  // namespace mirocup::test_support
