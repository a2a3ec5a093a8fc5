// SPDX-License-Identifier: MIT
#include "record/traces/trace_sampler.hpp"

#include "core/referee/touches.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace mirocup::traces {

namespace {

using referee::RobotId;
using referee::TickFacts;

constexpr double time_tolerance = 1e-9;  // s
constexpr double clearly_driving = 2.0;  // times the speed that counts as driving

Pose between(const Pose& a, const Pose& b, double share) {
  const double turn = Heading{a.heading.cos * b.heading.cos + a.heading.sin * b.heading.sin,
                              a.heading.cos * b.heading.sin - a.heading.sin * b.heading.cos}
                          .angle();
  return {a.position + share * (b.position - a.position), a.heading.turned(sincos(share * turn))};
}

}  // namespace

TraceSampler::TraceSampler(const Trace& trace, const referee::JudgedField& pitch)
    : trace_(trace), pitch_(pitch) {
  const auto samples = [](double t) { return t / sample_period; };
  const double last = trace.frames.back().t;
  last_sample_ = static_cast<int>(std::ceil(samples(last) - 1e-6));
  if (trace.hold) {
    last_sample_ =
        std::max(last_sample_, static_cast<int>(std::floor(samples(*trace.hold) + 1e-6)));
  }
  place_unlisted_robots();
}

const KeyFrame& TraceSampler::frame_at(double t) const {
  const auto later =
      std::upper_bound(trace_.frames.begin(), trace_.frames.end(), t + time_tolerance,
                       [](double time, const KeyFrame& frame) { return time < frame.t; });
  return later == trace_.frames.begin() ? *later : *std::prev(later);
}

Vec2 TraceSampler::ball_at(double t) const {
  const KeyFrame& frame = frame_at(t);
  const double since = t - frame.ball_since;
  const Motion& motion = trace_.motion;
  if (motion.type == Motion::Type::sine)
    return frame.ball + Vec2{motion.amplitude * std::sin(2.0 * pi * motion.frequency * since), 0.0};
  if (motion.type == Motion::Type::line) return frame.ball + since * motion.velocity;
  return frame.ball;
}

TraceSampler::Instant TraceSampler::instant(double t) const {
  const KeyFrame& frame = frame_at(t);
  const KeyFrame* next =
      &frame + 1 < trace_.frames.data() + trace_.frames.size() ? &frame + 1 : nullptr;
  const bool moves = trace_.is_interpolated && next != nullptr && next->t > frame.t;
  const double share = moves ? (t - frame.t) / (next->t - frame.t) : 0.0;
  Instant now;
  now.ball = moves && trace_.motion.type == Motion::Type::none
                 ? Vec2(frame.ball + share * (next->ball - frame.ball))
                 : ball_at(t);
  now.robots = unlisted_;
  for (const End end : both_ends) {
    const int e = index_of(end);
    for (std::size_t i = 0; i < frame.robots[e].size(); ++i) {
      const Pose& pose = frame.robots[e][i];
      const bool goes_on = moves && i < next->robots[e].size();
      now.robots[e][i] = goes_on ? between(pose, next->robots[e][i], share) : pose;
    }
  }
  return now;
}

// A ball that is first seen wholly behind a goal line was not seen crossing it: it crosses now.
Vec2 TraceSampler::first_seen(const Vec2& ball) const {
  const double line = pitch_.field.half_length + pitch_.ball_radius;
  return {std::clamp(ball.x(), -line, line), ball.y()};
}

TickFacts TraceSampler::sample(int k) const {
  const double t = k * sample_period;
  const Instant now = instant(t);
  TickFacts s;
  s.duration = k == 0 ? 0.0 : sample_period;
  s.ball = now.ball;
  s.ball_before = k == 0 ? first_seen(now.ball) : instant(t - sample_period).ball;
  s.robots = now.robots;
  const KeyFrame& frame = frame_at(t);
  s.fallen = frame.fallen;
  for (const HandOnField& hand : trace_.hands) {
    const bool is_now = hand.t <= t && (k == 0 || hand.t > t - sample_period);
    if (is_now) s.hand[index_of(hand.team)] = true;
  }
  if (k > 0) add_motion(t, s);
  add_contacts(frame, s);
  add_drives(frame, s);
  s.last_touch = frame.last_touch;
  if (!s.last_touch && s.touched_ball[0].count() + s.touched_ball[1].count() == 1) {
    const End end = s.touched_ball[0].any() ? End::left : End::right;
    for (int i = 0; i < pitch_.field.robots_per_team; ++i) {
      if (s.touched_ball[index_of(end)][i]) s.last_touch = RobotId{end, i};
    }
  }
  return s;
}

// Without interpolation robots jump from frame to frame and have no speed. With it they have the
// speed at the start of the sample's period.
void TraceSampler::add_motion(double t, TickFacts& s) const {
  if (!trace_.is_interpolated) return;
  constexpr double moment = 1e-3;
  const double begin = t - sample_period;
  const Instant before = instant(begin);
  const Instant after = instant(begin + moment);
  for (const End end : both_ends) {
    const int e = index_of(end);
    for (int i = 0; i < pitch_.field.robots_per_team; ++i) {
      s.velocity[e][i] = (after.robots[e][i].position - before.robots[e][i].position) / moment;
      s.commanded[e][i] = s.velocity[e][i];
    }
  }
}

void TraceSampler::add_contacts(const KeyFrame& frame, TickFacts& s) const {
  if (!frame.contacts) {
    add_near_touches(pitch_, s);
    return;
  }
  for (const auto& [robot, other] : *frame.contacts) {
    if (other) {
      set_touch(s, robot, *other);
    } else {
      s.touched_ball[index_of(robot.end)].set(robot.index);
    }
  }
}

// A drive is towards the opponent that the robot touches, or else that is nearest.
void TraceSampler::add_drives(const KeyFrame& frame, TickFacts& s) const {
  for (const End end : both_ends) {
    const int e = index_of(end);
    for (int i = 0; i < pitch_.field.robots_per_team; ++i) {
      if (!frame.drive[e][i]) continue;
      const referee::RobotSet& touched = s.touched_opponents[e][i];
      Vec2 way{0.0, 0.0};
      double nearest = HUGE_VAL;
      for (int j = 0; j < pitch_.field.robots_per_team; ++j) {
        if (touched.any() && !touched[j]) continue;
        const Vec2 to = s.robots[index_of(opposite(end))][j].position - s.robots[e][i].position;
        if (to.squaredNorm() >= nearest || to.squaredNorm() == 0.0) continue;
        nearest = to.squaredNorm();
        way = to / std::sqrt(nearest);
      }
      s.commanded[e][i] = *frame.drive[e][i] * clearly_driving * pitch_.rules.drive_mps * way;
    }
  }
}

// Unlisted robots stand in their own half, outside of all areas, and as far as possible from the
// bodies that the trace shows.
void TraceSampler::place_unlisted_robots() {
  const field::Field& field = pitch_.field;
  std::vector<Vec2> shown;
  for (const KeyFrame& frame : trace_.frames) {
    shown.push_back(frame.ball);
    for (const auto& robots : frame.robots) {
      for (const Pose& pose : robots) shown.push_back(pose.position);
    }
  }
  for (const End end : both_ends) {
    const int e = index_of(end);
    std::size_t listed = field.robots_per_team;
    for (const KeyFrame& frame : trace_.frames) listed = std::min(listed, frame.robots[e].size());
    for (std::size_t i = listed; i < static_cast<std::size_t>(field.robots_per_team); ++i) {
      Vec2 best{0.0, 0.0};
      double farthest = -1.0;
      for (double x = 0.1; x < field.half_length - 0.25; x += 0.1) {
        for (const double y : {1.0, -1.0}) {
          const Vec2 at = team_frame(end, Vec2{-x, y * (field.half_width - 0.06)});
          double distance = HUGE_VAL;
          for (const Vec2& p : shown) distance = std::min(distance, (p - at).squaredNorm());
          if (distance <= farthest) continue;
          farthest = distance;
          best = at;
        }
      }
      unlisted_[e][i] = {best, team_frame(end, Heading{})};
      shown.push_back(best);
    }
  }
}

}  // namespace mirocup::traces
