// SPDX-License-Identifier: MIT
//
// skills.h: the functions of strategy.hpp and the skills, as C calls them. It needs no C++ library,
// so that a team in C links it with a C compiler.
#ifdef MIROCUP_EXPORTED_SKILLS
#pragma GCC visibility push(default)
#endif
#include "mirocup/skills.h"
#ifdef MIROCUP_EXPORTED_SKILLS
#pragma GCC visibility pop
#endif

#include "mirocup/skills/attack.hpp"
#include "mirocup/skills/filter.hpp"
#include "mirocup/skills/hold_goal.hpp"
#include "mirocup/skills/laws.hpp"
#include "mirocup/skills/penalty.hpp"
#include "mirocup/skills/roles.hpp"
#include "mirocup/skills/worth.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <new>
#include <type_traits>

namespace strategy = mirocup::strategy;
using strategy::Point;

namespace {

// ---- from C to C++

Point in(mirocup_point p) {
  return {p.x, p.y};
}
strategy::MovingBall in(mirocup_ball b) {
  return {in(b.at), in(b.velocity)};
}
strategy::Target in(mirocup_pose p) {
  return {{p.x, p.y}, p.heading};
}
strategy::Shot in(mirocup_shot s) {
  return {in(s.at), in(s.along), s.aside, s.is_on_line != 0};
}

// ---- from C++ to C

mirocup_point out(Point p) {
  return {p.x, p.y};
}
mirocup_ball out(const strategy::MovingBall& b) {
  return {out(b.at), out(b.velocity)};
}
mirocup_pose out(const strategy::Target& t) {
  return {t.at.x, t.at.y, t.heading};
}
mirocup_crossing out(const strategy::Crossing& c) {
  return {c.seconds, c.y, c.is_ahead ? 1 : 0};
}
mirocup_interception out(const strategy::Interception& i) {
  return {out(i.ball), i.seconds, i.is_reached ? 1 : 0};
}
mirocup_shot out(const strategy::Shot& s) {
  return {out(s.at), out(s.along), s.aside, s.is_on_line ? 1 : 0};
}
std::int32_t out(bool b) {
  return b ? 1 : 0;
}
// What is the same in both.
mirocup_wheels out(mirocup_wheels w) {
  return w;
}
mirocup_pose out(mirocup_pose p) {
  return p;
}
mirocup_robot out(const mirocup_robot& r) {
  return r;
}
double out(double x) {
  return x;
}

using S = const mirocup_setup*;
using O = const mirocup_observation*;
using R = const mirocup_robot*;
using C = mirocup_command*;
using P = mirocup_point;
using W = mirocup_wheels;
using I = std::int32_t;
using D = double;

}  // namespace

// Defines mirocup_NAME(parameters) as strategy::NAME(arguments).
#define SKILL(Result, name, parameters, ...) \
  Result mirocup_##name parameters {         \
    return out(strategy::name(__VA_ARGS__)); \
  }

extern "C" {

SKILL(W, wheels_for, (S setup, D forward, D turn), *setup, forward, turn)
SKILL(W, turn_to, (S setup, R robot, D heading), *setup, *robot, heading)
SKILL(W, drive_to, (S setup, R robot, P target, D arrival, D fastest), *setup, *robot, in(target),
      arrival, fastest)
SKILL(W, drive_to_pose, (S setup, R robot, P target, D heading, D fastest), *setup, *robot,
      in(target), heading, fastest)
SKILL(P, ball_after, (O now, D seconds), *now, seconds)
SKILL(D, elbow_room, (S setup), *setup)
SKILL(D, behind_ball, (S setup), *setup)
SKILL(P, inside, (S setup, P p, D margin), *setup, in(p), margin)
SKILL(P, meeting_point, (S setup, O now, R robot, D pace), *setup, *now, *robot, pace)
SKILL(D, squared, (D heading), heading)
SKILL(W, drive_round, (S setup, R robot, P target, P obstacle, D arrival, D fastest), *setup,
      *robot, in(target), in(obstacle), arrival, fastest)
SKILL(W, drive_clear, (S setup, O now, R robot, P target, D arrival, D fastest), *setup, *now,
      *robot, in(target), arrival, fastest)
SKILL(W, slide_to, (S setup, R robot, D y, D fastest), *setup, *robot, y, fastest)

SKILL(P, keep_out, (S setup, I i, P p), *setup, i, in(p))
SKILL(P, make_way, (S setup, O now, P p), *setup, *now, in(p))
SKILL(I, is_stuck, (O now, D patience), *now, patience)
SKILL(W, without_pushing, (S setup, O now, R robot, W wheels), *setup, *now, *robot, wheels)
SKILL(W, out_of_area, (S setup, I i, R robot, W wheels), *setup, i, *robot, wheels)
SKILL(I, rolls_into_own_goal, (S setup, P ball, P velocity, D margin), *setup, in(ball),
      in(velocity), margin)
SKILL(I, would_turn_ball_in, (S setup, O now, R robot, D soon_s), *setup, *now, *robot, soon_s)
void mirocup_keep_laws(S setup, O now, C command) {
  strategy::keep_laws(*setup, *now, *command);
}
void mirocup_avoid_own_goals(S setup, O now, C command) {
  strategy::avoid_own_goals(*setup, *now, *command);
}

SKILL(W, kick_to, (S setup, O now, R robot, P point, D pace), *setup, *now, *robot, in(point), pace)
SKILL(I, must_kick_off, (O now), *now)
SKILL(W, kick_off, (S setup, R robot), *setup, *robot)
SKILL(D, middle_of_goal_view, (S setup, P ball), *setup, in(ball))
SKILL(W, free_ball, (S setup, O now, R robot), *setup, *now, *robot)
SKILL(W, keep_goal, (S setup, O now, R robot), *setup, *now, *robot)

SKILL(P, nose_of, (R robot), *robot)
SKILL(D, speed_ahead, (R robot), *robot)
SKILL(D, greatest_speed, (S setup), *setup)
SKILL(mirocup_robot, when_commanded, (S setup, R robot, W wheels), *setup, *robot, wheels)
SKILL(W, wheels_turning_first, (S setup, D forward, D turn), *setup, forward, turn)
SKILL(D, turn_for, (S setup, D turn, D error, D part), *setup, turn, error, part)
SKILL(W, turn_quickly, (S setup, R robot, D heading), *setup, *robot, heading)
SKILL(W, head_for, (S setup, R robot, D direction, D speed, D distance), *setup, *robot, direction,
      speed, distance)
SKILL(W, drive_quickly, (S setup, R robot, P target, D arrival, D speed), *setup, *robot,
      in(target), arrival, speed)
SKILL(W, take_pose, (S setup, R robot, P target, D heading, D near, D speed), *setup, *robot,
      in(target), heading, near, speed)

SKILL(mirocup_ball, rolled, (S setup, mirocup_ball moving, D seconds), *setup, in(moving), seconds)
SKILL(mirocup_crossing, time_at_x, (S setup, mirocup_ball moving, D x, D most_s), *setup,
      in(moving), x, most_s)
SKILL(mirocup_interception, intercept, (S setup, O now, R robot, D pace, D most_s), *setup, *now,
      *robot, pace, most_s)
SKILL(P, rough_meeting, (S setup, O now, R robot, D pace), *setup, *now, *robot, pace)

SKILL(W, follow_line,
      (S setup, R robot, P point, D heading, D speed, D aim_ahead, D gain, D lead_s), *setup,
      *robot, in(point), heading, speed, {aim_ahead, gain, lead_s})
SKILL(W, shoot, (S setup, R robot, P ball, P aim, D speed), *setup, *robot, in(ball), in(aim),
      speed)
SKILL(P, open_corner, (S setup, O now, D margin, D y_bias), *setup, *now, margin, y_bias)
SKILL(mirocup_pose, run_up, (P ball, P aim, D distance), in(ball), in(aim), distance)
SKILL(I, must_take_kick, (O now, P spot), *now, in(spot))

SKILL(D, field_heading, (P here, mirocup_pose pose, D radius, D smooth), {radius, smooth}, in(here),
      in(pose))
SKILL(D, around, (D heading, P here, P velocity, mirocup_ball moving, D nearest, D width, D lead_s),
      heading, in(here), in(velocity), {in(moving.at), in(moving.velocity)},
      {nearest, width, lead_s})
SKILL(D, round_others, (O now, I me, R robot, P target, D heading, D sight), *now, me, *robot,
      in(target), heading, sight)
SKILL(W, follow_heading, (S setup, R robot, D heading, D speed, D turn), *setup, *robot, heading,
      speed, turn)
mirocup_wheels mirocup_follow_field(S setup, R robot, mirocup_pose pose, D speed,
                                    const mirocup_ball* obstacles, I count, D radius, D smooth,
                                    D lead_s) {
  strategy::Obstacle others[2 * MIROCUP_MAX_ROBOTS];
  int used = 0;
  for (int k = 0; k < count && used < 2 * MIROCUP_MAX_ROBOTS; ++k)
    others[used++] = {in(obstacles[k].at), in(obstacles[k].velocity)};
  return strategy::follow_field(*setup, *robot, in(pose), speed, others, used, {radius, smooth},
                                lead_s);
}

SKILL(P, shooting_aim, (S setup, O now, P where), *setup, *now, in(where))
SKILL(mirocup_shot, shot_of, (R robot, P at, P aim), *robot, in(at), in(aim))
SKILL(P, through, (mirocup_shot shot), in(shot))
SKILL(mirocup_pose, pose_at_ball, (S setup, I me, mirocup_shot shot), *setup, me, in(shot))
SKILL(W, attack_ball_at, (S setup, O now, I me, P at, P aim, D speed, D sight, D lead_s), *setup,
      *now, me, in(at), in(aim), {speed, sight, lead_s})
SKILL(W, attack_ball, (S setup, O now, I me, P aim, D speed, D sight, D lead_s), *setup, *now, me,
      in(aim), {speed, sight, lead_s})
SKILL(P, supporting_place, (S setup, O now, I me, I rank), *setup, *now, me, rank)

SKILL(D, y_on_line, (P ball, P along, D x), in(ball), in(along), x)
double mirocup_y_of_coming_shot(O now, D x) {
  const auto y = strategy::y_of_coming_shot(*now, x);
  return y ? *y : std::numeric_limits<double>::quiet_NaN();
}
SKILL(P, cover_point, (S setup, O now, D line, D inside_post), *setup, *now,
      {.line = line, .inside_post = inside_post})
SKILL(W, guard_goal, (S setup, O now, R robot, D line, D inside_post, D clear_speed, D spin),
      *setup, *now, *robot, {line, inside_post, clear_speed, spin})
SKILL(W, rough_guard, (S setup, O now, R robot), *setup, *now, *robot)
SKILL(D, holding_y, (S setup, O now, D line, D inside_post), *setup, *now,
      strategy::BallPath(*setup, strategy::moving_ball(*now)),
      {.line = line, .inside_post = inside_post})
SKILL(W, hold_goal, (S setup, O now, R robot, D line, D inside_post, D slow, D patience), *setup,
      *now, strategy::BallPath(*setup, strategy::moving_ball(*now)), *robot,
      {line, inside_post, slow, patience})
SKILL(I, lies_in_area, (S setup, O now, D slow), *setup, *now, slow)
SKILL(W, slide_quickly, (S setup, R robot, P target), *setup, *robot, in(target))
SKILL(W, push_outwards, (S setup, R robot, D outwards), *setup, *robot, outwards)
SKILL(W, return_to, (S setup, R robot, P target, P ball), *setup, *robot, in(target), in(ball))

SKILL(I, has_ball, (S setup, O now, R robot, P along), *setup, *now, *robot, in(along))
SKILL(I, must_leave_area, (S setup, R robot), *setup, *robot)
SKILL(W, leave_area, (S setup, R robot), *setup, *robot)
void mirocup_spare_keeper(S setup, O now, C command) {
  strategy::spare_keeper(*setup, *now, *command);
}

SKILL(D, time_behind, (S setup, O now, I i, D round_s), *setup, *now, i, round_s)
std::int32_t mirocup_cheapest_robot(O now, I first, I last, D bonus, const double* costs) {
  return strategy::cheapest_robot(*now, first, last, bonus, [&](int i) { return costs[i]; });
}
void mirocup_assign_places(O now, const mirocup_point* places, const std::int32_t* free,
                           const std::int32_t* last, I count, D bonus, std::int32_t* chosen) {
  Point points[MIROCUP_MAX_ROBOTS];
  strategy::Assignment before{};
  const int used = count < MIROCUP_MAX_ROBOTS ? count : MIROCUP_MAX_ROBOTS;
  for (int k = 0; k < used; ++k) {
    points[k] = in(places[k]);
    before[static_cast<std::size_t>(k)] = last[k];
  }
  const auto size = static_cast<std::size_t>(used);
  const strategy::Assignment now_chosen =
      strategy::assign_places(*now, {points, size}, {free, size}, before, bonus);
  for (int k = 0; k < used; ++k) chosen[k] = now_chosen[static_cast<std::size_t>(k)];
}

SKILL(D, worth_of, (S setup, O now), *setup, *now)
SKILL(D, time_to_get_behind, (R robot, P ball, P goal), *robot, in(ball), in(goal))
SKILL(D, out_of_reach, (R robots, I count, P ball), robots, count, in(ball))

void mirocup_draw_role(S setup, R robot, const char* role) {
  strategy::draw_role(*setup, *robot, role);
}
void mirocup_draw_target(S setup, R robot, P target) {
  strategy::draw_target(*setup, *robot, in(target));
}
void mirocup_draw_shot(S setup, R robot, P at, P aim) {
  strategy::draw_shot(*setup, *robot, in(at), in(aim));
}

// ---- what remembers: malloc() and free(), because operator new is of the C++ library

struct mirocup_filter {
  strategy::Filter filter;
};
struct mirocup_penalty {
  strategy::PenaltyTaker taker;
};
static_assert(std::is_trivially_destructible_v<mirocup_filter>);
static_assert(std::is_trivially_destructible_v<mirocup_penalty>);

mirocup_filter* mirocup_filter_new(S setup) {
  void* room = std::malloc(sizeof(mirocup_filter));
  return room == nullptr ? nullptr : new (room) mirocup_filter{strategy::Filter(*setup)};
}
void mirocup_filter_see(mirocup_filter* filter, O seen, I ticks_ahead, mirocup_observation* now) {
  *now = filter->filter.see(*seen, ticks_ahead);
}
void mirocup_filter_sent(mirocup_filter* filter, const mirocup_command* command) {
  filter->filter.sent(*command);
}
void mirocup_filter_free(mirocup_filter* filter) {
  std::free(filter);
}

mirocup_penalty* mirocup_penalty_new(void) {
  void* room = std::malloc(sizeof(mirocup_penalty));
  return room == nullptr ? nullptr : new (room) mirocup_penalty{strategy::PenaltyTaker()};
}
mirocup_pose mirocup_penalty_stand(mirocup_penalty* taker, S setup, O now, D y_bias) {
  return taker->taker.stand(*setup, *now, y_bias);
}
mirocup_wheels mirocup_penalty_drive(mirocup_penalty* taker, S setup, O now, R robot) {
  return taker->taker.drive(*setup, *now, *robot);
}
void mirocup_penalty_free(mirocup_penalty* taker) {
  std::free(taker);
}

}  // extern "C"
