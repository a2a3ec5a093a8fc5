#include "Adaptor.h"
#include <math.h>
#include <string.h>
#include <stdlib.h>
#include <time.h>

static bool blue;

static void pose(Robot &r, double x, double y, double angle)
{
  // written for yellow, which is at the left
  r.pos.x = blue ? 220 - x : x;
  r.pos.y = blue ? 180 - y : y;
  r.rotation = blue ? angle + 180 : angle;
  if (r.rotation > 180) r.rotation -= 360;
}

void SetYellowTeamName(char *name) { strcpy(name, "sample"); blue = false; srand(time(0)); }
void SetBlueTeamName(char *name) { strcpy(name, "sample"); blue = true; srand(time(0)); }

static void place(PlayMode mode, Robot r[])
{
  bool ours = blue ? (mode == PM_PlaceKick_Blue || mode == PM_PenaltyKick_Blue || mode == PM_GoalKick_Blue)
                   : (mode == PM_PlaceKick_Yellow || mode == PM_PenaltyKick_Yellow || mode == PM_GoalKick_Yellow);
  switch (mode) {
  case PM_PlaceKick_Yellow:
  case PM_PlaceKick_Blue:
    pose(r[0], 7, 90, 90);
    if (ours) pose(r[1], 100, 90, 0); else pose(r[1], 75, 90, 0);
    pose(r[2], 70, 130, 0);
    pose(r[3], 70, 50, 0);
    pose(r[4], 45, 90, 0);
    break;
  case PM_PenaltyKick_Yellow:
  case PM_PenaltyKick_Blue:
    if (ours) {
      pose(r[1], 170, 90, 0);
      pose(r[0], 10, 90, 90);
      pose(r[2], 90, 60, 0);
      pose(r[3], 90, 120, 0);
      pose(r[4], 60, 90, 0);
    } else {
      pose(r[0], 4, 90, 90);
      pose(r[1], 130, 40, 0);
      pose(r[2], 130, 70, 0);
      pose(r[3], 130, 110, 0);
      pose(r[4], 130, 140, 0);
    }
    break;
  default:
    break;  // the default places will do
  }
}

void SetFormerRobots(PlayMode mode, Robot robots[]) { place(mode, robots); }
void SetLaterRobots(PlayMode mode, Robot former[], Vector3D ball, Robot later[]) { place(mode, later); }
void SetBall(PlayMode mode, Vector3D *ball)
{
  ball->x = blue ? 210 : 10;
  ball->y = 80 + rand() % 20;
}

static void go(Robot &r, double x, double y, double most)
{
  double dx = x - r.pos.x, dy = y - r.pos.y;
  double a = atan2(dy, dx) * 57.29578 - r.rotation;
  while (a > 180) a -= 360;
  while (a < -180) a += 360;
  double s = fabs(a) > 90 ? -1 : 1;
  if (s < 0) a = a > 0 ? a - 180 : a + 180;
  double v = s * (fabs(a) > 35 ? 25 : 15 + 2 * sqrt(dx * dx + dy * dy));
  if (v > most) v = most;
  if (v < -most) v = -most;
  r.velocityLeft = v - 0.45 * a;
  r.velocityRight = v + 0.45 * a;
}

// more than a robot around the goal areas of 15 by 50
static bool in_area(double x, double y) { return (x < 26 || x > 194) && y > 58 && y < 122; }

// the areas are for the goalies: a second robot of ours costs a penalty
static void field(Robot &r, double x, double y, double most)
{
  if (in_area(r.pos.x, r.pos.y)) x = r.pos.x < 110 ? 45 : 175;
  else if (in_area(x, y)) x = x < 110 ? 28 : 192;
  go(r, x, y, most);
}

void RunStrategy(Environment *env)
{
  blue = env->home[0].pos.x > 110;
  double to = blue ? -1 : 1, own = blue ? 220 : 0;
  Vector3D ball = env->currentBall.pos;
  double vx = ball.x - env->lastBall.pos.x, vy = ball.y - env->lastBall.pos.y;
  double y = ball.y < 75 ? 75 : ball.y > 105 ? 105 : ball.y;
  go(env->home[0], own + to * 5, y, 90);
  int first = 1;
  for (int i = 1; i < 5; i++)
    if (hypot(env->home[i].pos.x - ball.x, env->home[i].pos.y - ball.y) <
        hypot(env->home[first].pos.x - ball.x, env->home[first].pos.y - ball.y)) first = i;
  for (int i = 1; i < 5; i++) {
    Robot &r = env->home[i];
    if (i != first) field(r, own + to * (45 + 12 * i), 30 + 26 * i, 70);
    else if (in_area(ball.x, ball.y)) field(r, ball.x < 110 ? 33 : 187, ball.y, 90);
    else if (to * (ball.x - r.pos.x) > 5) field(r, ball.x + 4 * vx + to * 12, ball.y + 4 * vy, 120);
    else field(r, ball.x - to * 25, ball.y + (r.pos.y > ball.y ? 16 : -16), 110);
  }
}
