// SPDX-License-Identifier: MIT
//
// Every number of the laws, said once. A preset is a set of them; a league may change single ones,
// and the match record says which were used, so that a disputed call can be judged again with
// others.
//
// Sources: the FIRA MiroSot rule texts for what they state; where they leave a judgement to a
// person ("stalemate", "as judged by the referee"), common practice of automatic referees.
// docs/laws.md says which is which.
#pragma once

#include "core/base/names.hpp"
#include "core/field/league.hpp"

#include <array>
#include <limits>
#include <string_view>

namespace mirocup::referee {

enum class Preset { mirosot, simurosot, vsss };

// Group matches may end level.
enum class Stage { group, knockout };

inline constexpr double off =
    std::numeric_limits<double>::infinity();  // a limit that is never reached

// Seconds, metres, radians, m/s. A count of 0 is off.
struct Rules {
  Preset preset = Preset::mirosot;

  // The course of a match.
  double half_s = 300.0;         // length of a half, effective time
  double half_break_s = 600.0;   // between halves; a simulated match does not wait for it
  double golden_goal_s = 180.0;  // extra time that a goal ends; 0: none
  double extra_halves_s = 0.0;   // where there is no golden goal: each of two extra halves; 0: none
  int shoot_out_rounds = 3;      // attempts of each team before single pairs decide
  int shoot_out_most_rounds = 15;  // then lots are drawn
  double attempt_s = 30.0;         // a penalty attempt of a shoot-out lasts at most
  double attempt_hold_s = 1.0;     // the keeper alone touches the ball for so long: held
  int time_outs = 2;               // of each team
  double time_out_s = 120.0;
  int substitutions = 2;       // of each team while play is on; in the break any number
  double half_late_s = 300.0;  // a team that is not back after the break is waited for
  int mercy_goal_diff = 10;    // a lead of so many ends the match
  int forfeit_goals = 10;      // a forfeit counts as 0 to so many
  double ready_s = 0.33;  // between placement and whistle; robots stand, teams choose and see where

  // What several laws mean by their words.
  double touch_m = 0.004;       // bodies this near touch
  double drive_mps = 0.05;      // who commands this speed towards a robot drives at it
  double contested_m = 0.1125;  // an opponent's centre this near to the ball contests it
  double zone_margin_m =
      0.05;               // small league: so far around the goal area the ball is "in play" there
  double shoved_s = 1.0;  // a robot that was pushed is excused for so long after
  double advantage_s = 0.5;  // a goal may still come before a foul is called

  // Kick-off.
  bool kickoff_backward_required = true;  // the ball goes towards the taker's own side first
  double kickoff_move_m = 0.05;           // when it has moved so far, its side is judged
  double kickoff_limit_s = 5.0;           // until the ball is touched
  bool kickoff_behind = false;            // the kicker stands on its own side of the ball

  // Crowded areas.
  int def_max = 1;            // robots of the defenders in their goal area
  int pa_def_max = 3;         // in their penalty area
  double def_dwell_s = 0.5;   // more than that for so long
  int att_max = 1;            // robots of the attackers in the goal area
  int pa_att_max = 0;         // in the penalty area
  double att_dwell_s = 0.33;  // one too many for so long; two too many: at once

  // The keeper.
  double keeper_hold_s = 10.0;    // the ball stays uncontested in a goal area
  double charge_s = 0.10;         // an attacker drives into the keeper
  double charge_speed_mps = 0.5;  // or hits it so fast
  double push_in_s = 0.5;         // looked back from a goal
  double push_in_m = 0.02;        // the keeper was moved so far towards its line
  double block_s = 1.0;           // an attacker stands in the keeper's way
  double block_gap_m = 0.01;      // this near to it
  double block_ball_m = 0.25;     // with the ball farther from both

  // Play that gets nowhere.
  double stalemate_s = 10.0;          // the ball stays within the radius for so long
  double stalemate_radius_m = 0.075;  // one robot side

  // Pushing and holding.
  double push_dist_m = 0.10;          // an opponent is moved so far
  double push_angle_rad = 0.70;       // within this angle of the line of centres
  double cooldown_s = 2.0;            // the same pair is not called again
  double collision_mps = off;         // a closing speed that could do harm
  double collision_differ_mps = 0.3;  // one of the two is faster by so much
  bool collision_foul = false;        // it is called like a push, not only noted
  double hide_m = 0.0128;             // the ball is inside a robot's outline by so much
  double hide_s = 0.2;
  bool wall_push = false;        // pushing the ball along an end wall is an offence
  double wall_ball_m = 0.08;     // the ball's centre is this near to the end wall
  double wall_robot_m = 0.0669;  // and a robot's centre this near to the ball
  double wall_s = 50.0 / 60.0;   // robots of both teams for so long

  bool hand_penalty = false;  // who reaches onto the field gives a penalty kick away
};

// The rules of a preset. Some depend on the league's size (vsss: 3 or 5 a side).
Rules make_rules(Preset preset, League league = League::small);

}  // namespace mirocup::referee

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 3> enum_names<referee::Preset>{"mirosot", "simurosot",
                                                                             "vsss"};
template <>
inline constexpr std::array<std::string_view, 2> enum_names<referee::Stage>{"group", "knockout"};

}  // namespace mirocup
