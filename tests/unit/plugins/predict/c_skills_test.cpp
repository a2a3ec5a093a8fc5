// SPDX-License-Identifier: MIT
//
// skills.h gives what the C++ functions give. Catches an argument at another place, a usual value
// of the header that is not the default of C++, and a structure that is copied wrongly.
#include "mirocup/predict.hpp"
#include "mirocup/skills.h"
#include "mirocup/skills/attack.hpp"
#include "mirocup/skills/filter.hpp"
#include "mirocup/skills/hold_goal.hpp"
#include "mirocup/skills/laws.hpp"
#include "mirocup/skills/penalty.hpp"
#include "mirocup/skills/roles.hpp"
#include "mirocup/skills/worth.hpp"
#include "tests/support/skill_field.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>

namespace mirocup::strategy {
namespace {

Observation drawn_for_c(Random& random) {
  Observation now{};
  now.size = sizeof now;
  now.robots = 3;
  now.state = MIROCUP_PLAY;
  const auto to = [&](double most) { return most * (2.0 * random.uniform() - 1.0); };
  now.ball_x = to(0.7);
  now.ball_y = to(0.6);
  now.ball_vx = to(1.5);
  now.ball_vy = to(1.0);
  for (int i = 0; i < 3; ++i) {
    now.own[i] = {to(0.7), to(0.6), to(3.0), to(1.0), to(1.0), to(4.0)};
    now.opponent[i] = {to(0.7), to(0.6), to(3.0), to(1.0), to(1.0), to(4.0)};
  }
  return now;
}

// All of them are plain numbers.
template <class Plain>
auto numbers(const Plain& value) {
  return std::bit_cast<std::array<double, sizeof value / sizeof(double)>>(value);
}

#define SAME(in_c, in_cpp) EXPECT_EQ(numbers(in_c), numbers(in_cpp))

// The arguments at the end are those that the comments of the header give.
TEST(SkillsInC, GiveWhatTheyGiveInCpp) {
  const mirocup_setup s = test_support::SkillField().setup();
  Random random(3);
  for (int round = 0; round < 200; ++round) {
    const Observation now = drawn_for_c(random);
    const Robot& r = now.own[1];
    const mirocup_point c{now.own[2].x, now.own[2].y};
    const Point p{c.x, c.y};
    const mirocup_ball cb{c, {now.ball_vx, now.ball_vy}};
    const MovingBall b{p, ball_velocity(now)};
    const mirocup_pose pose{c.x, c.y, 0.4};
    const Target target{p, 0.4};
    SAME(mirocup_wrapped(r.heading + 5.0), wrapped(r.heading + 5.0));
    SAME(mirocup_dot(mirocup_unit(c), mirocup_ball_velocity(&now)), dot(unit(p), b.velocity));
    SAME(mirocup_length(mirocup_position(&r)), length(position(r)));
    SAME(mirocup_drive_to(&s, &r, c, 0.0, 1.5), drive_to(s, r, p));
    SAME(mirocup_drive_to_pose(&s, &r, c, 0.4, 1.5), drive_to_pose(s, r, p, 0.4));
    SAME(mirocup_inside(&s, c, mirocup_elbow_room(&s)), inside(s, p));
    SAME(mirocup_meeting_point(&s, &now, &r, 1.2), meeting_point(s, now, r));
    SAME(mirocup_drive_round(&s, &r, c, {0.1, 0.2}, 0.3, 1.1),
         drive_round(s, r, p, {0.1, 0.2}, 0.3, 1.1));
    SAME(mirocup_drive_clear(&s, &now, &r, c, 0.0, 1.5), drive_clear(s, now, r, p));
    SAME(mirocup_slide_to(&s, &r, 0.1, 1.5), slide_to(s, r, 0.1));
    SAME(mirocup_keep_out(&s, 1, c), keep_out(s, 1, p));
    SAME(mirocup_make_way(&s, &now, c), make_way(s, now, p));
    SAME(mirocup_without_pushing(&s, &now, &r, {9.0, 8.0}), without_pushing(s, now, r, {9.0, 8.0}));
    SAME(mirocup_out_of_area(&s, 1, &r, {9.0, 8.0}), out_of_area(s, 1, r, {9.0, 8.0}));
    EXPECT_EQ(mirocup_would_turn_ball_in(&s, &now, &r, 0.4) != 0, would_turn_ball_in(s, now, r));
    SAME(mirocup_kick_to(&s, &now, &r, c, 1.5), kick_to(s, now, r, p));
    SAME(mirocup_keep_goal(&s, &now, &r), keep_goal(s, now, r));
    SAME(mirocup_when_commanded(&s, &r, {9.0, 8.0}), when_commanded(s, r, {9.0, 8.0}));
    SAME(mirocup_turn_for(&s, 1.0, 0.2, 0.9), turn_for(s, 1.0, 0.2));
    SAME(mirocup_head_for(&s, &r, 0.3, 1.0, 1e9), head_for(s, r, 0.3, 1.0));
    SAME(mirocup_drive_quickly(&s, &r, c, 0.0, 1.8), drive_quickly(s, r, p));
    SAME(mirocup_take_pose(&s, &r, c, 0.4, 0.012, 1.8), take_pose(s, r, p, 0.4));
    SAME(mirocup_rolled(&s, cb, 0.4).at, rolled(s, b, 0.4).at);
    SAME(mirocup_rolled(&s, cb, 0.4).velocity, rolled(s, b, 0.4).velocity);
    SAME(mirocup_time_at_x(&s, cb, -0.5, 1.5).y, time_at_x(s, b, -0.5).y);
    SAME(mirocup_intercept(&s, &now, &r, 1.2, 1.5).ball.at, intercept(s, now, r).ball.at);
    SAME(mirocup_intercept(&s, &now, &r, 1.2, 1.5).seconds, intercept(s, now, r).seconds);
    SAME(mirocup_rough_meeting(&s, &now, &r, 1.2), rough_meeting(s, now, r));
    SAME(mirocup_follow_line(&s, &r, c, 0.4, 1.0, 0.2, 10.0, 0.08), follow_line(s, r, p, 0.4, 1.0));
    SAME(mirocup_shoot(&s, &r, c, {0.7, 0.1}, 1.8), shoot(s, r, p, {0.7, 0.1}));
    SAME(mirocup_open_corner(&s, &now, 0.05, 0.0), open_corner(s, now));
    SAME(mirocup_run_up(c, {0.7, 0.1}, 0.2), run_up(p, {0.7, 0.1}));
    SAME(mirocup_field_heading({r.x, r.y}, pose, 0.075, 0.07),
         field_heading({}, position(r), target));
    SAME(mirocup_around(0.4, {r.x, r.y}, {0.1, 0.2}, cb, 0.085, 0.045, 0.15),
         around(0.4, position(r), {0.1, 0.2}, {b.at, b.velocity}));
    SAME(mirocup_round_others(&now, 1, &r, c, 0.4, 0.35), round_others(now, 1, r, p, 0.4));
    SAME(mirocup_follow_heading(&s, &r, 0.4, 1.0, 0.0), follow_heading(s, r, 0.4, 1.0));
    const Obstacle obstacle{b.at, b.velocity};
    SAME(mirocup_follow_field(&s, &r, pose, 1.0, &cb, 1, 0.075, 0.07, 0.08),
         follow_field(s, r, target, 1.0, &obstacle, 1));
    SAME(mirocup_through(mirocup_shot_of(&r, c, {0.7, 0.1})), through(shot_of(r, p, {0.7, 0.1})));
    SAME(mirocup_pose_at_ball(&s, 1, mirocup_shot_of(&r, c, {0.7, 0.1})),
         pose_at_ball(s, 1, shot_of(r, p, {0.7, 0.1})));
    SAME(mirocup_attack_ball(&s, &now, 1, c, 1.8, 1e9, 0.08), attack_ball(s, now, 1, p));
    SAME(mirocup_attack_ball_at(&s, &now, 1, {r.x + 0.2, r.y}, c, 1.8, 1e9, 0.08),
         attack_ball_at(s, now, 1, {r.x + 0.2, r.y}, p));
    SAME(mirocup_supporting_place(&s, &now, 1, 2), supporting_place(s, now, 1, 2));
    SAME(mirocup_cover_point(&s, &now, 0.05, 0.0), cover_point(s, now));
    SAME(mirocup_guard_goal(&s, &now, &r, 0.05, 0.0, 0.5, 25.0), guard_goal(s, now, r));
    const BallPath path(s, moving_ball(now));
    SAME(mirocup_holding_y(&s, &now, 0.027, 0.0385), holding_y(s, now, path));
    SAME(mirocup_hold_goal(&s, &now, &r, 0.027, 0.0385, 0.2, 1.0), hold_goal(s, now, path, r));
    SAME(mirocup_return_to(&s, &r, c, {now.ball_x, now.ball_y}), return_to(s, r, p, ball(now)));
    SAME(mirocup_time_behind(&s, &now, 1, 0.35), time_behind(s, now, 1));
    SAME(mirocup_worth_of(&s, &now), worth_of(s, now));
    SAME(mirocup_time_to_get_behind(&r, c, {0.75, 0.0}), time_to_get_behind(r, p, {0.75, 0.0}));
    SAME(mirocup_out_of_reach(now.own, 3, c), out_of_reach(now.own, 3, p));
    SAME(mirocup_robot_after(&s, &r, {9.0, 8.0}, 0.2),
         robot_of(robot_after(s, body_of(r), {9.0, 8.0}, 0.2)));
    SAME(mirocup_driven_wheels(&s, &r, &now.own[2]), driven_wheels(s, r, now.own[2]));
  }
}

TEST(SkillsInC, ChangeCommandsAsInCpp) {
  const mirocup_setup s = test_support::SkillField().setup();
  Random random(4);
  for (int round = 0; round < 100; ++round) {
    const Observation now = drawn_for_c(random);
    Command in_c{{{10.0, 12.0}, {30.0, 28.0}, {-20.0, -22.0}}};
    Command in_cpp = in_c;
    mirocup_avoid_own_goals(&s, &now, &in_c);
    mirocup_keep_laws(&s, &now, &in_c);
    mirocup_spare_keeper(&s, &now, &in_c);
    avoid_own_goals(s, now, in_cpp);
    keep_laws(s, now, in_cpp);
    spare_keeper(s, now, in_cpp);
    for (int i = 0; i < 3; ++i) SAME(in_c.wheels[i], in_cpp.wheels[i]);
  }
}

TEST(SkillsInC, RememberAsInCpp) {
  const mirocup_setup s = test_support::SkillField().setup();
  Random random(5);
  mirocup_filter* filter = mirocup_filter_new(&s);
  mirocup_penalty* taker = mirocup_penalty_new();
  Filter filter_cpp(s);
  PenaltyTaker taker_cpp;
  Observation now = drawn_for_c(random);
  for (now.tick = 1; now.tick < 20; ++now.tick) {
    now.ball_age_ticks = 2;
    now.ball_x += 0.01;
    Observation seen{};
    mirocup_filter_see(filter, &now, 1, &seen);
    const Observation expected = filter_cpp.see(now);
    SAME(mirocup_point({seen.ball_x, seen.ball_vx}),
         mirocup_point({expected.ball_x, expected.ball_vx}));
    SAME(seen.own[1], expected.own[1]);
    SAME(mirocup_penalty_stand(taker, &s, &now, 0.1), taker_cpp.stand(s, now, 0.1));
    SAME(mirocup_penalty_drive(taker, &s, &now, &now.own[1]), taker_cpp.drive(s, now, now.own[1]));
    const Command sent{{{1.0, 2.0}, {3.0, 4.0}}};
    mirocup_filter_sent(filter, &sent);
    filter_cpp.sent(sent);
  }
  mirocup_filter_free(filter);
  mirocup_penalty_free(taker);
}

TEST(SkillsInC, PredictAsInCpp) {
  const mirocup_setup s = test_support::SkillField().setup();
  Random random(6);
  const Observation now = drawn_for_c(random);
  mirocup_simulator* simulator = mirocup_simulator_new(&s, 0);
  mirocup_scene* scene = mirocup_scene_new(&now);
  Simulator simulator_cpp(s);
  Scene scene_cpp = scene_of(now);
  const Command own{{{20.0, 18.0}, {30.0, 31.0}, {5.0, 9.0}}};
  const Command opponent{{{8.0, 7.0}, {-10.0, 5.0}, {1.0, 2.0}}};
  for (int tick = 0; tick < 20; ++tick) {
    const mirocup_predicted a = mirocup_simulator_advance(simulator, scene, &own, &opponent, 1);
    const PredictedTick b = simulator_cpp.advance(scene_cpp, own, opponent);
    EXPECT_EQ(a.last_touch, b.last_touch);
    EXPECT_EQ(a.events, b.events);
  }
  mirocup_scene* copy = mirocup_scene_copy_new(scene);
  Observation seen = now, expected = now;
  mirocup_scene_show_to_opponents(copy, &seen);
  show_to_opponents(scene_cpp, expected);
  for (int i = 0; i < 3; ++i) SAME(seen.opponent[i], expected.opponent[i]);
  mirocup_scene_free(copy);
  mirocup_scene_free(scene);
  mirocup_simulator_free(simulator);

  mirocup_tracker* tracker = mirocup_tracker_new(&s);
  mirocup_tracker_saw(tracker, &now);
  mirocup_tracker_sent(tracker, &own);
  SAME(mirocup_tracker_in_flight(tracker)->wheels[1], own.wheels[1]);
  mirocup_tracker_free(tracker);

  // A robot of three, told which is the cheapest, and two places for two robots.
  const double costs[3] = {0.0, 2.0, 1.0};
  EXPECT_EQ(mirocup_cheapest_robot(&now, 1, 1, 0.1, costs), 2);
  EXPECT_EQ(mirocup_cheapest_robot(&now, 1, 1, 1.1, costs), 1);
  const mirocup_point places[2] = {{now.own[2].x, now.own[2].y}, {now.own[1].x, now.own[1].y}};
  const std::int32_t free[2] = {1, 2}, last[2] = {1, 2};
  std::int32_t chosen[2] = {};
  mirocup_assign_places(&now, places, free, last, 2, 0.0, chosen);
  EXPECT_EQ(chosen[0], 2);
  EXPECT_EQ(chosen[1], 1);
}

}  // namespace
}  // namespace mirocup::strategy
