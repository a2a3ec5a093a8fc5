// SPDX-License-Identifier: MIT
//
// What the simulator is held to, scene by scene: each function plays one kind of scene and measures
// it against closed forms or the integrators in tests/support. `physics_bars` prints all of them in
// full size; the tests run them small.
#pragma once

#include <string>
#include <vector>

namespace mirocup::scenes {

struct Bar {
  std::string scene;
  std::string measure;
  double measured = 0.0;
  double limit = 0.0;      // of `measured`, in the measure's unit
  bool is_timing = false;  // depends on the machine: reported, never tested

  bool met() const { return measured <= limit; }  // NaN misses
};
using Bars = std::vector<Bar>;

enum class Size { small, full };
inline int cases(Size size, int small, int full) {
  return size == Size::small ? small : full;
}

Bars free_ball(Size size);
Bars bounce_trains(Size size);
Bars robot_alone(Size size);
Bars motors_alone(Size size);  // other motors than the default's, here and below
Bars single_impacts(Size size);
Bars motors_in_impacts(Size size);
Bars conserved_in_impacts(Size size);
Bars shots(Size size);
Bars lasting_pushes(Size size);
Bars motors_pushing(Size size);
Bars scrums(Size size);
Bars snippets(Size size);
Bars motors_in_crowds(Size size);
Bars newtons_cradle(Size size);
Bars symmetric_hits(Size size);
Bars corner_on_corner(Size size);
Bars wheel_spin_at_wall(Size size);
Bars zeno_bounces(Size size);
Bars tick_lengths(Size size);
Bars elastic_energy(Size size);
Bars heap_at_rest(Size size);
Bars sliding_along_a_wall(Size size);
Bars four_corners(Size size);
Bars nearly_parallel_faces(Size size);
Bars first_impacts_of_levels(Size size);
Bars mass_ratios(Size size);
Bars instant_motors(Size size);

// All of them, in the order of the table.
struct Kind {
  const char* name;
  Bars (*measure)(Size);
};
const std::vector<Kind>& kinds();

}  // namespace mirocup::scenes
