// SPDX-License-Identifier: MIT
#include "core/referee/placement_check.hpp"

#include "core/referee/decide.hpp"
#include "core/referee/placement_rules.hpp"
#include "core/referee/touches.hpp"

#include <cmath>

namespace mirocup::referee {

namespace {

constexpr double search_step = 0.05;  // m, of the last resort

// Places robots one after the other.
class Placer {
 public:
  Placer(const PlacementRules& rules, CheckedPlacement& result)
      : rules_(rules), pitch_(rules.pitch), result_(result) {}

  // Keeps a team where it stands.
  void keep(End team, const Placement& standing) {
    for (int i = 0; i < pitch_.field.robots_per_team; ++i) {
      put(team, i, standing.robots[index_of(team)][i]);
    }
  }

  // Places the robots of a team that may have the pose that was asked for.
  void accept(End team, const Placement& asked) {
    const auto& poses = asked.robots[index_of(team)];
    const int holder = special_robot(team, poses);
    for (int i = 0; i < pitch_.field.robots_per_team; ++i) {
      const Misplaced why = misplaced(team, i, poses[i], i == holder);
      result_.why[index_of(team)][i] = why;
      if (why == Misplaced::no) put(team, i, poses[i]);
    }
  }

  // Finds a place for the robots of a team that have none yet.
  void move_the_others(End team) {
    for (int i = 0; i < pitch_.field.robots_per_team; ++i) {
      if (placed_[index_of(team)][i]) continue;
      result_.moved[index_of(team)].set(i);
      put(team, i, free_pose(team, i));
    }
  }

 private:
  // Returns the robot that stands in the team's special place, or the one that has to.
  int special_robot(End team, const std::array<Pose, max_robots_per_team>& poses) const {
    if (rules_.roles == Roles::fixed) return holder_of_special_place(rules_, team);
    for (int i = 0; i < pitch_.field.robots_per_team; ++i) {
      if (has_special_place(rules_, team, poses[i])) return i;
    }
    return holder_of_special_place(rules_, team);
  }

  Misplaced misplaced(End team, int robot, const Pose& pose, bool holds_special_place) {
    if (!is_inside_walls(pitch_, pose)) return Misplaced::outside_walls;
    const bool special = holds_special_place && has_special_place(rules_, team, pose);
    if (!special && !exempt(team, robot, pose)) {
      if (holds_special_place) return Misplaced::special_place_empty;
      if (!may_stand(rules_, team, pose)) return Misplaced::not_allowed;
      if (second_in_goal_area(team, pose)) return Misplaced::second_in_goal_area;
    }
    if (ball_gap(pitch_, rules_.ball, pose) <= 0.0) return Misplaced::too_near_ball;
    return is_free(pose) ? Misplaced::no : Misplaced::too_near_robot;
  }

  // At a free ball a keeper may stay in its goal area, wherever the ball is.
  bool exempt(End team, int robot, const Pose& pose) const {
    return rules_.restart == Restart::FREE_BALL && robot == keeper &&
           pitch_.field.inside(pitch_.field.goal_area, team, pose.position);
  }

  // At a goal kick the taker's team may have one robot in the other goal area.
  bool second_in_goal_area(End team, const Pose& pose) {
    if (rules_.restart != Restart::GOAL_KICK || team != rules_.taker) return false;
    if (!pitch_.field.inside(pitch_.field.goal_area, opposite(team), pose.position)) return false;
    return ++in_other_goal_area_ > 1;
  }

  bool is_free(const Pose& pose) const {
    if (ball_gap(pitch_, rules_.ball, pose) <= 0.0) return false;
    for (const End end : both_ends) {
      for (int i = 0; i < pitch_.field.robots_per_team; ++i) {
        if (!placed_[index_of(end)][i]) continue;
        const Pose& other = result_.placement.robots[index_of(end)][i];
        if (robot_gap(pitch_, pose, other, pitch_.rules.touch_m) < pitch_.rules.touch_m) {
          return false;
        }
      }
    }
    return true;
  }

  Pose free_pose(End team, int robot) const {
    const auto& defaults = rules_.defaults.robots[index_of(team)];
    if (is_free(defaults[robot])) return defaults[robot];
    for (int i = 0; i < pitch_.field.robots_per_team; ++i) {
      if (is_free(defaults[i])) return defaults[i];
    }
    // Columns from the own goal line on, rows from the middle outwards, the same for both ends.
    const field::Field& field = pitch_.field;
    for (double x = search_step; x < 2.0 * field.half_length; x += search_step) {
      for (double y = 0.0; y < field.half_width; y += search_step) {
        for (const double side : {1.0, -1.0}) {
          const Pose pose = team_frame(team, Pose{{x - field.half_length, side * y}, Heading{}});
          if (is_inside_walls(pitch_, pose) && may_stand(rules_, team, pose) && is_free(pose)) {
            return pose;
          }
        }
      }
    }
    return defaults[robot];
  }

  void put(End team, int robot, const Pose& pose) {
    result_.placement.robots[index_of(team)][robot] = pose;
    placed_[index_of(team)].set(robot);
  }

  const PlacementRules& rules_;
  const Pitch& pitch_;
  CheckedPlacement& result_;
  ByEnd<RobotSet> placed_;
  int in_other_goal_area_ = 0;
};

// True if the taker may put the ball there. Only a kick-off and a goal kick leave a choice.
bool may_lie(const Pitch& pitch, Restart restart, End taker, const Vec2& ball) {
  const field::Field& field = pitch.field;
  if (restart == Restart::KICK_OFF) {
    return ball.squaredNorm() <= field.centre_circle_radius * field.centre_circle_radius;
  }
  return restart == Restart::GOAL_KICK && field.inside(field.goal_area, taker, ball) &&
         field.clearance(ball) >= pitch.ball_radius;
}

std::string point_text(const Vec2& p) {
  if (!std::isfinite(p.x()) || !std::isfinite(p.y())) return "nowhere";
  return "(" + fixed(p.x(), 3) + ", " + fixed(p.y(), 3) + ") m";
}

const char* why_text(Misplaced why) {
  switch (why) {
    case Misplaced::no:
      break;
    case Misplaced::outside_walls:
      return "not inside the walls";
    case Misplaced::not_allowed:
      return "not allowed at this restart";
    case Misplaced::special_place_empty:
      return "not where this restart needs it";
    case Misplaced::second_in_goal_area:
      return "the second one in that goal area";
    case Misplaced::too_near_ball:
      return "in the ball";
    case Misplaced::too_near_robot:
      return "too near to another robot";
  }
  return "";
}

}  // namespace

End first_placer(Restart restart, End taker) {
  const bool opponents_first = restart == Restart::PENALTY_KICK || restart == Restart::FREE_KICK;
  return opponents_first ? opposite(taker) : taker;
}

CheckedPlacement check_placement(const Pitch& pitch, const Decision& restart, Roles roles,
                                 const Placement& asked) {
  const End taker = restart.taker;
  const Placement defaults = default_placement(pitch, restart.restart, taker, restart.spot);
  CheckedPlacement result;
  result.placement = defaults;
  const bool ball_is_fine = (asked.ball - defaults.ball).squaredNorm() == 0.0 ||
                            may_lie(pitch, restart.restart, taker, asked.ball);
  if (ball_is_fine) result.placement.ball = asked.ball;
  result.ball_moved = !ball_is_fine;

  const PlacementRules rules{.pitch = pitch,
                             .restart = restart.restart,
                             .taker = taker,
                             .roles = roles,
                             .defaults = defaults,
                             .ball = result.placement.ball};
  const End first = first_placer(restart.restart, taker);
  Placer placer(rules, result);
  for (const End team : {first, opposite(first)}) placer.accept(team, asked);
  for (const End team : {first, opposite(first)}) placer.move_the_others(team);
  return result;
}

CheckedPlacement check_turn(const Pitch& pitch, const Decision& restart, End team, Roles roles,
                            const Placement& asked) {
  const Placement defaults = default_placement(pitch, restart.restart, restart.taker, restart.spot);
  const bool is_first = team == first_placer(restart.restart, restart.taker);
  CheckedPlacement result;
  // The ball lies where the restart was given, unless the taker may choose and does.
  result.placement = defaults;
  result.placement.ball = restart.spot;
  if ((asked.ball - restart.spot).squaredNorm() != 0.0) {
    result.ball_moved = !(is_first && team == restart.taker &&
                          may_lie(pitch, restart.restart, restart.taker, asked.ball));
    if (!result.ball_moved) result.placement.ball = asked.ball;
  }

  const PlacementRules rules{.pitch = pitch,
                             .restart = restart.restart,
                             .taker = restart.taker,
                             .roles = roles,
                             .defaults = defaults,
                             .ball = result.placement.ball};
  Placer placer(rules, result);
  if (!is_first) placer.keep(opposite(team), asked);
  placer.accept(team, asked);
  placer.move_the_others(team);
  if (is_first) {
    placer.accept(opposite(team), asked);
    placer.move_the_others(opposite(team));
  }
  return result;
}

ByEnd<RobotSet> misplaced_robots(const Pitch& pitch, const Decision& restart, Roles roles,
                                 const Placement& standing) {
  const End taker = restart.taker;
  const Placement defaults = default_placement(pitch, restart.restart, taker, restart.spot);
  CheckedPlacement result;
  result.placement = standing;
  const PlacementRules rules{.pitch = pitch,
                             .restart = restart.restart,
                             .taker = taker,
                             .roles = roles,
                             .defaults = defaults,
                             .ball = standing.ball};
  Placer placer(rules, result);
  const End first = first_placer(restart.restart, taker);
  ByEnd<RobotSet> misplaced;
  for (const End team : {first, opposite(first)}) {
    placer.accept(team, standing);
    for (int i = 0; i < pitch.field.robots_per_team; ++i) {
      if (result.why[index_of(team)][i] != Misplaced::no) misplaced[index_of(team)].set(i);
    }
  }
  return misplaced;
}

bool may_put_ball(const Pitch& pitch, const Decision& restart, const Vec2& ball) {
  if (pitch.field.clearance(ball) < pitch.ball_radius) return false;
  const bool has_choice =
      restart.restart == Restart::KICK_OFF || restart.restart == Restart::GOAL_KICK;
  return !has_choice || may_lie(pitch, restart.restart, restart.taker, ball);
}

std::string reason_of(const Pitch& pitch, const Placement& asked, const CheckedPlacement& checked) {
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
