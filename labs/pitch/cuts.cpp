// SPDX-License-Identifier: MIT
#include "labs/pitch/cuts.hpp"

#include "core/base/math.hpp"
#include "core/simulator/collision/collision_queries.hpp"
#include "core/simulator/collision/static_world.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace mirocup::pitch {

namespace {

using simulator::BodyState;

constexpr double longest_roll = 2.05;     // s
constexpr double longest_drive = 0.5;     // s
constexpr double soon = 0.25;             // s, at most, from the start of a window to its hit
constexpr double after_hit = 0.25;        // s, until it ends
constexpr int fewest_pictures = 10;       // of a window
constexpr int fewest_before = 6;          // of them before its hit
constexpr int fewest_after = 4;           // and after it
constexpr double apart = 0.02;            // m: a body this near may touch between two pictures
constexpr double together = 0.006;        // m: it touches, as far as pictures tell
constexpr double memory = 0.2;            // s, for which wheels may go on sliding
constexpr double short_memory = 0.1;      // s: of meetings
constexpr int pictures_of_state = 8;      // from which speeds are estimated
constexpr double gentle_turn = 2.9;       // m/s^2: wheels of a grip of 0.3 hold
constexpr double straight_enough = 0.08;  // m/s sideways: less is the camera's noise
constexpr std::array<double, 3> between{0.33, 0.67, 1.0};  // of the way from picture to picture

bool turns_hard(const simulator::Twist& v) {
  return std::abs(v.forward * v.omega) > gentle_turn;
}

// Which pictures of a body are in a window already.
class Taken {
 public:
  explicit Taken(const Footage& footage)
      : taken_(static_cast<std::size_t>(footage.bodies()),
               std::vector<char>(static_cast<std::size_t>(footage.frames()), 0)) {}

  bool has(int body, int frame) const { return taken_[body][frame] != 0; }
  bool has(const std::vector<int>& bodies, int frame) const {
    return std::any_of(bodies.begin(), bodies.end(), [&](int body) { return has(body, frame); });
  }
  void add(const Window& window) {
    for (const int body : window.bodies)
      std::fill(taken_[body].begin() + window.first, taken_[body].begin() + window.last + 1, 1);
  }

 private:
  std::vector<std::vector<char>> taken_;
};

class Cutter {
 public:
  Cutter(const Footage& footage, const simulator::Parameters& p)
      : footage_(footage),
        world_(simulator::collision::make_static_world(&footage.field(), p, simulator::Tolerances{},
                                                       footage.bodies() - 1, true)),
        robot_radius_(robot_outline(p).radius),
        ball_radius_(p.ball_radius),
        can_slide_(p.grip != simulator::infinite_grip) {}

  bool is_ball(int body) const { return body == footage_.ball(); }

  // True if two bodies are nearer than `gap` in a picture, or on the way to it.
  bool are_near(int i, int j, int frame, double gap_of_both) const;
  // True if the circle around a body is nearer to a wall.
  bool is_at_wall(int body, int frame, double gap_of_both) const;
  // True if a robot touches a wall in a picture, or will before the next one.
  bool hits_wall(int robot, int frame) const;
  // True if no other body than those is near one of them.
  bool are_alone(const std::vector<int>& bodies, int frame) const;
  // True if the wheels of a robot hold at the start of a window, and have held for long enough.
  bool holds(int robot, int frame, double seconds) const;
  std::optional<simulator::Twist> middle_twist(int robot, int first, int count) const;
  // Returns the window from a picture on: it ends before another body comes near, and before a
  // picture that is in another window.
  Window grow(int first, std::vector<int> bodies, double seconds, const Taken& taken) const;
  // Returns the window of a hit in a picture: it begins as early before as it may. It begins with
  // wheels that hold, if there is such a picture.
  std::optional<Window> around(int hit, const std::vector<int>& bodies, double wheels_held,
                               const Taken& taken) const;
  // True if each body is seen often enough, and robots have commands.
  bool is_usable(const Window& window) const;

 private:
  double gap_to_wall(int body, int frame) const;
  // True if bodies can be set down in a picture: they are seen, and touch nothing.
  bool stand_free(const std::vector<int>& bodies, int frame) const;
  BodyState state(int body, int frame) const {
    const Footage::Sight& s = footage_.sight(body, frame);
    return {s.position, Heading::from_angle(s.heading), {}};
  }
  double reach(int body) const { return is_ball(body) ? ball_radius_ : robot_radius_; }
  bool follows(int frame) const { return !footage_.is_broken(frame - 1, frame); }

  const Footage& footage_;
  simulator::collision::StaticWorld world_;
  double robot_radius_, ball_radius_;
  bool can_slide_;
};

bool Cutter::are_near(int i, int j, int frame, double limit) const {
  const Footage::Sight& a = footage_.sight(i, frame);
  const Footage::Sight& b = footage_.sight(j, frame);
  if (!a.is_seen || !b.is_seen) return false;
  const bool moves =
      frame > 0 && footage_.sight(i, frame - 1).is_seen && footage_.sight(j, frame - 1).is_seen;
  const double way =
      moves ? (a.position - b.position -
               (footage_.sight(i, frame - 1).position - footage_.sight(j, frame - 1).position))
                  .norm()
            : 0.0;
  if ((a.position - b.position).norm() > reach(i) + reach(j) + limit + way) return false;
  const auto on_the_way = [&](int body, double share) {
    BodyState now = state(body, frame);
    if (!moves) return now;
    const Footage::Sight& before = footage_.sight(body, frame - 1);
    const Footage::Sight& after = footage_.sight(body, frame);
    now.position = before.position + share * (after.position - before.position);
    now.heading = Heading::from_angle(before.heading + share * (after.heading - before.heading));
    return now;
  };
  return std::any_of(between.begin(), between.end(), [&](double share) {
    return gap(world_, {std::max(i, j), std::min(i, j)}, on_the_way(std::max(i, j), share),
               on_the_way(std::min(i, j), share)) < limit;
  });
}

bool Cutter::is_at_wall(int body, int frame, double limit) const {
  if (!footage_.sight(body, frame).is_seen) return false;
  const Vec2 seen = footage_.sight(body, frame).position;
  const Vec2 at{std::abs(seen.x()), std::abs(seen.y())};
  const field::Field& field = footage_.field();
  const double inside = reach(body) + limit;
  return at.x() > field.half_length - inside || at.y() > field.half_width - inside ||
         at.x() + at.y() >
             field.half_length + field.half_width - field.corner_leg - inside * std::sqrt(2.0);
}

double Cutter::gap_to_wall(int body, int frame) const {
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < simulator::plane_walls + simulator::end_walls; ++k) {
    least = std::min(least, gap(world_, simulator::pair_with_obstacle(body, k), state(body, frame),
                                BodyState{}));
  }
  return least;
}

bool Cutter::hits_wall(int robot, int frame) const {
  if (frame == 0 || !footage_.sight(robot, frame - 1).is_seen || !is_at_wall(robot, frame, apart))
    return false;
  const double now = gap_to_wall(robot, frame);
  return std::min(now, 2.0 * now - gap_to_wall(robot, frame - 1)) < together;
}

bool Cutter::stand_free(const std::vector<int>& bodies, int frame) const {
  return std::all_of(bodies.begin(), bodies.end(), [&](int body) {
    return footage_.sight(body, frame).is_seen && are_alone({body}, frame) &&
           gap_to_wall(body, frame) > together;
  });
}

bool Cutter::are_alone(const std::vector<int>& bodies, int frame) const {
  for (const int body : bodies) {
    for (int other = 0; other < footage_.bodies(); ++other) {
      const bool is_member = std::find(bodies.begin(), bodies.end(), other) != bodies.end();
      if (!is_member && are_near(body, other, frame, apart)) return false;
    }
  }
  return true;
}

bool Cutter::holds(int robot, int frame, double seconds) const {
  if (!can_slide_) return true;
  const double period = footage_.usual_period();
  const int past = static_cast<int>(std::ceil(seconds / period));
  if (frame <= past) return false;
  for (int f = frame - past; f < frame; ++f) {
    if (!follows(f + 1) || is_at_wall(robot, f, 0.0) || !are_alone({robot}, f)) return false;
  }
  const int count = std::clamp(static_cast<int>(0.14 / period), 5, pictures_of_state);
  const auto last = footage_.state_at(robot, frame - 1, -count, 2);
  if (!last || turns_hard(last->state.twist)) return false;
  for (int f = frame - count; f > 0 && f > frame - past - count; f -= count / 2) {
    const auto middle = middle_twist(robot, f, count);
    if (!middle || turns_hard(*middle)) return false;
    // Wheels that hold then, and do not turn hard until the start, hold at the start.
    if (f == frame - count && std::abs(middle->left) > straight_enough) return false;
  }
  return true;
}

// Returns the twist in the middle of some pictures: there a parabola through them tells speeds
// several times as well as at its ends.
std::optional<simulator::Twist> Cutter::middle_twist(int robot, int first, int count) const {
  const int last = first + count - 1;
  const auto a = footage_.state_at(robot, first, count, 2);
  const auto b = footage_.state_at(robot, last, -count, 2);
  if (!a || !b) return std::nullopt;
  const double span = footage_.time(last) - footage_.time(first);
  const double turned =
      std::remainder(b->state.heading.angle() - a->state.heading.angle(), 2.0 * pi);
  const double bend = (b->state.twist.omega - a->state.twist.omega) / (2.0 * span);
  const Heading heading =
      Heading::from_angle(a->state.heading.angle() + 0.5 * turned - 0.25 * bend * span * span);
  const auto velocity = [](const BodyState& s) {
    return s.heading.to_world({s.twist.forward, s.twist.left});
  };
  const Vec2 own = heading.to_body(0.5 * (velocity(a->state) + velocity(b->state)));
  return simulator::Twist{own.x(), own.y(), 0.5 * (a->state.twist.omega + b->state.twist.omega)};
}

Window Cutter::grow(int first, std::vector<int> bodies, double seconds, const Taken& taken) const {
  Window window{first, first, std::move(bodies)};
  while (window.last + 1 < footage_.frames() && follows(window.last + 1) &&
         footage_.time(window.last + 1) - footage_.time(first) < seconds &&
         !taken.has(window.bodies, window.last + 1) && are_alone(window.bodies, window.last + 1))
    ++window.last;
  return window;
}

std::optional<Window> Cutter::around(int hit, const std::vector<int>& bodies, double wheels_held,
                                     const Taken& taken) const {
  std::optional<int> first;
  bool hold = false;
  for (int f = hit - fewest_before; f >= 0; --f) {
    if (footage_.time(hit) - footage_.time(f) > soon || taken.has(bodies, f)) break;
    first = f;
  }
  if (!first) return std::nullopt;
  std::optional<int> any;
  for (int f = *first; f <= hit - fewest_before && !hold; ++f) {
    if (!stand_free(bodies, f)) continue;
    hold = std::all_of(bodies.begin(), bodies.end(),
                       [&](int body) { return is_ball(body) || holds(body, f, wheels_held); });
    if (hold || !any) any = f;
  }
  if (!any) return std::nullopt;
  const double seconds = footage_.time(hit) - footage_.time(*any) + after_hit;
  Window window = grow(*any, bodies, seconds, taken);
  window.may_slide = !hold;
  if (window.last < hit + fewest_after || !is_usable(window)) return std::nullopt;
  return window;
}

bool Cutter::is_usable(const Window& window) const {
  const int pictures = window.last - window.first + 1;
  if (pictures < fewest_pictures) return false;
  return std::all_of(window.bodies.begin(), window.bodies.end(), [&](int body) {
    if (!is_ball(body)) {
      const auto& told = footage_.told(body);
      if (told.empty() || told.front().t > footage_.time(window.first)) return false;
    }
    int seen = 0;
    for (int f = window.first; f <= window.last; ++f)
      seen += footage_.sight(body, f).is_seen ? 1 : 0;
    return 3 * seen >= 2 * pictures;
  });
}

// Appends the windows of one body: one after the other, each from the next picture that will do.
template <class Begins>
void cut_one(const Cutter& cutter, const Footage& footage, int body, double seconds,
             const Taken& taken, Begins begins, std::vector<Window>& windows) {
  for (int f = 0; f + fewest_pictures <= footage.frames();) {
    if (!footage.sight(body, f).is_seen || taken.has(body, f) || !begins(f) ||
        !cutter.are_alone({body}, f)) {
      ++f;
      continue;
    }
    Window window = cutter.grow(f, {body}, seconds, taken);
    if (!cutter.is_usable(window)) {
      ++f;
      continue;
    }
    f = window.last + 1;
    windows.push_back(std::move(window));
  }
}

// Appends the windows around the hits of a robot and a wall.
void cut_knocks(const Cutter& cutter, const Footage& footage, int robot, Taken& taken,
                std::vector<Window>& windows) {
  for (int f = fewest_before; f < footage.frames(); ++f) {
    if (!footage.sight(robot, f).is_seen || taken.has(robot, f) || !cutter.hits_wall(robot, f))
      continue;
    auto window = cutter.around(f, {robot}, memory, taken);
    if (!window) continue;
    taken.add(*window);
    windows.push_back(std::move(*window));
  }
}

}  // namespace

std::vector<Window> rolls(const Footage& footage, const simulator::Parameters& parameters) {
  const Cutter cutter(footage, parameters);
  std::vector<Window> windows;
  const int ball = footage.ball();
  cut_one(
      cutter, footage, ball, longest_roll, Taken(footage),
      [&](int f) { return !cutter.is_at_wall(ball, f, together); }, windows);
  return windows;
}

std::vector<Window> drives(const Footage& footage, const simulator::Parameters& parameters) {
  const Cutter cutter(footage, parameters);
  std::vector<Window> windows;
  Taken taken(footage);
  for (int robot = 0; robot < footage.ball(); ++robot) {
    if (footage.told(robot).empty()) continue;
    cut_knocks(cutter, footage, robot, taken, windows);
    cut_one(
        cutter, footage, robot, longest_drive, taken,
        [&](int f) { return cutter.holds(robot, f, memory); }, windows);
  }
  return windows;
}

std::vector<Window> meetings(const Footage& footage, const simulator::Parameters& parameters) {
  const Cutter cutter(footage, parameters);
  std::vector<Window> windows;
  Taken taken(footage);
  const int bodies = footage.bodies();
  const auto cut = [&](int f, std::vector<int> members) {
    std::sort(members.begin(), members.end());
    auto window = cutter.around(f, members, short_memory, taken);
    if (!window) return false;
    taken.add(*window);
    windows.push_back(std::move(*window));
    return true;
  };
  for (int f = fewest_before; f < footage.frames(); ++f) {
    for (int i = 0; i < bodies; ++i) {
      for (int j = 0; j < i; ++j) {
        if (taken.has({i, j}, f) || !cutter.are_near(i, j, f, together)) continue;
        bool done = cut(f, {i, j});
        for (int third = 0; third < bodies && !done; ++third)  // a third one may be in the way
          done = third != i && third != j && !taken.has(third, f) && cut(f, {i, j, third});
      }
    }
  }
  return windows;
}

}  // namespace mirocup::pitch
