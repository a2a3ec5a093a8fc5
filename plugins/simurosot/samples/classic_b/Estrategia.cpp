#include "stdafx.h"
#include "Estrategia.h"

void ir(Robot &r, double x, double y, double fuerza);

extern "C" __declspec(dllexport) void Create(Environment *) {}
extern "C" __declspec(dllexport) void Destroy(Environment *) {}

// a team of one side only: it was always compiled for blue
extern "C" __declspec(dllexport) void Strategy(Environment *env)
{
  wsprintf(myMessage, "estado %d", (int)env->gameState);
  strcpy(env->display, myMessage);
  Ball &b = env->currentBall;
  double y = max(35.0, min(48.0, b.pos.y));
  ir(env->home[0], 91.5, y, 90);
  for (int i = 1; i < JUGADORES; i++) {
    Robot &r = env->home[i];
    bool cerca = true;
    for (int j = 1; j < JUGADORES; j++)
      if (fabs(env->home[j].pos.x - b.pos.x) + fabs(env->home[j].pos.y - b.pos.y) <
          fabs(r.pos.x - b.pos.x) + fabs(r.pos.y - b.pos.y)) cerca = false;
    if (!cerca) ir(r, b.pos.x + 12 + 6 * i > 78 ? 78 : b.pos.x + 12 + 6 * i, 20 + 11 * i, 70);
    else if (r.pos.x > b.pos.x + 2) ir(r, b.pos.x - 6, b.pos.y, 115);
    else ir(r, b.pos.x + 10, b.pos.y + (r.pos.y > b.pos.y ? 7 : -7), 100);
  }
}
