#pragma once
// A plugin of Simuro5v5: structures of the platform.
#include <cstdint>

struct Vector2 { float x, y; };
struct Wheel { float leftSpeed, rightSpeed; };
struct Robot { Vector2 position; float rotation; Wheel wheel; };
struct Ball { Vector2 position; };
struct Field {
  Robot selfRobots[5];
  Robot opponentRobots[5];
  Ball ball;
  int32_t tick;
};
struct TeamInfo { wchar_t teamName[128]; };
enum class EventType { JudgeResult = 0, MatchStart, MatchStop, FirstHalfStart, SecondHalfStart, OvertimeStart, PenaltyShootoutStart };
enum class JudgeType {
  PlaceKick = 0, GoalKick, PenaltyKick,
  FreeKickRightTop, FreeKickRightBot, FreeKickLeftTop, FreeKickLeftBot
};
enum class Team { Self = 0, Opponent, None };
struct JudgeResultEvent { JudgeType type; Team actor; wchar_t reason[128]; };
