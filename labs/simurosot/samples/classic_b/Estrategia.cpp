#include "stdafx.h"
#include "Estrategia.h"

void ir(Robot &r, double x, double y, double fuerza);

bool en_area(double x, double y) { return (x < 17 || x > 83) && y > 29 && y < 54.5; }

// las areas son de los porteros: el segundo en la propia es penal
void ir_campo(Robot &r, double x, double y, double fuerza)
{
  if (en_area(r.pos.x, r.pos.y)) x = r.pos.x < 50 ? 24 : 76;
  else if (en_area(x, y)) x = x < 50 ? 18 : 82;
  ir(r, x, y, fuerza);
}

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
    if (!cerca) ir_campo(r, b.pos.x + 12 + 6 * i > 78 ? 78 : b.pos.x + 12 + 6 * i, 20 + 11 * i, 70);
    else if (en_area(b.pos.x, b.pos.y)) ir_campo(r, b.pos.x < 50 ? 20 : 80, b.pos.y, 100);
    else if (r.pos.x > b.pos.x + 2) ir_campo(r, b.pos.x - 6, b.pos.y, 115);
    else ir_campo(r, b.pos.x + 10, b.pos.y + (r.pos.y > b.pos.y ? 7 : -7), 100);
  }
}
