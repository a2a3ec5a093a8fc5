// SPDX-License-Identifier: MIT
//
// A team that tries moves before it makes them. A plan says which robot attacks, how and where to.
// In each tick the planner rolls the scene forward under the plan that it follows and under a few
// others, with the simulator of the match. The opponents are taken to play like `act` below. What
// the scene is worth after a third of a second decides. Six plans a tick, in turn, find as much as
// all plans at once and cost less, since a plan is kept until another one is clearly better.
#include "mirocup/predict.hpp"
#include "mirocup/skills/attack.hpp"
#include "mirocup/skills/keeper.hpp"
#include "mirocup/skills/laws.hpp"
#include "mirocup/skills/penalty.hpp"
#include "mirocup/skills/worth.hpp"
#include "mirocup/strategy.hpp"

#include <algorithm>
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

// Where the ball and the attacker are in a scene that is rolled forward; what is drawn of it.
struct Rollout {
  static constexpr int most = 32;
  std::array<Point, most> ball{};
  std::array<Point, most> attacker{};
  int count = 0;

  void add(const Scene& scene, int robot) {
    if (count == most) return;
    ball[count] = scene.ball.at;
    attacker[count++] = scene.own[robot].at;
  }
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
    rollout_.count = 0;
    const bool kicks_off = must_kick_off(now);
    if (now.state == MIROCUP_PLAY && !kicks_off) {
      effort_ = std::min(effort_ + effort_per_tick_, 10.0 * effort_per_tick_);
      if (effort_ > 0.0) choose(then, start);
    } else {
      plan_ = usual_plan(then);
      if (kicks_off) plan_.attacker = 1;  // the others leave the ball to it
    }
    command = act(then, plan_, 0);
    command.wheels[0] = guard_goal(setup(), then, then.own[0]);
    if (kicks_off) command.wheels[1] = kick_off(setup(), then.own[1]);
    keep_laws(setup(), then, command);
    spare_keeper(setup(), then, command);
    if (must_take_kick(now, spot_)) {
      command.wheels[1] = now.restart == MIROCUP_PENALTY_KICK
                              ? penalty_.drive(setup(), now, then.own[1])
                              : shoot(setup(), now.own[1], ball(now), aim_);
    }
    draw_plan(then);
    ++plan_.age;
    tracker_.sent(command);
  }

  // At a penalty or free kick robot 1 takes a run-up.
  void place(const Observation& now, Placement& placement) override {
    if (now.restart != MIROCUP_PENALTY_KICK && now.restart != MIROCUP_FREE_KICK) return;
    if (now.own_restart == 0) return;
    spot_ = ball(now);
    const double bias = 0.1 * (random().uniform() - 0.5);
    aim_ = open_corner(setup(), now, 0.05, bias);
    placement.robots[1] = now.restart == MIROCUP_PENALTY_KICK ? penalty_.stand(setup(), now, bias)
                                                              : run_up(spot_, aim_);
  }

 private:
  // ---- the search

  // Sets plan_ to the best of itself, the usual plan and the next few.
  void choose(const Observation& now, const Scene& start) {
    double best = value_of(now, start, plan_) + stay_;
    rollout_ = tried_;
    const auto consider = [&](const Plan& plan) {
      const double value = value_of(now, start, plan);
      if (value <= best) return;
      best = value;
      plan_ = plan;
      rollout_ = tried_;
    };
    const Plan usual = usual_plan(now);
    consider(usual);
    for (int i = 0; i < tries_; ++i) consider(next_plan(now, usual));
    draw_value("worth of the plan", best);
  }

  // Returns what comes of a plan: about 1 for a goal, -1 for one against. Leaves the way in tried_.
  double value_of(const Observation& now, const Scene& start, const Plan& plan) {
    Scene scene = start;
    Observation seen = now;
    double cost = 0.0;
    tried_.count = 0;
    tried_.add(scene, plan.attacker);
    for (int t = 0; t < horizon_; t += step_) {
      show_to_opponents(scene, seen);
      const Command theirs = t == 0 ? tracker_.opponents() : act(seen, usual_plan(seen), 0);
      show(scene, seen);
      Command mine = act(seen, plan, t);
      // Under SimuroSot rules a shot has to do without the last steps to the keeper.
      if (is_simurosot(setup())) spare_keeper(setup(), seen, mine);
      const PredictedTick tick = simulator_.advance(scene, mine, theirs, step_);
      effort_ -= (1.0 + tick.events) * std::max(1.0, now.robots / 4.0);
      tried_.add(scene, plan.attacker);
      if (std::abs(scene.ball.at.x) > setup().half_length)
        return (scene.ball.at.x > 0.0 ? 1.2 : -1.2) * (1.0 - 0.3 * t / horizon_) - cost;
      for (int i = 1; i < now.robots; ++i) {
        const bool plays = (tick.own_touched_ball >> i & 1u) != 0;
        if (tick.touched_opponent[i] != 0 && !plays) cost += push_;
      }
    }
    show(scene, seen);
    return worth_of(setup(), seen) - cost;
  }

  // ---- plans

  // The robot that is soonest behind the ball shoots into the open corner.
  Plan usual_plan(const Observation& now) const {
    const Point goal{setup().half_length, 0.0};
    Plan plan;
    double least = 1e9;
    for (int i = 1; i < now.robots; ++i) {
      const Point at = rough_meeting(setup(), now, now.own[i]);
      const double time = time_to_get_behind(now.own[i], at, goal);
      if (time >= least) continue;
      least = time;
      plan.attacker = i;
    }
    plan.aim = shooting_aim(setup(), now, ball(now));
    return plan;
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
    command.wheels[0] = rough_guard(setup(), now, now.own[0]);
    int rank = 0;
    for (int i = 1; i < now.robots; ++i) {
      if (i == plan.attacker) {
        command.wheels[i] = attack(now, i, plan, plan.age + tick);
      } else {
        const bool presses = plan.presses && rank == 0;
        command.wheels[i] = must_leave_area(setup(), now.own[i]) ? leave_area(setup(), now.own[i])
                            : presses                            ? shot(now, i, plan.aim)
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

  // Drives behind the ball along a field, and through it.
  Wheels shot(const Observation& now, int i, Point aim) const {
    const Point at = rough_meeting(setup(), now, now.own[i]);
    return attack_ball_at(setup(), now, i, at, aim, {.sight = 0.35, .lead_s = 0.06});
  }

  Wheels drive(const Observation& now, int i, Point place) const {
    return drive_clear(setup(), now, now.own[i], keep_out(setup(), i, inside(setup(), place)));
  }

  Wheels support(const Observation& now, int i, int rank) const {
    return drive(now, i, supporting_place(setup(), now, i, rank));
  }

  // Draws what the attacker does, and what the planner expects of it.
  void draw_plan(const Observation& now) const {
    constexpr std::array names{"shoots", "pushes", "spins", "spins", "holds", "bursts"};
    const Robot& attacker = now.own[plan_.attacker];
    draw_role(setup(), now.own[0], "keeps");
    draw_role(setup(), attacker, names[static_cast<std::size_t>(plan_.move)]);
    const bool aims = plan_.move == Move::shoot || plan_.move == Move::push;
    if (aims) draw_line("shots", shot_colour, ball(now), plan_.aim);
    draw_path(setup(), "expected ball", path_colour, rollout_.ball.data(), rollout_.count);
    draw_path(setup(), "expected attacker", target_colour, rollout_.attacker.data(),
              rollout_.count);
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
  Rollout tried_;          // of the plan that was looked at last
  Rollout rollout_;        // of plan_; empty if nothing was tried in this tick
  int count_ = 0;          // plans tried
  double effort_ = 0.0;    // steps and their events that it may predict
  Point spot_{10.0, 0.0};  // of the ball at the last kick of this team, m
  Point aim_;              // of that kick, m
  PenaltyTaker penalty_;
};

}  // namespace

MIROCUP_EXPORT_TEAM(Planner, "planner")
