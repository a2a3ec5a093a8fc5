// SPDX-License-Identifier: MIT
#include "labs/training/observations.hpp"

#include "labs/training/behind_ball.hpp"

#include <algorithm>

namespace mirocup::training {

namespace {

constexpr double max_stalemate = 10.0;  // s, of an observed 1
constexpr double near_m = 0.1;          // m: at this distance, nearness is 1/2

// Returns the direction of a vector; that of none is forward.
Vec2 direction(const Vec2& v) {
  const double length = v.norm();
  return length > 0.0 ? Vec2(v / length) : Vec2(1.0, 0.0);
}

// Tells small distances apart: 1 at the place, 0 far away.
double nearness(const Vec2& v) {
  return near_m / (near_m + v.norm());
}

// A body as it is seen, in the team's frame.
struct Seen {
  Vec2 position;
  Vec2 velocity;
  Heading heading;
  double turn = 0.0;
};

Seen seen(const match::Leg& leg, End end, Team team, int robot) {
  const simulator::BodyState r = leg.robot(team, robot);
  return {.position = team_frame(end, r.position),
          .velocity = team_frame(end, r.heading.to_world({r.twist.forward, r.twist.left})),
          .heading = team_frame(end, r.heading),
          .turn = r.twist.omega};
}

Seen seen(const match::Snapshot& view, End end, Team team, int robot) {
  const match::ObservedRobot& r = view.robots[index_of(team)][static_cast<std::size_t>(robot)];
  return {.position = team_frame(end, r.position),
          .velocity = team_frame(end, r.velocity),
          .heading = team_frame(end, Heading::from_angle(r.heading)),
          .turn = r.turn};
}

}  // namespace

Observer::Observer(const Config& config, const field::Field& field) : kind_(config.observation) {
  const simulator::Parameters& p = config.setup.parameters;
  speed_ = p.wheel_speed_limit * p.wheel_radius;
  metre_ = field.half_length + field.goal_depth;
  goal_x_ = field.half_length;
  gap_ = pushing_gap(p);
  if (kind_ == ObservationKind::vss) {
    // rSoccer: half of the length and the depth of its penalty area, 0.15 m; a robot turns about
    // its centre by the speed of a wheel, 0.04 m away; everything within 1.2.
    metre_ = std::max(field.half_width, field.half_length + field.goal_area.depth);
    turn_ = speed_ / 0.04;
    bound_ = fast_ = 1.2;
  } else {
    turn_ = 2.0 * speed_ / p.wheel_distance;
    bound_ = kind_ == ObservationKind::relative ? 2.5 : 1.2;
    fast_ = 5.0;
  }
  if (kind_ == ObservationKind::relative) {
    add_relative(field.robots_per_team);
  } else {
    add_field(field.robots_per_team);
  }
}

void Observer::add(const std::string& name, const char* unit, double scale, double bound) {
  quantities_.push_back({.name = name, .unit = unit, .scale = scale, .low = -bound, .high = bound});
}

void Observer::add_field(int robots) {
  const bool is_standard = kind_ == ObservationKind::standard;
  add("ball_x", "m", metre_, bound_);
  add("ball_y", "m", metre_, bound_);
  add("ball_vx", "m/s", speed_, fast_);
  add("ball_vy", "m/s", speed_, fast_);
  for (const std::string team : {"own_", "opponent_"}) {
    for (int i = 0; i < robots; ++i) {
      const std::string robot = team + std::to_string(i) + "_";
      add(robot + "x", "m", metre_, bound_);
      add(robot + "y", "m", metre_, bound_);
      if (is_standard) {
        add(robot + "cos", "1", 1.0, 1.0);
        add(robot + "sin", "1", 1.0, 1.0);
      } else if (team == "own_") {
        add(robot + "sin", "1", 1.0, bound_);
        add(robot + "cos", "1", 1.0, bound_);
      }
      add(robot + "vx", "m/s", speed_, fast_);
      add(robot + "vy", "m/s", speed_, fast_);
      add(robot + "turn", "rad/s", turn_, fast_);
    }
  }
  if (!is_standard) return;
  add("own_restart", "1", 1.0, 1.0);  // 1: the last restart was the own team's, -1: the opponents'
  add("stalemate", "s", max_stalemate, 1.0);
}

void Observer::add_relative(int robots) {
  const auto add_place = [&](const std::string& name) {
    add(name + "_x", "m", metre_, bound_);
    add(name + "_y", "m", metre_, bound_);
  };
  const auto add_velocity = [&](const std::string& name) {
    add(name + "_vx", "m/s", speed_, fast_);
    add(name + "_vy", "m/s", speed_, fast_);
  };
  const auto add_heading = [&](const std::string& name) {
    add(name + "_cos", "1", 1.0, 1.0);
    add(name + "_sin", "1", 1.0, 1.0);
  };
  add_place("ball");
  add_velocity("ball");
  add_velocity("self");
  add("self_turn", "rad/s", turn_, fast_);
  add_place("goal");
  add_place("own_goal");
  add_place("self_field");
  add_heading("self_field");
  add_place("ball_field");
  const auto add_direction = [&](const std::string& name) { add_heading(name + "_direction"); };
  const auto add_nearness = [&](const std::string& name) { add(name + "_near", "1", 1.0, 1.0); };
  add_direction("ball");
  add_nearness("ball");
  add_direction("goal");
  add_direction("shot");
  add("shot_length", "m", metre_, bound_);
  add_direction("behind");
  add_nearness("behind");
  for (int i = 1; i < 2 * robots; ++i) {
    const std::string name =
        i < robots ? "mate_" + std::to_string(i) : "opponent_" + std::to_string(i - robots);
    add_place(name);
    add_velocity(name);
    add_heading(name);
  }
  add("own_restart", "1", 1.0, 1.0);
  add("stalemate", "s", max_stalemate, 1.0);
}

void Observer::write_relative(const match::Leg& leg, const std::optional<match::Snapshot>& view,
                              Team team, int self, std::span<float> to) const {
  const End end = leg.end_of(team);
  float* out = to.data();
  const auto put = [&](double value, double bound) {
    *out++ = static_cast<float>(std::clamp(value, -bound, bound));
  };
  const auto see = [&](Team whose, int i) {
    return view ? seen(*view, end, whose, i) : seen(leg, end, whose, i);
  };
  const Seen me = see(team, self);
  const simulator::BallState ball = view ? view->ball : leg.ball();
  const Vec2 ball_at = team_frame(end, ball.position);
  const auto put_vector = [&](const Vec2& v, double per_unit, double bound) {
    put(v.x() * per_unit, bound);
    put(v.y() * per_unit, bound);
  };
  const auto put_place = [&](const Vec2& at) {
    put_vector(me.heading.to_body(at - me.position), 1.0 / metre_, bound_);
  };
  const auto put_velocity = [&](const Vec2& v) {
    put_vector(me.heading.to_body(v), 1.0 / speed_, fast_);
  };
  put_place(ball_at);
  put_velocity(team_frame(end, ball.velocity));
  put_velocity(me.velocity);
  put(me.turn / turn_, fast_);
  put_place({goal_x_, 0.0});
  put_place({-goal_x_, 0.0});
  put_vector(me.position, 1.0 / metre_, bound_);
  put_vector({me.heading.cos, me.heading.sin}, 1.0, 1.0);
  put_vector(ball_at, 1.0 / metre_, bound_);
  const Vec2 goal{goal_x_, 0.0};
  const auto seen_from_me = [&](const Vec2& v) { return me.heading.to_body(v); };
  const auto put_direction = [&](const Vec2& v) { put_vector(direction(v), 1.0, 1.0); };
  const Vec2 to_ball = seen_from_me(ball_at - me.position);
  const Vec2 to_behind = seen_from_me(behind_ball(ball_at, goal, gap_) - me.position);
  put_direction(to_ball);
  put(nearness(to_ball), 1.0);
  put_direction(seen_from_me(goal - me.position));
  put_direction(seen_from_me(goal - ball_at));
  put((goal - ball_at).norm() / metre_, bound_);
  put_direction(to_behind);
  put(nearness(to_behind), 1.0);
  for (const Team whose : {team, opponent_of(team)}) {
    for (int i = 0; i < leg.field().robots_per_team; ++i) {
      if (whose == team && i == self) continue;
      const Seen r = see(whose, i);
      put_place(r.position);
      put_velocity(r.velocity);
      put_vector(me.heading.to_body({r.heading.cos, r.heading.sin}), 1.0, 1.0);
    }
  }
  put(leg.taker() == team ? 1.0 : -1.0, 1.0);
  put(leg.referee().stalemate_s() / max_stalemate, 1.0);
}

void Observer::write(const match::Leg& leg, Team team, int first, std::span<float> to) const {
  const End end = leg.end_of(team);
  const int robots = leg.field().robots_per_team;
  std::optional<match::Snapshot> view;
  if (leg.setup().conditions.has_camera()) view.emplace(leg.view());
  if (kind_ == ObservationKind::relative) return write_relative(leg, view, team, first, to);
  float* out = to.data();
  const auto put = [&](double value, double bound) {
    *out++ = static_cast<float>(std::clamp(value, -bound, bound));
  };
  const simulator::BallState ball = view ? view->ball : leg.ball();
  const Vec2 at = team_frame(end, ball.position);
  const Vec2 velocity = team_frame(end, ball.velocity);
  const double per_metre = 1.0 / metre_;
  const double per_speed = 1.0 / speed_;
  const double per_turn = 1.0 / turn_;
  put(at.x() * per_metre, bound_);
  put(at.y() * per_metre, bound_);
  put(velocity.x() * per_speed, fast_);
  put(velocity.y() * per_speed, fast_);
  for (const Team whose : {team, opponent_of(team)}) {
    for (int k = 0; k < robots; ++k) {
      // The robot `first`, then the others in their order.
      const int i = whose != team ? k : k == 0 ? first : k <= first ? k - 1 : k;
      const Seen r = view ? seen(*view, end, whose, i) : seen(leg, end, whose, i);
      put(r.position.x() * per_metre, bound_);
      put(r.position.y() * per_metre, bound_);
      if (kind_ == ObservationKind::standard) {
        put(r.heading.cos, 1.0);
        put(r.heading.sin, 1.0);
      } else if (whose == team) {
        put(r.heading.sin, bound_);
        put(r.heading.cos, bound_);
      }
      put(r.velocity.x() * per_speed, fast_);
      put(r.velocity.y() * per_speed, fast_);
      put(r.turn * per_turn, fast_);
    }
  }
  if (kind_ != ObservationKind::standard) return;
  put(leg.taker() == team ? 1.0 : -1.0, 1.0);
  put(leg.referee().stalemate_s() / max_stalemate, 1.0);
}

}  // namespace mirocup::training
