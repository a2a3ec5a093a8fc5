/* SPDX-License-Identifier: MIT
 *
 * Skills and prediction for C, and for every language that calls C; mirocup.team calls them for
 * Python. Each function does the same as the C++ function of its name; the comment above a group
 * names the C++ header that says more. The build makes the functions of both languages from these
 * declarations (declarations.py). Frames and units are those of strategy.h.
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
 * arguments; those in braces are members of one structure in C++. `me` and `i` are numbers of own
 * robots. A yes or no is an int32_t, 1 or 0. You own the result of a function with `new` in its
 * name until you call its `free`; a null result means that memory is short.
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

/* ---- types.hpp and strategy.h: angles, vectors, bodies. */

/* Returns the same angle in (-pi, pi], rad. The difference of two headings needs it. */
double mirocup_wrapped(double angle);
double mirocup_dot(mirocup_point a, mirocup_point b);
double mirocup_length(mirocup_point a);
/* Returns the vector with the length 1; (1, 0) for one without a length. */
mirocup_point mirocup_unit(mirocup_point a);
mirocup_point mirocup_position(const mirocup_robot* robot);
mirocup_point mirocup_ball_velocity(const mirocup_observation* now);

/* ---- driving.hpp: one robot drives. */

/* Returns the wheel speeds for a forward speed (m/s) and an angular velocity (rad/s). */
mirocup_wheels mirocup_wheels_for(const mirocup_setup* setup, double forward, double turn);
/* Turns on the spot towards a heading, rad. */
mirocup_wheels mirocup_turn_to(const mirocup_setup* setup, const mirocup_robot* robot,
                               double heading);
/* Drives to a point, forwards or backwards, and passes it at `arrival` m/s (0: stops there). */
mirocup_wheels mirocup_drive_to(const mirocup_setup* setup, const mirocup_robot* robot,
                                mirocup_point target, double arrival, double fastest); /* 0, 1.5 */
/* Drives to a point and turns to a heading there. */
mirocup_wheels mirocup_drive_to_pose(const mirocup_setup* setup, const mirocup_robot* robot,
                                     mirocup_point target, double heading,
                                     double fastest); /* 1.5 */
/* Returns the place of the ball after some seconds, without robots and walls. */
mirocup_point mirocup_ball_after(const mirocup_observation* now, double seconds);
/* Returns how far from a wall a robot can still turn, m. */
double mirocup_elbow_room(const mirocup_setup* setup);
/* Returns how far behind the ball a robot can turn without touching it, m. */
double mirocup_behind_ball(const mirocup_setup* setup);
/* Returns the nearest point of the field at least `margin` (m) from the walls. */
mirocup_point mirocup_inside(const mirocup_setup* setup, mirocup_point p,
                             double margin); /* mirocup_elbow_room(setup) */
/* Returns the place where a robot that drives at `pace` m/s meets the ball. */
mirocup_point mirocup_meeting_point(const mirocup_setup* setup, const mirocup_observation* now,
                                    const mirocup_robot* robot, double pace); /* 1.2 */
/* Returns the multiple of a right angle that is nearest to a heading, rad. */
double mirocup_squared(double heading);
/* Drives to a point, around an obstacle on the line to it. */
mirocup_wheels mirocup_drive_round(const mirocup_setup* setup, const mirocup_robot* robot,
                                   mirocup_point target, mirocup_point obstacle, double arrival,
                                   double fastest); /* 0, 1.5 */
/* Drives to a point, around the ball or an opponent that is on the line to it. */
mirocup_wheels mirocup_drive_clear(const mirocup_setup* setup, const mirocup_observation* now,
                                   const mirocup_robot* robot, mirocup_point target, double arrival,
                                   double fastest); /* 0, 1.5 */
/* Drives along the goal line to a y, and looks along the line all the time. */
mirocup_wheels mirocup_slide_to(const mirocup_setup* setup, const mirocup_robot* robot, double y,
                                double fastest); /* 1.5 */

/* ---- laws.hpp: targets and commands that keep the laws, and keep the ball out of the own goal. */

/* Returns a target of robot `i`, moved out of the areas that the laws forbid. Not for keepers. */
mirocup_point mirocup_keep_out(const mirocup_setup* setup, int32_t i, mirocup_point p);
/* Returns a place for a waiting robot, moved aside where a ball that the keeper clears would
   rebound. */
mirocup_point mirocup_make_way(const mirocup_setup* setup, const mirocup_observation* now,
                               mirocup_point p);
/* True if the ball has got nowhere for `patience` s and nearly stands. */
int32_t mirocup_is_stuck(const mirocup_observation* now, double patience); /* 0.6 */
/* Returns the wheel speeds, or slower ones where the robot would push an opponent. */
mirocup_wheels mirocup_without_pushing(const mirocup_setup* setup, const mirocup_observation* now,
                                       const mirocup_robot* robot, mirocup_wheels wheels);
/* Returns the wheel speeds, or ones that take robot `i` out of an area that keep_out() forbids. */
mirocup_wheels mirocup_out_of_area(const mirocup_setup* setup, int32_t i,
                                   const mirocup_robot* robot, mirocup_wheels wheels);
/* Changes the command as without_pushing() and out_of_area() do, for all robots but the keeper, 0.
   Python returns a new list. */
void mirocup_keep_laws(const mirocup_setup* setup, const mirocup_observation* now,
                       mirocup_command* command);
/* True if a ball that rolls straight on goes in, or up to `margin` (m) beside the posts. */
int32_t mirocup_rolls_into_own_goal(const mirocup_setup* setup, mirocup_point ball,
                                    mirocup_point velocity, double margin);
/* True if a ball that comes to the robot within `soon_s` would rebound into the own goal. */
int32_t mirocup_would_turn_ball_in(const mirocup_setup* setup, const mirocup_observation* now,
                                   const mirocup_robot* robot, double soon_s); /* 0.4 */
/* Changes the command for robots from which a ball would rebound into the own goal. Python returns
   a new list. */
void mirocup_avoid_own_goals(const mirocup_setup* setup, const mirocup_observation* now,
                             mirocup_command* command);

/* ---- strategy.hpp: roles to start from. */

/* Kicks the ball towards a point: drives behind the ball first, and then through it. */
mirocup_wheels mirocup_kick_to(const mirocup_setup* setup, const mirocup_observation* now,
                               const mirocup_robot* robot, mirocup_point point,
                               double pace); /* 1.5 */
/* True if the ball is still on the spot of your own kick-off. It has to go backwards first. */
int32_t mirocup_must_kick_off(const mirocup_observation* now);
/* Takes a kick-off: drives in front of the ball, on its +x side, and rolls it back. */
mirocup_wheels mirocup_kick_off(const mirocup_setup* setup, const mirocup_robot* robot);
/* Returns the y of the middle of the own goal, as the ball sees it, m. */
double mirocup_middle_of_goal_view(const mirocup_setup* setup, mirocup_point ball);
/* Gets a stuck ball free: drives at it, and spins beside it. */
mirocup_wheels mirocup_free_ball(const mirocup_setup* setup, const mirocup_observation* now,
                                 const mirocup_robot* robot);
/* Keeps the goal: stays in its mouth where the ball meets its face, kicks a slow ball away. */
mirocup_wheels mirocup_keep_goal(const mirocup_setup* setup, const mirocup_observation* now,
                                 const mirocup_robot* robot);

/* ---- skills/drive.hpp: turning and driving in the shortest time. */

/* Returns the direction in which the robot looks, of length 1. */
mirocup_point mirocup_nose_of(const mirocup_robot* robot);
/* Returns the forward speed, m/s; negative if it drives backwards. */
double mirocup_speed_ahead(const mirocup_robot* robot);
/* Returns the greatest forward speed of a robot, m/s. */
double mirocup_greatest_speed(const mirocup_setup* setup);
/* Returns the robot one tick later, if it drives `wheels` until then. */
mirocup_robot mirocup_when_commanded(const mirocup_setup* setup, const mirocup_robot* robot,
                                     mirocup_wheels wheels);
/* Returns the wheel speeds: first for the turn (rad/s), with what is left for the speed (m/s). */
mirocup_wheels mirocup_wheels_turning_first(const mirocup_setup* setup, double forward,
                                            double turn);
/* Returns the turn (rad/s) after which a robot that turns at `turn` ends `error` rad farther. */
double mirocup_turn_for(const mirocup_setup* setup, double turn, double error,
                        double part); /* 0.9 */
/* Turns on the spot to a heading, without overshoot. */
mirocup_wheels mirocup_turn_quickly(const mirocup_setup* setup, const mirocup_robot* robot,
                                    double heading);
/* Drives at up to `speed` m/s in a direction; `distance`: to the stop, m. */
mirocup_wheels mirocup_head_for(const mirocup_setup* setup, const mirocup_robot* robot,
                                double direction, double speed, double distance); /* 1e9 */
/* Drives to a point and stops there, or passes it at `arrival` m/s. */
mirocup_wheels mirocup_drive_quickly(const mirocup_setup* setup, const mirocup_robot* robot,
                                     mirocup_point target, double arrival,
                                     double speed); /* 0, 1.8 */
/* Drives to a point and turns to a heading there, forwards or backwards. */
mirocup_wheels mirocup_take_pose(const mirocup_setup* setup, const mirocup_robot* robot,
                                 mirocup_point target, double heading, double near,
                                 double speed); /* 0.012, 1.8 */

/* ---- skills/ball_path.hpp and intercept.hpp: the path of the ball, and where a robot meets it. */

/* Returns the ball after `seconds`, walls included. */
mirocup_ball mirocup_rolled(const mirocup_setup* setup, mirocup_ball moving, double seconds);
/* Returns when and where the ball comes to the line x from the right, within `most_s`. If it does
   not come, C gets is_ahead = 0, and Python None. */
mirocup_crossing mirocup_time_at_x(const mirocup_setup* setup, mirocup_ball moving, double x,
                                   double most_s); /* 1.5 */
/* Returns where and when a robot that drives at `pace` m/s meets the ball. */
mirocup_interception mirocup_intercept(const mirocup_setup* setup, const mirocup_observation* now,
                                       const mirocup_robot* robot, double pace,
                                       double most_s); /* 1.2, 1.5 */
/* Returns about where it meets the ball, at a fraction of the cost. */
mirocup_point mirocup_rough_meeting(const mirocup_setup* setup, const mirocup_observation* now,
                                    const mirocup_robot* robot, double pace); /* 1.2 */

/* ---- skills/shoot.hpp. */

/* Drives along the line through `point` with direction `heading`, also from beside it. */
mirocup_wheels mirocup_follow_line(const mirocup_setup* setup, const mirocup_robot* robot,
                                   mirocup_point point, double heading, double speed,
                                   double aim_ahead, double gain,
                                   double lead_s); /* {0.2, 10, 0.08} */
/* Drives through a ball so that it goes to `aim`; the robot is behind the ball. */
mirocup_wheels mirocup_shoot(const mirocup_setup* setup, const mirocup_robot* robot,
                             mirocup_point ball, mirocup_point aim, double speed); /* 1.8 */
/* Returns the point on the opponents' goal line to aim at. */
mirocup_point mirocup_open_corner(const mirocup_setup* setup, const mirocup_observation* now,
                                  double margin, double y_bias); /* 0.05, 0 */
/* Returns the pose from which to shoot a resting ball. */
mirocup_pose mirocup_run_up(mirocup_point ball, mirocup_point aim, double distance); /* 0.2 */
/* True while the ball of your own penalty or free kick lies where it was put, `spot`. */
int32_t mirocup_must_take_kick(const mirocup_observation* now, mirocup_point spot);

/* ---- skills/univector_field.hpp: a field of directions that leads to a pose. */

/* Returns the direction at `here` that leads to the pose, rad. */
double mirocup_field_heading(mirocup_point here, mirocup_pose pose, double radius,
                             double smooth); /* {0.075, 0.07} */
/* Returns `heading`, turned aside by an obstacle that moves, `moving`. */
double mirocup_around(double heading, mirocup_point here, mirocup_point velocity,
                      mirocup_ball moving, double nearest, double width,
                      double lead_s); /* {0.085, 0.045, 0.15} */
/* Returns `heading`, turned aside by the other robots, except those at `target`. */
double mirocup_round_others(const mirocup_observation* now, int32_t me, const mirocup_robot* robot,
                            mirocup_point target, double heading, double sight); /* 0.35 */
/* Drives in a direction; `turn`: rad/s that the direction itself turns. */
mirocup_wheels mirocup_follow_heading(const mirocup_setup* setup, const mirocup_robot* robot,
                                      double heading, double speed, double turn); /* 0 */
/* Drives along the field to a pose, round `count` obstacles. */
mirocup_wheels mirocup_follow_field(const mirocup_setup* setup, const mirocup_robot* robot,
                                    mirocup_pose pose, double speed, const mirocup_ball* obstacles,
                                    int32_t count, double radius, double smooth,
                                    double lead_s); /* {0.075, 0.07, 0.08} */

/* ---- skills/attack.hpp. */

/* Returns where a ball at `where` shall go: to the open corner, or along a wall. */
mirocup_point mirocup_shooting_aim(const mirocup_setup* setup, const mirocup_observation* now,
                                   mirocup_point where);
/* Returns the shot of a robot at the ball that will be at `at`. */
mirocup_shot mirocup_shot_of(const mirocup_robot* robot, mirocup_point at, mirocup_point aim);
/* Returns the point to drive to for a robot that is on the line of the shot. */
mirocup_point mirocup_through(mirocup_shot shot);
/* Returns the pose that robot `me` shall have at the ball. */
mirocup_pose mirocup_pose_at_ball(const mirocup_setup* setup, int32_t me, mirocup_shot shot);
/* Shoots the ball that robot `me` meets at `at` to `aim`, round all other robots. */
mirocup_wheels mirocup_attack_ball_at(const mirocup_setup* setup, const mirocup_observation* now,
                                      int32_t me, mirocup_point at, mirocup_point aim, double speed,
                                      double sight, double lead_s); /* {1.8, 1e9, 0.08} */
/* Shoots the ball to `aim` from where robot `me` meets it, and draws both points. */
mirocup_wheels mirocup_attack_ball(const mirocup_setup* setup, const mirocup_observation* now,
                                   int32_t me, mirocup_point aim, double speed, double sight,
                                   double lead_s); /* {1.8, 1e9, 0.08} */
/* Returns the place of a robot that does not attack: between the ball and the own goal. */
mirocup_point mirocup_supporting_place(const mirocup_setup* setup, const mirocup_observation* now,
                                       int32_t me, int32_t rank);

/* ---- skills/keeper.hpp and hold_goal.hpp: two ways of keeping the goal. */

/* Returns the y at which the line through a ball along a direction crosses x, m. */
double mirocup_y_on_line(mirocup_point ball, mirocup_point along, double x);
/* Returns the y at which a resting ball will cross x, as an opponent drives at it; NaN: none does.
   */
double mirocup_y_of_coming_shot(const mirocup_observation* now, double x);
/* Returns the place on the keeper's line from which it covers the goal. */
mirocup_point mirocup_cover_point(const mirocup_setup* setup, const mirocup_observation* now,
                                  double line, double inside_post); /* {0.05, 0} */
/* Guards the goal from a line before it, and clears to the side. */
mirocup_wheels mirocup_guard_goal(const mirocup_setup* setup, const mirocup_observation* now,
                                  const mirocup_robot* robot, double line, double inside_post,
                                  double clear_speed, double spin); /* {0.05, 0, 0.5, 25} */
/* A keeper for predictions: cheaper, and clears nothing. */
mirocup_wheels mirocup_rough_guard(const mirocup_setup* setup, const mirocup_observation* now,
                                   const mirocup_robot* robot);
/* Returns the y in the mouth of the goal at which the keeper has to be, m. */
double mirocup_holding_y(const mirocup_setup* setup, const mirocup_observation* now, double line,
                         double inside_post); /* {0.027, 0.0385} */
/* Keeps the goal from its mouth. `robot` is the keeper at its next command (when_commanded()). */
mirocup_wheels mirocup_hold_goal(const mirocup_setup* setup, const mirocup_observation* now,
                                 const mirocup_robot* robot, double line, double inside_post,
                                 double slow, double patience); /* {0.027, 0.0385, 0.2, 1} */
/* True if a ball slower than `slow` lies in the own goal area. */
int32_t mirocup_lies_in_area(const mirocup_setup* setup, const mirocup_observation* now,
                             double slow);
/* Drives along the goal line to the y of `target` in the shortest time. */
mirocup_wheels mirocup_slide_quickly(const mirocup_setup* setup, const mirocup_robot* robot,
                                     mirocup_point target);
/* Pushes along the goal line, to the side of the sign of y times `outwards` (1 or -1). */
mirocup_wheels mirocup_push_outwards(const mirocup_setup* setup, const mirocup_robot* robot,
                                     double outwards);
/* Drives home to the goal, round the ball. */
mirocup_wheels mirocup_return_to(const mirocup_setup* setup, const mirocup_robot* robot,
                                 mirocup_point target, mirocup_point ball);

/* ---- skills/laws.hpp. */

/* True if the ball is at the robot, on the side of the direction `along`. */
int32_t mirocup_has_ball(const mirocup_setup* setup, const mirocup_observation* now,
                         const mirocup_robot* robot, mirocup_point along);
/* Slows robots down before the opponents' keeper. Python returns a new list. */
void mirocup_spare_keeper(const mirocup_setup* setup, const mirocup_observation* now,
                          mirocup_command* command);
/* True if a robot that does not attack has to leave the opponents' goal area. */
int32_t mirocup_must_leave_area(const mirocup_setup* setup, const mirocup_robot* robot);
/* Drives out of that area. */
mirocup_wheels mirocup_leave_area(const mirocup_setup* setup, const mirocup_robot* robot);

/* ---- skills/roles.hpp. */

/* Returns how soon own robot `i` is behind the ball, s. */
double mirocup_time_behind(const mirocup_setup* setup, const mirocup_observation* now, int32_t i,
                           double round_s); /* 0.35 */
/* Returns the own robot from `first` on with the least cost; `last` costs `bonus` less. costs[i]
   is the cost of own robot i. */
int32_t mirocup_cheapest_robot(const mirocup_observation* now, int32_t first, int32_t last,
                               double bonus, const double* costs);
/* Gives places[k] to robot chosen[k], one of `free`, the most important place first; `last` is
   `chosen` of the last tick, whose robots count as `bonus` m nearer. Each of the four arrays has
   `count` elements. */
void mirocup_assign_places(const mirocup_observation* now, const mirocup_point* places,
                           const int32_t* free, const int32_t* last, int32_t count, double bonus,
                           int32_t* chosen); /* 0.1 */

/* ---- skills/worth.hpp: the worth of a scene. */

/* Returns the worth of a scene: about 1 is a goal, -1 a goal against. */
double mirocup_worth_of(const mirocup_setup* setup, const mirocup_observation* now);
/* Returns about how long a robot takes to get behind the ball, seen from a goal, s. */
double mirocup_time_to_get_behind(const mirocup_robot* robot, mirocup_point ball,
                                  mirocup_point goal);
/* Returns how far from the robots a ball passes that goes in: 0 at one, 1 out of reach of all. */
double mirocup_out_of_reach(const mirocup_robot* robots, int32_t count, mirocup_point ball);

/* ---- skills/draw.hpp. */

/* Writes what a robot does beside it in the replay. */
void mirocup_draw_role(const mirocup_setup* setup, const mirocup_robot* robot, const char* role);
/* Draws where a robot drives. */
void mirocup_draw_target(const mirocup_setup* setup, const mirocup_robot* robot,
                         mirocup_point target);
/* Draws where a robot meets the ball, and where the ball shall go. */
void mirocup_draw_shot(const mirocup_setup* setup, const mirocup_robot* robot, mirocup_point at,
                       mirocup_point aim);

/* ---- skills/filter.hpp: Filter. see() writes its result to `now`. */

typedef struct mirocup_filter mirocup_filter;
mirocup_filter* mirocup_filter_new(const mirocup_setup* setup);
void mirocup_filter_see(mirocup_filter* filter, const mirocup_observation* seen,
                        int32_t ticks_ahead, mirocup_observation* now); /* 1 */
void mirocup_filter_sent(mirocup_filter* filter, const mirocup_command* command);
void mirocup_filter_free(mirocup_filter* filter);

/* ---- skills/penalty.hpp: PenaltyTaker. */

typedef struct mirocup_penalty mirocup_penalty;
mirocup_penalty* mirocup_penalty_new(void);
mirocup_pose mirocup_penalty_stand(mirocup_penalty* taker, const mirocup_setup* setup,
                                   const mirocup_observation* now, double y_bias);
mirocup_wheels mirocup_penalty_drive(mirocup_penalty* taker, const mirocup_setup* setup,
                                     const mirocup_observation* now, const mirocup_robot* robot);
void mirocup_penalty_free(mirocup_penalty* taker);

/* ---- predict.hpp: the simulator of the match. */

typedef struct mirocup_simulator mirocup_simulator;
typedef struct mirocup_scene mirocup_scene;
typedef struct mirocup_tracker mirocup_tracker;

/* The events of a predicted tick. Bit i of a set is robot i. */
typedef struct mirocup_predicted {
  uint32_t own_touched_ball, opponent_touched_ball;
  int32_t last_touch; /* who touched the ball last: i + 1 own i, -i - 1 opponent i, 0 none */
  int32_t events;
} mirocup_predicted;

/* Returns the wheel speeds that are driven: rounded, and clamped to the limit. */
mirocup_wheels mirocup_sent_wheels(const mirocup_setup* setup, mirocup_wheels wheels);
/* Returns a robot, as observed, after `seconds` under these wheel speeds, if it meets nothing. */
mirocup_robot mirocup_robot_after(const mirocup_setup* setup, const mirocup_robot* robot,
                                  mirocup_wheels wheels, double seconds);
/* Returns the wheel speeds that took a robot from one observation to the next. */
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
