/* SPDX-License-Identifier: MIT
 *
 * strategy.h and team.h compile in C, and their layout is that of the libraries that teams have: a
 * member that moves makes them play on garbage. Add new members at the end of a structure, and of
 * its list.
 */
#include "mirocup/strategy.h"
#include "mirocup/team.h"

#include <stddef.h>

#define AT(member, offset) _Static_assert(offsetof(mirocup_robot, member) == (offset), #member)
AT(x, 0);
AT(y, 8);
AT(heading, 16);
AT(vx, 24);
AT(vy, 32);
AT(turn, 40);
#undef AT
_Static_assert(sizeof(mirocup_robot) == 48, "its end");

#define AT(member, offset) _Static_assert(offsetof(mirocup_setup, member) == (offset), #member)
AT(size, 0);
AT(command_size, 4);
AT(placement_size, 8);
AT(league, 12);
AT(team, 16);
AT(robots, 20);
AT(corners, 24);
AT(laws, 28);
AT(seed, 32);
AT(control_period, 40);
AT(half_s, 48);
AT(ready_s, 56);
AT(half_length, 64);
AT(half_width, 72);
AT(corner_leg, 80);
AT(goal_half_width, 88);
AT(goal_depth, 96);
AT(goal_area_depth, 104);
AT(goal_area_half_width, 112);
AT(penalty_area_depth, 120);
AT(penalty_area_half_width, 128);
AT(centre_circle_radius, 136);
AT(robot_side, 144);
AT(robot_mass, 152);
AT(wheel_distance, 160);
AT(wheel_radius, 168);
AT(wheel_speed_limit, 176);
AT(grip, 184);
AT(motor_time_constant, 192);
AT(turn_time_constant, 200);
AT(brake_time_constant, 208);
AT(corner_x, 216);
AT(corner_y, 280);
AT(ball_radius, 344);
AT(ball_mass, 352);
AT(rolling_resistance, 360);
AT(viscous_friction, 368);
AT(ball_wall_restitution, 376);
AT(ball_robot_restitution, 384);
AT(robot_wall_restitution, 392);
AT(robot_robot_restitution, 400);
AT(ball_wall_friction, 408);
AT(ball_robot_friction, 416);
AT(robot_wall_friction, 424);
AT(robot_robot_friction, 432);
AT(stalemate_limit_s, 440);
AT(advantage_limit_s, 448);
AT(time_limit_s, 456);
AT(robots_allowed, 584);
AT(host, 648);
AT(log, 656);
AT(parameter, 664);
AT(draw_line, 672);
AT(draw_circle, 680);
AT(draw_polygon, 688);
AT(draw_text, 696);
#undef AT
_Static_assert(sizeof(mirocup_setup) == 704, "its end");

#define AT(member, offset) _Static_assert(offsetof(mirocup_counts, member) == (offset), #member)
AT(time_s, 0);
AT(robots, 128);
AT(keeper, 192);
AT(advantage_against, 196);
#undef AT
_Static_assert(sizeof(mirocup_counts) == 200, "its end");

#define AT(member, offset) \
  _Static_assert(offsetof(mirocup_observation, member) == (offset), #member)
AT(size, 0);
AT(tick, 4);
AT(time, 8);
AT(clock, 16);
AT(state, 24);
AT(phase, 28);
AT(restart, 32);
AT(own_restart, 36);
AT(placing, 40);
AT(own_score, 44);
AT(opponent_score, 48);
AT(robots, 52);
AT(laws, 56);
AT(ball_age_ticks, 60);
AT(ball_x, 64);
AT(ball_y, 72);
AT(ball_vx, 80);
AT(ball_vy, 88);
AT(own, 96);
AT(opponent, 624);
AT(own_age_ticks, 1152);
AT(opponent_age_ticks, 1196);
AT(stalemate_s, 1240);
AT(advantage_s, 1248);
AT(own_counts, 1256);
AT(opponent_counts, 1456);
#undef AT
_Static_assert(sizeof(mirocup_observation) == 1656, "its end");

/* The indexes of the arrays by law: a law keeps its number, and a further one gets the next. */
_Static_assert(MIROCUP_TWO_DEFENDERS == 0 && MIROCUP_FOUR_DEFENDERS == 1, "laws");
_Static_assert(MIROCUP_TWO_ATTACKERS == 2 && MIROCUP_KEEPER_HOLD == 3, "laws");
_Static_assert(MIROCUP_LAWS <= MIROCUP_MAX_LAWS, "laws");

#define AT(member, offset) _Static_assert(offsetof(mirocup_wheels, member) == (offset), #member)
AT(left, 0);
AT(right, 8);
#undef AT
_Static_assert(sizeof(mirocup_wheels) == 16, "its end");

#define AT(member, offset) _Static_assert(offsetof(mirocup_command, member) == (offset), #member)
AT(wheels, 0);
#undef AT
_Static_assert(sizeof(mirocup_command) == 176, "its end");

#define AT(member, offset) _Static_assert(offsetof(mirocup_pose, member) == (offset), #member)
AT(x, 0);
AT(y, 8);
AT(heading, 16);
#undef AT
_Static_assert(sizeof(mirocup_pose) == 24, "its end");

#define AT(member, offset) _Static_assert(offsetof(mirocup_placement, member) == (offset), #member)
AT(ball_x, 0);
AT(ball_y, 8);
AT(robots, 16);
#undef AT
_Static_assert(sizeof(mirocup_placement) == 280, "its end");

#define AT(member, offset) _Static_assert(offsetof(mirocup_strategy, member) == (offset), #member)
AT(abi_version, 0);
AT(size, 4);
AT(name, 8);
AT(create, 16);
AT(decide, 24);
AT(destroy, 32);
AT(place, 40);
#undef AT
_Static_assert(sizeof(mirocup_strategy) == 48, "its end");

#define AT(member, offset) _Static_assert(offsetof(mirocup_team_call, member) == (offset), #member)
AT(size, 0);
AT(team, 4);
AT(server, 8);
AT(match, 16);
AT(name, 24);
AT(credentials, 32);
AT(domain, 40);
AT(interface, 48);
#undef AT
_Static_assert(sizeof(mirocup_team_call) == 56, "its end");

const mirocup_strategy* mirocup_entry(void) {
  return 0;
}
