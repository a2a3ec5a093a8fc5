// el robot va a un punto; grados y pulgadas (1 pulgada = 2.54 cm; ángulo en grados)
#include "stdafx.h"
#include "ESTRATEGIA.H"

void ir(Robot &r, double x, double y, double fuerza)
{
  double dx = x - r.pos.x, dy = y - r.pos.y;
  double a = atan2(dy, dx) * 180 / M_PI - r.rotation;
  while (a > 180) a -= 360;
  while (a < -180) a += 360;
  double s = 1;
  if (a > 90) { a -= 180; s = -1; }
  else if (a < -90) { a += 180; s = -1; }
  double v = s * min(fuerza, 15 + 5 * sqrt(dx * dx + dy * dy)) * (fabs(a) < 35 ? 1.0 : 0.25);
  r.velocityLeft = v - 0.4 * a;
  r.velocityRight = v + 0.4 * a;
}
