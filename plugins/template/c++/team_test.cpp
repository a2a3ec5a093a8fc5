// Calls the team as a match would. Exit code 0: every expectation holds.
#include "mirocup/strategy.hpp"

#include <cmath>
#include <cstdio>

namespace {

int failures = 0;

void expect(bool holds, const char* what) {
  if (holds) return;
  std::printf("failed: %s\n", what);
  ++failures;
}

// Returns a setup with about the numbers of the small league.
mirocup_setup setup() {
  mirocup_setup s{};
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
  s.log = [](void*, const char* text) { std::puts(text); };
  return s;
}

mirocup_observation kick_off() {
  mirocup_observation now{};
  now.size = sizeof now;
  now.robots = 3;
  now.state = MIROCUP_PLAY;
  for (int i = 0; i < now.robots; ++i) {
    now.own[i].x = -0.7 + 0.3 * i;
    now.opponent[i].x = 0.7 - 0.2 * i;
  }
  return now;
}

}  // namespace

int main() {
  const mirocup_strategy* strategy = mirocup_entry();
  const mirocup_setup s = setup();
  void* team = strategy->create(&s);
  expect(team != nullptr, "the team is created");

  mirocup_observation now = kick_off();
  for (now.tick = 0; now.tick < 100; ++now.tick) {
    now.ball_x = 0.005 * now.tick;
    mirocup_command command{};
    strategy->decide(team, &now, &command);
    for (int i = 0; i < now.robots; ++i) {
      expect(std::isfinite(command.wheels[i].left) && std::isfinite(command.wheels[i].right),
             "wheel speeds are numbers");
    }
  }
  if (strategy->destroy != nullptr) strategy->destroy(team);
  return failures == 0 ? 0 : 1;
}
