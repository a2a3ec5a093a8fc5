// SPDX-License-Identifier: MIT
#include "core/referee/rules.hpp"

namespace mirocup::referee {

Rules make_rules(Preset preset) {
  Rules rules;
  rules.preset = preset;
  switch (preset) {
    case Preset::mirosot:
      break;
    case Preset::simurosot:
      rules.mercy_goal_difference = 0;
      rules.stalemate_radius_m = 0.118;
      rules.keeper_hold_s = off;
      rules.kickoff_backward_required = false;
      rules.kickoff_limit_s = off;
      break;
    case Preset::vsss:
      rules.kickoff_backward_required = false;
      rules.kickoff_limit_s = off;
      break;
  }
  return rules;
}

}  // namespace mirocup::referee
