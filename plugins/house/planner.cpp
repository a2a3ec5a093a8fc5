// SPDX-License-Identifier: MIT
//
// A team that tries moves before it makes them. A plan says which robot attacks, how and where to.
// In each tick the planner rolls the scene forward under the plan that it follows and under a few
// others, with the simulator of the match. The opponents are taken to play like `act` below. What
// the scene is worth after a third of a second decides. Six plans a tick, in turn, find as much as
// all plans at once and cost less, since a plan is kept until another one is clearly better.
#include "mirocup/predict.hpp"
#include "mirocup/skills/keeper.hpp"
#include "mirocup/skills/laws.hpp"
#include "mirocup/skills/shoot.hpp"
#include "mirocup/skills/univector_field.hpp"
#include "mirocup/strategy.hpp"

#include <array>

namespace {

using namespace mirocup::strategy;

// What the attacker does.
enum class Move { shoot, push, spin_left, spin_right, hold, burst };

struct Plan {
  Move move = Move::shoot;
  Point aim{};  // of a shot or push, m
  int attacker = 1;
  bool presses = false;  // the next robot attacks, too
  Wheels burst{};        // what it drives for the first ticks, before it shoots
  int age = 0;           // ticks since it was chosen
};

constexpr std::array bursts{Wheels{80, 80},   Wheels{80, 50},   Wheels{50, 80}, Wheels{80, -80},
                            Wheels{-80, 80},  Wheels{-80, -80}, Wheels{80, 20}, Wheels{20, 80},
                            Wheels{-80, -40}, Wheels{-40, -80}};

class Planner : public Team {
 public:
  explicit Planner(const Setup& setup)
      : Team(setup), simulator_(this->setup(), Precision::coarse), tracker_(this->setup()) {}

  void decide(const Observation& now, Command& command) override {
    tracker_.saw(now);
    // The answer is driven in the next tick: decide there.
    Scene start = scene_of(now);
    if (now.state == MIROCUP_PLAY)
      simulator_.advance(start, tracker_.in_flight(), tracker_.opponents());
    Observation then = now;
    show(start, then);
    if (now.state == MIROCUP_PLAY && !must_kick_off(now)) {
      effort_ = std::min(effort_ + effort_per_tick_, 10.0 * effort_per_tick_);
      if (effort_ > 0.0) choose(then, start);
    } else {
      plan_ = usual_plan(then);
    }
    command = act(then, plan_, 0);
    command.wheels[0] = guard_goal(setup(), then, then.own[0]);
    if (must_kick_off(now)) command.wheels[1] = kick_off(setup(), then.own[1]);
    keep_laws(setup(), then, command);
    spare_keeper(setup(), then, command);
    if (must_take_kick(now, spot_)) command.wheels[1] = shoot(setup(), now.own[1], ball(now), aim_);
    ++plan_.age;
    tracker_.sent(command);
  }

  // At a penalty or free kick robot 1 takes a run-up to the corner that the keeper leaves open.
  void place(const Observation& now, Placement& placement) override {
    if (now.restart != MIROCUP_PENALTY_KICK && now.restart != MIROCUP_FREE_KICK) return;
    if (now.own_restart == 0) return;
    spot_ = ball(now);
    aim_ = open_corner(setup(), now, 0.05, 0.1 * (random().uniform() - 0.5));
    placement.robots[1] = run_up(spot_, aim_);
  }

 private:
  // ---- the search

  // Sets plan_ to the best of itself, the usual plan and the next few.
  void choose(const Observation& now, const Scene& start) {
    double best = value_of(now, start, plan_) + stay_;
    const auto consider = [&](const Plan& plan) {
      const double value = value_of(now, start, plan);
      if (value <= best) return;
      best = value;
      plan_ = plan;
    };
    const Plan usual = usual_plan(now);
    consider(usual);
    for (int i = 0; i < tries_; ++i) consider(next_plan(now, usual));
  }

  // Returns what comes of a plan: about 1 for a goal, -1 for one against.
  double value_of(const Observation& now, const Scene& start, const Plan& plan) {
    Scene scene = start;
    Observation seen = now;
    double cost = 0.0;
    for (int t = 0; t < horizon_; t += step_) {
      show_to_opponents(scene, seen);
      const Command theirs = t == 0 ? tracker_.opponents() : act(seen, usual_plan(seen), 0);
      show(scene, seen);
      const PredictedTick tick = simulator_.advance(scene, act(seen, plan, t), theirs, step_);
      effort_ -= (1.0 + tick.events) * std::max(1.0, now.robots / 4.0);
      if (std::abs(scene.ball.at.x) > setup().half_length)
        return (scene.ball.at.x > 0.0 ? 1.2 : -1.2) * (1.0 - 0.3 * t / horizon_) - cost;
      for (int i = 1; i < now.robots; ++i) {
        const bool plays = (tick.own_touched_ball >> i & 1u) != 0;
        if (tick.touched_opponent[i] != 0 && !plays) cost += push_;
      }
    }
    show(scene, seen);
    return worth_of(seen) - cost;
  }

  // Returns what a scene is worth: where the ball is and goes, and who is first at it.
  double worth_of(const Observation& now) const {
    const double half = setup().half_length;
    const MovingBall later = rolled(setup(), moving_ball(now), 0.5);
    if (later.at.x > half) return 0.35 + 0.3 * beyond_reach(now.opponent, now.robots, later.at);
    if (later.at.x < -half) return -0.5 - 0.3 * beyond_reach(now.own, now.robots, later.at);
    const MovingBall soon = rolled(setup(), moving_ball(now), 0.2);
    const auto near = [&](double x) {
      const Point goal{x, std::clamp(soon.at.y, -0.1, 0.1)};
      return std::exp(-length(soon.at - goal) / 0.35);
    };
    double worth = 0.2 * soon.at.x / half + 0.25 * (near(half) - near(-half));
    double own = 1e9, opponent = 1e9;
    bool is_covered = false;
    for (int i = 1; i < now.robots; ++i) {
      own = std::min(own, time_behind(now.own[i], soon.at, {half, 0.0}));
      opponent = std::min(opponent, time_behind(now.opponent[i], soon.at, {-half, 0.0}));
      is_covered |= now.own[i].x < soon.at.x - 0.1;
    }
    worth += 0.2 * std::clamp((opponent - own) / 0.4, -1.0, 1.0);
    if (!is_covered) worth -= 0.05;
    return worth;
  }

  // Returns how far from all robots of a team the ball goes in: 0 at one, 1 out of reach.
  static double beyond_reach(const Robot* robots, int count, Point ball) {
    double nearest = 1.0;
    for (int i = 0; i < count; ++i) {
      if (std::abs(robots[i].x - ball.x) > 0.25) continue;
      nearest = std::min(nearest, std::abs(robots[i].y + 0.1 * robots[i].vy - ball.y));
    }
    return std::clamp((nearest - 0.05) / 0.15, 0.0, 1.0);
  }

  // Returns about how long a robot takes to get behind the ball, seen from a goal, s.
  static double time_behind(const Robot& robot, Point ball, Point goal) {
    const Point along = unit(goal - ball);
    const Point to = ball - 0.06 * along - position(robot);
    const double before = std::max(0.0, dot(position(robot) - ball, along));
    const double turned = std::abs(std::sin(std::atan2(along.y, along.x) - robot.heading));
    return length(to) / 1.3 + 0.5 * std::min(before, 0.15) + 0.08 * turned;
  }

  // ---- plans

  // The robot that is soonest behind the ball shoots into the open corner.
  Plan usual_plan(const Observation& now) const {
    const Point goal{setup().half_length, 0.0};
    Plan plan;
    double least = 1e9;
    for (int i = 1; i < now.robots; ++i) {
      const double time = time_behind(now.own[i], meet(now, now.own[i]), goal);
      if (time >= least) continue;
      least = time;
      plan.attacker = i;
    }
    plan.aim = usual_aim(now);
    return plan;
  }

  Point usual_aim(const Observation& now) const {
    const bool is_at_wall = std::abs(now.ball_y) > setup().half_width - 0.05;
    if (is_at_wall && now.ball_x < setup().half_length - 0.25)
      return {now.ball_x + 1.0, now.ball_y};
    if (now.ball_x < -setup().half_length + 0.06)
      return {now.ball_x + 0.2, now.ball_y + (now.ball_y > 0.0 ? 1.0 : -1.0)};
    return open_corner(setup(), now, 0.06);
  }

  // Returns one plan after the other.
  Plan next_plan(const Observation& now, const Plan& usual) {
    const int n = count_++;
    const bool is_near = length(position(now.own[usual.attacker]) - ball(now)) < 0.13;
    const auto pick = [](const auto& list, int k) { return list[k % list.size()]; };
    if (is_near && n % 2 == 0) {
      Plan plan = usual;
      plan.move = Move::burst;
      plan.burst = pick(bursts, n / 2);
      return plan;
    }
    const double half = setup().half_length;
    const double bank = 2.0 * setup().half_width - 0.1;  // the goal, seen in a side wall
    const Point here = ball(now);
    const auto shot_at = [](Point aim) { return Plan{Move::shoot, aim}; };
    const auto push_to = [](Point aim) { return Plan{Move::push, aim}; };
    const std::array<Plan, 14> list{
        shot_at({half, 0.0}),   shot_at({half, 0.13}),           shot_at({half, -0.13}),
        push_to({half, 0.0}),   shot_at({half, bank}),           shot_at({half, -bank}),
        Plan{Move::hold},       shot_at(here + Point{0.3, 1.0}), shot_at(here - Point{-0.3, 1.0}),
        Plan{Move::spin_left},  Plan{Move::spin_right},          push_to({half, 0.13}),
        push_to({half, -0.13}), shot_at(here + Point{1.0, 0.0})};
    const int k = is_near ? n / 2 : n;
    Plan plan = pick(list, k);
    // Now and then the plan is one of another robot, or of two.
    const bool is_other = k % 3 == 2;
    plan.attacker = is_other ? 1 + usual.attacker % (now.robots - 1) : usual.attacker;
    plan.presses = k % 4 == 3;
    return plan;
  }

  // ---- what a team does under a plan, `tick` ticks from now

  Command act(const Observation& now, const Plan& plan, int tick) const {
    Command command{};
    command.wheels[0] = keep(now, now.own[0]);
    int rank = 0;
    for (int i = 1; i < now.robots; ++i) {
      if (i == plan.attacker) {
        command.wheels[i] = attack(now, i, plan, plan.age + tick);
      } else {
        const bool presses = plan.presses && rank == 0;
        command.wheels[i] = is_near_their_area(now.own[i]) ? leave_their_area(now.own[i])
                            : presses                      ? shot(now, i, plan.aim)
                                                           : support(now, i, rank);
        ++rank;
      }
    }
    return command;
  }

  Wheels attack(const Observation& now, int i, const Plan& plan, int age) const {
    const Robot& robot = now.own[i];
    switch (plan.move) {
      case Move::burst:
        if (age < burst_ticks_) return plan.burst;
        break;
      case Move::push: {
        const Point to = ball(now) - position(robot);
        if (length(to) > 0.15) break;
        return drive_to(setup(), robot, ball(now) + 0.2 * unit(plan.aim - ball(now)), 1.8, 1.8);
      }
      case Move::spin_left:
      case Move::spin_right:
        if (length(ball(now) - position(robot)) > 0.075) break;
        return wheels_for(setup(), 0.0, plan.move == Move::spin_left ? 40.0 : -40.0);
      case Move::hold: {
        const Point own{-setup().half_length, 0.0};
        return drive(now, i, ball(now) + 0.15 * unit(own - ball(now)));
      }
      case Move::shoot:
        break;
    }
    return shot(now, i, plan.aim);
  }

  // Only one attacker may be in the opponents' goal area. SimuroSot, which is known by its control
  // period, calls it so often that the others keep away, at the cost of goals.
  bool is_near_their_area(const Robot& robot) const {
    if (setup().control_period > 0.02) return false;
    return robot.x + 0.1 * robot.vx > setup().half_length - setup().goal_area_depth - 0.1 &&
           std::abs(robot.y + 0.1 * robot.vy) < setup().goal_area_half_width + 0.05;
  }

  Wheels leave_their_area(const Robot& robot) const {
    const double front = setup().half_length - setup().goal_area_depth - 0.2;
    return drive_to(setup(), robot, {front, robot.y});
  }

  // Where a robot that drives 1.2 m/s meets the ball, about.
  Point meet(const Observation& now, const Robot& robot) const {
    Point p = ball(now);
    for (int i = 0; i < 2; ++i) {
      p = ball_after(now, std::min(length(p - position(robot)) / 1.2, 0.8));
      const double width = setup().half_width - setup().ball_radius;
      if (std::abs(p.y) > width) p.y = std::copysign(2.0 * width - std::abs(p.y), p.y);
    }
    return inside(setup(), p, setup().ball_radius);
  }

  // Drives behind the ball along a field, and through it.
  Wheels shot(const Observation& now, int i, Point aim) const {
    const Robot& robot = now.own[i];
    const Point at = meet(now, robot);
    const Point along = unit(aim - at);
    const Point from_ball = position(robot) - at;
    const double behind = -dot(from_ball, along);
    const double aside = along.x * from_ball.y - along.y * from_ball.x;
    if (behind > 0.0 && behind < 0.4 && std::abs(aside) < 0.02 + 0.35 * behind) {
      const Point through = at + 0.3 * along - (2.0 * aside) * Point{-along.y, along.x};
      return drive_to(setup(), robot, keep_out(setup(), i, through), 1.8, 1.8);
    }
    const Target target{keep_out(setup(), i, inside(setup(), at, 0.04)),
                        std::atan2(along.y, along.x)};
    std::array<Obstacle, 2 * MIROCUP_MAX_ROBOTS> obstacles;
    std::size_t count = 0;
    const auto add = [&](const Robot& other) {
      const Point p = position(other);
      if (length(p - target.at) < 0.1 || length(p - position(robot)) > 0.35) return;
      obstacles[count++] = {p, {other.vx, other.vy}};
    };
    for (int j = 0; j < now.robots; ++j) {
      add(now.opponent[j]);
      if (j != i) add(now.own[j]);
    }
    return follow_field(setup(), robot, target, 1.8, {obstacles.data(), count}, {}, 0.06);
  }

  Wheels drive(const Observation& now, int i, Point place) const {
    return drive_clear(setup(), now, now.own[i], keep_out(setup(), i, inside(setup(), place)));
  }

  // Stays between the ball and the own goal; the second of these covers the other side.
  Wheels support(const Observation& now, int i, int rank) const {
    const double side = now.ball_y > 0.0 ? -1.0 : 1.0;
    const int row = rank / 2;
    const double x = std::max(-0.75 * setup().half_length, now.ball_x - 0.3 - 0.25 * row);
    const double part = (x + setup().half_length) / (now.ball_x + setup().half_length + 0.01);
    const double spread = rank % 2 == 0 ? 0.0 : side * (0.3 + 0.1 * row);
    return drive(now, i, {x, std::clamp(part, 0.0, 1.0) * now.ball_y + spread});
  }

  // A keeper for predictions, quicker than guard_goal().
  Wheels keep(const Observation& now, const Robot& robot) const {
    const double line = -setup().half_length + 0.05;
    double y = now.ball_y * 0.3;
    if (now.ball_vx < -0.15 && now.ball_x > line) {
      const double width = setup().half_width - setup().ball_radius;
      y = now.ball_y + now.ball_vy * (line + 0.06 - now.ball_x) / now.ball_vx;
      if (std::abs(y) > width) y = std::copysign(2.0 * width - std::abs(y), y);
    }
    const Point post{line, std::clamp(y, -setup().goal_half_width, setup().goal_half_width)};
    const Point to = post - position(robot);
    if (std::abs(to.x) > 0.05) return drive_to(setup(), robot, post);
    const double speed = std::min(1.8, 7.0 * std::abs(to.y));
    return follow_line(setup(), robot, post, to.y > 0.0 ? pi / 2.0 : -pi / 2.0, speed,
                       {.aim_ahead = 0.08});
  }

  // Returns a time in ticks, at least one.
  int ticks_in(double seconds) const {
    return std::max(1, static_cast<int>(std::lround(seconds / setup().control_period)));
  }

  const int tries_ = static_cast<int>(parameter("tries", 6));
  const int step_ = ticks_in(parameter("step", 0.066));  // for which a predicted command holds
  const int horizon_ = step_ * static_cast<int>(parameter("steps", 5));  // ticks
  const int burst_ticks_ = ticks_in(0.132);
  const double stay_ = parameter("stay", 0.03);  // a plan is worth more if it is kept
  const double push_ = parameter("push", 0.02);  // a touch of an opponent

  // Predicting takes processor time, which is counted in steps and events: without a clock, a leg
  // can be played again.
  const double effort_per_tick_ = parameter("effort", 160.0);

  Simulator simulator_;
  Tracker tracker_;
  Plan plan_;
  int count_ = 0;          // plans tried
  double effort_ = 0.0;    // steps and their events that it may predict
  Point spot_{10.0, 0.0};  // of the ball at the last kick of this team, m
  Point aim_;              // of that kick, m
};

}  // namespace

MIROCUP_EXPORT_TEAM(Planner, "planner")
