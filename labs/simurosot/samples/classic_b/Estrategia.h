// Some headers had the opponents behind the balls, as here. This header also defines a variable.
#ifndef ESTRATEGIA_H
#define ESTRATEGIA_H

#define JUGADORES 5

struct Vector3D { double x, y, z; };
struct Bounds { long left, right, top, bottom; };
struct Robot { Vector3D pos; double rotation; double velocityLeft, velocityRight; };
struct OpponentRobot { Vector3D pos; double rotation; };
struct Ball { Vector3D pos; };
struct Goal { Vector3D mid, sup, inf, tope; };

struct Environment {
  Robot home[JUGADORES];
  Ball currentBall, lastBall, predictedBall;
  Bounds fieldBounds, goalBounds;
  long gameState;
  long whoseBall;
  OpponentRobot opponent[JUGADORES];
  void *userData;
  char *display;
};

char myMessage[200];

#endif
