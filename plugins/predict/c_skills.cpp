// SPDX-License-Identifier: MIT
//
// skills.h: the functions of strategy.hpp and the skills, as C calls them. It needs no C++ library,
// so that a team in C links it with a C compiler.
#include "mirocup/skills/attack.hpp"
#include "mirocup/skills/filter.hpp"
#include "mirocup/skills/hold_goal.hpp"
#include "mirocup/skills/laws.hpp"
#include "mirocup/skills/penalty.hpp"
#include "mirocup/skills/roles.hpp"
#include "mirocup/skills/worth.hpp"
#include "plugins/predict/c_calls.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <new>
#include <optional>
#include <type_traits>

using strategy::Point;

namespace {

struct Cpp : SameInCpp {
  using SameInCpp::of;
  static const char* of(const char* text) { return text; }
  static Point of(mirocup_point p) { return {p.x, p.y}; }
  static strategy::MovingBall of(mirocup_ball b) { return {of(b.at), of(b.velocity)}; }
  static strategy::Target of(mirocup_pose p) { return {{p.x, p.y}, p.heading}; }
  static strategy::Shot of(mirocup_shot s) {
    return {of(s.at), of(s.along), s.aside, s.is_on_line != 0};
  }
};

// A yes or no is 1 or 0 in C.
struct C : SameInC {
  using SameInC::of;
  static mirocup_point of(Point p) { return {p.x, p.y}; }
  static mirocup_ball of(strategy::MovingBall b) { return {of(b.at), of(b.velocity)}; }
  static mirocup_pose of(strategy::Target t) { return {t.at.x, t.at.y, t.heading}; }
  static mirocup_crossing of(strategy::Crossing c) { return {c.seconds, c.y, c.is_ahead}; }
  static mirocup_interception of(strategy::Interception i) {
    return {of(i.ball), i.seconds, i.is_reached};
  }
  static mirocup_shot of(strategy::Shot s) {
    return {of(s.at), of(s.along), s.aside, s.is_on_line};
  }
  static double of(std::optional<double> x) {
    return x.value_or(std::numeric_limits<double>::quiet_NaN());
  }
};

using S = const mirocup_setup*;
using O = const mirocup_observation*;
using R = const mirocup_robot*;
using P = mirocup_point;
using I = std::int32_t;
using D = double;

// What remembers has malloc() and free(), because operator new is of the C++ library.
template <class T>
T* made(const auto&... arguments) {
  void* room = std::malloc(sizeof(T));
  return room == nullptr ? nullptr : new (room) T(arguments...);
}
void destroy(auto* object) {
  static_assert(std::is_trivially_destructible_v<std::remove_pointer_t<decltype(object)>>);
  std::free(object);
}

}  // namespace

struct mirocup_filter : strategy::Filter {
  using Filter::Filter;
};
struct mirocup_penalty : strategy::PenaltyTaker {};

extern "C" {

// SKILLS

// ---- those whose C++ function takes something else

double mirocup_field_heading(P here, mirocup_pose pose, D radius, D smooth) {
  return strategy::field_heading({radius, smooth}, Cpp::of(here), Cpp::of(pose));
}
double mirocup_around(D heading, P here, P velocity, mirocup_ball moving, D nearest, D width,
                      D lead_s) {
  return strategy::around(heading, Cpp::of(here), Cpp::of(velocity),
                          {Cpp::of(moving.at), Cpp::of(moving.velocity)}, {nearest, width, lead_s});
}
mirocup_wheels mirocup_follow_field(S setup, R robot, mirocup_pose pose, D speed,
                                    const mirocup_ball* obstacles, I count, D radius, D smooth,
                                    D lead_s) {
  strategy::Obstacle others[2 * MIROCUP_MAX_ROBOTS];
  int used = 0;
  for (int k = 0; k < count && used < 2 * MIROCUP_MAX_ROBOTS; ++k)
    others[used++] = {Cpp::of(obstacles[k].at), Cpp::of(obstacles[k].velocity)};
  return strategy::follow_field(*setup, *robot, Cpp::of(pose), speed, others, used,
                                {radius, smooth}, lead_s);
}
double mirocup_holding_y(S setup, O now, D line, D inside_post) {
  const strategy::BallPath path(*setup, strategy::moving_ball(*now));
  return strategy::holding_y(*setup, *now, path, {line, inside_post});
}
mirocup_wheels mirocup_hold_goal(S setup, O now, R robot, D line, D inside_post, D slow,
                                 D patience) {
  const strategy::BallPath path(*setup, strategy::moving_ball(*now));
  return strategy::hold_goal(*setup, *now, path, *robot, {line, inside_post, slow, patience});
}
std::int32_t mirocup_cheapest_robot(O now, I first, I last, D bonus, const double* costs) {
  return strategy::cheapest_robot(*now, first, last, bonus, [&](int i) { return costs[i]; });
}
void mirocup_assign_places(O now, const mirocup_point* places, const std::int32_t* free,
                           const std::int32_t* last, I count, D bonus, std::int32_t* chosen) {
  Point points[MIROCUP_MAX_ROBOTS];
  strategy::Assignment before{};
  const int used = count < MIROCUP_MAX_ROBOTS ? count : MIROCUP_MAX_ROBOTS;
  for (int k = 0; k < used; ++k) {
    points[k] = Cpp::of(places[k]);
    before[static_cast<std::size_t>(k)] = last[k];
  }
  const auto size = static_cast<std::size_t>(used);
  const strategy::Assignment now_chosen =
      strategy::assign_places(*now, {points, size}, {free, size}, before, bonus);
  for (int k = 0; k < used; ++k) chosen[k] = now_chosen[static_cast<std::size_t>(k)];
}
double mirocup_out_of_reach(R robots, I count, P ball) {
  return strategy::out_of_reach(robots, count, Cpp::of(ball));
}

void mirocup_filter_see(mirocup_filter* filter, O seen, I ticks_ahead, mirocup_observation* now) {
  *now = filter->see(*seen, ticks_ahead);
}

}  // extern "C"
