// SPDX-License-Identifier: MIT
#include "core/referee/placer.hpp"

#include "core/base/math.hpp"
#include "core/referee/touches.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace mirocup::referee {

namespace {

// The rings on which a free place is searched.
constexpr int directions = 24;
constexpr double first_ring = 0.005;   // m
constexpr double ring_growth = 0.1;    // of the radius, but at least first_ring
constexpr double farthest_ring = 6.0;  // m; longer than any way on a field

// Returns the k-th direction in a team's frame: the first points home, the others turn away from it
// to both sides by turns.
Vec2 direction(int k) {
  const int steps = (k + 1) / 2;
  const SinCos angle = sincos(2.0 * pi / directions * steps);
  return {-angle.cos, k % 2 == 0 ? angle.sin : -angle.sin};
}

// True if the pose is so near to the field that a nearest place can be found.
bool is_near_field(const Pose& pose) {
  return pose.position.squaredNorm() < farthest_ring * farthest_ring &&
         std::isfinite(pose.heading.cos) && std::isfinite(pose.heading.sin);
}

}  // namespace

Placer::Placer(const PlacementRules& rules) : rules_(rules), pitch_(rules.pitch) {
  standing_.placement = rules.defaults;
  standing_.placement.ball = rules.ball;
}

void Placer::Standing::put(End team, int robot, const Pose& pose) {
  placement.robots[index_of(team)][robot] = pose;
  placed[index_of(team)].set(robot);
}

void Placer::keep(End team, const Placement& standing) {
  for (int i = 0; i < pitch_.field.robots_per_team; ++i) {
    standing_.put(team, i, standing.robots[index_of(team)][i]);
  }
}

void Placer::accept(End team, const Placement& asked) {
  const Request request = judged(team, asked);
  const RobotSet kept = kept_of(request);
  for (int i = 0; i < pitch_.field.robots_per_team; ++i) {
    if (kept[i]) {
      standing_.put(team, i, request.poses[i]);
    } else {
      moved_[index_of(team)].set(i);
      why_[index_of(team)][i] = reason(request, kept, i);
    }
  }
}

void Placer::move_the_others(End team, const Placement& asked) {
  if (moved_[index_of(team)].none()) return;
  move(standing_, judged(team, asked), standing_.placed[index_of(team)]);
}

Placer::Request Placer::judged(End team, const Placement& asked) const {
  Request request{.team = team,
                  .poses = asked.robots[index_of(team)],
                  .in_special_place = {},
                  .alone = {},
                  .clashes = {}};
  const int n = pitch_.field.robots_per_team;
  const int holder = holder_of_special_place(rules_, team);
  for (int i = 0; i < n; ++i) {
    const bool may_hold = rules_.roles == Roles::any || i == holder;
    request.in_special_place[i] = may_hold && is_near_field(request.poses[i]) &&
                                  has_special_place(rules_, team, request.poses[i]);
  }
  for (int i = 0; i < n; ++i) request.alone[i] = judged_alone(request, i);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < i; ++j) {
      if (request.alone[i] != Misplaced::no || request.alone[j] != Misplaced::no) continue;
      if (clash(request, i, j) == Misplaced::no) continue;
      request.clashes[i].set(j);
      request.clashes[j].set(i);
    }
  }
  return request;
}

Misplaced Placer::judged_alone(const Request& request, int robot) const {
  const Pose& pose = request.poses[robot];
  if (!is_inside_walls(pitch_, pose)) return Misplaced::outside_walls;
  if (!request.in_special_place[robot] && !is_exempt(request.team, robot, pose)) {
    const bool must_hold =
        rules_.roles == Roles::fixed && robot == holder_of_special_place(rules_, request.team);
    if (must_hold) return Misplaced::special_place_empty;
    if (!may_stand(rules_, request.team, pose)) return Misplaced::not_allowed;
  }
  if (ball_gap(pitch_, rules_.ball, pose) <= 0.0) return Misplaced::too_near_ball;
  return is_near_placed_robot(standing_, pose) ? Misplaced::too_near_robot : Misplaced::no;
}

// Returns why two team-mates, each of which may stand where it was asked for, may not both do so.
Misplaced Placer::clash(const Request& request, int robot, int mate) const {
  const Pose& a = request.poses[robot];
  const Pose& b = request.poses[mate];
  const double least = pitch_.rules.touch_m;
  if (robot_gap(pitch_, a, b, least) < least) return Misplaced::too_near_robot;
  if (request.in_special_place[robot] && request.in_special_place[mate]) {
    return Misplaced::not_allowed;
  }
  const bool both_in_area =
      is_in_other_goal_area(request.team, a) && is_in_other_goal_area(request.team, b);
  return both_in_area ? Misplaced::second_in_goal_area : Misplaced::no;
}

// True if all robots of the set may stay where they were asked for.
bool Placer::may_stay(const Request& request, RobotSet kept) const {
  const int n = pitch_.field.robots_per_team;
  for (int i = 0; i < n; ++i) {
    if (!kept[i]) continue;
    if (request.alone[i] != Misplaced::no || (request.clashes[i] & kept).any()) return false;
  }
  // Somebody has to be free for the special place.
  const bool special_place_is_filled =
      holder_of_special_place(rules_, request.team) < 0 || (request.in_special_place & kept).any();
  return special_place_is_filled || static_cast<int>(kept.count()) < n;
}

// Tries all sets, the larger ones first. A team of eleven has 2048. A set that leaves no place for
// another robot does not do: at a free kick a keeper may stand in the way of the wall.
RobotSet Placer::kept_of(const Request& request) const {
  const int n = pitch_.field.robots_per_team;
  for (int size = n; size > 0; --size) {
    RobotSet best;
    double shortest = infinity;
    for (unsigned code = 1u << n; code-- > 0;) {
      if (std::popcount(code) != size) continue;
      RobotSet kept;  // robot 0 is the highest bit, so sets with low numbers come first
      for (int i = 0; i < n; ++i) kept[i] = ((code >> (n - 1 - i)) & 1u) != 0;
      if (!may_stay(request, kept)) continue;
      Standing trial = standing_;
      for (int i = 0; i < n; ++i) {
        if (kept[i]) trial.put(request.team, i, request.poses[i]);
      }
      const double way = move(trial, request, kept);
      if (way < shortest) {
        best = kept;
        shortest = way;
      }
    }
    if (shortest < infinity) return best;
  }
  return {};
}

Misplaced Placer::reason(const Request& request, RobotSet kept, int robot) const {
  if (request.alone[robot] != Misplaced::no) return request.alone[robot];
  for (int i = 0; i < pitch_.field.robots_per_team; ++i) {
    if (kept[i] && request.clashes[robot][i]) return clash(request, robot, i);
  }
  return Misplaced::special_place_empty;
}

// Returns the robot that is to be moved into the special place; -1 if none is.
int Placer::robot_for_special_place(const Request& request, RobotSet kept) const {
  const int holder = holder_of_special_place(rules_, request.team);
  if (holder < 0 || (request.in_special_place & kept).any()) return -1;
  if (rules_.roles == Roles::fixed) return kept[holder] ? -1 : holder;
  const Vec2 place = rules_.defaults.robots[index_of(request.team)][holder].position;
  int nearest = kept[holder] ? -1 : holder;
  double least = infinity;
  for (int i = 0; i < pitch_.field.robots_per_team; ++i) {
    if (kept[i]) continue;
    const double way = is_near_field(request.poses[i])
                           ? (request.poses[i].position - place).squaredNorm()
                           : infinity;
    if (nearest < 0 || way < least) {
      nearest = i;
      least = way;
    }
  }
  return nearest;
}

// Places the robots that are not kept, and returns how far they are moved in total, m; infinity if
// one of them finds no place.
double Placer::move(Standing& standing, const Request& request, RobotSet kept) const {
  const int special = robot_for_special_place(request, kept);
  double sum = 0.0;
  const auto put = [&](int robot) {
    const Place place =
        nearest_place(standing, request.team, robot, request.poses[robot], robot == special);
    standing.put(request.team, robot, place.pose);
    sum += place.way;
  };
  if (special >= 0) put(special);
  for (int i = 0; i < pitch_.field.robots_per_team; ++i) {
    if (!kept[i] && i != special) put(i);
  }
  return sum;
}

// Returns the robot's default place and an infinite way if there is no free one.
Placer::Place Placer::nearest_place(const Standing& standing, End team, int robot,
                                    const Pose& asked, bool is_special) const {
  const Pose& own_default = rules_.defaults.robots[index_of(team)][robot];
  const Place best = nearest_default(standing, team, robot, asked, is_special);
  // The special place is taken by default: elsewhere in a goal area a keeper may block its wall.
  if (is_special && best.way < infinity) return best;
  const Pose start = is_near_field(asked) ? asked : own_default;
  double radius = first_ring;
  while (radius < std::min(best.way, farthest_ring)) {
    for (int k = 0; k < directions; ++k) {
      const Vec2 at = start.position + team_frame(team, Vec2(radius * direction(k)));
      const Pose pose{at, start.heading};
      if (may_be_put(standing, team, robot, pose, is_special)) return {pose, radius};
    }
    radius += std::max(first_ring, ring_growth * radius);
  }
  return best.way < infinity ? best : Place{own_default, infinity};
}

// Returns the free default place of the team that is nearest, or an infinite way. Without a place
// that was asked for, the robot's own default place is at no distance, and the others at a metre.
Placer::Place Placer::nearest_default(const Standing& standing, End team, int robot,
                                      const Pose& asked, bool is_special) const {
  Place best{{}, infinity};
  for (int k = 0; k < pitch_.field.robots_per_team; ++k) {
    const int i = k == 0 ? robot : k <= robot ? k - 1 : k;  // the own one first
    const Pose& pose = rules_.defaults.robots[index_of(team)][i];
    const double unknown = i == robot ? 0.0 : 1.0;
    const double way =
        is_near_field(asked) ? std::sqrt((pose.position - asked.position).squaredNorm()) : unknown;
    if (way < best.way && may_be_put(standing, team, robot, pose, is_special)) best = {pose, way};
  }
  return best;
}

// At a free ball a keeper may stay in its goal area, wherever the ball is.
bool Placer::is_exempt(End team, int robot, const Pose& pose) const {
  return rules_.restart == Restart::FREE_BALL && robot == keeper &&
         pitch_.field.inside(pitch_.field.goal_area, team, pose.position);
}

// At a goal kick the taker's team may have one robot in the other goal area.
bool Placer::is_in_other_goal_area(End team, const Pose& pose) const {
  return rules_.restart == Restart::GOAL_KICK && team == rules_.taker &&
         pitch_.field.inside(pitch_.field.goal_area, opposite(team), pose.position);
}

bool Placer::is_near_placed_robot(const Standing& standing, const Pose& pose) const {
  const double least = pitch_.rules.touch_m;
  for (const End end : both_ends) {
    for (int i = 0; i < pitch_.field.robots_per_team; ++i) {
      if (!standing.placed[index_of(end)][i]) continue;
      const Pose& other = standing.placement.robots[index_of(end)][i];
      if (robot_gap(pitch_, pose, other, least) < least) return true;
    }
  }
  return false;
}

bool Placer::may_be_put(const Standing& standing, End team, int robot, const Pose& pose,
                        bool is_special) const {
  if (!is_inside_walls(pitch_, pose)) return false;
  const bool is_allowed = is_special
                              ? has_special_place(rules_, team, pose)
                              : is_exempt(team, robot, pose) || may_stand(rules_, team, pose);
  if (!is_allowed || ball_gap(pitch_, rules_.ball, pose) <= 0.0) return false;
  if (is_near_placed_robot(standing, pose)) return false;
  if (!is_in_other_goal_area(team, pose)) return true;
  for (int i = 0; i < pitch_.field.robots_per_team; ++i) {
    const bool is_there = standing.placed[index_of(team)][i] &&
                          is_in_other_goal_area(team, standing.placement.robots[index_of(team)][i]);
    if (is_there) return false;
  }
  return true;
}

}  // namespace mirocup::referee
