/* A keeper, one robot that drives to the ball, and the others behind it. */
#include "mirocup/elementary.h"
#include "mirocup/strategy.h"

#include <math.h>
#include <stdlib.h>

/* mirocup_sin() and its neighbours have the same bits on every system: elementary.h. */
static const double pi = MIROCUP_PI;

struct team {
  const mirocup_setup* setup;
  double
      wait; /* how far behind the ball the others stay, m. To try another value: --param wait=0.4 */
};

static double limited(double value, double low, double high) {
  return value < low ? low : value > high ? high : value;
}

/* Drives to a point, forwards or backwards, whichever needs the smaller turn. */
static mirocup_wheels drive_to(const mirocup_setup* setup, const mirocup_robot* robot, double x,
                               double y) {
  const double distance = mirocup_hypot(x - robot->x, y - robot->y);
  double error, direction = 1.0, speed, side;
  mirocup_wheels wheels = {0.0, 0.0};
  if (distance < 0.01) return wheels;
  error = remainder(mirocup_atan2(y - robot->y, x - robot->x) - robot->heading, 2.0 * pi);
  if (fabs(error) > pi / 2.0) {
    error = remainder(error + pi, 2.0 * pi);
    direction = -1.0;
  }
  speed = direction * limited(5.0 * distance, 0.0, 1.2) * fmax(0.0, mirocup_cos(error));
  side = 8.0 * error * setup->wheel_distance / 2.0;
  wheels.left = (speed - side) / setup->wheel_radius;
  wheels.right = (speed + side) / setup->wheel_radius;
  return wheels;
}

/* Drives behind the ball first, and then through it. */
static mirocup_wheels kick(const mirocup_setup* setup, const mirocup_observation* now,
                           const mirocup_robot* robot) {
  const double to_x = setup->half_length - now->ball_x, to_y = -now->ball_y;
  const double distance = fmax(mirocup_hypot(to_x, to_y), 1e-6);
  const double along_x = to_x / distance, along_y = to_y / distance;
  const double dx = robot->x - now->ball_x, dy = robot->y - now->ball_y;
  const double behind = -(dx * along_x + dy * along_y);
  const double aside = dy * along_x - dx * along_y;
  double step = 0.12;
  if (behind > 0.03 && fabs(aside) < 0.03) {
    return drive_to(setup, robot, now->ball_x + 0.3 * along_x, now->ball_y + 0.3 * along_y);
  }
  if (behind > 0.0)
    return drive_to(setup, robot, now->ball_x - step * along_x, now->ball_y - step * along_y);
  /* In front of the ball: round it. */
  step = aside < 0.0 ? -0.15 : 0.15;
  return drive_to(setup, robot, now->ball_x - 0.15 * along_x - step * along_y,
                  now->ball_y - 0.15 * along_y + step * along_x);
}

static void* create(const mirocup_setup* setup) {
  struct team* team = calloc(1, sizeof *team);
  if (team == NULL) return NULL;
  team->setup = setup;
  team->wait = setup->parameter(setup->host, "wait", 0.45);
  setup->log(setup->host, "a team in C");
  return team;
}

static void decide(void* handle, const mirocup_observation* now, mirocup_command* command) {
  const struct team* team = handle;
  const mirocup_setup* setup = team->setup;
  const double reach = setup->goal_half_width - 0.04;
  int i;
  command->wheels[0] = drive_to(setup, &now->own[0], -setup->half_length + 0.05,
                                limited(now->ball_y, -reach, reach));
  for (i = 1; i < now->robots; ++i) {
    const double x = fmax(now->ball_x - team->wait, -setup->half_length + 0.35);
    const double side = i % 2 == 0 ? 0.2 : -0.2;
    command->wheels[i] =
        i == 1 ? kick(setup, now, &now->own[i]) : drive_to(setup, &now->own[i], x, side);
  }
}

/* Called at restarts: robot 2 of an own kick-off stands ready for the ball that rolls back. */
static void place(void* handle, const mirocup_observation* now, mirocup_placement* placement) {
  (void)handle;
  if (now->restart == MIROCUP_KICK_OFF && now->own_restart && now->robots > 2)
    placement->robots[2].y = 0.25;
}

const mirocup_strategy* mirocup_entry(void) {
  static const mirocup_strategy strategy = {
      .abi_version = MIROCUP_ABI_VERSION,
      .size = sizeof strategy,
      .name = "mine",
      .create = create,
      .decide = decide,
      .destroy = free,
      .place = place,
  };
  return &strategy;
}
