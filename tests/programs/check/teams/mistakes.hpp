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
  counts_processors,
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
  // Reads what is not its own, or no longer.
  integral_not_set,
  unset_in_second_half,
  keeps_observation,
  reads_behind,
  reads_before,
  grown_vector,
  dangling_capture,
  text_too_long,
  writes_behind_command,
  throws_a_text,
  number_as_text,
  // Lives by a clock.
  derivative_by_the_clock,
  waits_by_the_clock,
  waits_by_its_processor_time,
  thinks_by_the_clock,
  time_stamp_counter,
  // Asks the system.
  variable_that_is_missing,
  locale,
  program,
  alarm,
  // In some state of play only.
  as_yellow,
  endless_angle,
  throws_at_own_penalty,
  throws_at_penalty_against,
  throws_at_own_free_kick,
  throws_at_free_kick_against,
  throws_at_own_goal_kick,
  throws_at_goal_kick_against,
  throws_at_free_ball,
  throws_in_a_corner,
  throws_without_keeper,
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
  not_a_number,
  small_counter,
  opponent_that_is_not_there,
  chance_without_seed,
  sets_locale,
  writes_a_file,
  tries_a_connection,
  tries_a_program,
  reads_input,
  leaks_a_little,
  places_in_degrees,
  one_robot_too_many,
  one_wheel,
  turns_in_degrees,
  a_little_slow,  // 1.5 ms in each tick
};

}  // namespace mirocup::check_test
