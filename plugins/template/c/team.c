/* A keeper, one robot that kicks to the opponents' goal, and the others behind the ball. */
#include "mirocup/skills.h"

#include <stdlib.h>

struct team {
  const mirocup_setup* setup;
  double wait; /* how far behind, m */
};

static void* create(const mirocup_setup* setup) {
  struct team* team = calloc(1, sizeof *team);
  if (team == NULL) return NULL;
  team->setup = setup;
  team->wait = setup->parameter(setup->host, "wait", 0.45);
  return team;
}

/* You always attack +x. */
static mirocup_wheels kick(const mirocup_setup* setup, const mirocup_observation* now) {
  if (mirocup_must_kick_off(now)) return mirocup_kick_off(setup, &now->own[1]);
  if (mirocup_is_stuck(now, 0.6)) return mirocup_free_ball(setup, now, &now->own[1]);
  return mirocup_attack_ball(setup, now, 1, mirocup_open_corner(setup, now, 0.05, 0.0), 1.8, 1e9,
                             0.08);
}

static void decide(void* handle, const mirocup_observation* now, mirocup_command* command) {
  const struct team* team = handle;
  const mirocup_setup* setup = team->setup;
  int i;
  command->wheels[0] = mirocup_keep_goal(setup, now, &now->own[0]);
  command->wheels[1] = kick(setup, now);
  for (i = 2; i < now->robots; ++i) { /* the others wait behind the ball */
    mirocup_point post = {now->ball_x - team->wait - 0.2 * (i - 2), -0.5 * now->ball_y};
    post = mirocup_inside(setup, post, mirocup_elbow_room(setup));
    post = mirocup_make_way(setup, now, mirocup_keep_out(setup, i, post));
    command->wheels[i] = mirocup_drive_clear(setup, now, &now->own[i], post, 0.0, 1.5);
  }
  mirocup_avoid_own_goals(setup, now, command);
  mirocup_keep_laws(setup, now, command); /* no pushing */
}

const mirocup_strategy* mirocup_entry(void) {
  static const mirocup_strategy strategy = {
      .abi_version = MIROCUP_ABI_VERSION,
      .size = sizeof strategy,
      .name = "@NAME@",
      .create = create,
      .decide = decide,
      .destroy = free,
  };
  return &strategy;
}
