// SPDX-License-Identifier: MIT
//
// skills.h: predict.hpp, as C calls it.
#include "mirocup/predict.hpp"
#include "plugins/predict/c_calls.hpp"

#include <new>

namespace {

using Cpp = SameInCpp;

struct C : SameInC {
  using SameInC::of;
  static const mirocup_command* of(const mirocup_command& command) { return &command; }
  static mirocup_predicted of(const strategy::PredictedTick& t) {
    return {t.own_touched_ball, t.opponent_touched_ball, t.last_touch, t.events};
  }
};

template <class T>
T* made(const auto&... arguments) {
  return new (std::nothrow) T(arguments...);
}
void destroy(auto* object) {
  delete object;
}

}  // namespace

struct mirocup_tracker : strategy::Tracker {
  using Tracker::Tracker;
};
struct mirocup_scene : strategy::Scene {
  explicit mirocup_scene(const mirocup_observation& now) : Scene(strategy::scene_of(now)) {}
  void show(mirocup_observation& now) const { strategy::show(*this, now); }
  void show_to_opponents(mirocup_observation& now) const {
    strategy::show_to_opponents(*this, now);
  }
};
struct mirocup_simulator : strategy::Simulator {
  mirocup_simulator(const mirocup_setup& setup, bool is_coarse)
      : Simulator(setup, is_coarse ? strategy::Precision::coarse : strategy::Precision::match) {}
};

extern "C" {

// SKILLS

mirocup_robot mirocup_robot_after(const mirocup_setup* setup, const mirocup_robot* robot,
                                  mirocup_wheels wheels, double seconds) {
  const strategy::Body body = strategy::body_of(*robot);
  return strategy::robot_of(strategy::robot_after(*setup, body, wheels, seconds));
}

}  // extern "C"
