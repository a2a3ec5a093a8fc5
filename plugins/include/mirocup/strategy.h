/* SPDX-License-Identifier: MIT
 *
 * What a team is: a shared library with one function, mirocup_entry().
 *
 * The host calls create() once, then decide() once in every control period (33 ms of simulated
 * time), at restarts place(), and at the end destroy(). All calls come from one thread, one after
 * the other.
 *
 * Frame
 *   Your own: you always attack +x, whatever end you have, and your goal is at x = -half_length.
 *   The origin is the middle of the field, y points to the left of +x. Metres, m/s, radians
 *   counter-clockwise from +x, rad/s, kg, seconds.
 *
 * Wheels
 *   A robot is a square that two wheels drive. You ask for wheel speeds in rad/s, at most
 *   wheel_speed_limit either way: beyond, they are clamped, and a speed that is not finite counts
 *   as 0; both are counted in the record. They are rounded to 1/256 rad/s. A motor follows with
 *   the time constant motor_time_constant:
 *     forward speed aimed at = wheel_radius * (right + left) / 2
 *     turn rate aimed at     = wheel_radius * (right - left) / wheel_distance
 *   Wheels slide sideways when |turn rate * forward speed| exceeds grip * 9.81 m/s^2.
 *
 * Tick and delay
 *   One tick is control_period (33 ms of simulated time; 1/60 s under SimuroSot rules). What you
 *   answer to the observation of tick t is driven in tick t + 1, for both teams alike.
 *
 * Play
 *   Robot 0 is placed as keeper at restarts, robot 1 as kicker. While play is stopped (state READY)
 *   your commands have no effect, but the answer to the last observation before the whistle is
 *   driven in the first tick of play.
 *
 * Restarts
 *   First everybody is put in default places. A team that has place() may then choose others, in
 *   the tick in which `placing` is 1, before decide(): at a kick-off, a goal kick and a free ball
 *   first the team that takes it (at a free ball: that defends that half), at a penalty kick and a
 *   free kick first the opponents; the other team a tick later, when it sees where the first
 *   stands. Whole bodies count; all inside the walls, clear of the ball, 4 mm from other robots:
 *     kick-off     the taker: own half and centre circle, the ball anywhere in the circle;
 *                  opponents: own half, outside the circle
 *     goal kick    the taker: a robot in its goal area, the ball anywhere in that area, the others
 *                  outside the penalty area (small league: goal area), at most one in the other
 *                  goal area; opponents: own half
 *     penalty kick the taker: one robot behind the ball; opponents: one robot on its goal line,
 *                  between the posts; all others in the taker's half
 *     free kick    the taker: one robot behind the ball, the others in their half; opponents: one
 *                  robot in its goal area, the others on the default places, whoever takes which
 *     free ball    one robot of each team on its default place, all others outside that quarter,
 *                  robot 0 also in its goal area
 *   In a shoot-out robot 1 takes and robot 0 keeps, which may begin anywhere in its goal area. A
 *   robot that may not stand where you want it is moved to its default place or the nearest free
 *   one, and the record says why; nothing worse happens.
 *
 * Time
 *   A match is played as fast as both teams answer; what is counted is your processor time. A leg
 *   has 2 s, 1 ms for each tick and 20 ms for each place(); one tick may take 1 s, a place() 1 s
 *   more, loading and create() 10 s; who sleeps or waits has 10 s in all. Who needs more loses the leg. Thinking between two calls counts, too.
 *   `mirocup check` shows what you use. In matches at the speed of real time, who is late drives on
 *   with the last command for a few ticks, then stands; at a restart its robots stay where they are.
 *
 * Surroundings
 *   Your library plays in a process of its own, shut in: 1 GiB of memory, 8 MiB of stack, one
 *   thread. Files, network, processes and threads answer with errors, or end the leg as a loss.
 *   Put tables that you need into the library. Any language that can make a C library will do.
 *
 * Log
 *   setup->log("text") and what you print to standard output or error end up in the log of the leg;
 *   64 KiB of it are kept.
 *
 * Chance
 *   Take it from `seed`: then a leg can be played again exactly. Clocks, addresses and
 *   std::random_device make a leg that nobody can repeat; `mirocup check` refuses such a library.
 *
 * This header is C11 and C++; it needs nothing else. strategy.hpp is a C++ layer on top of it.
 */
#ifndef MIROCUP_STRATEGY_H
#define MIROCUP_STRATEGY_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A library with another number is refused. It changes whenever libraries that were built before
 * could not play any more; what was added without harm is told by the structures' sizes. */
#define MIROCUP_ABI_VERSION 1u

/* Room in every array of robots; setup.robots and observation.robots say how many there are. */
#define MIROCUP_MAX_ROBOTS 11

enum mirocup_league { MIROCUP_SMALL = 0, MIROCUP_MIDDLE = 1, MIROCUP_LARGE = 2 };

enum mirocup_team { MIROCUP_BLUE = 0, MIROCUP_YELLOW = 1 };

enum mirocup_state {
  MIROCUP_READY = 0, /* placed for a restart; robots stand until the whistle */
  MIROCUP_PLAY = 1,
  MIROCUP_END = 2
};

enum mirocup_phase {
  MIROCUP_FIRST_HALF = 0,
  MIROCUP_SECOND_HALF = 1,
  MIROCUP_EXTRA = 2,    /* knock-out matches that are level */
  MIROCUP_SHOOT_OUT = 3 /* only the kicker (robot 1) and the keeper (robot 0) may move */
};

/* The last restart. Under MiroSot rules the ball of a kick-off must first go to the kicker's own
 * side. */
enum mirocup_restart {
  MIROCUP_NO_RESTART = 0,
  MIROCUP_KICK_OFF = 1,
  MIROCUP_GOAL_KICK = 2,
  MIROCUP_PENALTY_KICK = 3,
  MIROCUP_FREE_BALL = 4,
  MIROCUP_FREE_KICK = 5
};

typedef struct mirocup_robot {
  double x, y;    /* centre, m */
  double heading; /* rad, in (-pi, pi] */
  double vx, vy;  /* m/s */
  double turn;    /* rad/s */
} mirocup_robot;

/* Told once. */
typedef struct mirocup_setup {
  uint32_t size;         /* of this structure, bytes */
  int32_t league;        /* enum mirocup_league */
  int32_t team;          /* enum mirocup_team: your colour in this leg */
  int32_t robots;        /* of each team: 3, 5 or 11 */
  uint64_t seed;         /* for your own random numbers; your opponent's is another */
  double control_period; /* s between two calls of decide() */
  double half_seconds;   /* length of a half */

  /* The field: |x| <= half_length, |y| <= half_width, its corners cut off by triangles with legs
     corner_leg; goals |y| < goal_half_width, goal_depth deep. Your goal is at -half_length. */
  double half_length, half_width, corner_leg, goal_half_width, goal_depth;
  double goal_area_depth, goal_area_half_width;       /* its arc left out */
  double penalty_area_depth, penalty_area_half_width; /* 0: the small league has none */
  double centre_circle_radius;

  double robot_side, robot_mass;
  double wheel_distance, wheel_radius, wheel_speed_limit, motor_time_constant;
  double grip; /* infinite: wheels that never slide */
  double ball_radius, ball_mass;

  /* Writes a line to the log of the leg. Never null. */
  void (*log)(const char* text);
} mirocup_setup;

/* What the referee counts about a team. Robots count with more than half of their body inside, and
   not if they were pushed there. A time is that of the law: 0 while nothing is wrong. */
typedef struct mirocup_counts {
  int32_t defenders;         /* in its own goal area: one may be */
  int32_t area_defenders;    /* in its own penalty area */
  int32_t attackers;         /* in the other goal area: one may be */
  int32_t keeper;            /* its robot that counts as keeper; -1: none is at home */
  int32_t advantage_against; /* 1: it fouled, and is called unless the others score at once */
  int32_t reserved;
  double two_defenders_s, four_defenders_s, two_attackers_s;
  double keeper_hold_s; /* the ball is in its goal area with no opponent near */
} mirocup_counts;

/* What you see of one tick. */
typedef struct mirocup_observation {
  uint32_t size;       /* of this structure, bytes */
  uint32_t tick;       /* counts up from 0 */
  double time;         /* simulated seconds since the match began */
  double clock;        /* of the half; stands while play is stopped */
  int32_t state;       /* enum mirocup_state */
  int32_t phase;       /* enum mirocup_phase */
  int32_t restart;     /* enum mirocup_restart */
  int32_t own_restart; /* 1 if it was given to you */
  int32_t own_score, opponent_score;
  int32_t robots;  /* of each team */
  int32_t placing; /* 1: place() is called for this tick */
  double ball_x, ball_y, ball_vx, ball_vy;
  mirocup_robot own[MIROCUP_MAX_ROBOTS];
  mirocup_robot opponent[MIROCUP_MAX_ROBOTS];
  mirocup_counts own_counts, opponent_counts;
  double stalemate_s; /* for so long the ball has got nowhere */
  double advantage_s; /* for so long a foul has waited for a goal; 0: none does */
} mirocup_observation;

typedef struct mirocup_wheels {
  double left, right; /* rad/s */
} mirocup_wheels;

/* Your answer. It is all zero when decide() is called. */
typedef struct mirocup_command {
  mirocup_wheels wheels[MIROCUP_MAX_ROBOTS];
} mirocup_command;

typedef struct mirocup_pose {
  double x, y;    /* centre, m */
  double heading; /* rad */
} mirocup_pose;

/* Where you want to stand at a restart. It has everything where it is when place() is called: change
 * what you like. The ball is yours to move at your own kick-off and goal kick. */
typedef struct mirocup_placement {
  double ball_x, ball_y;
  mirocup_pose robots[MIROCUP_MAX_ROBOTS]; /* your own */
} mirocup_placement;

typedef struct mirocup_strategy {
  uint32_t abi_version; /* MIROCUP_ABI_VERSION */
  uint32_t size;        /* of this structure, bytes */
  const char* name;     /* of the team, for reports */

  /* Makes whatever you keep between calls. Null is a refusal to play. `setup` stays valid and
   * unchanged. */
  void* (*create)(const mirocup_setup* setup);

  /* One tick. `team` is what create() returned; the pointers are valid during the call only. */
  void (*decide)(void* team, const mirocup_observation* observation, mirocup_command* command);

  /* May be null. Not called if the leg ends by force. */
  void (*destroy)(void* team);

  /* May be null, or left out by libraries that were built before there was one: then your robots
   * stand in the default places. The pointers are valid during the call only. */
  void (*place)(void* team, const mirocup_observation* observation, mirocup_placement* placement);
} mirocup_strategy;

#if defined(__GNUC__)
#define MIROCUP_PUBLIC __attribute__((visibility("default")))
#else
#define MIROCUP_PUBLIC
#endif

/* The one function that your library exports. What it returns lives as long as the library. */
MIROCUP_PUBLIC const mirocup_strategy* mirocup_entry(void);

#ifdef __cplusplus
}
#endif

#endif
