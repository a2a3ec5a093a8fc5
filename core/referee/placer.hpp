// SPDX-License-Identifier: MIT
//
// The placer decides which robots keep the places that were asked for at a restart, and where the
// others go.
//
// As few robots as possible are moved. Among the choices that move equally few, the one that moves
// them the shortest way in total is taken; if these ways are also equal, robots with low numbers
// stay. A robot that is moved goes to the nearest place to the requested one that is free and that
// the law allows: a default place of its team, or a place on rings around the requested place. The
// rings miss the nearest place by at most a tenth of the way or 5 mm, whichever is more. A robot
// whose requested place is far from the field goes to its default place, or to a free place near
// it. A robot that is moved to fill the special place, because the restart needs a robot there,
// goes to the default pose in that place if it is free.
#pragma once

#include "core/referee/placement_rules.hpp"

namespace mirocup::referee {

// The reasons why a robot may not have the pose that was asked for.
enum class Misplaced {
  no,
  outside_walls,        // or the pose is not finite
  not_allowed,          // by the law of the restart
  special_place_empty,  // a robot has to stand in the special place, and this one is sent there
  second_in_goal_area,  // at a goal kick, the taker's second robot in the opponents' goal area
  too_near_ball,
  too_near_robot,
};

class Placer {
 public:
  // The rules outlive the placer.
  explicit Placer(const PlacementRules& rules);

  // Keeps a team where it stands, whatever the law says.
  void keep(End team, const Placement& standing);

  // Lets as many robots of the team as possible stand where `asked` has them, clear of the robots
  // that have a place already. The other robots of the team have no place until move_the_others().
  // Robots of a team that is not accepted yet do not block places.
  void accept(End team, const Placement& asked);

  // Finds a place for each robot of an accepted team that has none.
  void move_the_others(End team, const Placement& asked);

  // The decisions so far. `moved` are the robots that accept() left without a place.
  const Placement& placement() const { return standing_.placement; }
  const ByEnd<RobotSet>& moved() const { return moved_; }
  const ByRobot<Misplaced>& why() const { return why_; }

 private:
  // The robots that have a place, and where they stand.
  struct Standing {
    Placement placement;
    ByEnd<RobotSet> placed;

    void put(End team, int robot, const Pose& pose);
  };

  // What a team asks for, and what forbids it.
  struct Request {
    End team;
    const std::array<Pose, max_robots_per_team>& poses;
    RobotSet in_special_place;  // the robots that ask for the special place and may hold it
    // By robot: what forbids its pose even without team-mates, and the team-mates whose poses clash
    // with its pose.
    std::array<Misplaced, max_robots_per_team> alone{};
    std::array<RobotSet, max_robots_per_team> clashes;
  };

  Request judged(End team, const Placement& asked) const;
  Misplaced judged_alone(const Request& request, int robot) const;
  Misplaced clash(const Request& request, int robot, int mate) const;
  bool may_stay(const Request& request, RobotSet kept) const;
  RobotSet kept_of(const Request& request) const;
  Misplaced reason(const Request& request, RobotSet kept, int robot) const;
  int robot_for_special_place(const Request& request, RobotSet kept) const;
  double move(Standing& standing, const Request& request, RobotSet kept) const;

  struct Place {
    Pose pose;
    double way = 0.0;  // m, from the place that was asked for
  };
  Place nearest_place(const Standing& standing, End team, int robot, const Pose& asked,
                      bool is_special) const;
  Place nearest_default(const Standing& standing, End team, int robot, const Pose& asked,
                        bool is_special) const;

  bool is_exempt(End team, int robot, const Pose& pose) const;
  bool is_in_other_goal_area(End team, const Pose& pose) const;
  bool is_near_placed_robot(const Standing& standing, const Pose& pose) const;
  bool may_be_put(const Standing& standing, End team, int robot, const Pose& pose,
                  bool is_special) const;

  const PlacementRules& rules_;
  const JudgedField& pitch_;
  Standing standing_;
  ByEnd<RobotSet> moved_;
  ByRobot<Misplaced> why_{};
};

}  // namespace mirocup::referee
