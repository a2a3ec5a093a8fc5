// SPDX-License-Identifier: MIT
#include "core/referee/laws/collision.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::referee {

namespace {

struct Meeting {
  double closing = 0.0;     // speed along the line of centres, m/s
  double difference = 0.0;  // speed of the left robot minus that of the right robot, m/s
};

Meeting meeting_of(const TickFacts& s, const RobotId& left, const RobotId& right) {
  const Vec2 offset = s.pose(right).position - s.pose(left).position;
  const double length = std::sqrt(offset.squaredNorm());
  const Vec2& a = s.velocity[index_of(left.end)][left.index];
  const Vec2& b = s.velocity[index_of(right.end)][right.index];
  return {length > 0.0 ? (a - b).dot(offset) / length : 0.0,
          std::sqrt(a.squaredNorm()) - std::sqrt(b.squaredNorm())};
}

}  // namespace

std::optional<Decision> judge_collision(const JudgedField& pitch, const TickFacts& s,
                                        CollisionMemory& memory) {
  const Rules& rules = pitch.rules;
  if (rules.collision_mps == off) return std::nullopt;
  std::optional<Decision> found;
  const int n = pitch.field.robots_per_team;
  for (const End end : both_ends) {
    for (double& muted : memory.muted_s[index_of(end)]) muted = std::max(muted - s.duration, 0.0);
  }
  for (int i = 0; i < n; ++i) {
    const RobotId left{End::left, i};
    const RobotSet fresh = s.touched_opponents[0][i] & ~memory.touched[0][i];
    memory.touched[0][i] = s.touched_opponents[0][i];
    for (int j = 0; j < n && fresh.any(); ++j) {
      if (!fresh[j] || found) continue;
      const RobotId right{End::right, j};
      const Meeting meeting = meeting_of(s, left, right);
      if (meeting.closing <= rules.collision_mps ||
          std::abs(meeting.difference) <= rules.collision_differ_mps) {
        continue;
      }
      const RobotId& faster = meeting.difference > 0.0 ? left : right;
      double& muted = memory.muted_s[index_of(faster.end)][faster.index];
      if (muted > 0.0) continue;
      muted = rules.cooldown_s;
      const std::string reason = name_of(left) + " and " + name_of(right) + " met at " +
                                 fixed(meeting.closing, 2) + " m/s, " + name_of(faster) +
                                 " faster by " + fixed(std::abs(meeting.difference), 2) + " m/s";
      if (rules.collision_foul) {
        found = call_push(pitch, s, faster, faster == left ? right : left, reason);
        found->law = Law::collision;
        continue;
      }
      found = decide(Verdict::NONE, Law::collision, s, reason);
      found->team = faster.end;
      found->add_robot(left);
      found->add_robot(right);
    }
  }
  return found;
}

}  // namespace mirocup::referee
