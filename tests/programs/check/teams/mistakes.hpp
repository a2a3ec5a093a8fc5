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
  address,
  // Uses memory that is not its own, or that it never wrote.
  writes_behind,
  writes_freed,
  frees_twice,
  heap_not_set,
  stack_not_set,
  bool_not_set,
  // Ends itself.
  recursion,
  division_by_zero,
  throws_in_noexcept,
  exits,
  writes_observation,
  thread,
  file,
  // Reads what is not its own, or no longer.
  keeps_observation,
  reads_behind,
  writes_behind_command,
  throws_a_text,
  // Lives by a clock.
  thinks_by_the_clock,
  time_stamp_counter,
  // Asks the system.
  variable_that_is_missing,
  program,
  // In some state of play only.
  as_yellow,
  throws_at_own_penalty,
  throws_at_free_ball,
  throws_without_keeper,
  // Harmless ones: allowed, some with a warning.
  bad_values,
  not_finite,
  wheels_exchanged,
  wrong_end,
  targets_outside,
  never_moves,
  illegal_places,
  tries_a_file,
  measures_time,
  tries_a_thread,
  chance_without_seed,
  one_robot_too_many,
  turns_in_degrees,
  turns_unwrapped,
  axes_exchanged,
  robots_exchanged,
  wheels_negated,
  heading_offset,
  ball_in_ticks,
  end_by_colour,
  keeps_the_first_ball,
  drives_opponents,
  a_little_slow,  // 1.5 ms in each tick
};

}  // namespace mirocup::check_test
