// SPDX-License-Identifier: MIT
#include "core/referee/crowd.hpp"

namespace mirocup::referee {

std::optional<Crowd> find_crowd(const Pitch& pitch, const Situation& s, const Occupancy& occupancy,
                                const CrowdLimit& limit, std::optional<End> goal_at,
                                ByEnd<Dwell>& crowded) {
  std::optional<Crowd> found;
  for (const End owner : ends_from_ball(s)) {
    Dwell& dwell = crowded[index_of(owner)];
    const End team = limit.side == Side::defenders ? owner : opposite(owner);
    const RobotSet robots = counted(occupancy, limit.area, owner, team);
    const int count = static_cast<int>(robots.count());
    dwell.sample(limit.most > 0 && count > limit.most, s.duration);
    const double patience = count > limit.most + 1 ? limit.patience_beyond : limit.patience;
    if (found || !dwell.reached(patience, s.duration)) continue;
    if (!ball_in_zone(pitch, s, owner) && goal_at != owner) continue;
    found = Crowd{owner, robots, dwell.for_s};
  }
  return found;
}

}  // namespace mirocup::referee
