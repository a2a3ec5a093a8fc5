// SPDX-License-Identifier: MIT
//
// drill:attacker plays to score: one robot meets the ball where it will be and shoots past the
// opponents' keeper, robot 0 keeps the goal, the others wait behind to take over lost balls.
#include "drill_team.hpp"

namespace {

using namespace mirocup::drill_teams;

class Attacker : public DrillTeam {
 public:
  using DrillTeam::DrillTeam;

  // At a penalty or free kick robot 1 takes a run-up to the corner that the keeper leaves open.
  void place(const Observation& observation, Placement& placement) override {
    if (!is_kick(observation)) return;
    const double bias = 0.1 * (random().uniform() - 0.5);
    spot_ = {observation.ball_x, observation.ball_y};
    const double corner = setup().goal_half_width - 0.05;
    aim_ = {setup().half_length, keeper_y(observation) + bias > 0.0 ? -corner : corner};
    const Point along = unit(aim_ - spot_);
    const Point from = spot_ - 0.2 * along;
    placement.robots[1] = {from.x, from.y, mirocup_atan2(along.y, along.x)};
  }

 private:
  static bool is_kick(const Observation& o) {
    return (o.restart == MIROCUP_PENALTY_KICK || o.restart == MIROCUP_FREE_KICK) &&
           o.own_restart != 0;
  }

  // Of the opponent that is nearest to its goal, m.
  static double keeper_y(const Observation& o) {
    const Robot* keeper = &o.opponent[0];
    for (int i = 1; i < o.robots; ++i) {
      if (o.opponent[i].x > keeper->x) keeper = &o.opponent[i];
    }
    return keeper->y;
  }

  void before_steering() override {
    rank_ = 0;
    // The robot that is behind the ball first; that of the last tick has a bonus.
    const auto cost = [this](int i) {
      const Point to = meeting_point(now->own[i]) - position(now->own[i]);
      return length(to) + (to.x < 0.0 ? 0.25 : 0.0) - (i == attacker_ ? 0.1 : 0.0);
    };
    int best = 1;
    for (int i = 2; i < now->robots && !must_kick_off(); ++i) {
      if (cost(i) < cost(best)) best = i;
    }
    attacker_ = best;
    // The corner that the keeper leaves open; a draw after each restart decides close cases.
    if (now->state != MIROCUP_PLAY) {
      offset_ = 0.06 * (random().uniform() - 0.5);
      return;
    }
    const double open = 0.6 * setup().goal_half_width;
    corner_ = (keeper_y(*now) + offset_ > 0.0 ? -open : open) + offset_;
  }

  Wheels steer(int i, const Robot& robot) override {
    if (i != attacker_) return support(robot, rank_++);
    if (must_kick_off()) return kick_off(robot);
    if (is_stuck()) return free_ball(robot);
    const Point meet = meeting_point(robot);
    const Point shot = unit(Point{setup().half_length + 0.05, corner_} - meet);
    const Point from_ball = position(robot) - meet;
    const double behind = -dot(from_ball, shot);
    const double aside = from_ball.y * shot.x - from_ball.x * shot.y;
    if (behind > 0.0 && std::abs(aside) < 0.02 + 0.4 * behind && behind < 0.35) {
      const Point through = meet + 0.3 * shot - (2.0 * aside) * Point{-shot.y, shot.x};
      return drive_to(robot, keep_out(through), 1.7, 1.7);
    }
    return drive_clear(robot, make_way(keep_out(inside(meet - 0.11 * shot))), 0.3, 1.7);
  }

  // Waits between the ball and the own goal, fanned out.
  Wheels support(const Robot& robot, int rank) const {
    const double side = ball.y > 0.0 ? -1.0 : 1.0;
    const int row = rank / 2;
    const double x = std::max(-0.7 * setup().half_length, ball.x - 0.3 - 0.2 * row);
    const double y = 0.4 * ball.y + side * (rank % 2 == 0 ? 0.12 : -0.25);
    return drive_clear(robot, make_way(keep_out(inside({x, y}))));
  }

  void after_laws(Command& command) override {
    spare_keeper(command);
    if (!is_kick(*now) || length(ball - spot_) >= 0.01) return;
    // Drives along the line of the shot through the ball.
    const Robot& robot = now->own[1];
    const Point along = unit(aim_ - ball);
    const double aside = cross(along, position(robot) - ball);
    const double soon = robot.heading + 0.08 * robot.turn;
    double error = wrapped(mirocup_atan2(along.y, along.x) - mirocup_atan2(aside, 0.2) - soon);
    double direction = 1.0;
    if (std::abs(error) > pi / 2.0) {
      error = wrapped(error + pi);
      direction = -1.0;
    }
    command.wheels[1] = steady(direction, 1.8 * std::max(0.1, mirocup_cos(error)), 10.0 * error);
  }

  // Slows down robots that would drive into a keeper in its goal area.
  void spare_keeper(Command& command) const {
    for (int j = 0; j < now->robots; ++j) {
      const Robot& other = now->opponent[j];
      const Point keeper = position(other) + 0.05 * Point{other.vx, other.vy};
      const bool is_home = keeper.x > setup().half_length - setup().goal_area_depth - 0.05 &&
                           std::abs(keeper.y) < setup().goal_area_half_width;
      for (int i = 1; is_home && i < now->robots; ++i) {
        const Robot& robot = now->own[i];
        const Point to = keeper - position(robot);
        const Wheels wheels = command.wheels[i];
        const double forward = forward_of(wheels);
        const double closing = dot((forward < 0.0 ? -1.0 : 1.0) * nose(robot), unit(to));
        if (length(to) > 0.6 || closing < 0.3) continue;
        const double gap = length(to) - 0.11;
        double allowed = gap > 0.0 ? 0.3 + 3.5 * gap : -0.3;
        const Point to_ball = ball - position(robot);
        const bool has_ball = length(to_ball) < 0.085 && dot(unit(to_ball), unit(to)) > 0.7;
        if (has_ball) allowed = std::max(allowed, 0.45);
        if (std::abs(forward) <= allowed) continue;
        command.wheels[i] = wheels_for(forward < 0.0 ? -allowed : allowed, turn_of(wheels));
      }
    }
  }

  Point spot_{10.0, 0.0};  // of the ball at the last kick of this team, m
  Point aim_;              // of that kick, m
  int attacker_ = 1;
  int rank_ = 0;         // of the next robot that does not attack
  double corner_ = 0.1;  // m, where the shot shall cross the goal line
  double offset_ = 0.0;  // m
};

}  // namespace

MIROCUP_EXPORT_TEAM(Attacker, "drill:attacker")
