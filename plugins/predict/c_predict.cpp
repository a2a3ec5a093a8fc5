// SPDX-License-Identifier: MIT
//
// skills.h: predict.hpp, as C calls it.
#ifdef MIROCUP_EXPORTED_SKILLS
#pragma GCC visibility push(default)
#endif
#include "mirocup/skills.h"
#ifdef MIROCUP_EXPORTED_SKILLS
#pragma GCC visibility pop
#endif

#include "mirocup/predict.hpp"

#include <new>

namespace strategy = mirocup::strategy;

struct mirocup_simulator {
  strategy::Simulator simulator;
};
struct mirocup_scene {
  strategy::Scene scene;
};
struct mirocup_tracker {
  strategy::Tracker tracker;
};

extern "C" {

mirocup_wheels mirocup_sent_wheels(const mirocup_setup* setup, mirocup_wheels wheels) {
  return strategy::sent_wheels(*setup, wheels);
}
mirocup_robot mirocup_robot_after(const mirocup_setup* setup, const mirocup_robot* robot,
                                  mirocup_wheels wheels, double seconds) {
  const strategy::Body after =
      strategy::robot_after(*setup, strategy::body_of(*robot), wheels, seconds);
  return strategy::robot_of(after);
}
mirocup_wheels mirocup_driven_wheels(const mirocup_setup* setup, const mirocup_robot* before,
                                     const mirocup_robot* after) {
  return strategy::driven_wheels(*setup, *before, *after);
}

mirocup_tracker* mirocup_tracker_new(const mirocup_setup* setup) {
  return new (std::nothrow) mirocup_tracker{strategy::Tracker(*setup)};
}
void mirocup_tracker_saw(mirocup_tracker* tracker, const mirocup_observation* now) {
  tracker->tracker.saw(*now);
}
void mirocup_tracker_sent(mirocup_tracker* tracker, const mirocup_command* command) {
  tracker->tracker.sent(*command);
}
const mirocup_command* mirocup_tracker_in_flight(const mirocup_tracker* tracker) {
  return &tracker->tracker.in_flight();
}
const mirocup_command* mirocup_tracker_opponents(const mirocup_tracker* tracker) {
  return &tracker->tracker.opponents();
}
void mirocup_tracker_free(mirocup_tracker* tracker) {
  delete tracker;
}

mirocup_scene* mirocup_scene_new(const mirocup_observation* now) {
  return new (std::nothrow) mirocup_scene{strategy::scene_of(*now)};
}
mirocup_scene* mirocup_scene_copy_new(const mirocup_scene* scene) {
  return new (std::nothrow) mirocup_scene(*scene);
}
void mirocup_scene_show(const mirocup_scene* scene, mirocup_observation* now) {
  strategy::show(scene->scene, *now);
}
void mirocup_scene_show_to_opponents(const mirocup_scene* scene, mirocup_observation* now) {
  strategy::show_to_opponents(scene->scene, *now);
}
void mirocup_scene_free(mirocup_scene* scene) {
  delete scene;
}

mirocup_simulator* mirocup_simulator_new(const mirocup_setup* setup, int32_t is_coarse) {
  return new (std::nothrow) mirocup_simulator{strategy::Simulator(
      *setup, is_coarse != 0 ? strategy::Precision::coarse : strategy::Precision::match)};
}
mirocup_predicted mirocup_simulator_advance(mirocup_simulator* simulator, mirocup_scene* scene,
                                            const mirocup_command* own,
                                            const mirocup_command* opponent, int32_t ticks) {
  const strategy::PredictedTick tick =
      simulator->simulator.advance(scene->scene, *own, *opponent, ticks);
  return {tick.own_touched_ball, tick.opponent_touched_ball, tick.last_touch, tick.events};
}
void mirocup_simulator_free(mirocup_simulator* simulator) {
  delete simulator;
}

}  // extern "C"
