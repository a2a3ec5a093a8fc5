/* SPDX-License-Identifier: MIT
 *
 * A team in a program of its own, in any language that can call C: libmirocup_team.
 *
 *   mirocup_team_open    names the match and the team; comes back at once
 *   mirocup_team_wait    waits for what happens next: a seat, a tick, the end
 *   mirocup_team_place   at restarts: where the robots are to stand
 *   mirocup_team_send    answers the tick
 *   mirocup_team_close   leaves
 *
 * Frames, units, the delay of a command and the meaning of every number are those of strategy.h.
 * The program runs anywhere from where it can reach the match server by UDP, and is neither shut in
 * nor counted: only its answers are, and when they arrive.
 *
 * The connection looks after itself: lost packets, a server that is started again, a team that is
 * started again in the middle of a match (a new process simply opens the same match; it gets the
 * seat once the old one has been silent for a moment).
 *
 * Not for several threads at once, and one connection in a process at a time. Texts and structures
 * that it hands out stay valid until the next call with the same connection. team.hpp is a C++ layer
 * on top of it.
 */
#ifndef MIROCUP_TEAM_H
#define MIROCUP_TEAM_H

#include "mirocup/strategy.h"

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct mirocup_team_call {
  uint32_t size;           /* of this structure, bytes */
  int32_t team;            /* enum mirocup_team: the colour to play */
  const char* server;      /* host of the match server; null: this one */
  const char* match;       /* ID of the match */
  const char* name;        /* of the team, as the match knows it */
  const char* credentials; /* folder with the team's credentials; null: open mode */
} mirocup_team_call;

typedef struct mirocup_connection mirocup_connection;

/* What mirocup_team_wait() brought. */
enum mirocup_team_news {
  MIROCUP_TEAM_NOTHING = 0, /* in so many seconds */
  MIROCUP_TEAM_SEATED = 1,  /* the team takes part in a leg that is new to it; see _setup() */
  MIROCUP_TEAM_TICK = 2,    /* see _observation(); answer it with _send() */
  MIROCUP_TEAM_OVER = 3,    /* the leg is over; see _text() ("full_time", "forfeit") and _score() */
  MIROCUP_TEAM_REFUSED = 4  /* the server does not let this team play; see _text() */
};

/* Null if it cannot be had; then `why`, of `size` bytes, gets a sentence. It may be null. */
mirocup_connection* mirocup_team_open(const mirocup_team_call* call, char* why, size_t size);

/* Waits at most so many seconds of wall time; an enum mirocup_team_news. Ticks come in order and
 * once each, but a slow team misses some. */
int32_t mirocup_team_wait(mirocup_connection* connection, double seconds);

/* Everything that a team is told once; since the last MIROCUP_TEAM_SEATED. Valid until the next. */
const mirocup_setup* mirocup_team_setup(const mirocup_connection* connection);

/* The last tick. */
const mirocup_observation* mirocup_team_observation(const mirocup_connection* connection);

/* At a restart, while the last tick has `placing` 1: where you want to stand, told with _send(), which
 * comes after it. What strategy.h says of place() holds here, but `placement` has to be filled whole:
 * robots that are to stay, and the ball, with what the tick shows of them. Without it all stay. In
 * any other tick it has no effect. */
void mirocup_team_place(mirocup_connection* connection, const mirocup_placement* placement);

/* Answers the last tick; once. */
void mirocup_team_send(mirocup_connection* connection, const mirocup_command* command);

/* How the leg ended, why the team was refused; before that, why it has no seat yet. */
const char* mirocup_team_text(mirocup_connection* connection);

/* The official score once the leg is over: [0] blue, [1] yellow. */
const int32_t* mirocup_team_score(const mirocup_connection* connection);

/* Leaves the match. Null is fine. */
void mirocup_team_close(mirocup_connection* connection);

#ifdef __cplusplus
}
#endif

#endif
