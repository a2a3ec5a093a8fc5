// SPDX-License-Identifier: MIT
//
// Makes the result of a leg in one line of code, for tests of tables and ratings.
#pragma once

#include "tournaments/table/table.hpp"

namespace mirocup::league {

inline LegResult leg_result(int home, int away, int home_goals, int away_goals) {
  LegResult r;
  r.home = home;
  r.away = away;
  r.home_goals = home_goals;
  r.away_goals = away_goals;
  return r;
}

}  // namespace mirocup::league
