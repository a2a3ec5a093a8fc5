// SPDX-License-Identifier: MIT
#include "server/pitch/cuts.hpp"

#include "core/base/math.hpp"
#include "core/simulator/collision/collision_queries.hpp"
#include "core/simulator/collision/static_world.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace mirocup::pitch {

namespace {

using simulator::BodyState;

constexpr double longest_roll = 2.05;     // s
constexpr double longest_drive = 0.5;     // s
constexpr double soon = 0.25;             // s, from the start of a meeting to its touch
constexpr int most_bodies = 3;            // of a meeting
constexpr int fewest_pictures = 10;       // of a window
constexpr double apart = 0.02;            // m: a body this near may touch between two pictures
constexpr double together = 0.006;        // m: it touches, as far as pictures tell
constexpr double memory = 0.2;            // s, for which wheels may go on sliding
constexpr double short_memory = 0.1;      // s: of meetings, which are few
constexpr int pictures_of_state = 8;      // from which speeds are estimated
constexpr double gentle_turn = 2.9;       // m/s^2: wheels of a grip of 0.3 hold
constexpr double straight_enough = 0.08;  // m/s sideways: less is the camera's noise
constexpr std::array<double, 3> between{0.33, 0.67, 1.0};  // of the way from picture to picture

bool turns_hard(const simulator::Twist& v) {
  return std::abs(v.forward * v.omega) > gentle_turn;
}

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
  bool is_at_wall(int body, int frame, double gap_of_both) const;
  // True if no other body than those is near one of them.
  bool are_alone(const std::vector<int>& bodies, int frame) const;
  // True if the wheels of a robot hold at the start of a window, and have held for long enough.
  bool holds(int robot, int frame, double seconds) const;
  std::optional<simulator::Twist> middle_twist(int robot, int first, int count) const;
  // Returns the window from a picture on: it ends before another body comes near.
  Window grow(int first, std::vector<int> bodies, double seconds) const;
  // True if each body is seen often enough, and robots have commands.
  bool is_usable(const Window& window) const;
  // Returns the lists of bodies that touch each other within `soon`.
  std::vector<std::vector<int>> groups(int first) const;

 private:
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
  const Vec2 at = footage_.sight(body, frame).position.cwiseAbs();
  const field::Field& field = footage_.field();
  const double inside = reach(body) + limit;
  return at.x() > field.half_length - inside || at.y() > field.half_width - inside ||
         at.sum() >
             field.half_length + field.half_width - field.corner_leg - inside * std::sqrt(2.0);
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

Window Cutter::grow(int first, std::vector<int> bodies, double seconds) const {
  Window window{first, first, std::move(bodies)};
  while (window.last + 1 < footage_.frames() && follows(window.last + 1) &&
         footage_.time(window.last + 1) - footage_.time(first) < seconds &&
         are_alone(window.bodies, window.last + 1))
    ++window.last;
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

std::vector<std::vector<int>> Cutter::groups(int first) const {
  const int bodies = footage_.bodies();
  std::vector<int> group(static_cast<std::size_t>(bodies));
  for (int i = 0; i < bodies; ++i) group[i] = i;
  for (int f = first; f < footage_.frames() && footage_.time(f) - footage_.time(first) < soon;
       ++f) {
    for (int i = 0; i < bodies; ++i) {
      for (int j = 0; j < i; ++j) {
        if (group[i] == group[j] || !are_near(i, j, f, together)) continue;
        std::replace(group.begin(), group.end(), group[i], group[j]);
      }
    }
  }
  std::vector<std::vector<int>> all;
  for (int g = 0; g < bodies; ++g) {
    std::vector<int> members;
    for (int i = 0; i < bodies; ++i) {
      if (group[i] == g) members.push_back(i);
    }
    const int count = static_cast<int>(members.size());
    if (count >= 2 && count <= most_bodies) all.push_back(std::move(members));
  }
  return all;
}

// Returns the windows of one body: one after the other, each from the next picture that will do.
template <class Begins>
void cut_one(const Cutter& cutter, const Footage& footage, int body, double seconds, Begins begins,
             std::vector<Window>& windows) {
  for (int f = 0; f + fewest_pictures <= footage.frames();) {
    if (!footage.sight(body, f).is_seen || !begins(f) || !cutter.are_alone({body}, f)) {
      ++f;
      continue;
    }
    Window window = cutter.grow(f, {body}, seconds);
    if (!cutter.is_usable(window)) {
      ++f;
      continue;
    }
    f = window.last + 1;
    windows.push_back(std::move(window));
  }
}

}  // namespace

std::vector<Window> rolls(const Footage& footage, const simulator::Parameters& parameters) {
  const Cutter cutter(footage, parameters);
  std::vector<Window> windows;
  const int ball = footage.ball();
  cut_one(
      cutter, footage, ball, longest_roll,
      [&](int f) { return !cutter.is_at_wall(ball, f, together); }, windows);
  return windows;
}

std::vector<Window> drives(const Footage& footage, const simulator::Parameters& parameters) {
  const Cutter cutter(footage, parameters);
  std::vector<Window> windows;
  for (int robot = 0; robot < footage.ball(); ++robot) {
    if (footage.told(robot).empty()) continue;
    cut_one(
        cutter, footage, robot, longest_drive,
        [&](int f) { return cutter.holds(robot, f, memory); }, windows);
  }
  return windows;
}

std::vector<Window> meetings(const Footage& footage, const simulator::Parameters& parameters) {
  const Cutter cutter(footage, parameters);
  std::vector<Window> windows;
  std::vector<int> free_from(static_cast<std::size_t>(footage.bodies()), 0);
  for (int f = 0; f + fewest_pictures <= footage.frames(); ++f) {
    for (std::vector<int>& bodies : cutter.groups(f)) {
      const bool begins = std::all_of(bodies.begin(), bodies.end(), [&](int body) {
        return free_from[body] <= f && footage.sight(body, f).is_seen &&
               !cutter.is_at_wall(body, f, together) && cutter.are_alone({body}, f) &&
               (cutter.is_ball(body) || cutter.holds(body, f, short_memory));
      });
      if (!begins) continue;
      Window window = cutter.grow(f, std::move(bodies), longest_drive);
      if (!cutter.is_usable(window)) continue;
      for (const int body : window.bodies) free_from[body] = window.last + 1;
      windows.push_back(std::move(window));
    }
  }
  return windows;
}

}  // namespace mirocup::pitch
