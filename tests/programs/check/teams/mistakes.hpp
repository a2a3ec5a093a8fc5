// SPDX-License-Identifier: MIT
//
// The mistakes that the team mistakes.so can make: the parameter "mistake" is the number of one.
#pragma once

namespace mirocup::check_test {

enum class Mistake {
  none,
  // Ends in some state of play only.
  null_pointer_late,
  throws_in_second_half,
  throws_when_trailing,
  throws_after_a_goal,
  throws_in_a_shoot_out,
  throws_in_place,
  // Takes too much.
  slow,
  sleeps,
  leaks,
  endless_loop,
  // Takes chance from its surroundings.
  seed_of_time,
  seed_of_process,
  random_device,
  address,
  processor,
  // Uses memory that is not its own, or that it never wrote.
  writes_behind,
  writes_before,
  writes_freed,
  frees_twice,
  reads_freed,
  heap_not_set,
  stack_not_set,
  // Ends itself.
  recursion,
  division_by_zero,
  throws_in_noexcept,
  assertion,
  exits,
  wild_pointer,
  writes_observation,
  thread,
  file,
  // Harmless ones: allowed, some with a warning.
  bad_values,
  never_moves,
  illegal_places,
  long_log,
  asks_for_a_variable,
  tries_a_file,
  keeps_much_memory,
  measures_time,
  tries_a_thread,
};

}  // namespace mirocup::check_test
