/* SPDX-License-Identifier: MIT
 *
 * Everybody in one place, nowhere, in the walls; the ball in the other goal.
 */
#define HOSTILE_PLACE place
#include "tests/security/hostile/hostile.h"

BEHAVES_LATER

static void place(void* team, const mirocup_observation* now, mirocup_placement* placement) {
  volatile double zero = 0.0;
  (void)team, (void)now;
  for (int i = 0; i < MIROCUP_MAX_ROBOTS; ++i) {
    placement->robots[i].x = i == 0 ? zero / zero : i == 1 ? -1e308 : -0.5;
    placement->robots[i].y = i == 1 ? 1.0 / zero : 0.1;
    placement->robots[i].heading = i == 2 ? 1e300 : 1.0;
  }
  placement->ball_x = 5.0;
  placement->ball_y = zero / zero;
}
