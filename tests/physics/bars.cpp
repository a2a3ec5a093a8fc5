// SPDX-License-Identifier: MIT
#include "tests/physics/bars.hpp"

namespace mirocup::scenes {

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all{
      {"free_ball", free_ball},
      {"bounce_trains", bounce_trains},
      {"robot_alone", robot_alone},
      {"motors_alone", motors_alone},
      {"single_impacts", single_impacts},
      {"motors_in_impacts", motors_in_impacts},
      {"conserved_in_impacts", conserved_in_impacts},
      {"shots", shots},
      {"lasting_pushes", lasting_pushes},
      {"motors_pushing", motors_pushing},
      {"scrums", scrums},
      {"snippets", snippets},
      {"motors_in_crowds", motors_in_crowds},
      {"newtons_cradle", newtons_cradle},
      {"symmetric_hits", symmetric_hits},
      {"corner_on_corner", corner_on_corner},
      {"wheel_spin_at_wall", wheel_spin_at_wall},
      {"zeno_bounces", zeno_bounces},
      {"tick_lengths", tick_lengths},
      {"elastic_energy", elastic_energy},
      {"heap_at_rest", heap_at_rest},
      {"sliding_along_a_wall", sliding_along_a_wall},
      {"four_corners", four_corners},
      {"nearly_parallel_faces", nearly_parallel_faces},
      {"first_impacts_of_levels", first_impacts_of_levels},
      {"mass_ratios", mass_ratios},
      {"instant_motors", instant_motors},
  };
  return all;
}

}  // namespace mirocup::scenes
