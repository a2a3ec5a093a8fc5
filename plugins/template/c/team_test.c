/* Calls the team as a match would. Exit code 0: every expectation holds. */
#include "mirocup/strategy.h"

#include <math.h>
#include <stdio.h>

static int failures = 0;

static void expect(int holds, const char* what) {
  if (holds) return;
  printf("failed: %s\n", what);
  ++failures;
}

static void print_line(void* host, const char* text) {
  (void)host;
  puts(text);
}

static double default_of(void* host, const char* name, double fallback) {
  (void)host;
  (void)name;
  return fallback;
}

/* Returns a setup with about the numbers of the small league. */
static mirocup_setup small_league(void) {
  mirocup_setup s = {0};
  s.size = sizeof s;
  s.robots = 3;
  s.seed = 1;
  s.control_period = 0.033;
  s.half_length = 0.75;
  s.half_width = 0.65;
  s.goal_half_width = 0.2;
  s.goal_depth = 0.1;
  s.goal_area_depth = 0.15;
  s.robot_side = 0.075;
  s.wheel_distance = 0.07;
  s.wheel_radius = 0.025;
  s.wheel_speed_limit = 60.0;
  s.grip = 1.0;
  s.motor_time_constant = 0.06;
  s.ball_radius = 0.02135;
  s.ball_mass = 0.046;
  s.rolling_resistance = 0.01;
  s.ball_wall_restitution = 0.8;
  s.log = print_line;
  s.parameter = default_of;
  return s;
}

int main(void) {
  const mirocup_strategy* strategy = mirocup_entry();
  const mirocup_setup setup = small_league();
  void* team = strategy->create(&setup);
  mirocup_observation now = {0};
  int i;
  expect(team != NULL, "the team is created");
  now.size = sizeof now;
  now.robots = 3;
  now.state = MIROCUP_PLAY;
  for (i = 0; i < now.robots; ++i) {
    now.own[i].x = -0.7 + 0.3 * i;
    now.opponent[i].x = 0.7 - 0.2 * i;
  }
  for (now.tick = 0; now.tick < 100; ++now.tick) {
    mirocup_command command = {0};
    now.ball_x = 0.005 * now.tick;
    strategy->decide(team, &now, &command);
    for (i = 0; i < now.robots; ++i) {
      expect(isfinite(command.wheels[i].left) && isfinite(command.wheels[i].right),
             "wheel speeds are numbers");
    }
  }
  strategy->destroy(team);
  return failures == 0 ? 0 : 1;
}
