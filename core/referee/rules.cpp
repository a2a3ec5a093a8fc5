// SPDX-License-Identifier: MIT
#include "core/referee/rules.hpp"

namespace mirocup::referee {

namespace {

// Simulated leagues judge at once what a person would watch for a moment first.
void change_to_simurosot(Rules& rules) {
  rules.shoot_out_rounds = 5;
  rules.attempt_s = 3.0;
  rules.mercy_goal_diff = 0;
  rules.stalemate_radius_m = 0.118;
  rules.keeper_hold_s = off;
  rules.def_dwell_s = 0.0;
  rules.advantage_s = 0.0;
  rules.att_dwell_s = 0.0;
  rules.pa_att_max = 3;
  rules.charge_s = 0.0;
  rules.charge_speed_mps = 0.0;
  rules.block_s = off;
  rules.push_dist_m = off;
  rules.kickoff_backward_required = false;
  rules.kickoff_limit_s = off;
}

void change_to_vsss(Rules& rules, League league) {
  rules.golden_goal_s = 0.0;
  rules.extra_halves_s = 180.0;
  rules.shoot_out_rounds = 5;
  rules.charge_s = off;
  rules.charge_speed_mps = off;
  rules.block_s = off;
  rules.push_dist_m = off;
  rules.kickoff_backward_required = false;
  rules.kickoff_limit_s = off;
  rules.kickoff_behind = true;
  rules.pa_def_max = 0;
  if (league == League::small) return;
  rules.half_break_s = 240.0;
  rules.stalemate_s = 5.0;
  rules.pa_def_max = 4;
  rules.pa_att_max = 3;
}

}  // namespace

Rules make_rules(Preset preset, League league) {
  Rules rules;
  rules.preset = preset;
  switch (preset) {
    case Preset::mirosot:
      break;
    case Preset::simurosot:
      change_to_simurosot(rules);
      break;
    case Preset::vsss:
      change_to_vsss(rules, league);
      break;
  }
  return rules;
}

}  // namespace mirocup::referee
