// SPDX-License-Identifier: MIT
//
// A team in C++: derive a class from Team and export it.
//
//   using namespace mirocup::strategy;
//   class Mine : public Team {
//    public:
//     using Team::Team;
//     void decide(const Observation& now, Command& command) override {
//       for (int i = 0; i < now.robots; ++i) {
//         command.wheels[i] = drive_to(setup(), now.own[i], {now.ball_x, now.ball_y});
//       }
//     }
//   };
//   MIROCUP_EXPORT_TEAM(Mine, "mine")
//
// Frames, units, delays and limits are those of strategy.h. All functions are inline and keep
// nothing between two calls. The functions are in types.hpp, driving.hpp, laws.hpp and here. This
// header includes the other three.
//
//   numbers     math::sin(x) and its family, with the same bits everywhere; math::min(a, b),
//               max(a, b), clamp(x, low, high)
//   points      Point{x, y} with + - *; dot(a, b), length(a), unit(a); wrapped(angle),
//               squared(heading)
//   the scene   ball(now), ball_velocity(now), position(robot), ball_after(now, seconds),
//               meeting_point(setup, now, robot, pace = 1.2), must_kick_off(now),
//               is_stuck(now, patience = 0.6), middle_of_goal_view(setup, ball),
//               rolls_into_own_goal(setup, ball, velocity, margin),
//               would_turn_ball_in(setup, now, robot, soon_s = 0.4)
//   places      inside(setup, point), inside(setup, point, margin), keep_out(setup, i, point),
//               make_way(setup, now, point); distances: elbow_room(setup), behind_ball(setup)
//   one robot   wheels_for(setup, forward, turn), turn_to(setup, robot, heading),
//               drive_to(setup, robot, point, arrival = 0, fastest = 1.5),
//               drive_to_pose(setup, robot, point, heading, fastest = 1.5),
//               drive_round(setup, robot, point, obstacle, arrival, fastest),
//               drive_clear(setup, now, robot, point, arrival = 0, fastest = 1.5),
//               slide_to(setup, robot, y, fastest = 1.5)
//   its role    keep_goal(setup, now, robot), kick_to(setup, now, robot, point, pace = 1.5),
//               kick_off(setup, robot), free_ball(setup, now, robot)
//   the laws    keep_laws(setup, now, command), avoid_own_goals(setup, now, command); for one robot
//               without_pushing(setup, now, robot, wheels), out_of_area(setup, i, robot, wheels)
//   a team      Team: decide(), place(), setup(), random(), parameter("name", default),
//               log("format", values...), draw_line, draw_circle, draw_polygon, draw_text,
//               draw_value
//
// The folder skills/ beside this header has stronger functions: read attack.hpp first. Functions
// that drive return the wheel speeds of one robot for this tick; call them again in every tick. The
// functions of this header are good enough to start from: copy and improve them.
#pragma once

#if __cplusplus < 202002L
#error "mirocup/strategy.hpp is C++20: compile with -std=c++20"
#endif

#include "mirocup/laws.hpp"

#include <cmath>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <initializer_list>

// Lets the compiler check the arguments of a function against its format, as it does for printf().
#if defined(__GNUC__)
#define MIROCUP_PRINTF(form, first) __attribute__((format(printf, form, first)))
#else
#define MIROCUP_PRINTF(form, first)
#endif

namespace mirocup::strategy {

// Kicks the ball towards a point: drives first to a place behind the ball, then through the ball.
// The point may lie behind the goal line; the middle of the opponents' goal is {half_length, 0}.
inline Wheels kick_to(const Setup& setup, const Observation& now, const Robot& robot, Point point,
                      double pace = 1.5) {
  const Point meet = meeting_point(setup, now, robot);
  const Point along = unit(point - meet);
  const Point from_ball = position(robot) - meet;
  const double behind = -dot(from_ball, along);
  const double aside = from_ball.y * along.x - from_ball.x * along.y;
  if (behind > 0.0 && behind < 0.35 && std::abs(aside) < 0.02 + 0.35 * behind) {
    const Point through = meet + 0.3 * along - (2.0 * aside) * Point{-along.y, along.x};
    return drive_to(setup, robot, through, pace, pace);
  }
  return drive_clear(setup, now, robot, inside(setup, meet - behind_ball(setup) * along), 0.3,
                     pace);
}

// True if the ball is still on the spot of your own kick-off. Your first touch must play it back.
inline bool must_kick_off(const Observation& now) {
  return now.restart == MIROCUP_KICK_OFF && now.own_restart != 0 &&
         math::hypot(now.ball_x, now.ball_y) < 0.055;
}

// Takes a kick-off: rolls the ball back to the team-mates, as the law wants it. A robot that is
// not in front of the ball, on its +x side, first drives round it. Under `hall` the ball of a
// placed robot stops before the own goal line if nobody touches it. A ball that stays near the
// centre would go to the opponents: their kicker waits on the side of the ball from which it can
// shoot, while the taker must first go round the ball. Rules without a limit for a held ball
// (vsss, simurosot) let the kick-off go anywhere: there the robot drives through the ball from any
// place.
inline Wheels kick_off(const Setup& setup, const Robot& robot) {
  const Point out = unit(position(robot));
  const double distance = length(position(robot));
  const double near = setup.robot_side + 0.025;  // m
  const double away = dot(out, {math::cos(robot.heading), math::sin(robot.heading)});
  // How well robot, ball and home must be in line, as a cosine. The face of a robot looks at most
  // 45 degrees past the ball. Only a robot that is pushing the ball is nearer than the first limit.
  const double touching = setup.robot_side / 2.0 + setup.ball_radius;
  const double in_line = distance < touching ? 0.0 : distance < near ? 0.7 : 0.9;
  const bool is_free = std::isinf(setup.time_limit_s[MIROCUP_KEEPER_HOLD]);
  if (is_free || (out.x > in_line && std::abs(away) > in_line)) {
    // Drives through the ball, and fast, because the opponents drive at the ball.
    const double pace = distance < near ? 0.28 : is_free ? 0.8 : 0.4;  // m/s
    return drive_to(setup, robot, -0.1 * out, pace, pace);
  }
  if (out.x > in_line) return turn_to(setup, robot, math::atan2(-out.y, -out.x));
  // A robot that turned beside the ball would touch it.
  if (distance < near - 0.02) return wheels_for(setup, away < 0.0 ? -0.5 : 0.5, 0.0);
  const Point round{out.x + 1.7 * std::abs(out.y), out.y - std::copysign(1.7, out.y) * out.x};
  const Point to = near * round - position(robot);
  const double error = wrapped(math::atan2(to.y, to.x) - robot.heading);
  // Beside the robot, where it could go either way, it would otherwise stay for ever.
  const double forward = math::cos(error);
  return wheels_for(setup, 0.6 * forward, 9.0 * (forward < -0.3 ? wrapped(error + pi) : error));
}

// Returns the y, m, of the place on the own goal line from which a keeper covers the goal: the
// bisector of the angle between the two posts, as seen from the ball, meets the line there.
inline double middle_of_goal_view(const Setup& setup, Point ball) {
  const double left = length(ball - Point{-setup.half_length, setup.goal_half_width});
  const double right = length(ball - Point{-setup.half_length, -setup.goal_half_width});
  return setup.goal_half_width * (right - left) / (right + left);
}

// Frees a stuck ball: drives to the ball, then spins beside it, so that a corner of the robot
// throws the ball forward or, near the opponents' end, towards the middle of their goal.
inline Wheels free_ball(const Setup& setup, const Observation& now, const Robot& robot) {
  const Point to = ball(now) - position(robot);
  const double beside = setup.robot_side / 2.0 + 0.0325;  // m
  if (length(to) > beside) return drive_to(setup, robot, ball(now), 0.6, 1.2);
  Point way{1.0, 0.0};
  if (now.ball_x > 0.3 * setup.half_length) {
    way = Point{setup.half_length - 0.18, 0.0} - ball(now);
  } else if (now.ball_x < -setup.half_length + 0.06) {
    way = {0.3, now.ball_y < 0.0 ? -1.0 : 1.0};
  }
  const bool is_left = to.x * way.y - to.y * way.x > 0.0;
  return wheels_for(setup, 0.0, is_left ? 30.0 : -30.0);
}

// Keeps the goal: the robot stays in the mouth of the goal, where the ball will meet its face, and
// kicks a slow ball in the goal area away from the goal. A ball that rolls along the end wall meets
// the middle of the keeper's face; if the keeper stood farther out, such a ball would meet a corner
// and turn the keeper aside.
inline Wheels keep_goal(const Setup& setup, const Observation& now, const Robot& robot) {
  const double line = -setup.half_length + 0.4 * setup.robot_side;
  const Point here = position(robot);
  const Point away = ball(now) - here;

  const double outwards = now.ball_y < 0.0 ? -1.0 : 1.0;
  const bool is_slow = length(ball_velocity(now)) < 0.4;
  const bool is_in_reach = now.ball_x > here.x + 0.02 && length(away) < setup.robot_side + 0.085 &&
                           now.ball_x < -setup.half_length + setup.goal_area_depth + 0.02;
  const bool is_outer = away.x > 0.6 * setup.robot_side || outwards * away.y > -0.02;
  if (is_slow && is_in_reach && is_outer) {
    return drive_to(setup, robot, ball(now) + 0.2 * unit(away), 1.0);
  }
  // A ball at the end wall beside the keeper: an attacker would push it in past the near post, and
  // the keeper with it, so the keeper pushes outwards with all its force, but not past the post.
  const double gap = outwards * away.y;
  const double inside_post = setup.goal_half_width - outwards * here.y;
  if (away.x < 0.03 && std::abs(here.x - line) < 0.04 && gap > 0.4 * setup.robot_side &&
      gap < setup.robot_side && inside_post > 0.02 && inside_post < 0.1) {
    return slide_to(setup, robot, here.y + 0.3 * outwards, 1.8);
  }
  // If the ball comes, the keeper goes to the y at which the ball will meet the face that looks
  // into the field; otherwise to middle_of_goal_view(). If the keeper waited where the ball would
  // cross the goal line, a ball from the side would meet another face, which would turn the ball
  // into the goal.
  const double face = line + setup.robot_side / 2.0 + setup.ball_radius;
  double y = middle_of_goal_view(setup, ball(now));
  if (now.ball_vx < -0.1) {
    const double seconds = (face - now.ball_x) / now.ball_vx;
    if (seconds > 0.0 && seconds < 1.5) y = now.ball_y + now.ball_vy * seconds;
  }
  const double reach = setup.goal_half_width - (setup.robot_side / 2.0 + 0.001);
  const Point post{line, math::clamp(y, -reach, reach)};
  if (std::abs(post.x - here.x) < 0.04 && std::abs(here.y) < setup.goal_half_width + 0.05) {
    return slide_to(setup, robot, post.y, 1.8);
  }
  return drive_round(setup, robot, post, ball(now), 0.0, 1.5);
}

// Returns the value of the parameter `name`, or `fallback` if the leg does not give this parameter
// to the team, or if a test has made the setup. See "Parameters" in strategy.h.
inline double parameter(const Setup& setup, const char* name, double fallback) {
  if (setup.parameter == nullptr) return fallback;
  return setup.parameter(setup.host, name, fallback);
}

// These functions draw into the replay of `mirocup match --thoughts`; with the setup of a test they
// have no effect. `setup` is setup() of a Team. Points are in your own frame, m; colours are
// 0xRRGGBBAA; the page can switch a layer off. See "Thoughts" in strategy.h. draw.hpp in
// mirocup/skills draws targets, roles and shots with these functions.
inline void draw_line(const Setup& setup, const char* layer, std::uint32_t colour, Point from,
                      Point to) {
  if (setup.draw_line == nullptr) return;
  setup.draw_line(setup.host, layer, colour, from.x, from.y, to.x, to.y);
}
inline void draw_circle(const Setup& setup, const char* layer, std::uint32_t colour, Point centre,
                        double radius) {
  if (setup.draw_circle == nullptr) return;
  setup.draw_circle(setup.host, layer, colour, centre.x, centre.y, radius);
}
inline void draw_polygon(const Setup& setup, const char* layer, std::uint32_t colour,
                         std::initializer_list<Point> corners) {
  static_assert(sizeof(Point) == 2 * sizeof(double));
  if (setup.draw_polygon == nullptr || corners.size() == 0) return;
  setup.draw_polygon(setup.host, layer, colour, &corners.begin()->x,
                     static_cast<std::int32_t>(corners.size()));
}
inline void draw_text(const Setup& setup, const char* layer, std::uint32_t colour, Point at,
                      const char* text) {
  if (setup.draw_text == nullptr) return;
  setup.draw_text(setup.host, layer, colour, at.x, at.y, text);
}

// The base class of a team in C++: keeps the setup, and has random numbers from the setup's seed.
class Team {
 public:
  explicit Team(const Setup& setup) : setup_(setup), random_(setup.seed) {}
  virtual ~Team() = default;

  // Sets the wheel speeds of this tick; all are 0 when decide() is called.
  virtual void decide(const Observation& now, Command& command) = 0;

  // Chooses the places of the robots at a restart, and of the ball at an own kick-off or goal kick.
  // strategy.h says which places are allowed. A body whose pose you do not change stays.
  virtual void place(const Observation& now, Placement& placement) {
    (void)now;
    (void)placement;
  }

 protected:
  const Setup& setup() const { return setup_; }
  Random& random() { return random_; }

  // Returns the value of the parameter `name`, or `fallback` if the leg does not give it. Read
  // a parameter once, into a member of your team: `const double wait_ = parameter("wait", 0.45);`
  double parameter(const char* name, double fallback) const {
    return strategy::parameter(setup_, name, fallback);
  }

  // Writes a line to the log of the leg. With values, as in log("ball at %.2f", now.ball_x), the
  // first argument is a format of printf(). The compiler checks it, and the line is cut after 255
  // bytes. Without values the text is written unchanged, percent signs included.
  void log(const char* text) const { setup_.log(setup_.host, text); }
  // This function is a template only so that a call without values selects the overload above.
  template <int = 0>
  MIROCUP_PRINTF(2, 3)
  void log(const char* format, ...) const {
    char line[256];
    std::va_list values;
    va_start(values, format);
    std::vsnprintf(line, sizeof line, format, values);
    va_end(values);
    setup_.log(setup_.host, line);
  }

  // The drawing functions above this class, with the setup of this team.
  void draw_line(const char* layer, std::uint32_t colour, Point from, Point to) const {
    strategy::draw_line(setup_, layer, colour, from, to);
  }
  void draw_circle(const char* layer, std::uint32_t colour, Point centre, double radius) const {
    strategy::draw_circle(setup_, layer, colour, centre, radius);
  }
  void draw_polygon(const char* layer, std::uint32_t colour,
                    std::initializer_list<Point> corners) const {
    strategy::draw_polygon(setup_, layer, colour, corners);
  }
  void draw_text(const char* layer, std::uint32_t colour, Point at, const char* text) const {
    strategy::draw_text(setup_, layer, colour, at, text);
  }
  // The replay shows the value as a curve over time. The name has at most 31 bytes.
  void draw_value(const char* name, double value) const {
    constexpr std::uint32_t invisible = 0;
    char text[64];
    std::snprintf(text, sizeof text, "%.31s = %.6g", name, value);
    draw_text("values", invisible, {0.0, 0.0}, text);
  }

 private:
  Setup setup_;
  Random random_;
};

// True if T::place() takes the placement by reference, as Team::place() does.
template <class T>
concept places_by_reference = requires {
  static_cast<void (T::*)(const Observation&, Placement&)>(&T::place);
};

}  // namespace mirocup::strategy

// Exports a class as the team of the library. The constructor of the class takes the setup. The
// assertion rejects a place() that takes a copy of the placement, because changes of the copy would
// have no effect.
#define MIROCUP_EXPORT_TEAM(Class, Name)                                               \
  static_assert(mirocup::strategy::places_by_reference<Class>,                         \
                "declare it: void place(const Observation&, Placement&) override");    \
  extern "C" MIROCUP_PUBLIC const mirocup_strategy* mirocup_entry(void) {              \
    static const mirocup_strategy entry = {                                            \
        MIROCUP_ABI_VERSION,                                                           \
        sizeof(mirocup_strategy),                                                      \
        Name,                                                                          \
        [](const mirocup_setup* setup) -> void* { return new Class(*setup); },         \
        [](void* team, const mirocup_observation* now, mirocup_command* command) {     \
          static_cast<Class*>(team)->decide(*now, *command);                           \
        },                                                                             \
        [](void* team) { delete static_cast<Class*>(team); },                          \
        [](void* team, const mirocup_observation* now, mirocup_placement* placement) { \
          static_cast<Class*>(team)->place(*now, *placement);                          \
        }};                                                                            \
    return &entry;                                                                     \
  }
