#include "stdafx.h"
#include "Platform.h"
#include <cmath>
#include <cstring>
#include <random>

static JudgeType last = JudgeType::PlaceKick;
static Team actor = Team::None;
static std::mt19937 dice(1);

extern "C" __declspec(dllexport) void GetTeamInfo(TeamInfo *info)
{
  static const wchar_t name[] = L"sample";
  memcpy(info->teamName, name, sizeof(name));
}

void OnEvent(EventType type, void *argument)
{
  if (type != EventType::JudgeResult) return;
  auto *result = static_cast<JudgeResultEvent *>(argument);
  last = result->type;
  actor = result->actor;
}

// we defend the right end
extern "C" void GetPlacement(Field *field)
{
  Robot *r = field->selfRobots;
  auto put = [](Robot &robot, float x, float y) { robot.position = {x, y}; robot.rotation = 180; };
  if (last == JudgeType::PlaceKick) {
    put(r[0], 104, 0);
    put(r[1], actor == Team::Self ? 10.f : 35.f, 0);
    put(r[2], 40, 35);
    put(r[3], 40, -35);
    put(r[4], 75, 0);
  } else if (last == JudgeType::GoalKick && actor == Team::Self) {
    put(r[0], 106, 0);
    field->ball.position = {98, float(int(dice() % 20) - 10)};
  } else if (last == JudgeType::PenaltyKick && actor == Team::Opponent) {
    put(r[0], 106, 0);
  }
}

static void go(Robot &r, float x, float y, float most)
{
  const float dx = x - r.position.x, dy = y - r.position.y;
  float a = std::atan2(dy, dx) * 57.29578f - r.rotation;
  while (a > 180) a -= 360;
  while (a < -180) a += 360;
  float s = 1;
  if (std::fabs(a) > 90) { s = -1; a += a > 0 ? -180 : 180; }
  const float v = s * (std::fabs(a) > 35 ? 25.f : std::fmin(most, 15 + 2.f * std::hypot(dx, dy)));
  r.wheel.leftSpeed = v - 0.45f * a;
  r.wheel.rightSpeed = v + 0.45f * a;
}

// more than a robot around the goal areas of 15 by 50
static bool in_area(const Vector2 &p) { return std::fabs(p.x) > 84 && std::fabs(p.y) < 32; }

// the areas are for the keepers: a second robot of ours costs a penalty
static void go_outside(Robot &r, float x, float y, float most)
{
  if (in_area(r.position)) x = std::copysign(65.f, r.position.x);
  else if (in_area({x, y})) x = std::copysign(82.f, x);
  go(r, x, y, most);
}

extern "C" void GetInstruction(Field *field)
{
  const Vector2 ball = field->ball.position;
  Robot *r = field->selfRobots;
  go(r[0], 105, std::fmin(15.f, std::fmax(-15.f, ball.y)), 90);
  int first = 1;
  for (int i = 2; i < 5; i++)
    if (std::hypot(r[i].position.x - ball.x, r[i].position.y - ball.y) <
        std::hypot(r[first].position.x - ball.x, r[first].position.y - ball.y)) first = i;
  for (int i = 1; i < 5; i++) {
    if (i != first) go_outside(r[i], 70.f - 14.f * float(i), -65.f + 26.f * float(i), 70);
    else if (in_area(ball)) go_outside(r[i], std::copysign(77.f, ball.x), ball.y, 90);
    else if (r[i].position.x > ball.x + 5) go_outside(r[i], ball.x - 14, ball.y, 120);
    else go_outside(r[i], ball.x + 25, ball.y + (r[i].position.y > ball.y ? 16.f : -16.f), 110);
  }
}
