// Strategy.cpp : a keeper, two who attack, two who wait.
#include "stdafx.h"
#include "Strategy.h"

const double PI = 3.14159265;

struct Memory { FILE *debug; int ticks; bool left; };

BOOL APIENTRY DllMain(HANDLE hModule, DWORD reason, LPVOID reserved)
{
  switch (reason) {
  case DLL_PROCESS_ATTACH:
  case DLL_PROCESS_DETACH:
    break;
  }
  return TRUE;
}

void Velocity(Robot *robot, int vl, int vr)
{
  robot->velocityLeft = vl;
  robot->velocityRight = vr;
}

// drives to a place, forwards or backwards
void Position(Robot *robot, double x, double y)
{
  double dx = x - robot->pos.x, dy = y - robot->pos.y;
  double d = sqrt(dx * dx + dy * dy);
  double angle = 180.0 / PI * atan2(dy, dx) - robot->rotation;
  while (angle > 180) angle -= 360;
  while (angle < -180) angle += 360;
  double sign = 1;
  if (fabs(angle) > 90) {
    sign = -1;
    angle = angle > 0 ? angle - 180 : angle + 180;
  }
  double speed = d > 20 ? 110 : 20 + 4.5 * d;
  if (fabs(angle) > 30) speed *= 0.3;
  double turn = 0.45 * angle;
  Velocity(robot, int(sign * speed - turn), int(sign * speed + turn));
}

void PredictBall(Environment *env)
{
  env->predictedBall.pos.x = env->currentBall.pos.x + 3 * (env->currentBall.pos.x - env->lastBall.pos.x);
  env->predictedBall.pos.y = env->currentBall.pos.y + 3 * (env->currentBall.pos.y - env->lastBall.pos.y);
}

void Goalie(Environment *env, bool left)
{
  double y = env->currentBall.pos.y;
  if (y > GTOPY - 2) y = GTOPY - 2;
  if (y < GBOTY + 2) y = GBOTY + 2;
  Position(&env->home[0], left ? FLEFTX + 2 : FRIGHTX - 2, y);
}

void Attack(Environment *env, int i, bool left)
{
  Vector3D ball = env->predictedBall.pos;
  double to = left ? 1 : -1;
  Robot *robot = &env->home[i];
  if (to * (ball.x - robot->pos.x) > 2.5 && fabs(ball.y - robot->pos.y) < 8)
    Position(robot, ball.x + to * 6, ball.y + 0.3 * (ball.y - robot->pos.y));
  else
    Position(robot, ball.x - to * 9, ball.y + (i - 1.5) * 3);
}

extern "C" STRATEGY_API void Create(Environment *env)
{
  Memory *memory = (Memory *)malloc(sizeof(Memory));
  env->userData = memory;
  memory->debug = fopen("c:\\strategy\\debugfile.txt", "wt");
  fprintf(memory->debug, "a match begins\n");
}

extern "C" STRATEGY_API void Destroy(Environment *env)
{
  Memory *memory = (Memory *)env->userData;
  fclose(memory->debug);
  free(memory);
}

extern "C" STRATEGY_API void Strategy(Environment *env)
{
  Memory *memory = (Memory *)env->userData;
  if (memory->ticks++ == 0) memory->left = env->home[0].pos.x < 50;
  bool left = memory->left;
  // ends change at half time
  if (env->gameState != 0) left = memory->left = env->home[0].pos.x < 50;
  PredictBall(env);
  Goalie(env, left);
  switch (env->gameState) {
  case 0:
  case FREE_BALL:
  case PLACE_KICK:
  case PENALTY_KICK:
  case FREE_KICK:
  case GOAL_KICK: {
    int first = 1, i;
    double best = 1e9;
    for (i = 1; i < 4; i++) {
      double d = fabs(env->home[i].pos.x - env->currentBall.pos.x) + fabs(env->home[i].pos.y - env->currentBall.pos.y);
      if (d < best) { best = d; first = i; }
    }
    for (i = 1; i < 4; i++) {
      if (i == first) Attack(env, i, left);
      else Position(&env->home[i], 50 - (left ? 8 : -8) * i, 42 + (i - 2) * 14);
    }
    Position(&env->home[4], left ? 30 : 70, 42);
    break;
  }
  }
  if (memory->debug) fprintf(memory->debug, "%d %ld %f\n", memory->ticks, env->gameState, env->currentBall.pos.x);
}
