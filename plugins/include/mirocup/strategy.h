/* SPDX-License-Identifier: MIT
 *
 * The interface of a team: a shared library with one function, mirocup_entry().
 *
 * The host calls create() once, then decide() once in every control period, place() at restarts,
 * and destroy() at the end. All calls come from one thread, one after the other.
 *
 * Frame
 *   Your own frame: you always attack +x, whichever end you defend, and your goal is at x =
 *   -half_length. The origin is the middle of the field; y points to the left of +x. Lengths are in
 *   metres, speeds in m/s, angles in radians counter-clockwise from +x, angular velocities in
 *   rad/s, masses in kg, times in seconds.
 *
 * Wheels
 *   A robot is a square that is driven by two wheels. You ask for wheel speeds in rad/s, at most
 *   wheel_speed_limit in either direction. A greater speed is clamped, a speed that is not finite
 *   becomes 0, and the record counts both cases. Speeds are rounded to 1/256 rad/s. A motor follows
 *   with the time constant motor_time_constant:
 *     forward speed aimed at    = wheel_radius * (right + left) / 2
 *     angular velocity aimed at = wheel_radius * (right - left) / wheel_distance
 *   On some pitches turning has a separate lag, and wheels with the command 0, 0 brake faster: see
 *   turn_time_constant and brake_time_constant. Wheels slide sideways when |angular velocity *
 *   forward speed| exceeds grip * 9.81 m/s^2.
 *
 * Tick and delay
 *   One tick is control_period: 33 ms of simulated time, 1/60 s under SimuroSot rules, 16 ms under
 *   VSSS rules. The answer to the observation of tick t is driven in tick t + 1, for both teams
 *   alike.
 *
 * Play
 *   At restarts robot 0 is placed as the keeper and robot 1 as the kicker. While play is stopped
 *   (state READY) commands have no effect, except that the answer to the last observation before
 *   the whistle is driven in the first tick of play.
 *
 * Restarts
 *   First all robots are put in default places. Then each team with place() may choose other
 *   places, in the tick in which its `placing` is 1; place() is called before decide(). The first
 *   to choose is the taker at a kick-off and a goal kick, the opponents at a penalty kick and a
 *   free kick, and the team that defends the half of the ball at a free ball. The other team
 *   chooses one tick later and sees where the first team stands. Bodies must be completely in the
 *   named areas, inside the walls, clear of the ball and at least 4 mm from other robots:
 *     kick-off     taker: own half and centre circle, the ball anywhere in the circle;
 *                  opponents: own half, outside the circle
 *     goal kick    taker: a robot in its goal area, the ball anywhere in that area, the other
 *                  robots outside the penalty area (small league: goal area), at most one of them
 *                  in the opponents' goal area; opponents: own half
 *     penalty kick taker: one robot behind the ball; opponents: one robot on its goal line, between
 *                  the posts; all other robots in the taker's half
 *     free kick    taker: one robot behind the ball, the others in their half; opponents: one robot
 *                  in its goal area, the others on the default places in any order
 *     free ball    one robot of each team on its default place, all others outside the quarter of
 *                  the ball; robot 0 may also stand in its goal area
 *   In a shoot-out robot 1 takes the kick and robot 0, the keeper, may start anywhere in its goal
 *   area. If a robot may not stand where you want it, the referee moves as few robots as possible,
 *   each to the nearest free place, and the record says why. There is no other penalty. Places are
 *   rounded to 2^-24 m, headings to 2^-24 rad.
 *
 * Time
 *   A match is played as fast as both teams answer. The host counts the processor time of your
 *   process, also between two calls. For a leg you have 2 s, and 1 ms more for each tick and 20 ms
 *   more for each place(). One tick may take 1 s, a tick with place() 2 s, loading and create()
 *   together 10 s. A leg allows 10 s of sleeping and waiting in all. A team that needs more loses
 *   the leg. `mirocup check` shows the time that you use. In a match in real time a team whose
 *   answer is late drives its last command for a few more ticks and then stands; at a restart its
 *   robots stay on their default places.
 *
 * Surroundings
 *   Your library runs in a separate sandboxed process, with 1 GiB of memory, 8 MiB of stack and one
 *   thread. Use of files, network, processes and threads returns errors, or ends the leg as a loss.
 *   Put tables that you need into the library. Any language that can make a C library will do.
 *
 * Log
 *   setup->log(setup->host, "text") and your standard output and error go to the log of the leg,
 *   which keeps 64 KiB.
 *
 * Thoughts
 *   Draw a target, a path or a number in a tick. Only the replay of `mirocup match --thoughts`
 *   shows the drawing, step by step with the play.
 *     setup->draw_line(setup->host, "plan", 0xff8000ff, x1, y1, x2, y2)
 *   Points are in your own frame; a colour is 0xRRGGBBAA; a layer is a name of at most 31 bytes,
 *   which the page switches on and off. A text of the form "name = 1.5" is also shown as a curve. A
 *   tick has room for 200 shapes, 2000 numbers and 4 KiB of text, a leg for 32 MiB; further shapes
 *   are dropped and counted. Drawing has no effect on the leg but the time that it takes you;
 *   without `--thoughts` the calls return at once.
 *
 * Parameters
 *   A number that you want to vary need not be a constant of your code:
 *     setup->parameter(setup->host, "wait", 0.45)
 *   returns 0.45, unless another value comes from `mirocup match --param wait=0.4`, from `check` or
 *   `join` with the same option, or from "parameters" of your team in league.json. A name has
 *   letters, digits, '_', '-' and '.', begins with a letter and has at most 31 bytes. A leg gives a
 *   team at most 32 parameters. The record keeps them, and `mirocup rerun` gives them again.
 *
 * Clocks
 *   The time of day begins at 1 January 2000 in every leg. The time that passes between two
 *   readings of a clock is real, and so is processor time.
 *
 * Random numbers
 *   Derive random numbers from `seed`, so that a leg can be played again exactly. Clocks, addresses
 *   and std::random_device make a leg that cannot be repeated; `mirocup check` refuses a library
 *   that uses them. The check plays a leg twice, the second time with another time of day and with
 *   clocks that run as in real time.
 *
 * Versions
 *   A library with another MIROCUP_ABI_VERSION is refused: build it again with today's strategy.h.
 *   Within a version, structures with a `size` grow at their end, and `size` tells how many bytes
 *   exist: missing members of your mirocup_strategy count as null, and a library that should also
 *   run on older hosts reads no member behind `size`. Structures in arrays never grow, so new facts
 *   of a robot come as separate arrays. Arrays by law have room for further laws: a library that
 *   knows fewer laws than its host does not see the further ones, and to a library that knows more,
 *   a law that its host does not count is off. docs/interfaces.md has the conventions.
 *
 * Building
 *   gcc -std=c17 -O2 -ffp-contract=off -shared -fPIC -Iplugins/include mine.c -lm -o mine.so
 *   With -ffp-contract=off, arithmetic rounds in the same way on every computer.
 *
 * This header is C11 and C++ and needs nothing else. skills.h begins with a whole team in C, and
 * has the skills for C; strategy.hpp is a C++ layer on top.
 */
#ifndef MIROCUP_STRATEGY_H
#define MIROCUP_STRATEGY_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The host refuses a library whose number is not the host's. The number changes only when libraries
 * that were built before can no longer play; additions show in the sizes of the structures. */
#define MIROCUP_ABI_VERSION 1u

/* The length of every array of robots; setup.robots and observation.robots give the used length. */
#define MIROCUP_MAX_ROBOTS 11

/* The length of every array by law; setup.laws and observation.laws give the used length. */
#define MIROCUP_MAX_LAWS 16

/* The most corners of a robot's outline, and of a polygon that a team draws. */
#define MIROCUP_MAX_CORNERS 8
#define MIROCUP_MAX_POLYGON_CORNERS 32

enum mirocup_league { MIROCUP_SMALL = 0, MIROCUP_MIDDLE = 1, MIROCUP_LARGE = 2 };

enum mirocup_colour { MIROCUP_BLUE = 0, MIROCUP_YELLOW = 1 };

enum mirocup_state {
  MIROCUP_READY = 0, /* bodies are placed; robots stand until the whistle */
  MIROCUP_PLAY = 1,
  MIROCUP_OVER = 2
};

enum mirocup_phase {
  MIROCUP_FIRST_HALF = 0,
  MIROCUP_SECOND_HALF = 1,
  MIROCUP_EXTRA_TIME = 2, /* after a level knock-out match */
  MIROCUP_SHOOT_OUT = 3   /* only the kicker (robot 1) and the keeper (robot 0) may move */
};

/* The kinds of restart. Under MiroSot rules the ball of a kick-off must first go to the kicker's
 * own side. */
enum mirocup_restart {
  MIROCUP_NO_RESTART = 0,
  MIROCUP_KICK_OFF = 1,
  MIROCUP_GOAL_KICK = 2,
  MIROCUP_PENALTY_KICK = 3,
  MIROCUP_FREE_BALL = 4,
  MIROCUP_FREE_KICK = 5
};

/* The laws whose counts run for each team: the indexes of the arrays by law. A later header may add
 * laws at the end. */
enum mirocup_law {
  MIROCUP_TWO_DEFENDERS = 0,  /* too many defenders in their own goal area */
  MIROCUP_FOUR_DEFENDERS = 1, /* too many defenders in their own penalty area */
  MIROCUP_TWO_ATTACKERS = 2,  /* too many attackers in the opponents' goal area */
  MIROCUP_KEEPER_HOLD = 3,    /* the ball stays in the own goal area with no opponent near */
  MIROCUP_LAWS = 4            /* their number in this header */
};

typedef struct mirocup_robot {
  double x, y;    /* centre, m */
  double heading; /* rad, in (-pi, pi], a multiple of 2^-50 */
  double vx, vy;  /* m/s */
  double turn;    /* rad/s */
} mirocup_robot;

/* The facts of a leg, which a team receives once, at create(). */
typedef struct mirocup_setup {
  /* The sizes of this structure, and of those that this host passes to decide() and place(), bytes.
     A library that was built with a newer header must write no member behind these sizes. */
  uint32_t size, command_size, placement_size;

  int32_t league;        /* enum mirocup_league */
  int32_t team;          /* enum mirocup_colour: yours in this leg */
  int32_t robots;        /* number of each team: 3, 5 or 11 */
  int32_t corners;       /* used length of corner_x and corner_y; 0: the outline is a square */
  int32_t laws;          /* used length of the arrays by law */
  uint64_t seed;         /* for your own random numbers; your opponent gets another seed */
  double control_period; /* time between two calls of decide(), s */
  double half_s;         /* length of a half, s */
  double ready_s;        /* time from a placement to the whistle, s */

  /* The field, m: |x| <= half_length and |y| <= half_width, without triangles in the corners, whose
     legs are corner_leg long. A goal has |y| < goal_half_width and is goal_depth deep. */
  double half_length, half_width, corner_leg, goal_half_width, goal_depth;
  double goal_area_depth, goal_area_half_width;       /* without the arc, m */
  double penalty_area_depth, penalty_area_half_width; /* m; 0 in the small league */
  double centre_circle_radius;

  double robot_side, robot_mass;
  double wheel_distance, wheel_radius, wheel_speed_limit;
  double grip;                /* infinite: wheels never slide */
  double motor_time_constant; /* lag of the forward speed, s */
  double turn_time_constant;  /* lag of the angular velocity, s */
  double brake_time_constant; /* lag of the forward speed at the command 0, 0, s */
  /* The corners of a robot's outline, counter-clockwise in the robot's frame, m. */
  double corner_x[MIROCUP_MAX_CORNERS], corner_y[MIROCUP_MAX_CORNERS];

  double ball_radius, ball_mass;
  double rolling_resistance; /* the ball slows down by (rolling_resistance * 9.81 +        */
  double viscous_friction;   /* viscous_friction * speed / ball_mass) / 1.4, m/s^2         */

  /* Restitution: speed of separation divided by speed of approach. Friction: Coulomb's. */
  double ball_wall_restitution, ball_robot_restitution;
  double robot_wall_restitution, robot_robot_restitution;
  double ball_wall_friction, ball_robot_friction, robot_wall_friction, robot_robot_friction;

  /* The limits of the laws: the referee applies a law when a time of the observation reaches its
     limit. The limit of a law that is off, or that this host does not count, is infinite. */
  double stalemate_limit_s;                 /* limit of stalemate_s */
  double advantage_limit_s;                 /* limit of advantage_s */
  double time_limit_s[MIROCUP_MAX_LAWS];    /* limits of mirocup_counts.time_s */
  int32_t robots_allowed[MIROCUP_MAX_LAWS]; /* by law, the most robots that break no law */

  /* The handle of the host for this team: the first argument of the functions below. These
     functions are never null. */
  void* host;

  /* Writes a line to the log of the leg. If create() then returns null, the report of the leg gives
     the last such line as the reason. */
  void (*log)(void* host, const char* text);

  /* Returns the value of the parameter `name`, or `fallback` if the leg does not give this
     parameter to this team. See "Parameters". */
  double (*parameter)(void* host, const char* name, double fallback);

  /* Draw a shape into the replay, see "Thoughts". `points` has x, y of each corner of a polygon,
     which has 3 to MIROCUP_MAX_POLYGON_CORNERS corners. */
  void (*draw_line)(void* host, const char* layer, uint32_t colour, double x1, double y1, double x2,
                    double y2);
  void (*draw_circle)(void* host, const char* layer, uint32_t colour, double x, double y,
                      double radius);
  void (*draw_polygon)(void* host, const char* layer, uint32_t colour, const double* points,
                       int32_t corners);
  void (*draw_text)(void* host, const char* layer, uint32_t colour, double x, double y,
                    const char* text);
} mirocup_setup;

/* The referee's counts about a team, by law. A robot counts if more than half of its body is inside
   the area and it was not pushed there. */
typedef struct mirocup_counts {
  double time_s[MIROCUP_MAX_LAWS];  /* how long the team has broken the law, s; else 0 */
  int32_t robots[MIROCUP_MAX_LAWS]; /* robots in the law's area; 0 if the law counts no robots */
  int32_t keeper;                   /* the robot that counts as keeper; -1: none */
  int32_t advantage_against; /* 1: the team fouled; the call waits for a goal of the opponents */
} mirocup_counts;

/* The observation of one tick, in the team's own frame. The age of a body's pose, in ticks, is
   above 0 only under the conditions `camera`: the pictures come late, and now and then lack a body,
   whose last pose is then repeated. */
typedef struct mirocup_observation {
  uint32_t size;       /* of this structure, bytes */
  uint32_t tick;       /* counts up from 0 */
  double time;         /* simulated time since the match began, s */
  double clock;        /* time in the half, s; stops while play is stopped */
  int32_t state;       /* enum mirocup_state */
  int32_t phase;       /* enum mirocup_phase */
  int32_t restart;     /* enum mirocup_restart: the last restart */
  int32_t own_restart; /* 1 if the last restart was awarded to you */
  int32_t placing;     /* 1: place() is called for this tick */
  int32_t own_score, opponent_score;
  int32_t robots; /* number of each team */
  int32_t laws;   /* used length of the arrays by law */
  int32_t ball_age_ticks;
  double ball_x, ball_y, ball_vx, ball_vy;
  mirocup_robot own[MIROCUP_MAX_ROBOTS];
  mirocup_robot opponent[MIROCUP_MAX_ROBOTS];
  int32_t own_age_ticks[MIROCUP_MAX_ROBOTS];
  int32_t opponent_age_ticks[MIROCUP_MAX_ROBOTS];
  double stalemate_s; /* how long the ball has made no progress */
  double advantage_s; /* how long a foul has waited for a goal; 0: no foul waits */
  mirocup_counts own_counts, opponent_counts;
} mirocup_observation;

typedef struct mirocup_wheels {
  double left, right; /* rad/s */
} mirocup_wheels;

/* The answer of a team. All speeds are 0 when decide() is called. */
typedef struct mirocup_command {
  mirocup_wheels wheels[MIROCUP_MAX_ROBOTS];
} mirocup_command;

typedef struct mirocup_pose {
  double x, y;    /* centre, m */
  double heading; /* rad */
} mirocup_pose;

/* The places that a team requests at a restart. When place() is called, this structure holds
 * the present places: change the places that you like. You may move the ball at your own kick-off
 * and goal kick. */
typedef struct mirocup_placement {
  double ball_x, ball_y;
  mirocup_pose robots[MIROCUP_MAX_ROBOTS]; /* your own */
} mirocup_placement;

typedef struct mirocup_strategy {
  uint32_t abi_version; /* MIROCUP_ABI_VERSION */
  uint32_t size;        /* of this structure, bytes */
  const char* name;     /* name of the team in reports */

  /* Returns a pointer to the data that you keep between calls, or null if you refuse to play.
   * `setup` stays valid and unchanged until destroy(). */
  void* (*create)(const mirocup_setup* setup);

  /* Answers one tick. `team` is the result of create(); the other pointers are valid only during
   * the call. */
  void (*decide)(void* team, const mirocup_observation* observation, mirocup_command* command);

  /* Ends the team. May be null. A host that ends the process by force does not call destroy(). */
  void (*destroy)(void* team);

  /* Chooses the places at a restart. If null, your robots stand in the default places. The
   * pointers are valid only during the call. */
  void (*place)(void* team, const mirocup_observation* observation, mirocup_placement* placement);
} mirocup_strategy;

#if defined(__GNUC__)
#define MIROCUP_PUBLIC __attribute__((visibility("default")))
#else
#define MIROCUP_PUBLIC
#endif

/* The one function that your library exports. Its result must live as long as the library. */
MIROCUP_PUBLIC const mirocup_strategy* mirocup_entry(void);

#ifdef __cplusplus
}
#endif

#endif
