// SPDX-License-Identifier: MIT
//
// Every number of the laws, in one place. A preset is a set of values; a league may change single
// values, and the match record holds those that were used, so that a disputed call can be judged
// again with others.
//
// Sources: the FIRA MiroSot rule texts for what they state; where they leave a judgement to a
// person ("stalemate", "as judged by the referee"), common practice of automatic referees.
// docs/laws.md says from which of the two a number comes.
#pragma once

#include "core/base/names.hpp"
#include "core/field/league.hpp"

#include <array>
#include <limits>
#include <string_view>

namespace mirocup::referee {

enum class Preset { mirosot, simurosot, vsss };

// A group match may end level, a knock-out match may not.
enum class Stage { group, knockout };

// A limit that is never reached.
inline constexpr double off = std::numeric_limits<double>::infinity();

// Seconds, metres, radians, m/s. A limit of `off` is never reached; a count of 0 switches its law
// off. The names are the keys in records and league files.
struct Rules {
  Preset preset = Preset::mirosot;

  // The course of a match.
  double half_s = 300.0;           // length of a half, effective time
  double half_break_s = 600.0;     // break between the halves; a simulated match does not wait
  double golden_goal_s = 180.0;    // longest extra time, which a goal ends; 0: none
  double extra_halves_s = 0.0;     // each of two extra halves if golden_goal_s is 0; 0: none
  int shoot_out_rounds = 3;        // attempts of each team before single pairs of attempts decide
  int shoot_out_most_rounds = 15;  // attempts of each team after which lots are drawn
  double attempt_s = 30.0;         // length of a penalty attempt
  double attempt_hold_s = 1.0;     // a keeper that alone touches the ball this long holds it
  int time_outs = 2;               // of each team
  double time_out_s = 120.0;       // length of a time-out
  int substitutions = 2;           // of each team while play is on; in the break any number
  double half_late_s = 300.0;      // how long a match waits for a team that is late after the break
  int mercy_goal_diff = 10;        // a lead of this many goals ends the match
  int forfeit_goals = 10;          // a forfeit counts as 0 to this many goals
  double ready_s = 0.33;           // from placement to whistle: robots stand, teams place and see

  // Definitions of words that several laws use.
  double touch_m = 0.004;       // bodies this near touch
  double drive_mps = 0.05;      // commanding this speed towards a robot is driving at it
  double contested_m = 0.1125;  // an opponent's centre this near to the ball contests it
  double zone_margin_m = 0.05;  // small league: a goal's zone reaches this far beyond its goal area
  // The zone of a goal where crowds and charges count: the ball is at most zone_depth_m from the
  // goal line and zone_half_width_m from the long axis. If the depth is 0, charges count in the
  // whole half, and the zone of crowds is the penalty area or, in the small league, the goal area
  // and zone_margin_m around it.
  double zone_depth_m = 0.0;
  double zone_half_width_m = off;
  double shoved_s = 1.0;     // how long a robot is excused after it was pushed
  double advantage_s = 0.5;  // how long a foul of the defenders waits for a goal

  // Kick-off.
  bool kickoff_backward_required = true;  // the ball must go towards the taker's own side first
  double kickoff_move_m = 0.05;           // the side is judged when the ball has moved this far
  double kickoff_limit_s = 5.0;           // the ball must be touched within this time
  bool kickoff_behind = false;            // the kicker must stand on its own side of the ball

  // Crowded areas.
  int def_max = 1;                // robots of the defenders allowed in their goal area
  int pa_def_max = 3;             // robots of the defenders allowed in their penalty area
  double def_dwell_s = 0.5;       // how long more defenders than allowed are forgiven
  bool def_at_once = false;       // two robots too many are not forgiven at all
  int att_max = 1;                // robots of the attackers allowed in the defenders' goal area
  int pa_att_max = 0;             // robots of the attackers allowed in the defenders' penalty area
  double att_dwell_s = 0.33;      // how long more attackers than allowed are forgiven
  bool att_at_once = true;        // two too many in the goal area are not forgiven at all
  bool att_cancels_goal = false;  // too many in the goal area, however briefly, cancel a goal

  // The keeper.
  double keeper_hold_s = 10.0;    // the ball stays uncontested in a goal area for this time
  double charge_s = 0.10;         // an attacker drives into the keeper for this time
  double charge_speed_mps = 0.5;  // or an attacker hits the keeper at this speed
  double push_in_s = 0.5;         // time before a goal in which a push counts
  double push_in_m = 0.02;        // a push moves the keeper this far towards its goal line
  double block_s = 1.0;           // an attacker stands in the keeper's way for this time
  double block_gap_m = 0.01;      // the attacker is this near to the keeper
  double block_ball_m = 0.25;     // the ball is farther than this from attacker and keeper

  // Play that gets nowhere.
  double stalemate_s = 10.0;          // the ball stays within stalemate_radius_m for this time
  double stalemate_radius_m = 0.075;  // one robot side
  // If above 0, the ball gets nowhere while it is not faster than this, whatever the radius.
  double stalemate_speed_mps = 0.0;
  // The restart of a stalemate in a goal area. True: a free ball if both teams have a robot within
  // contested_m of the ball, otherwise a penalty kick. False: a goal kick.
  bool stalemate_penalty = false;

  // Pushing and holding.
  double push_dist_m = 0.10;     // the pusher moves an opponent this far
  double push_angle_rad = 0.70;  // largest angle of the push to the line of the robots' centres
  double cooldown_s = 2.0;       // the same pair is not called again for this time
  double collision_mps = off;    // a speed of approach that could do harm
  double collision_differ_mps = 0.3;  // in a harmful collision, one robot is faster by this much
  bool collision_foul = false;        // such a collision is called like a push, not only noted
  double hide_m = 0.0128;             // a ball this deep inside a robot's outline is hidden
  double hide_s = 0.2;                // the ball is hidden for this time
  bool wall_push = false;             // pushing the ball along an end wall is an offence
  double wall_ball_m = 0.08;          // the ball's centre is this near to the end wall
  double wall_robot_m = 0.0669;       // a robot's centre is this near to the ball's centre
  double wall_s = 50.0 / 60.0;  // robots of both teams press the ball to the wall for this time

  bool hand_penalty = false;  // a hand on the field costs its team a penalty kick
};

// Returns the rules of a preset. Some depend on the league (vsss: 3 or 5 a side).
Rules make_rules(Preset preset, RobotLeague league = RobotLeague::small);

}  // namespace mirocup::referee

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 3> enum_names<referee::Preset>{"mirosot", "simurosot",
                                                                             "vsss"};
template <>
inline constexpr std::array<std::string_view, 2> enum_names<referee::Stage>{"group", "knockout"};

}  // namespace mirocup
