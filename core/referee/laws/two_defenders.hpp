// SPDX-License-Identifier: MIT
//
// Two defenders in their own goal area. Source: MiroSot laws 8.4 and 11.1, a penalty kick. The time
// is counted whatever the ball does; it is called when the ball is there, so that robots cannot
// park. A robot that was pushed in does not count.
#pragma once

#include "core/referee/crowd.hpp"

namespace mirocup::referee {

struct TwoDefendersMemory {
  ByEnd<Dwell> crowded;  // by the end whose goal area it is
};

// Calls it without the advantage, which is the referee's business.
std::optional<Decision> judge_two_defenders(const Pitch& pitch, const Situation& situation,
                                            const Occupancy& occupancy, TwoDefendersMemory& memory);

}  // namespace mirocup::referee
