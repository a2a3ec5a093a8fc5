/* SPDX-License-Identifier: MIT
 *
 * libmirocup_team: a team in its own program, in any language that can call C.
 *
 *   mirocup_team_open    names the match and the team; returns at once
 *   mirocup_team_wait    waits for the next event: a seat, a tick, the end
 *   mirocup_team_place   requests places for the robots at a restart
 *   mirocup_team_send    answers the tick
 *   mirocup_team_close   leaves the match
 *
 * Frames, units, the delay of a command and the meaning of every number are those of strategy.h.
 * The team's program can run on any computer that reaches the match server by UDP. The program has
 * no sandbox and no budget of processor time; only its answers and their arrival times count.
 *
 * The connection recovers by itself from lost packets and from a server that is started again. If
 * your program crashes in the middle of a match, start it again and open the match: the new process
 * gets the seat once the old process has been silent for a moment.
 *
 * A program draws nothing into the replay: the drawing functions of its setup (strategy.h,
 * "Thoughts") have no effect.
 *
 * A connection may be used by one thread at a time. A process may have one connection at a time,
 * because credentials and the address of the server belong to the DDS domain of the whole process.
 * Returned texts and structures stay valid until the next call with the same connection.
 * Enumerations are passed as int32_t, because compilers differ in the size of an enum. team.hpp is
 * a C++ layer on top of this header, docs/interfaces.md has the conventions.
 */
#ifndef MIROCUP_TEAM_H
#define MIROCUP_TEAM_H

#include "mirocup/strategy.h"

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The match to join. Set all members to 0, then set `size`, `team`, `match` and `name`. */
typedef struct mirocup_team_call {
  uint32_t size;           /* of this structure, bytes; later versions add members at its end */
  int32_t team;            /* enum mirocup_colour: the colour to play */
  const char* server;      /* host of the match server; null: this computer */
  const char* match;       /* ID of the match */
  const char* name;        /* of the team, as the match knows it: 1 to 64 bytes of UTF-8 */
  const char* credentials; /* folder with the team's credentials; null: open mode */
  int32_t domain;          /* DDS domain, 0 to 230 */
  const char* interface;   /* network interface, by name or IPv4 address, that leads to the server;
                            * null: as the routing table says */
} mirocup_team_call;

typedef struct mirocup_connection mirocup_connection;

/* The result of mirocup_team_wait(). */
enum mirocup_team_news {
  MIROCUP_TEAM_NOTHING = 0, /* nothing happened in the given time */
  MIROCUP_TEAM_SEATED = 1,  /* the team has a seat in a new leg; see _setup() */
  MIROCUP_TEAM_TICK = 2,    /* see _observation(); answer it with _send() */
  MIROCUP_TEAM_OVER = 3,    /* the leg is over; see _text() ("full_time", "forfeit") and _score() */
  MIROCUP_TEAM_REFUSED = 4  /* the server does not admit this team; see _text() */
};

/* Opens a connection. On failure returns null, writes a sentence into `why`, which has room for
 * `size` bytes and may be null, and sets errno: EINVAL if the call is wrong, or if the credentials
 * are missing or belong to another team; ENETDOWN if the network cannot be used. */
mirocup_connection* mirocup_team_open(const mirocup_team_call* call, char* why, size_t size);

/* Waits at most `seconds` of wall time. Returns an enum mirocup_team_news. Ticks come in order,
 * each tick once, but a slow team misses ticks. */
int32_t mirocup_team_wait(mirocup_connection* connection, double seconds);

/* Returns the facts of the leg of the last MIROCUP_TEAM_SEATED, valid until the next
 * MIROCUP_TEAM_SEATED. */
const mirocup_setup* mirocup_team_setup(const mirocup_connection* connection);

/* Returns the observation of the last MIROCUP_TEAM_TICK. */
const mirocup_observation* mirocup_team_observation(const mirocup_connection* connection);

/* Requests places at a restart, while the last tick has `placing` 1. The following _send() sends
 * the request. The rules of place() in strategy.h hold, but fill `placement` completely: give
 * robots that should stay, and the ball, their observed places. Without a request all robots stay.
 * Returns 0; in a tick without `placing` returns -1 and has no effect. */
int32_t mirocup_team_place(mirocup_connection* connection, const mirocup_placement* placement);

/* Sends the answer to the last tick. Call this function once for a tick. Returns 0, or -1 if the
 * match is over or has refused the team: mirocup_team_text() has the reason. A lost connection
 * shows in mirocup_team_wait(). */
int32_t mirocup_team_send(mirocup_connection* connection, const mirocup_command* command);

/* Returns the MIROCUP_ABI_VERSION of the strategy.h that this library was built with, whose
 * structures the library uses. A program with another MIROCUP_ABI_VERSION must be built again. */
uint32_t mirocup_team_version(void);

/* Returns a sentence for the person who runs the team. Until the team has a seat, it says why there
 * is none yet; while the team has a seat, it is ""; afterwards, it says how the leg ended or why
 * the team was refused. */
const char* mirocup_team_text(const mirocup_connection* connection);

/* Returns the official score when the leg is over: [0] blue, [1] yellow. */
const int32_t* mirocup_team_score(const mirocup_connection* connection);

/* Leaves the match and frees the connection. Null has no effect. */
void mirocup_team_close(mirocup_connection* connection);

#ifdef __cplusplus
}
#endif

#endif
