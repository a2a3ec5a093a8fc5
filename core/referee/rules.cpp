// SPDX-License-Identifier: MIT
#include "core/referee/rules.hpp"

namespace mirocup::referee {

namespace {

// The referee of the SimuroSot platform of 2018, which counts ticks of 1/60 s.
void change_to_simurosot(Rules& rules) {
  constexpr double tick = 1.0 / 60.0;
  rules.shoot_out_rounds = 5;
  rules.attempt_s = 3.0;
  rules.mercy_goal_diff = 0;
  rules.zone_depth_m = 0.80;
  rules.zone_half_width_m = 0.60;
  rules.shoved_s = 0.0;
  rules.stalemate_s = 100.0 * tick;
  rules.stalemate_speed_mps = 0.005 / tick;
  rules.keeper_hold_s = off;
  rules.def_dwell_s = 20.0 * tick;
  rules.def_at_once = true;
  rules.advantage_s = 0.0;
  rules.att_max = 0;
  rules.charge_s = 0.0;
  rules.charge_speed_mps = 0.0;
  rules.push_in_m = off;
  rules.block_s = off;
  rules.push_dist_m = off;
  rules.hide_s = off;
  rules.wall_push = true;
  rules.kickoff_backward_required = false;
  rules.kickoff_limit_s = off;
}

// The calls of VSSReferee. It stops for 4 s before the bodies are placed and for 4 s after that.
void change_to_vsss(Rules& rules, RobotLeague league) {
  rules.golden_goal_s = 0.0;
  rules.extra_halves_s = 180.0;
  rules.shoot_out_rounds = 5;
  rules.ready_s = 8.0;
  rules.shoved_s = 0.0;
  rules.stalemate_s = 5.0;
  rules.stalemate_speed_mps = 0.1;
  rules.stalemate_penalty = true;
  rules.keeper_hold_s = off;
  rules.def_dwell_s = 3.0;
  rules.att_dwell_s = 3.0;
  rules.att_at_once = false;
  rules.att_cancels_goal = true;
  rules.charge_s = off;
  rules.charge_speed_mps = off;
  rules.push_in_m = off;
  rules.block_s = off;
  rules.push_dist_m = off;
  rules.hide_s = off;
  rules.kickoff_backward_required = false;
  rules.kickoff_limit_s = off;
  rules.kickoff_behind = true;
  rules.pa_def_max = 0;
  if (league == RobotLeague::small) return;
  rules.half_break_s = 240.0;
  rules.pa_def_max = 4;
  rules.pa_att_max = 3;
}

}  // namespace

Rules make_rules(Preset preset, RobotLeague league) {
  Rules rules;
  rules.preset = preset;
  if (preset == Preset::simurosot) change_to_simurosot(rules);
  if (preset == Preset::vsss) change_to_vsss(rules, league);
  return rules;
}

}  // namespace mirocup::referee
