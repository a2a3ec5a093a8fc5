/* SPDX-License-Identifier: MIT
 *
 * training.h stands alone, as C11 with every warning. Plays some steps and prints the observations
 * and rewards of the last one as hexadecimal numbers: tests/programs/training/same_bits_test.py
 * plays the same in Python.
 */
#include "mirocup/training.h"

#include <stdio.h>
#include <stdlib.h>

#define AT(member, offset) \
  _Static_assert(offsetof(mirocup_training_sizes, member) == (offset), #member)
AT(matches, 0);
AT(slots, 4);
AT(rows, 8);
AT(robots, 12);
AT(observation, 16);
AT(action, 20);
AT(terms, 24);
AT(statistics, 28);
AT(threads, 32);
#undef AT
_Static_assert(sizeof(mirocup_training_sizes) == 36, "its end");
#define AT(member, offset) \
  _Static_assert(offsetof(mirocup_training_buffers, member) == (offset), #member)
AT(actions, 0);
AT(observations, 8);
AT(rewards, 16);
AT(terminations, 24);
AT(truncations, 32);
AT(final_observations, 40);
AT(terms, 48);
AT(statistics, 56);
#undef AT
_Static_assert(sizeof(mirocup_training_buffers) == 64, "its end");

enum { matches = 6, steps = 100 };

int main(void) {
  char error[500];
  mirocup_training* training = mirocup_training_create(
      "{\"matches\": 6, \"threads\": 2, \"yellow\": \"chaser\","
      " \"episode\": {\"seconds\": 2}}",
      error, sizeof error);
  if (training == NULL) {
    fprintf(stderr, "%s\n", error);
    return 3;
  }
  const mirocup_training_sizes size = *mirocup_training_get_sizes(training);
  const size_t rows = (size_t)size.rows;
  const size_t numbers = rows * (size_t)size.observation;
  float* const actions = calloc(rows * (size_t)size.action, sizeof *actions);
  float* const observations = calloc(numbers, sizeof *observations);
  float* const rewards = calloc(rows, sizeof *rewards);
  const mirocup_training_buffers buffers = {
      .actions = actions, .observations = observations, .rewards = rewards};
  uint64_t seeds[matches];
  for (int i = 0; i < matches; ++i) seeds[i] = 11 + (uint64_t)i;
  int code = mirocup_training_bind(training, &buffers);
  if (code == 0) code = mirocup_training_reset(training, NULL, seeds);
  for (int step = 0; code == 0 && step < steps; ++step) {
    for (size_t i = 0; i < rows * (size_t)size.action; ++i) {
      actions[i] = (float)((int)((i * 37 + (size_t)step * 11) % 65) - 32) / 32.0F;
    }
    code = mirocup_training_step(training);
  }
  for (size_t i = 0; i < numbers; ++i) printf("%a\n", (double)observations[i]);
  for (size_t i = 0; i < rows; ++i) printf("%a\n", (double)rewards[i]);
  mirocup_training_destroy(training);
  free(actions);
  free(observations);
  free(rewards);
  return code;
}
