// SPDX-License-Identifier: MIT
#include "core/referee/laws/push.hpp"

#include "core/base/math.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mirocup::referee {

namespace {

bool is_pushing(const JudgedField& pitch, const TickFacts& s, const Occupancy& occupancy,
                const RobotId& pusher, const RobotId& pushed) {
  return s.touch(pusher, pushed.index) && !s.touches_ball(pusher) &&
         occupancy.keeper[index_of(pushed.end)] != pushed && drives_at(pitch, s, pusher, pushed) &&
         !drives_at(pitch, s, pushed, pusher);
}

// True if the pushed robot was moved far enough, and away from the pusher.
bool is_moved(const JudgedField& pitch, const TickFacts& s, const RobotId& pusher,
              const RobotId& pushed, const Vec2& from) {
  const Vec2 moved = s.pose(pushed).position - from;
  const double limit = pitch.rules.push_dist_m;
  if (moved.squaredNorm() < limit * limit) return false;
  const Vec2 offset = s.pose(pushed).position - s.pose(pusher).position;
  return std::abs(atan2(cross(offset, moved), offset.dot(moved))) <= pitch.rules.push_angle_rad;
}

}  // namespace

Decision call_push(const JudgedField& pitch, const TickFacts& s, const RobotId& pusher,
                   const RobotId& pushed, std::string reason) {
  const bool defends =
      ball_in_half(s, pusher.end) || (s.last_touch && s.last_touch->end == pushed.end);
  Decision d;
  if (defends) {
    reason += ball_in_half(s, pusher.end) ? ", the ball in its own half"
                                          : ", the ball last touched by the pushed team";
    d = against(decide(Verdict::FREE_KICK, Law::push, s, std::move(reason)), pusher.end,
                Restart::FREE_KICK);
  } else if (pitch.field.inside(pitch.field.goal_area, pushed.end, s.ball)) {
    d = against(decide(Verdict::GOAL_KICK, Law::attacking_push, s,
                       reason + " while its team attacked, the ball in the goal area"),
                pusher.end, Restart::GOAL_KICK);
  } else {
    d = decide(Verdict::FREE_BALL, Law::attacking_push, s, reason + " while its team attacked");
    give_free_ball(pitch, s.ball, d);
    d.team = pusher.end;
  }
  d.add_robot(pusher);
  d.add_robot(pushed);
  return d;
}

std::optional<Decision> judge_push(const JudgedField& pitch, const TickFacts& s,
                                   const Occupancy& occupancy, PushMemory& memory) {
  const Rules& rules = pitch.rules;
  if (rules.push_dist_m == off) return std::nullopt;
  std::optional<Decision> called;
  for (const End end : ends_from_ball(s)) {
    for (int i = 0; i < pitch.field.robots_per_team; ++i) {
      const RobotId pusher{end, i};
      RobotSet& on = memory.on[index_of(end)][i];
      const RobotSet touched = s.touched_opponents[index_of(end)][i];
      if ((on | touched).none()) continue;
      for (int j = 0; j < pitch.field.robots_per_team; ++j) {
        if (!on[j] && !touched[j]) continue;
        const RobotId pushed{opposite(end), j};
        Push& push = memory.pairs[index_of(end)][i][j];
        push.muted_s = std::max(push.muted_s - s.duration, 0.0);
        if (!is_pushing(pitch, s, occupancy, pusher, pushed)) {
          push.is_on = false;
          on[j] = push.muted_s > 0.0;
          continue;
        }
        if (!push.is_on) push.from = s.pose(pushed).position;
        push.is_on = true;
        on.set(j);
        if (called || push.muted_s > 0.0 || !is_moved(pitch, s, pusher, pushed, push.from)) {
          continue;
        }
        const Vec2 moved = s.pose(pushed).position - push.from;
        called = call_push(pitch, s, pusher, pushed,
                           name_of(pusher) + " pushed " + name_of(pushed) + " " +
                               fixed(std::sqrt(moved.squaredNorm()), 3) + " m");
        push.is_on = false;
        push.muted_s = rules.cooldown_s;
      }
    }
  }
  return called;
}

}  // namespace mirocup::referee
