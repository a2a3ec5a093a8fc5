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
AT(league, 4);
AT(team, 8);
AT(robots, 12);
AT(seed, 16);
AT(control_period, 24);
AT(half_s, 32);
AT(half_length, 40);
AT(half_width, 48);
AT(corner_leg, 56);
AT(goal_half_width, 64);
AT(goal_depth, 72);
AT(goal_area_depth, 80);
AT(goal_area_half_width, 88);
AT(penalty_area_depth, 96);
AT(penalty_area_half_width, 104);
AT(centre_circle_radius, 112);
AT(robot_side, 120);
AT(robot_mass, 128);
AT(wheel_distance, 136);
AT(wheel_radius, 144);
AT(wheel_speed_limit, 152);
AT(motor_time_constant, 160);
AT(grip, 168);
AT(ball_radius, 176);
AT(ball_mass, 184);
AT(host, 192);
AT(log, 200);
AT(parameter, 208);
AT(draw_line, 216);
AT(draw_circle, 224);
AT(draw_polygon, 232);
AT(draw_text, 240);
AT(turn_time_constant, 248);
AT(brake_time_constant, 256);
AT(rolling_resistance, 264);
AT(viscous_friction, 272);
AT(ball_wall_restitution, 280);
AT(ball_robot_restitution, 288);
AT(robot_wall_restitution, 296);
AT(robot_robot_restitution, 304);
AT(ball_wall_friction, 312);
AT(ball_robot_friction, 320);
AT(robot_wall_friction, 328);
AT(robot_robot_friction, 336);
AT(corners, 344);
AT(reserved_corners, 348);
AT(corner_x, 352);
AT(corner_y, 416);
AT(command_size, 480);
AT(placement_size, 484);
AT(stalemate_limit_s, 488);
AT(advantage_limit_s, 496);
AT(keeper_hold_limit_s, 504);
AT(defenders_limit_s, 512);
AT(attackers_limit_s, 520);
AT(ready_s, 528);
AT(defenders_allowed, 536);
AT(area_defenders_allowed, 540);
AT(attackers_allowed, 544);
AT(reserved_limits, 548);
#undef AT
_Static_assert(sizeof(mirocup_setup) == 552, "its end");

#define AT(member, offset) _Static_assert(offsetof(mirocup_counts, member) == (offset), #member)
AT(defenders, 0);
AT(area_defenders, 4);
AT(attackers, 8);
AT(keeper, 12);
AT(advantage_against, 16);
AT(reserved, 20);
AT(two_defenders_s, 24);
AT(four_defenders_s, 32);
AT(two_attackers_s, 40);
AT(keeper_hold_s, 48);
#undef AT
_Static_assert(sizeof(mirocup_counts) == 56, "its end");

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
AT(own_score, 40);
AT(opponent_score, 44);
AT(robots, 48);
AT(placing, 52);
AT(ball_x, 56);
AT(ball_y, 64);
AT(ball_vx, 72);
AT(ball_vy, 80);
AT(own, 88);
AT(opponent, 616);
AT(own_counts, 1144);
AT(opponent_counts, 1200);
AT(stalemate_s, 1256);
AT(advantage_s, 1264);
AT(own_age_ticks, 1272);
AT(opponent_age_ticks, 1316);
AT(ball_age_ticks, 1360);
AT(reserved_age, 1364);
#undef AT
_Static_assert(sizeof(mirocup_observation) == 1368, "its end");

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
#undef AT
_Static_assert(sizeof(mirocup_team_call) == 48, "its end");

const mirocup_strategy* mirocup_entry(void) {
  return 0;
}
