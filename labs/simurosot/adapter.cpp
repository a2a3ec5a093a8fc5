// SPDX-License-Identifier: MIT
//
// Makes a team of SimuroSot one of mirocup. Compiled once for each team, with the team's own header
// (MIROCUP_SIMUROSOT_HEADER), and copies by the names of members, whose order differs from team to
// team. Functions are found by their names in the object files, in C or C++, declared or not.
//
// Styles (MIROCUP_SIMUROSOT_STYLE):
//   1 classic  Create, Strategy, Destroy; inches, origin at the lower left outside of the field
//   2 restart  RunStrategy and Set...; centimetres, origin at the lower left corner
//   3 v5       GetInstruction, GetPlacement, OnEvent; centimetres, origin in the middle
//
// In the first two, blue defends the right end and yellow the left one. A team of mirocup always
// attacks +x, so it sees what yellow saw; blue's view is turned by 180 degrees. In the third every
// team sees itself at the right, or with SIDE yellow at the left.
#include "mirocup/strategy.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>

#include MIROCUP_SIMUROSOT_HEADER

#ifndef MIROCUP_SIMUROSOT_HEADER_ALONE
#define MIROCUP_TEAM_FUNCTION(name, symbol) \
  name __asm__(symbol) __attribute__((weak, visibility("hidden")))

void mirocup_simurosot_set_time(double seconds);

namespace {

constexpr int classic = 1, restart = 2, v5 = 3;
constexpr int style = MIROCUP_SIMUROSOT_STYLE;

constexpr int robots = 5;
constexpr double degrees = 180.0 / 3.14159265358979323846;
constexpr double inch = 0.0254;  // m

// The greatest command of a wheel, in the platform's units.
constexpr double most = 125.0;

// Measured from match logs of the platform: speed for each unit of the mean of both wheels, turn
// for each unit of half their difference, and the time constants of both, which a robot with one
// motor for each wheel cannot have.
constexpr double mps_per_unit = 0.02320;
constexpr double turn_per_unit = 0.5595;  // rad/s
constexpr double forward_lag = 0.269;     // s
constexpr double turn_lag = 0.052;
constexpr double brake_lag = 0.0154;      // forward, with both commands 0
constexpr double wheel_per_unit = 1.031;  // rad/s, where wheels are taken one by one

constexpr int linear = 0, imitate = 1, plain = 2;  // MIROCUP_SIMUROSOT_WHEELS
constexpr int own = 0, blue = 1, yellow = 2;       // MIROCUP_SIMUROSOT_SIDE, and whosBall

// A body in the platform's units.
struct Placed {
  double x = 0.0, y = 0.0;
  double rotation = 0.0;  // degrees
};

// Between mirocup's frame and that of the team's style and side.
struct Frame {
  double sign = 1.0;  // -1: turned by 180 degrees
  double centre_x = 0.0, centre_y = 0.0;
  double unit = 1.0;  // m

  Placed out(double x, double y, double heading) const {
    double rotation = heading * degrees + (sign < 0.0 ? 180.0 : 0.0);
    if (rotation > 180.0) rotation -= 360.0;
    return {centre_x + sign * x / unit, centre_y + sign * y / unit, rotation};
  }
  Placed out(const mirocup_robot& robot) const { return out(robot.x, robot.y, robot.heading); }
  mirocup_pose in(double x, double y, double rotation) const {
    return {sign * (x - centre_x) * unit, sign * (y - centre_y) * unit,
            (rotation + (sign < 0.0 ? 180.0 : 0.0)) / degrees};
  }
};

double limited(double command) {
  return std::isfinite(command) ? std::clamp(command, -most, most) : 0.0;
}

// Turns the platform's commands into wheel speeds of this simulator, both scaled down together.
mirocup_wheels wheels_for(const mirocup_setup& setup, const mirocup_robot& robot, double left_units,
                          double right_units) {
  const double l = limited(left_units), r = limited(right_units);
  mirocup_wheels wheels{wheel_per_unit * l, wheel_per_unit * r};
  if (MIROCUP_SIMUROSOT_WHEELS != plain) {
    double forward = mps_per_unit * (l + r) / 2.0;
    double turn = turn_per_unit * (r - l) / 2.0;
    if (MIROCUP_SIMUROSOT_WHEELS == imitate) {
      const double now = robot.vx * std::cos(robot.heading) + robot.vy * std::sin(robot.heading);
      const double lag = l == 0.0 && r == 0.0 ? brake_lag : forward_lag;
      forward = now + std::min(1.0, setup.motor_time_constant / lag) * (forward - now);
      turn = robot.turn + std::min(1.0, setup.motor_time_constant / turn_lag) * (turn - robot.turn);
    }
    const double across = turn * setup.wheel_distance / 2.0;
    wheels = {(forward - across) / setup.wheel_radius, (forward + across) / setup.wheel_radius};
  }
  const double fastest = std::max(std::abs(wheels.left), std::abs(wheels.right));
  if (fastest > setup.wheel_speed_limit) {
    wheels.left *= setup.wheel_speed_limit / fastest;
    wheels.right *= setup.wheel_speed_limit / fastest;
  }
  return wheels;
}

// A robot that the league does not have stands behind the team's own goal.
mirocup_robot robot_at(const mirocup_robot* team, int count, int i, double behind) {
  if (i < count) return team[i];
  return {behind, 0.1 * (i - 2), 0.0, 0.0, 0.0, 0.0};
}

// The team that places first: the taker at a kick-off and a goal kick, the defender at a free ball,
// to whom mirocup awards it, and the opponents otherwise.
bool places_first(const mirocup_observation& now) {
  const bool taker_first = now.restart == MIROCUP_KICK_OFF || now.restart == MIROCUP_GOAL_KICK ||
                           now.restart == MIROCUP_FREE_BALL;
  return taker_first == (now.own_restart != 0);
}

// True if the team changed something of what it was shown.
template <class T>
bool differs(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof(T)) != 0;
}

#if MIROCUP_SIMUROSOT_STYLE != 3

extern "C" {
void MIROCUP_TEAM_FUNCTION(create_c(Environment*), "Create");
void MIROCUP_TEAM_FUNCTION(create_cpp(Environment*), "_Z6CreateP11Environment");
void MIROCUP_TEAM_FUNCTION(strategy_c(Environment*), "Strategy");
void MIROCUP_TEAM_FUNCTION(strategy_cpp(Environment*), "_Z8StrategyP11Environment");
void MIROCUP_TEAM_FUNCTION(run_c(Environment*), "RunStrategy");
void MIROCUP_TEAM_FUNCTION(run_cpp(Environment*), "_Z11RunStrategyP11Environment");
void MIROCUP_TEAM_FUNCTION(former_c(int, Robot*), "SetFormerRobots");
void MIROCUP_TEAM_FUNCTION(former_cpp(int, Robot*), "_Z15SetFormerRobots8PlayModeP5Robot");
void MIROCUP_TEAM_FUNCTION(later_c(int, Robot*, Vector3D, Robot*), "SetLaterRobots");
void MIROCUP_TEAM_FUNCTION(later_cpp(int, Robot*, Vector3D, Robot*),
                           "_Z14SetLaterRobots8PlayModeP5Robot8Vector3DS1_");
void MIROCUP_TEAM_FUNCTION(ball_c(int, Vector3D*), "SetBall");
void MIROCUP_TEAM_FUNCTION(ball_cpp(int, Vector3D*), "_Z7SetBall8PlayModeP8Vector3D");
void MIROCUP_TEAM_FUNCTION(blue_name_c(char*), "SetBlueTeamName");
void MIROCUP_TEAM_FUNCTION(blue_name_cpp(char*), "_Z15SetBlueTeamNamePc");
void MIROCUP_TEAM_FUNCTION(yellow_name_c(char*), "SetYellowTeamName");
void MIROCUP_TEAM_FUNCTION(yellow_name_cpp(char*), "_Z17SetYellowTeamNamePc");
}

// Calls the one of the two that the team has, if any.
template <class F, class... Arguments>
bool call(F* in_c, F* in_cpp, Arguments... arguments) {
  F* function = in_c != nullptr ? in_c : in_cpp;
  if (function == nullptr) return false;
  function(arguments...);
  return true;
}

template <class E>
void set_whose_ball(E& environment, long whose) {
  if constexpr (requires { environment.whosBall; }) {
    environment.whosBall = whose;
  } else if constexpr (requires { environment.whoseBall; }) {
    environment.whoseBall = whose;
  }
}

// Headers call the opponents "opponent" or "opp".
template <class E>
auto& opponents_in(E& environment) {
  if constexpr (requires { environment.opponent; }) {
    return environment.opponent;
  } else {
    return environment.opp;
  }
}

// The lines of the field in whole inches, as the team's own header has them with decimals. The
// header of the platform's last version has no place for them.
template <class E>
void set_bounds(E& environment) {
  if constexpr (requires { environment.fieldBounds; }) {
    environment.fieldBounds.left = 6;
    environment.fieldBounds.right = 93;
    environment.fieldBounds.top = 77;
    environment.fieldBounds.bottom = 6;
  }
  if constexpr (requires { environment.goalBounds; }) {
    environment.goalBounds.left = 2;
    environment.goalBounds.right = 97;
    environment.goalBounds.top = 49;
    environment.goalBounds.bottom = 33;
  }
}

template <class E>
void set_last_ball(E& environment, const auto& ball) {
  if constexpr (requires { environment.lastBall; }) environment.lastBall = ball;
}

template <class E>
void set_display(E& environment) {
  static char display[4096];
  if constexpr (requires { environment.display; }) environment.display = display;
}

class OldTeam {
 public:
  explicit OldTeam(const mirocup_setup& setup) : setup_(setup) {
    std::memset(static_cast<void*>(&environment_), 0, sizeof environment_);
    side_ = MIROCUP_SIMUROSOT_SIDE;
    if (side_ == own) side_ = setup.team == MIROCUP_BLUE ? blue : yellow;
    const double sign = side_ == blue ? -1.0 : 1.0;
    frame_ =
        style == classic ? Frame{sign, 50.1189, 41.8061, inch} : Frame{sign, 110.0, 90.0, 0.01};
    set_bounds(environment_);
    set_display(environment_);
    char name[256] = {};  // for names that are longer than their 50 bytes
    if (side_ == blue) call(blue_name_c, blue_name_cpp, static_cast<char*>(name));
    if (side_ == yellow) call(yellow_name_c, yellow_name_cpp, static_cast<char*>(name));
    if (style == classic) call(create_c, create_cpp, &environment_);
  }

  void decide(const mirocup_observation& now, mirocup_command& command) {
    if (style == restart && now.state != MIROCUP_PLAY)
      return;  // it is not asked before the whistle
    show(now);
    const bool is_asked = style == restart ? call(run_c, run_cpp, &environment_)
                                           : call(strategy_c, strategy_cpp, &environment_);
    if (!is_asked) return;
    for (int i = 0; i < std::min<int>(now.robots, robots); ++i) {
      command.wheels[i] = wheels_for(setup_, now.own[i], environment_.home[i].velocityLeft,
                                     environment_.home[i].velocityRight);
    }
  }

  void place(const mirocup_observation& now, mirocup_placement& placement) {
    if (style != restart) return;
    const int mode = mode_of(now);
    if (mode == 0) return;
    Robot asked[robots], shown[robots], others[robots];
    std::memset(static_cast<void*>(asked), 0, sizeof asked);
    std::memset(static_cast<void*>(others), 0, sizeof others);
    for (int i = 0; i < robots; ++i) {
      put(asked[i], now.own, now.robots, i, -setup_.half_length - 0.2);
      put(others[i], now.opponent, now.robots, i, setup_.half_length + 0.2);
    }
    std::memcpy(static_cast<void*>(shown), asked, sizeof asked);
    Vector3D ball = {};
    put_at(ball, now.ball_x, now.ball_y);
    if (places_first(now)) {
      if (now.restart == MIROCUP_GOAL_KICK) place_ball(mode, ball, placement);
      call(former_c, former_cpp, mode, static_cast<Robot*>(asked));
    } else {
      call(later_c, later_cpp, mode, static_cast<Robot*>(others), ball, static_cast<Robot*>(asked));
    }
    for (int i = 0; i < std::min<int>(now.robots, robots); ++i) {
      if (!differs(asked[i], shown[i])) continue;
      placement.robots[i] = frame_.in(asked[i].pos.x, asked[i].pos.y, asked[i].rotation);
    }
  }

 private:
  template <class R>
  void put(R& to, const mirocup_robot* team, int count, int i, double behind) const {
    const Placed placed = frame_.out(robot_at(team, count, i, behind));
    to.pos.x = placed.x;
    to.pos.y = placed.y;
    to.rotation = placed.rotation;
  }

  template <class V>
  void put_at(V& to, double x, double y) const {
    const Placed placed = frame_.out(x, y, 0.0);
    to.x = placed.x;
    to.y = placed.y;
    to.z = 0.0;
  }

  void place_ball(int mode, Vector3D ball, mirocup_placement& placement) const {
    const Vector3D shown = ball;
    call(ball_c, ball_cpp, mode, &ball);
    if (!differs(ball, shown)) return;
    const mirocup_pose pose = frame_.in(ball.x, ball.y, 0.0);
    placement.ball_x = pose.x;
    placement.ball_y = pose.y;
  }

  // Everything is told anew, except what the team itself keeps there: its commands, predictedBall
  // and userData. While play is stopped the ball has no speed.
  void show(const mirocup_observation& now) {
    set_last_ball(environment_, environment_.currentBall);
    put_at(environment_.currentBall.pos, now.ball_x, now.ball_y);
    if (now.state != MIROCUP_PLAY || !has_seen_)
      set_last_ball(environment_, environment_.currentBall);
    has_seen_ = true;
    for (int i = 0; i < robots; ++i) {
      put(environment_.home[i], now.own, now.robots, i, -setup_.half_length - 0.2);
      put(opponents_in(environment_)[i], now.opponent, now.robots, i, setup_.half_length + 0.2);
    }
    const bool is_told = now.state != MIROCUP_PLAY || MIROCUP_SIMUROSOT_STICKY;
    environment_.gameState = is_told ? state_of(now.restart) : 0;
    const bool is_anyones = now.restart == MIROCUP_FREE_BALL || !is_told;
    set_whose_ball(environment_, is_anyones ? 0 : taker(now));
  }

  static long state_of(int how) {
    switch (how) {
      case MIROCUP_FREE_BALL:
        return 1;
      case MIROCUP_KICK_OFF:
        return 2;
      case MIROCUP_PENALTY_KICK:
        return 3;
      case MIROCUP_FREE_KICK:
        return 4;
      case MIROCUP_GOAL_KICK:
        return 5;
      default:
        return 0;
    }
  }

  int taker(const mirocup_observation& now) const {
    return now.own_restart != 0 ? side_ : blue + yellow - side_;
  }

  // The PlayMode of the restart; 0: the platform has none.
  int mode_of(const mirocup_observation& now) const {
    const int of_blue = taker(now) == blue ? 1 : 0;
    const Placed ball = frame_.out(now.ball_x, now.ball_y, 0.0);
    switch (now.restart) {
      case MIROCUP_FREE_BALL:
        return 1 + (ball.x > frame_.centre_x ? 2 : 0) + (ball.y > frame_.centre_y ? 0 : 1);
      case MIROCUP_KICK_OFF:
        return 5 + of_blue;
      case MIROCUP_PENALTY_KICK:
        return 7 + of_blue;
      case MIROCUP_GOAL_KICK:
        return 11 + of_blue;
      default:
        return 0;
    }
  }

  mirocup_setup setup_;
  Environment environment_;
  Frame frame_;
  int side_ = own;
  bool has_seen_ = false;
};

#else

// The platform's structures are in a namespace, as its own template has them, or in none.
#ifdef MIROCUP_SIMUROSOT_NAMESPACE
using MIROCUP_SIMUROSOT_NAMESPACE::Field;
using MIROCUP_SIMUROSOT_NAMESPACE::TeamInfo;
#define MIROCUP_PLATFORM(structure) "N" MIROCUP_SIMUROSOT_MANGLED structure "E"
#else
#define MIROCUP_PLATFORM(structure) structure
#endif

extern "C" {
void MIROCUP_TEAM_FUNCTION(info_c(TeamInfo*), "GetTeamInfo");
void MIROCUP_TEAM_FUNCTION(info_cpp(TeamInfo*), "_Z11GetTeamInfoP" MIROCUP_PLATFORM("8TeamInfo"));
void MIROCUP_TEAM_FUNCTION(instruct_c(Field*), "GetInstruction");
void MIROCUP_TEAM_FUNCTION(instruct_cpp(Field*), "_Z14GetInstructionP" MIROCUP_PLATFORM("5Field"));
void MIROCUP_TEAM_FUNCTION(place_c(Field*), "GetPlacement");
void MIROCUP_TEAM_FUNCTION(place_cpp(Field*), "_Z12GetPlacementP" MIROCUP_PLATFORM("5Field"));
void MIROCUP_TEAM_FUNCTION(event_c(int, void*), "OnEvent");
void MIROCUP_TEAM_FUNCTION(event_cpp(int, void*), "_Z7OnEvent" MIROCUP_PLATFORM("9EventType") "Pv");
}

template <class F, class... Arguments>
void call(F* in_c, F* in_cpp, Arguments... arguments) {
  F* function = in_c != nullptr ? in_c : in_cpp;
  if (function != nullptr) function(arguments...);
}

// What OnEvent gets with a call of the referee.
struct Judged {
  std::int32_t type = 0;   // JudgeType
  std::int32_t actor = 0;  // 0 self, 1 opponent
  wchar_t reason[128] = {};
};

// The platform has renamed members of Field: ourRobots, tickTotal and tickRound came first.
template <class F>
auto& own_robots_of(F& field) {
  if constexpr (requires { field.selfRobots; }) {
    return field.selfRobots;
  } else {
    return field.ourRobots;
  }
}

// `round`: ticks since the last restart.
template <class F>
void set_ticks(F& field, std::int32_t total, std::int32_t round) {
  if constexpr (requires { field.tick; }) field.tick = total;
  if constexpr (requires { field.tickTotal; }) field.tickTotal = total;
  if constexpr (requires { field.tickRound; }) field.tickRound = round;
}

class OldTeam {
 public:
  explicit OldTeam(const mirocup_setup& setup) : setup_(setup) {
    std::memset(static_cast<void*>(&field_), 0, sizeof field_);
    auto info = std::make_unique<TeamInfo>();
    call(info_c, info_cpp, info.get());
  }

  void decide(const mirocup_observation& now, mirocup_command& command) {
    tell(now);
    show(now);
    call(instruct_c, instruct_cpp, &field_);
    for (int i = 0; i < std::min<int>(now.robots, robots); ++i) {
      const auto& wheel = own_robots_of(field_)[i].wheel;
      command.wheels[i] = wheels_for(setup_, now.own[i], wheel.leftSpeed, wheel.rightSpeed);
    }
  }

  void place(const mirocup_observation& now, mirocup_placement& placement) {
    tell(now);
    show(now);
    Field asked = field_;
    call(place_c, place_cpp, &asked);
    for (int i = 0; i < std::min<int>(now.robots, robots); ++i) {
      const auto& wanted = own_robots_of(asked)[i];
      const auto& shown = own_robots_of(field_)[i];
      if (!differs(wanted.position, shown.position) && wanted.rotation == shown.rotation) continue;
      placement.robots[i] = frame_.in(wanted.position.x, wanted.position.y, wanted.rotation);
    }
    const bool own_goal_kick = now.restart == MIROCUP_GOAL_KICK && now.own_restart != 0;
    if (!own_goal_kick || !differs(asked.ball.position, field_.ball.position)) return;
    const mirocup_pose ball = frame_.in(asked.ball.position.x, asked.ball.position.y, 0.0);
    placement.ball_x = ball.x;
    placement.ball_y = ball.y;
  }

 private:
  template <class R>
  void put(R& to, const mirocup_robot* team, int count, int i, double behind) const {
    const Placed placed = frame_.out(robot_at(team, count, i, behind));
    to.position.x = static_cast<float>(placed.x);
    to.position.y = static_cast<float>(placed.y);
    to.rotation = static_cast<float>(placed.rotation);
  }

  void show(const mirocup_observation& now) {
    const Placed ball = frame_.out(now.ball_x, now.ball_y, 0.0);
    field_.ball.position.x = static_cast<float>(ball.x);
    field_.ball.position.y = static_cast<float>(ball.y);
    for (int i = 0; i < robots; ++i) {
      put(own_robots_of(field_)[i], now.own, now.robots, i, -setup_.half_length - 0.2);
      put(field_.opponentRobots[i], now.opponent, now.robots, i, setup_.half_length + 0.2);
    }
    set_ticks(field_, static_cast<std::int32_t>(now.tick),
              static_cast<std::int32_t>(now.tick - restarted_));
  }

  // Tells of the match, of a half and of a restart when they begin.
  void tell(const mirocup_observation& now) {
    if (!was_told_) event(1);
    if (!was_told_ || now.phase != phase_) {
      constexpr int starts[] = {3, 4, 5, 6};  // first half, second half, overtime, shoot-out
      event(starts[now.phase & 3]);
    }
    was_told_ = true;
    phase_ = now.phase;
    const bool is_ready = now.state == MIROCUP_READY;
    if (is_ready && !was_ready_) {
      restarted_ = now.tick;
      tell_restart(now);
    }
    was_ready_ = is_ready;
  }

  static void event(int type, void* argument = nullptr) {
    call(event_c, event_cpp, type, argument);
  }

  void tell_restart(const mirocup_observation& now) const {
    Judged judged;
    judged.actor = now.own_restart != 0 ? 0 : 1;
    const Placed ball = frame_.out(now.ball_x, now.ball_y, 0.0);
    switch (now.restart) {
      case MIROCUP_KICK_OFF:
        judged.type = 0;
        break;
      case MIROCUP_GOAL_KICK:
        judged.type = 1;
        break;
      case MIROCUP_PENALTY_KICK:
        judged.type = 2;
        break;
      case MIROCUP_FREE_BALL:  // mirocup names the defender, this platform the attacker
        judged.actor = 1 - judged.actor;
        judged.type = 3 + (ball.x > 0.0 ? 0 : 2) + (ball.y > 0.0 ? 0 : 1);
        break;
      default:
        return;
    }
    event(0, &judged);
  }

  mirocup_setup setup_;
  Field field_;
  // Every team sees itself at the right, unless it was written for a platform that turned yellow.
  Frame frame_{MIROCUP_SIMUROSOT_SIDE == yellow ? 1.0 : -1.0, 0.0, 0.0, 0.01};
  bool was_told_ = false;
  bool was_ready_ = false;
  int phase_ = 0;
  decltype(mirocup_observation::tick) restarted_ = 0;
};

#endif

// A team that was created, and the one before it. They stay reachable until the program ends: they
// are kept, and a checker of leaks must not take them for lost.
struct Kept {
  OldTeam team;
  const Kept* before;
};
const Kept* latest = nullptr;

void* create(const mirocup_setup* setup) {
  auto* kept = new Kept{OldTeam(*setup), latest};
  latest = kept;
  return &kept->team;
}

void decide(void* team, const mirocup_observation* now, mirocup_command* command) {
  mirocup_simurosot_set_time(now->time);
  static_cast<OldTeam*>(team)->decide(*now, *command);
}

void place(void* team, const mirocup_observation* now, mirocup_placement* placement) {
  mirocup_simurosot_set_time(now->time);
  static_cast<OldTeam*>(team)->place(*now, *placement);
}

}  // namespace

// Destroy is never called: the platform did not, either, and some teams do not survive it.
extern "C" MIROCUP_PUBLIC const mirocup_strategy* mirocup_entry(void) {
  static const mirocup_strategy entry{
      MIROCUP_ABI_VERSION,
      sizeof(mirocup_strategy),
      MIROCUP_SIMUROSOT_NAME,
      create,
      decide,
      nullptr,
      style == classic || !MIROCUP_SIMUROSOT_PLACING ? nullptr : place};
  return &entry;
}
#endif
