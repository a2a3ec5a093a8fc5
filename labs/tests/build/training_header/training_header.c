/* SPDX-License-Identifier: MIT
 *
 * training.h stands alone, as C11 with every warning. Plays some steps and prints the observations
 * and rewards of the last one as hexadecimal numbers;
 * labs/tests/programs/training/same_bits_test.py plays the same in Python.
 */
#include "mirocup/training.h"

#include <stdio.h>
#include <stdlib.h>

#define AT(member, offset) \
  _Static_assert(offsetof(mirocup_training_sizes, member) == (offset), #member)
AT(size, 0);
AT(matches, 4);
AT(slots, 8);
AT(rows, 12);
AT(robots, 16);
AT(observation, 20);
AT(action, 24);
AT(terms, 28);
AT(statistics, 32);
AT(threads, 36);
#undef AT
_Static_assert(sizeof(mirocup_training_sizes) == 40, "its end");
#define AT(member, offset) \
  _Static_assert(offsetof(mirocup_training_buffers, member) == (offset), #member)
AT(size, 0);
AT(actions, 8);
AT(observations, 16);
AT(rewards, 24);
AT(terminations, 32);
AT(truncations, 40);
AT(final_observations, 48);
AT(terms, 56);
AT(statistics, 64);
#undef AT
_Static_assert(sizeof(mirocup_training_buffers) == 72, "its end");

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
      .size = sizeof buffers, .actions = actions, .observations = observations, .rewards = rewards};
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
