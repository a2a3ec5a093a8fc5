/* SPDX-License-Identifier: MIT
 *
 * libmirocup_training: many matches in one process, for programs that learn.
 *
 *   mirocup_training_create    makes a batch of matches from a JSON configuration
 *   mirocup_training_spec      tells sizes, names, units and bounds, as JSON
 *   mirocup_training_bind      names the caller's buffers, which are read and written in place
 *   mirocup_training_reset     starts episodes
 *   mirocup_training_step      plays one step of every match, on all threads of the batch
 *
 * labs/docs/training.md has the keys of the configuration and all names. {"matches": 64} is enough:
 * its matches have 3 robots a side, blue learns, and yellow is the house team `idle`.
 *
 * Rows
 *   A match has a slot for each learner: a whole team or, with "agents": "robot", one robot. The
 *   slots of blue come before those of yellow. Buffers have a row for each slot of each match, with
 *   the index match * slots + slot. All values of a row are in the frame of the row's team, which
 *   always attacks +x.
 *
 * Same result
 *   A match depends only on the configuration, its seeds and its actions, not on the number of
 *   threads or of other matches. Each episode is a leg that `mirocup verify` can prove.
 *
 * Ends of episodes
 *   An event such as a goal terminates an episode; the limit of its length truncates it.
 *   "autoreset" says what happens then, as in Gymnasium:
 *     next_step  the next step of this match ignores its actions, starts an episode and returns its
 *                first observation, with reward 0
 *     same_step  the step returns the first observation of the next episode; the last observation
 *                of the old episode goes to final_observations
 *     disabled   the caller resets; until then, steps leave the match as it is
 *
 * Errors
 *   Functions that can fail return 0 for success, else the exit code with which commands report the
 *   same fault (2 wrong input, 3 not available, 4 damaged data, 5 the host's fault).
 *   mirocup_training_error() then has a sentence. Nothing throws. A batch may be used by one thread
 *   at a time, bind() included; different batches are independent. docs/interfaces.md has the
 *   conventions.
 */
#ifndef MIROCUP_TRAINING_H
#define MIROCUP_TRAINING_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct mirocup_training mirocup_training;

/* The header's version. It changes when programs built with an older header can no longer run. */
#define MIROCUP_TRAINING_VERSION 1u

/* Returns the MIROCUP_TRAINING_VERSION that the library was built with. */
uint32_t mirocup_training_version(void);

/* Lengths of the arrays below. The lengths are constant while a batch lives. */
typedef struct mirocup_training_sizes {
  uint32_t size; /* of this structure, bytes; later versions add members at its end */
  int32_t matches;
  int32_t slots;       /* number of learners of a match */
  int32_t rows;        /* matches * slots */
  int32_t robots;      /* robots of each team */
  int32_t observation; /* numbers in a row of observations */
  int32_t action;      /* numbers in a row of actions, each in [-1, 1] */
  int32_t terms;       /* terms of the reward */
  int32_t statistics;  /* number of statistics of an episode */
  int32_t threads;
} mirocup_training_sizes;

/* The caller's arrays, row after row, which must live as long as they are bound. Null means that
 * you do not want an array. The batch reads only `actions` and writes the other arrays. */
typedef struct mirocup_training_buffers {
  uint32_t size;             /* of this structure, bytes; later versions add members at its end */
  const float* actions;      /* rows * action */
  float* observations;       /* rows * observation */
  float* rewards;            /* rows: the sum of weight * term */
  uint8_t* terminations;     /* rows: 1 or 0 */
  uint8_t* truncations;      /* rows: 1 or 0 */
  float* final_observations; /* rows * observation: written with same_step, when an episode ends */
  float* terms;              /* rows * terms: each term of the step, without its weight */
  float* statistics;         /* rows * statistics: written when an episode ends */
} mirocup_training_buffers;

/* An episode of a match. */
enum mirocup_training_episode {
  MIROCUP_TRAINING_CURRENT_EPISODE = 0, /* the present episode, as far as it has been played */
  MIROCUP_TRAINING_LAST_EPISODE = 1     /* the episode that ended last */
};

/* Makes a batch. Loads and starts the teams that do not learn, in this process and without a
 * sandbox. No episode runs yet: reset all matches first. After an error returns null and writes
 * a sentence into `error` (`size` bytes, ended with 0). */
mirocup_training* mirocup_training_create(const char* configuration, char* error, size_t size);
void mirocup_training_destroy(mirocup_training* training);

const mirocup_training_sizes* mirocup_training_get_sizes(const mirocup_training* training);
const char* mirocup_training_spec(const mirocup_training* training);
const char* mirocup_training_error(const mirocup_training* training);

/* Names the caller's arrays. The batch reads and writes the arrays only during reset() and step(),
 * so you may bind other arrays between two steps. */
int32_t mirocup_training_bind(mirocup_training* training, const mirocup_training_buffers* buffers);

/* Starts an episode in each match whose `mask` is not 0 (null: in all), writes its observations and
 * sets its rewards, terminations and truncations to 0. `seeds` (null: none) has a seed for each
 * match, from which all later episodes of the match follow as well. Without seeds, the match
 * continues with its next episode. `mask` and `seeds` have `matches` entries. */
int32_t mirocup_training_reset(mirocup_training* training, const uint8_t* mask,
                               const uint64_t* seeds);

/* Plays one step of every match. */
int32_t mirocup_training_step(mirocup_training* training);

/* Sets the weights of all terms of the reward, in the order of the spec: `terms` numbers. */
int32_t mirocup_training_set_weights(mirocup_training* training, const double* weights);

/* Writes the true state of a match in the field's frame: for each robot of blue, each of yellow,
 * and the ball: x, y (m), heading (rad), velocity along x and y (m/s), turn (rad/s). `bodies` has
 * (2 * robots + 1) * 6 numbers. */
int32_t mirocup_training_bodies(const mirocup_training* training, int32_t match, double* bodies);

/* Writes an episode as a record, with its replay beside it, as `mirocup match --record` does. */
int32_t mirocup_training_record(mirocup_training* training, int32_t match,
                                int32_t episode, /* enum mirocup_training_episode */
                                const char* path);

/* save() copies a match, so that restore() can continue it from this moment, in this or another
 * match or process with the same configuration. save() returns the length of the copy in bytes (0
 * after an error), and writes the copy if `size` is at least this length. The copy holds the
 * commands of the episode, so restoring takes as long as playing the episode. restore() asks teams
 * that do not learn for their commands again, so such teams must be deterministic. It writes the
 * observations, terminations and truncations of the match, as the step before save() wrote them. */
size_t mirocup_training_save(const mirocup_training* training, int32_t match, void* copy,
                             size_t size);
int32_t mirocup_training_restore(mirocup_training* training, int32_t match, const void* copy,
                                 size_t size);

#ifdef __cplusplus
}
#endif

#endif /* MIROCUP_TRAINING_H */
