// SPDX-License-Identifier: MIT
#include "core/referee/placement_check.hpp"

#include "core/referee/decide.hpp"
#include "core/referee/placement_rules.hpp"

#include <array>
#include <cmath>

namespace mirocup::referee {

namespace {

// True if the taker may put the ball there. Only a kick-off and a goal kick leave a choice.
bool may_lie(const JudgedField& pitch, Restart restart, End taker, const Vec2& ball) {
  const field::Field& field = pitch.field;
  if (restart == Restart::KICK_OFF) {
    return ball.squaredNorm() <= field.centre_circle_radius * field.centre_circle_radius;
  }
  return restart == Restart::GOAL_KICK && field.inside(field.goal_area, taker, ball) &&
         field.clearance(ball) >= pitch.ball_radius;
}

PlacementRules rules_of(const JudgedField& pitch, const Decision& restart, Roles roles,
                        const Placement& defaults, const Vec2& ball) {
  return {.pitch = pitch,
          .restart = restart.restart,
          .taker = restart.taker,
          .roles = roles,
          .defaults = defaults,
          .ball = ball};
}

CheckedPlacement granted(const Placer& placer, bool ball_is_fine) {
  return {.placement = placer.placement(),
          .moved = placer.moved(),
          .why = placer.why(),
          .ball_moved = !ball_is_fine};
}

std::string point_text(const Vec2& p) {
  if (!std::isfinite(p.x()) || !std::isfinite(p.y())) return "nowhere";
  return "(" + fixed(p.x(), 3) + ", " + fixed(p.y(), 3) + ") m";
}

const char* why_text(Misplaced why) {
  constexpr std::array texts{"",
                             "not inside the walls",
                             "not allowed at this restart",
                             "not where this restart needs it",
                             "the second one in that goal area",
                             "in the ball",
                             "too near to another robot"};
  static_assert(texts.size() == static_cast<std::size_t>(Misplaced::too_near_robot) + 1);
  return texts[static_cast<std::size_t>(why)];
}

}  // namespace

End first_placer(Restart restart, End taker) {
  const bool opponents_first = restart == Restart::PENALTY_KICK || restart == Restart::FREE_KICK;
  return opponents_first ? opposite(taker) : taker;
}

CheckedPlacement check_placement(const JudgedField& pitch, const Decision& restart, Roles roles,
                                 const Placement& asked) {
  const End taker = restart.taker;
  const Placement defaults = default_placement(pitch, restart.restart, taker, restart.spot);
  const bool ball_is_fine = (asked.ball - defaults.ball).squaredNorm() == 0.0 ||
                            may_lie(pitch, restart.restart, taker, asked.ball);

  const PlacementRules rules =
      rules_of(pitch, restart, roles, defaults, ball_is_fine ? asked.ball : defaults.ball);
  const End first = first_placer(restart.restart, taker);
  Placer placer(rules);
  for (const End team : {first, opposite(first)}) placer.accept(team, asked);
  for (const End team : {first, opposite(first)}) placer.move_the_others(team, asked);
  return granted(placer, ball_is_fine);
}

CheckedPlacement check_turn(const JudgedField& pitch, const Decision& restart, End team,
                            Roles roles, const Placement& asked) {
  const Placement defaults = default_placement(pitch, restart.restart, restart.taker, restart.spot);
  const bool is_first = team == first_placer(restart.restart, restart.taker);
  // The ball lies where the restart was given, unless the taker may choose and does.
  const bool ball_is_fine = (asked.ball - restart.spot).squaredNorm() == 0.0 ||
                            (is_first && team == restart.taker &&
                             may_lie(pitch, restart.restart, restart.taker, asked.ball));

  const PlacementRules rules =
      rules_of(pitch, restart, roles, defaults, ball_is_fine ? asked.ball : restart.spot);
  Placer placer(rules);
  if (!is_first) {
    placer.keep(opposite(team), asked);
    placer.accept(team, asked);
    placer.move_the_others(team, asked);
  } else {
    for (const End end : {team, opposite(team)}) placer.accept(end, asked);
    for (const End end : {team, opposite(team)}) placer.move_the_others(end, asked);
  }
  return granted(placer, ball_is_fine);
}

ByEnd<RobotSet> misplaced_robots(const JudgedField& pitch, const Decision& restart, Roles roles,
                                 const Placement& standing) {
  const End taker = restart.taker;
  const Placement defaults = default_placement(pitch, restart.restart, taker, restart.spot);
  const PlacementRules rules = rules_of(pitch, restart, roles, defaults, standing.ball);
  Placer placer(rules);
  const End first = first_placer(restart.restart, taker);
  for (const End team : {first, opposite(first)}) {
    placer.accept(team, standing);
  }
  return placer.moved();
}

bool may_put_ball(const JudgedField& pitch, const Decision& restart, const Vec2& ball) {
  if (pitch.field.clearance(ball) < pitch.ball_radius) return false;
  const bool has_choice =
      restart.restart == Restart::KICK_OFF || restart.restart == Restart::GOAL_KICK;
  return !has_choice || may_lie(pitch, restart.restart, restart.taker, ball);
}

std::string reason_of(const JudgedField& pitch, const Placement& asked,
                      const CheckedPlacement& checked) {
  if (!checked.any_moved()) return "everybody stands where the law of the restart allows it";
  std::string text;
  const auto add = [&text](const std::string& who, const Vec2& from, const Vec2& to,
                           const char* why) {
    text += (text.empty() ? "" : "; ") + who + " from " + point_text(from) + " to " +
            point_text(to) + ": " + why;
  };
  if (checked.ball_moved) {
    add("the ball", asked.ball, checked.placement.ball, "not free to choose there");
  }
  for (const End end : both_ends) {
    const int e = index_of(end);
    for (int i = 0; i < pitch.field.robots_per_team; ++i) {
      if (!checked.moved[e][i]) continue;
      add(name_of({end, i}), asked.robots[e][i].position, checked.placement.robots[e][i].position,
          why_text(checked.why[e][i]));
    }
  }
  return text;
}

}  // namespace mirocup::referee
