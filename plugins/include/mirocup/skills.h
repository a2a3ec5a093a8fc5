/* SPDX-License-Identifier: MIT
 *
 * Skills and prediction for C, and for every language that calls C; mirocup.team calls them for
 * Python. Each function does the same as the C++ function of its name; the comment above a group
 * names the C++ header that explains its functions. Frames and units are those of strategy.h.
 *
 *   gcc -std=c17 -O2 -ffp-contract=off -shared -fPIC -fvisibility=hidden -Iplugins/include mine.c
 *       build/lib/libmirocup_predict.a -lm -o mine.so
 *
 * This command is one line. If you use the simulator (the last group), link with g++ and
 * -static-libstdc++. In CMake, link mirocup::predict. A team in C:
 *
 *   static void* create(const mirocup_setup* setup) { return (void*)setup; }
 *   static void decide(void* team, const mirocup_observation* now, mirocup_command* command) {
 *     const mirocup_setup* setup = team;
 *     mirocup_point goal = {setup->half_length, 0.0};
 *     command->wheels[0] = mirocup_keep_goal(setup, now, &now->own[0]);
 *     command->wheels[1] = mirocup_kick_to(setup, now, &now->own[1], goal, 1.5);
 *     mirocup_keep_laws(setup, now, command);
 *   }
 *   const mirocup_strategy* mirocup_entry(void) {
 *     static const mirocup_strategy mine = {
 *         MIROCUP_ABI_VERSION, sizeof mine, "mine", create, decide, NULL, NULL};
 *     return &mine;
 *   }
 *
 * C has no default arguments, so the comment behind a function gives the usual values of its last
 * arguments. `me` and `i` are numbers of own robots. A yes or no is an int32_t, 1 or 0. You own the
 * result of a function with `new` in its name until you call its `free`; a null result means that
 * memory is short.
 */
#ifndef MIROCUP_SKILLS_H
#define MIROCUP_SKILLS_H

#include "mirocup/strategy.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A point or a vector, m. */
typedef struct mirocup_point {
  double x, y;
} mirocup_point;

typedef struct mirocup_ball {
  mirocup_point at;       /* m */
  mirocup_point velocity; /* m/s */
} mirocup_ball;

typedef struct mirocup_crossing {
  double seconds, y;
  int32_t is_ahead; /* 0: the ball does not cross the line, and all members are 0 */
} mirocup_crossing;

typedef struct mirocup_interception {
  mirocup_ball ball; /* when the robot meets it */
  double seconds;    /* until the meeting */
  int32_t is_reached;
} mirocup_interception;

typedef struct mirocup_shot {
  mirocup_point at;    /* m */
  mirocup_point along; /* of length 1 */
  double aside;        /* m */
  int32_t is_on_line;
} mirocup_shot;

/* driving.hpp: one robot drives. */
mirocup_wheels mirocup_wheels_for(const mirocup_setup* setup, double forward, double turn);
mirocup_wheels mirocup_turn_to(const mirocup_setup* setup, const mirocup_robot* robot,
                               double heading);
mirocup_wheels mirocup_drive_to(const mirocup_setup* setup, const mirocup_robot* robot,
                                mirocup_point target, double arrival, double fastest); /* 0, 1.5 */
mirocup_wheels mirocup_drive_to_pose(const mirocup_setup* setup, const mirocup_robot* robot,
                                     mirocup_point target, double heading,
                                     double fastest); /* 1.5 */
mirocup_point mirocup_ball_after(const mirocup_observation* now, double seconds);
double mirocup_elbow_room(const mirocup_setup* setup);
double mirocup_behind_ball(const mirocup_setup* setup);
mirocup_point mirocup_inside(const mirocup_setup* setup, mirocup_point p,
                             double margin); /* mirocup_elbow_room(setup) */
mirocup_point mirocup_meeting_point(const mirocup_setup* setup, const mirocup_observation* now,
                                    const mirocup_robot* robot, double pace); /* 1.2 */
double mirocup_squared(double heading);
mirocup_wheels mirocup_drive_round(const mirocup_setup* setup, const mirocup_robot* robot,
                                   mirocup_point target, mirocup_point obstacle, double arrival,
                                   double fastest); /* 0, 1.5 */
mirocup_wheels mirocup_drive_clear(const mirocup_setup* setup, const mirocup_observation* now,
                                   const mirocup_robot* robot, mirocup_point target, double arrival,
                                   double fastest); /* 0, 1.5 */
mirocup_wheels mirocup_slide_to(const mirocup_setup* setup, const mirocup_robot* robot, double y,
                                double fastest); /* 1.5 */

/* laws.hpp: targets and commands that keep the laws, and keep the ball out of the own goal. */
mirocup_point mirocup_keep_out(const mirocup_setup* setup, int32_t i, mirocup_point p);
mirocup_point mirocup_make_way(const mirocup_setup* setup, const mirocup_observation* now,
                               mirocup_point p);
int32_t mirocup_is_stuck(const mirocup_observation* now, double patience); /* 0.6 */
mirocup_wheels mirocup_without_pushing(const mirocup_setup* setup, const mirocup_observation* now,
                                       const mirocup_robot* robot, mirocup_wheels wheels);
mirocup_wheels mirocup_out_of_area(const mirocup_setup* setup, int32_t i,
                                   const mirocup_robot* robot, mirocup_wheels wheels);
void mirocup_keep_laws(const mirocup_setup* setup, const mirocup_observation* now,
                       mirocup_command* command);
int32_t mirocup_rolls_into_own_goal(const mirocup_setup* setup, mirocup_point ball,
                                    mirocup_point velocity, double margin);
int32_t mirocup_would_turn_ball_in(const mirocup_setup* setup, const mirocup_observation* now,
                                   const mirocup_robot* robot, double soon_s); /* 0.4 */
void mirocup_avoid_own_goals(const mirocup_setup* setup, const mirocup_observation* now,
                             mirocup_command* command);

/* strategy.hpp: roles to start from. */
mirocup_wheels mirocup_kick_to(const mirocup_setup* setup, const mirocup_observation* now,
                               const mirocup_robot* robot, mirocup_point point,
                               double pace); /* 1.5 */
int32_t mirocup_must_kick_off(const mirocup_observation* now);
mirocup_wheels mirocup_kick_off(const mirocup_setup* setup, const mirocup_robot* robot);
double mirocup_middle_of_goal_view(const mirocup_setup* setup, mirocup_point ball);
mirocup_wheels mirocup_free_ball(const mirocup_setup* setup, const mirocup_observation* now,
                                 const mirocup_robot* robot);
mirocup_wheels mirocup_keep_goal(const mirocup_setup* setup, const mirocup_observation* now,
                                 const mirocup_robot* robot);

/* skills/drive.hpp: turning and driving in the shortest time. */
mirocup_point mirocup_nose_of(const mirocup_robot* robot);
double mirocup_speed_ahead(const mirocup_robot* robot);
double mirocup_greatest_speed(const mirocup_setup* setup);
mirocup_robot mirocup_when_commanded(const mirocup_setup* setup, const mirocup_robot* robot,
                                     mirocup_wheels wheels);
mirocup_wheels mirocup_wheels_turning_first(const mirocup_setup* setup, double forward,
                                            double turn);
double mirocup_turn_for(const mirocup_setup* setup, double turn, double error,
                        double part); /* 0.9 */
mirocup_wheels mirocup_turn_quickly(const mirocup_setup* setup, const mirocup_robot* robot,
                                    double heading);
mirocup_wheels mirocup_head_for(const mirocup_setup* setup, const mirocup_robot* robot,
                                double direction, double speed, double distance); /* 1e9 */
mirocup_wheels mirocup_drive_quickly(const mirocup_setup* setup, const mirocup_robot* robot,
                                     mirocup_point target, double arrival,
                                     double speed); /* 0, 1.8 */
mirocup_wheels mirocup_take_pose(const mirocup_setup* setup, const mirocup_robot* robot,
                                 mirocup_point target, double heading, double near,
                                 double speed); /* 0.012, 1.8 */

/* skills/ball_path.hpp and intercept.hpp: the path of the ball, and where a robot meets it. */
mirocup_ball mirocup_rolled(const mirocup_setup* setup, mirocup_ball moving, double seconds);
mirocup_crossing mirocup_time_at_x(const mirocup_setup* setup, mirocup_ball moving, double x,
                                   double most_s); /* 1.5 */
mirocup_interception mirocup_intercept(const mirocup_setup* setup, const mirocup_observation* now,
                                       const mirocup_robot* robot, double pace,
                                       double most_s); /* 1.2, 1.5 */
mirocup_point mirocup_rough_meeting(const mirocup_setup* setup, const mirocup_observation* now,
                                    const mirocup_robot* robot, double pace); /* 1.2 */

/* skills/shoot.hpp. */
mirocup_wheels mirocup_follow_line(const mirocup_setup* setup, const mirocup_robot* robot,
                                   mirocup_point point, double heading, double speed,
                                   double aim_ahead, double gain,
                                   double lead_s); /* 0.2, 10, 0.08 */
mirocup_wheels mirocup_shoot(const mirocup_setup* setup, const mirocup_robot* robot,
                             mirocup_point ball, mirocup_point aim, double speed); /* 1.8 */
mirocup_point mirocup_open_corner(const mirocup_setup* setup, const mirocup_observation* now,
                                  double margin, double y_bias);                     /* 0.05, 0 */
mirocup_pose mirocup_run_up(mirocup_point ball, mirocup_point aim, double distance); /* 0.2 */
int32_t mirocup_must_take_kick(const mirocup_observation* now, mirocup_point spot);

/* skills/univector_field.hpp: a field of directions that leads to a pose. */
double mirocup_field_heading(mirocup_point here, mirocup_pose pose, double radius,
                             double smooth); /* 0.075, 0.07 */
double mirocup_around(double heading, mirocup_point here, mirocup_point velocity,
                      mirocup_ball moving, double nearest, double width,
                      double lead_s); /* `moving` is the obstacle; 0.085, 0.045, 0.15 */
double mirocup_round_others(const mirocup_observation* now, int32_t me, const mirocup_robot* robot,
                            mirocup_point target, double heading, double sight); /* 0.35 */
mirocup_wheels mirocup_follow_heading(const mirocup_setup* setup, const mirocup_robot* robot,
                                      double heading, double speed, double turn); /* 0 */
mirocup_wheels mirocup_follow_field(const mirocup_setup* setup, const mirocup_robot* robot,
                                    mirocup_pose pose, double speed, const mirocup_ball* obstacles,
                                    int32_t count, double radius, double smooth,
                                    double lead_s); /* 0.075, 0.07, 0.08 */

/* skills/attack.hpp. */
mirocup_point mirocup_shooting_aim(const mirocup_setup* setup, const mirocup_observation* now,
                                   mirocup_point where);
mirocup_shot mirocup_shot_of(const mirocup_robot* robot, mirocup_point at, mirocup_point aim);
mirocup_point mirocup_through(mirocup_shot shot);
mirocup_pose mirocup_pose_at_ball(const mirocup_setup* setup, int32_t me, mirocup_shot shot);
mirocup_wheels mirocup_attack_ball_at(const mirocup_setup* setup, const mirocup_observation* now,
                                      int32_t me, mirocup_point at, mirocup_point aim, double speed,
                                      double sight, double lead_s); /* 1.8, 1e9, 0.08 */
mirocup_wheels mirocup_attack_ball(const mirocup_setup* setup, const mirocup_observation* now,
                                   int32_t me, mirocup_point aim, double speed, double sight,
                                   double lead_s); /* 1.8, 1e9, 0.08 */
mirocup_point mirocup_supporting_place(const mirocup_setup* setup, const mirocup_observation* now,
                                       int32_t me, int32_t rank);

/* skills/keeper.hpp and hold_goal.hpp: two ways of keeping the goal. */
double mirocup_y_on_line(mirocup_point ball, mirocup_point along, double x);
double mirocup_y_of_coming_shot(const mirocup_observation* now, double x); /* NaN: no shot comes */
mirocup_point mirocup_cover_point(const mirocup_setup* setup, const mirocup_observation* now,
                                  double line, double inside_post); /* 0.05, 0 */
mirocup_wheels mirocup_guard_goal(const mirocup_setup* setup, const mirocup_observation* now,
                                  const mirocup_robot* robot, double line, double inside_post,
                                  double clear_speed, double spin); /* 0.05, 0, 0.5, 25 */
mirocup_wheels mirocup_rough_guard(const mirocup_setup* setup, const mirocup_observation* now,
                                   const mirocup_robot* robot);
double mirocup_holding_y(const mirocup_setup* setup, const mirocup_observation* now, double line,
                         double inside_post); /* 0.027, 0.0385 */
mirocup_wheels mirocup_hold_goal(const mirocup_setup* setup, const mirocup_observation* now,
                                 const mirocup_robot* robot, double line, double inside_post,
                                 double slow, double patience); /* 0.027, 0.0385, 0.2, 1 */
int32_t mirocup_lies_in_area(const mirocup_setup* setup, const mirocup_observation* now,
                             double slow);
mirocup_wheels mirocup_slide_quickly(const mirocup_setup* setup, const mirocup_robot* robot,
                                     mirocup_point target);
mirocup_wheels mirocup_push_outwards(const mirocup_setup* setup, const mirocup_robot* robot,
                                     double outwards);
mirocup_wheels mirocup_return_to(const mirocup_setup* setup, const mirocup_robot* robot,
                                 mirocup_point target, mirocup_point ball);

/* skills/laws.hpp. */
int32_t mirocup_has_ball(const mirocup_setup* setup, const mirocup_observation* now,
                         const mirocup_robot* robot, mirocup_point along);
void mirocup_spare_keeper(const mirocup_setup* setup, const mirocup_observation* now,
                          mirocup_command* command);
int32_t mirocup_must_leave_area(const mirocup_setup* setup, const mirocup_robot* robot);
mirocup_wheels mirocup_leave_area(const mirocup_setup* setup, const mirocup_robot* robot);

/* skills/roles.hpp. costs[i] is the cost of own robot i. assign_places() gives places[k] to robot
   chosen[k], one of `free`; `last` is `chosen` of the last tick. Each of these four arrays of
   assign_places() has `count` elements. */
double mirocup_time_behind(const mirocup_setup* setup, const mirocup_observation* now, int32_t i,
                           double round_s); /* 0.35 */
int32_t mirocup_cheapest_robot(const mirocup_observation* now, int32_t first, int32_t last,
                               double bonus, const double* costs);
void mirocup_assign_places(const mirocup_observation* now, const mirocup_point* places,
                           const int32_t* free, const int32_t* last, int32_t count, double bonus,
                           int32_t* chosen); /* 0.1 */

/* skills/worth.hpp: the worth of a scene. */
double mirocup_worth_of(const mirocup_setup* setup, const mirocup_observation* now);
double mirocup_time_to_get_behind(const mirocup_robot* robot, mirocup_point ball,
                                  mirocup_point goal);
double mirocup_out_of_reach(const mirocup_robot* robots, int32_t count, mirocup_point ball);

/* skills/draw.hpp. */
void mirocup_draw_role(const mirocup_setup* setup, const mirocup_robot* robot, const char* role);
void mirocup_draw_target(const mirocup_setup* setup, const mirocup_robot* robot,
                         mirocup_point target);
void mirocup_draw_shot(const mirocup_setup* setup, const mirocup_robot* robot, mirocup_point at,
                       mirocup_point aim);

/* skills/filter.hpp: Filter. see() writes its result to `now`. */
typedef struct mirocup_filter mirocup_filter;
mirocup_filter* mirocup_filter_new(const mirocup_setup* setup);
void mirocup_filter_see(mirocup_filter* filter, const mirocup_observation* seen,
                        int32_t ticks_ahead, mirocup_observation* now); /* 1 */
void mirocup_filter_sent(mirocup_filter* filter, const mirocup_command* command);
void mirocup_filter_free(mirocup_filter* filter);

/* skills/penalty.hpp: PenaltyTaker. */
typedef struct mirocup_penalty mirocup_penalty;
mirocup_penalty* mirocup_penalty_new(void);
mirocup_pose mirocup_penalty_stand(mirocup_penalty* taker, const mirocup_setup* setup,
                                   const mirocup_observation* now, double y_bias);
mirocup_wheels mirocup_penalty_drive(mirocup_penalty* taker, const mirocup_setup* setup,
                                     const mirocup_observation* now, const mirocup_robot* robot);
void mirocup_penalty_free(mirocup_penalty* taker);

/* predict.hpp: the simulator of the match. robot_after() takes and returns a robot as observed. */
typedef struct mirocup_simulator mirocup_simulator;
typedef struct mirocup_scene mirocup_scene;
typedef struct mirocup_tracker mirocup_tracker;

/* The events of a predicted tick. Bit i of a set is robot i. */
typedef struct mirocup_predicted {
  uint32_t own_touched_ball, opponent_touched_ball;
  int32_t last_touch; /* who touched the ball last: i + 1 own i, -i - 1 opponent i, 0 none */
  int32_t events;
} mirocup_predicted;

mirocup_wheels mirocup_sent_wheels(const mirocup_setup* setup, mirocup_wheels wheels);
mirocup_robot mirocup_robot_after(const mirocup_setup* setup, const mirocup_robot* robot,
                                  mirocup_wheels wheels, double seconds);
mirocup_wheels mirocup_driven_wheels(const mirocup_setup* setup, const mirocup_robot* before,
                                     const mirocup_robot* after);

mirocup_tracker* mirocup_tracker_new(const mirocup_setup* setup);
void mirocup_tracker_saw(mirocup_tracker* tracker, const mirocup_observation* now);
void mirocup_tracker_sent(mirocup_tracker* tracker, const mirocup_command* command);
const mirocup_command* mirocup_tracker_in_flight(const mirocup_tracker* tracker);
const mirocup_command* mirocup_tracker_opponents(const mirocup_tracker* tracker);
void mirocup_tracker_free(mirocup_tracker* tracker);

mirocup_scene* mirocup_scene_new(const mirocup_observation* now);
mirocup_scene* mirocup_scene_copy_new(const mirocup_scene* scene);
void mirocup_scene_show(const mirocup_scene* scene, mirocup_observation* now);
void mirocup_scene_show_to_opponents(const mirocup_scene* scene, mirocup_observation* now);
void mirocup_scene_free(mirocup_scene* scene);

mirocup_simulator* mirocup_simulator_new(const mirocup_setup* setup, int32_t is_coarse);
mirocup_predicted mirocup_simulator_advance(mirocup_simulator* simulator, mirocup_scene* scene,
                                            const mirocup_command* own,
                                            const mirocup_command* opponent, int32_t ticks); /* 1 */
void mirocup_simulator_free(mirocup_simulator* simulator);

#ifdef __cplusplus
}
#endif

#endif
