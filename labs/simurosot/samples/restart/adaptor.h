#pragma once
// A team of the 2018 rules: places its robots at restarts and counts in centimetres.
struct Vector3D { double x, y, z; };
struct Bounds { long left, right, top, bottom; };
struct Robot { Vector3D pos; double rotation; double velocityLeft, velocityRight; };
struct OpponentRobot { Vector3D pos; double rotation; };
struct Ball { Vector3D pos; };
struct Environment {
  Robot home[5];
  OpponentRobot opponent[5];
  Ball currentBall, lastBall, predictedBall;
  Bounds fieldBounds, goalBounds;
  long gameState, whosBall;
  void *userData;
};
enum PlayMode {
  PM_PlayOn = 0,
  PM_FreeBall_LeftTop, PM_FreeBall_LeftBot, PM_FreeBall_RightTop, PM_FreeBall_RightBot,
  PM_PlaceKick_Yellow, PM_PlaceKick_Blue,
  PM_PenaltyKick_Yellow, PM_PenaltyKick_Blue,
  PM_FreeKick_Yellow, PM_FreeKick_Blue,
  PM_GoalKick_Yellow, PM_GoalKick_Blue
};
void SetYellowTeamName(char *name);
void SetBlueTeamName(char *name);
void SetFormerRobots(PlayMode mode, Robot robots[]);
void SetLaterRobots(PlayMode mode, Robot former[], Vector3D ball, Robot later[]);
void SetBall(PlayMode mode, Vector3D *ball);
void RunStrategy(Environment *env);
