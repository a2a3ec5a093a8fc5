// SPDX-License-Identifier: MIT
#include "labs/bench/scenes.hpp"

#include "tests/support/outline.hpp"

#include <algorithm>
#include <ctime>

namespace mirocup::bench {

namespace {

using simulator::BodyState;
using simulator::WheelSpeeds;
using test_support::Outline;

constexpr std::uint64_t seed = 4;
constexpr double walking_wheels = 1.0 / 0.0225;  // rad/s: 1 m/s

constexpr double circle_radius = 0.1;  // m

RobotLeague league_of(SceneKind kind) {
  if (kind == SceneKind::game_5) return RobotLeague::middle;
  if (kind == SceneKind::game_11) return RobotLeague::large;
  return RobotLeague::small;
}

WheelSpeeds wheels_for(const simulator::Parameters& p, double forward, double turn) {
  const double apart = turn * p.wheel_distance / 2.0;
  return {(forward - apart) / p.wheel_radius, (forward + apart) / p.wheel_radius};
}

// Robots in columns over the whole field, headings at random, none at the centre.
std::vector<BodyState> spread_out(const field::Field& field, Random& random) {
  const int robots = 2 * field.robots_per_team;
  const int rows = robots > 10 ? 4 : 2;
  const int columns = (robots + rows - 1) / rows;
  std::vector<BodyState> all;
  for (int i = 0; i < robots; ++i) {
    const double x = 1.5 * field.half_length * ((i / rows + 0.5) / columns - 0.5);
    const double y = 1.2 * field.half_width * ((i % rows + 0.5) / rows - 0.5);
    all.push_back({{x, y}, Heading::from_angle(random.uniform(-pi, pi)), {}});
  }
  return all;
}

// The wheel commands of all robots, tick by tick.
class Steering {
 public:
  Steering(const Scene& scene, const Start& start)
      : kind_(scene.kind),
        p_(start.parameters),
        field_(field::make_field(*start.league)),
        random_(mix_seed(seed)),
        goals_(start.robots.size()) {
    for (Vec2& goal : goals_) goal = random_place();
  }

  Commands commands(const Engine& engine) {
    Commands all;
    for (std::size_t i = 0; i < goals_.size(); ++i) {
      all.push_back(wheels(engine, static_cast<int>(i)));
    }
    return all;
  }

 private:
  WheelSpeeds wheels(const Engine& engine, int i) {
    switch (kind_) {
      case SceneKind::quiet:  // circles of circle_radius, never quite the same
        return {20.0 + random_.uniform(-3.0, 3.0), 40.0 + random_.uniform(-3.0, 3.0)};
      case SceneKind::jam:
        return drive_to(engine.robot(i),
                        is_chaser(i) ? engine.ball().position : way_point(engine, i), 1.0);
      case SceneKind::scrum:
        return drive_to(engine.robot(i), engine.ball().position, 1.0);
      case SceneKind::pinch:
        return wheels_for(p_, 0.5, -8.0 * (engine.robot(i).heading.angle() - pi / 2.0));
      default: {
        const double left = random_.uniform(-walking_wheels, walking_wheels);
        return {left, random_.uniform(-walking_wheels, walking_wheels)};
      }
    }
  }

  bool is_chaser(int i) const { return i % field_.robots_per_team == 0; }

  Vec2 random_place() {
    const double x = random_.uniform(-0.9, 0.9) * field_.half_length;
    return {x, random_.uniform(-0.9, 0.9) * field_.half_width};
  }

  // A new target when the robot has reached the last one, and sometimes before.
  Vec2 way_point(const Engine& engine, int i) {
    const bool is_there = (engine.robot(i).position - goals_[i]).norm() < 0.1;
    if (is_there || random_.below(120) == 0) goals_[i] = random_place();
    return goals_[i];
  }

  WheelSpeeds drive_to(const BodyState& r, const Vec2& place, double fastest) const {
    const Vec2 to = r.heading.to_body(place - r.position);
    const double turn = std::clamp(8.0 * std::atan2(to.y(), to.x()), -12.0, 12.0);
    const double along = fastest * std::max(0.3, to.x() / std::max(to.norm(), 1e-3));
    return wheels_for(p_, along, turn);
  }

  SceneKind kind_;
  simulator::Parameters p_;
  field::Field field_;
  Random random_;
  std::vector<Vec2> goals_;
};

std::vector<Outline> outlines(const Start& start, const Engine& engine) {
  std::vector<Outline> all;
  for (std::size_t i = 0; i < start.robots.size(); ++i) {
    const BodyState r = engine.robot(static_cast<int>(i));
    all.push_back(
        test_support::square_at(r.position, r.heading.angle(), start.parameters.robot_side));
  }
  all.push_back(test_support::circle_at(engine.ball().position, start.parameters.ball_radius));
  return all;
}

double deepest_overlap(const std::vector<Outline>& bodies, const std::vector<Outline>& solids) {
  constexpr double out_of_reach = 0.25;  // m between first corners of bodies that cannot touch
  double least = 0.0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if ((bodies[i].corners[0] - bodies[j].corners[0]).norm() > out_of_reach) continue;
      least = std::min(least, test_support::distance(bodies[i], bodies[j]));
    }
    for (const Outline& solid : solids) {
      least = std::min(least, test_support::distance(bodies[i], solid));
    }
  }
  return -least;
}

double cpu_seconds() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

// labs/bench/instructions.sh counts the instructions of this function and looks for its name.
[[gnu::noinline]] void play_timed(Engine& engine, const std::vector<Commands>& commands) {
  for (const Commands& c : commands) engine.advance(c);
}

std::vector<Scene> scenes(bool quick) {
  const int whole = quick ? 300 : 900;  // 10 s, 30 s
  return {{SceneKind::quiet, 100, quick ? 5 : 10},
          {SceneKind::game, whole},
          {SceneKind::game_5, whole / 3},
          {SceneKind::game_11, whole / 3},
          {SceneKind::jam, whole},
          {SceneKind::scrum, quick ? 200 : 300},
          {SceneKind::pinch, 180}};
}

Start start_of(const Scene& scene) {
  Start s;
  s.league = league_of(scene.kind);
  const field::Field field = field::make_field(*s.league);
  Random random(seed);
  switch (scene.kind) {
    case SceneKind::quiet:
      for (int i = 0; i < 6; ++i) {
        const Vec2 centre{0.42 * (i % 3 - 1), i < 3 ? -0.32 : 0.32};
        const Heading heading = Heading::from_angle(random.uniform(-pi, pi));
        s.robots.push_back({centre - circle_radius * heading.to_world({0.0, 1.0}), heading, {}});
      }
      s.ball = {{-0.7, 0.0}, {0.6, 0.0}};
      break;
    case SceneKind::scrum:
      for (int i = 0; i < 6; ++i) {
        const double angle = pi / 3.0 * i + 0.2;
        const Heading outwards = Heading::from_angle(angle);
        s.robots.push_back({0.3 * outwards.forward(), Heading::from_angle(angle + pi + 0.3), {}});
      }
      s.ball = {{0.003, 0.001}, {0.0, 0.0}};
      break;
    case SceneKind::pinch: {
      const double ball_y = field.half_width - s.parameters.ball_radius;
      const double robot_y = ball_y - s.parameters.ball_radius - s.parameters.robot_side / 2.0;
      s.robots.push_back({{0.1, robot_y - 0.02}, Heading{0.0, 1.0}, {}});
      s.ball = {{0.1, ball_y - 0.01}, {0.0, 0.0}};
      break;
    }
    default:
      s.robots = spread_out(field, random);
      s.ball = {{0.05, 0.0}, {0.3, 0.2}};
  }
  return s;
}

Play play(const Scene& scene, const Contender& contender) {
  const Start start = start_of(scene);
  const field::Field field = field::make_field(*start.league);
  const auto solids = test_support::solids_around(field);
  const auto engine = contender.make(start);
  Steering steering(scene, start);
  Play play;
  std::vector<double> overlaps;
  for (int i = 0; i < scene.ticks; ++i) {
    play.commands.push_back(steering.commands(*engine));
    engine->advance(play.commands.back());
    overlaps.push_back(deepest_overlap(outlines(start, *engine), solids));
    const Vec2 ball = engine->ball().position;
    play.ball_is_lost |= !(std::abs(ball.x()) < field.half_length + field.goal_depth &&
                           std::abs(ball.y()) < field.half_width);
  }
  play.last_overlap = *std::max_element(overlaps.begin() + scene.ticks / 6, overlaps.end());
  std::sort(overlaps.begin(), overlaps.end());
  play.deepest_overlap = overlaps.back();
  play.overlap_p99 = overlaps[overlaps.size() * 99 / 100];
  return play;
}

double time_round(const Scene& scene, const Play& play, const Contender& contender) {
  const Start start = start_of(scene);
  double seconds = 0.0;
  for (int i = 0; i < scene.repeats; ++i) {
    const auto engine = contender.make(start);
    const double begin = cpu_seconds();
    play_timed(*engine, play.commands);
    seconds += cpu_seconds() - begin;
  }
  return 1e6 * seconds / (scene.ticks * scene.repeats);
}

}  // namespace mirocup::bench
