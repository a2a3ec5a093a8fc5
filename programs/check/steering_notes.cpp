// SPDX-License-Identifier: MIT
//
// Warnings from single scenes, for a team that has not won its worst leg. What its robots see is
// changed a little, which tells whom the wheels follow. Its robots drive to a resting ball, and the
// direction in which they drive tells mistakes of angles. Against a team that stands, it shows
// towards which end it plays.
#include "core/base/math.hpp"
#include "core/field/field.hpp"
#include "programs/check/examination.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::app {

namespace {

// Headings as a robot is seen, rad. Turns, and a change of a turn, as differences of wheels, rad/s.
constexpr double small_turn = 0.01;
constexpr double at_pi = pi - 0.01;
constexpr double least_error = 1.0;
constexpr double told_jump = 10.0;
constexpr Vec2 seen_balls[] = {{-0.4, 0.2}, {0.3, -0.3}};
constexpr std::uint32_t blind_ticks = 20;  // in which a ball is seen elsewhere
// A robot drives to a ball so far away, m, in these directions, rad, until it has driven so far, m.
constexpr double ball_distance = 0.35;
constexpr double bearings[] = {-0.8, -0.3, 0.3, 0.8};
constexpr double driven = 0.1;
constexpr std::uint32_t driven_ticks = 40;
// It drives to a place between the ball and one so far behind it, m.
constexpr double behind_ball = 0.12;
constexpr int driving_robots = 2;
// A ball is seen so much farther to the left, rad, or rolls there so fast that it is there so soon,
// s. The robot turns more if a unit is wrong.
constexpr double small_bearing = 0.002, many_times = 20.0;
constexpr double few_seconds = 3.0, rolls = 0.05;
// A robot stands so far behind or before a ball, m, and pushes it by so much, m.
constexpr double beside_ball = 0.25, pushed = 0.08;
// A right team plays alike in both colours and halves.
constexpr double told_difference = 0.15;
constexpr std::uint32_t pushing_ticks = 75;

// A robot drives in the direction of the ball times `slope`, plus `offset`, rad. The first row is
// right.
struct WayRow {
  double slope, offset;
  const char* code;
};
constexpr WayRow way_rows[] = {{1.0, 0.0, nullptr},        {-1.0, pi / 2.0, "axes"},
                               {-1.0, 0.0, "mirrored"},    {-1.0, pi, "mirrored"},
                               {1.0, pi / 2.0, "heading"}, {1.0, -pi / 2.0, "heading"},
                               {1.0, pi, "drives_away"},   {-1.0, -pi / 2.0, "axes"}};
// The mean error of a row that fits, rad. A robot that ignores the ball fits none.
constexpr double fitting = 0.4;

// What the robots near a resting ball did.
struct Ways {
  const char* code = nullptr;  // of the row that one robot fits, if none is right
  bool is_right = false;
  bool is_away = false;  // one robot that fits no row always turns away first
  double forward = 0.0;  // the sum of their first wheels; negative: backwards from the ball
};

template <class Change>
Result<TrialLeg> play_scene(Examination& e, std::uint32_t ticks, const Change& change,
                            match::Start start = {}) {
  TrialTerms terms = trial(e, Team::blue, *e.idle);
  terms.setup.start = start;
  terms.max_ticks = ticks;
  terms.trick.show = change;
  return play(e, terms);
}

// Returns the answer to the first tick of a leg in which the ball is seen at that place, and the
// own robots at odd places, whose order differs from ball to ball, and then `change` is made.
template <class Change>
Result<match::DrivenCommand> answer_to(Examination& e, Vec2 ball, const Change& change) {
  MIROCUP_TRY(const auto leg, play_scene(e, 1, [&](match::Observation& scene) {
                scene.ball = ball;
                for (std::size_t i = 0; i < scene.own.size(); ++i)
                  scene.own[i].position +=
                      Vec2(0.013, ball.x() < 0.0 ? 0.021 : -0.1 * static_cast<double>(i % 3));
                change(scene);
              }));
  return leg.log.empty() ? match::DrivenCommand() : leg.log[0].commands[index_of(Team::blue)];
}

// The way from robot j to the ball, turned to the left.
Vec2 to_the_left(const match::Observation& scene, int j) {
  const Vec2 to = scene.ball - scene.own[j].position;
  return {-to.y(), to.x()};
}

double turn_of(const match::DrivenCommand& command, int i) {
  return command.speeds(i).right - command.speeds(i).left;
}

// Puts robot j beside a resting ball, and all others but the keepers away from it, in the frame of
// that team. `is_left`: it defends x < 0.
match::Start start_at_ball(Team team, bool is_left, int j, Vec2 from, Vec2 ball,
                           const field::Field& field) {
  match::Start start;
  const double side = is_left ? 1.0 : -1.0;
  start.left = (team == Team::blue) == is_left ? Team::blue : Team::yellow;
  start.ball = simulator::BallState{side * ball, {}};
  for (int i = 1; i < field.robots_per_team; ++i) {
    const Vec2 away(-0.8 * field.half_length, (i % 2 == 0 ? 0.1 : -0.1) * (i + 1));
    const Heading heading = is_left ? Heading() : Heading::from_angle(pi);
    start.robots[index_of(team)][i].state = {side * (i == j ? from : away), heading, {}};
    start.robots[1 - index_of(team)][i].state = {-side * away, heading, {}};
  }
  return start;
}

// Returns a part of the mean error, rad, of a way that is not a number if the robot did not drive.
double error_of(double way, double expected) {
  const double error = std::isnan(way) ? pi : std::abs(std::remainder(way - expected, 2.0 * pi));
  return error / std::size(bearings);
}

Result<Ways> ways_to_ball(Examination& e) {
  const field::Field field = field::make_field(e.setup.league);
  const Vec2 from(-0.3, 0.013);
  Ways ways;
  for (int j = 1; j <= driving_robots; ++j) {
    std::array<double, std::size(way_rows)> errors{};
    Vec2 mean(0.0, 0.0);
    std::array<double, std::size(bearings)> found{};
    int away = 0;
    for (std::size_t k = 0; k < std::size(bearings); ++k) {
      const double bearing = bearings[k];
      const Vec2 ball = from + ball_distance * Heading::from_angle(bearing).forward();
      const Vec2 to = ball - from - Vec2(behind_ball, 0.0);
      const double place = atan2(to.y(), to.x());
      double& way = found[k] = NAN;
      const auto watch = [&](const match::Observation& scene) {
        const match::ObservedRobot& robot = scene.own[j];
        if (std::isnan(way) && (robot.position - from).norm() > driven)
          way = atan2(robot.velocity.y(), robot.velocity.x());
      };
      MIROCUP_TRY(const auto leg,
                  play_scene(e, driven_ticks, watch,
                             start_at_ball(Team::blue, true, j, from, ball, field)));
      for (std::size_t i = 0; i < errors.size(); ++i)
        errors[i] += error_of(way, way_rows[i].slope * place + way_rows[i].offset);
      if (!std::isnan(way)) mean += Heading::from_angle(way).forward();
      if (leg.log.empty()) continue;
      const match::DrivenCommand& first = leg.log[0].commands[index_of(Team::blue)];
      away += turn_of(first, j) * bearing < 0.0 ? 1 : 0;
      if (std::abs(bearing) < 0.5) ways.forward += first.speeds(j).left + first.speeds(j).right;
    }
    double of_place = 0.0;  // the error if it drives to one place
    for (const double way : found) of_place += error_of(way, atan2(mean.y(), mean.x()));
    const auto best = std::ranges::min_element(errors) - errors.begin();
    if (errors[best] > std::min(fitting, 0.5 * of_place)) {
      ways.is_away |= away == std::ssize(bearings) && of_place > 2.0 * fitting;
      continue;
    }
    if (best == 0) ways.is_right = true;
    if (ways.code == nullptr) ways.code = way_rows[best].code;
  }
  return ways;
}

// True if all robots but the keeper do the same wherever the ball is after the first tick, and they
// move.
Result<bool> is_blind(Examination& e) {
  std::vector<match::TickLog> first;
  bool has_moved = false;
  for (const Vec2 ball : seen_balls) {
    MIROCUP_TRY(const auto leg, play_scene(e, blind_ticks, [ball](match::Observation& scene) {
                  if (scene.tick > 0) scene.ball = ball;
                }));
    if (first.empty()) first = leg.log;
    for (std::size_t i = 0; i < std::min(first.size(), leg.log.size()); ++i) {
      const auto& [one, other] =
          std::pair(first[i].commands[0].wheels, leg.log[i].commands[0].wheels);
      if (!std::equal(one.begin() + 1, one.end(), other.begin() + 1)) return false;
      has_moved |= std::any_of(one.begin() + 1, one.end(), [](const auto& w) { return w[0] != 0; });
    }
  }
  return has_moved;
}

// Returns how far robot 1 pushes a resting ball to the opponents' end and to its own. It stands in
// line with the middle of the opponents' goal, or with its own goal.
Result<std::array<double, 2>> pushes_of(Examination& e, Team team, std::size_t half,
                                        bool is_behind) {
  const field::Field field = field::make_field(e.setup.league);
  const Vec2 ball(0.05, 0.3);
  const Vec2 goal((is_behind ? 1.0 : -1.0) * field.half_length, 0.0);
  const Vec2 from = ball - beside_ball / (goal - ball).norm() * (goal - ball);
  TrialTerms terms = trial(e, team, *e.idle);
  terms.setup.start =
      start_at_ball(team, (team == Team::blue) == (half == 0), 1, from, ball, field);
  terms.setup.start->phase = half == 0 ? referee::Phase::FIRST_HALF : referee::Phase::SECOND_HALF;
  terms.setup.seed = 1 + half + 2 * index_of(team);  // what is told does not hang on chance
  terms.max_ticks = pushing_ticks;
  std::array<double, 2> pushes{};
  terms.trick.show = [&](const match::Observation& scene) {
    pushes[0] = std::max(pushes[0], scene.ball.x() - ball.x());
    pushes[1] = std::max(pushes[1], ball.x() - scene.ball.x());
  };
  MIROCUP_TRY_VOID(play(e, terms));
  return pushes;
}

}  // namespace

Result<bool> tell_steering(Examination& e, bool is_slow, bool is_at_wall) {
  const int robots = field::make_field(e.setup.league).robots_per_team;
  int away = 0, followers = 0, degrees = 0, ticks = 0, opponents = 0;
  std::array<int, max_robots_per_team> jumps{};
  for (const Vec2 ball : seen_balls) {
    bool is_far_beside = false, is_far_later = false;
    MIROCUP_TRY(const auto plain, answer_to(e, ball, [](auto&) {}));
    // By how much the turn of robot j changes with a change of the scene.
    const auto change_of = [&](int j, const auto& change) -> Result<double> {
      MIROCUP_TRY(const auto changed, answer_to(e, ball, change));
      return std::abs(turn_of(changed, j) - turn_of(plain, j));
    };
    for (int j = 0; j < robots; ++j) {
      MIROCUP_TRY(const auto turned,
                  answer_to(e, ball, [j](auto& scene) { scene.own[j].heading -= small_turn; }));
      for (int i = 0; i < robots && turned.wheels[j] == plain.wheels[j]; ++i) {
        if (turned.wheels[i] == plain.wheels[i]) continue;
        note(e, "order", std::to_string(i), std::to_string(j));
        return true;
      }
      if (j == 0) continue;
      followers += turned.wheels[j] != plain.wheels[j] ? 1 : 0;
      const double turn = turn_of(turned, j) - turn_of(plain, j);
      away += ball.x() < 0.0 && turn < 0.0 ? 1 : 0;
      if (j > driving_robots || turn == 0.0) continue;
      const double usual = std::abs(turn) / small_turn;
      MIROCUP_TRY(const double beside, change_of(j, [j](auto& scene) {
                    scene.ball += small_bearing * to_the_left(scene, j);
                  }));
      MIROCUP_TRY(const double later, change_of(j, [j](auto& scene) {
                    scene.ball_velocity = rolls * to_the_left(scene, j);
                  }));
      is_far_beside |= beside > many_times * small_bearing * usual;
      is_far_later |= later > few_seconds * rolls * usual;
    }
    degrees += is_far_beside ? 1 : 0;
    ticks += is_far_later ? 1 : 0;
    MIROCUP_TRY(const auto beyond, answer_to(e, ball, [](auto& scene) {
                  for (match::ObservedRobot& robot : scene.opponent) robot.heading -= small_turn;
                }));
    opponents += beyond != plain ? 1 : 0;
    const auto at_heading = [&](double angle) {
      return answer_to(e, ball, [angle](auto& scene) {
        for (match::ObservedRobot& robot : scene.own) robot.heading = angle;
      });
    };
    MIROCUP_TRY(const auto left, at_heading(at_pi));
    MIROCUP_TRY(const auto right, at_heading(-at_pi));
    MIROCUP_TRY(const auto ahead, at_heading(0.0));
    for (int i = 1; i < robots; ++i) {
      // A robot with its target straight ahead turns otherwise on both sides, rightly.
      const bool is_beside = std::abs(turn_of(ahead, i)) > least_error;
      jumps[i] += is_beside && std::abs(turn_of(left, i) - turn_of(right, i)) > told_jump ? 1 : 0;
    }
  }
  constexpr int all = static_cast<int>(std::size(seen_balls));
  MIROCUP_TRY(const Ways ways, ways_to_ball(e));
  const bool is_away =
      !ways.is_right && (away == robots - 1 || (ways.is_away && ways.code == nullptr));
  const char* code = followers == 0 && opponents > 0          ? "opponents"
                     : degrees == all                         ? "degrees"
                     : is_away && ways.forward < 0.0          ? "backwards_all"
                     : is_away                                ? "wrong_turn"
                     : std::ranges::count(jumps, all) > 0     ? "unwrapped"
                     : !ways.is_right && ways.code != nullptr ? ways.code
                     : is_slow && ways.forward != 0.0         ? "slow_wheels"
                     : ticks == all                           ? "ticks"
                                                              : nullptr;
  if (code == nullptr && !is_at_wall) {
    MIROCUP_TRY(const bool is_blind_team, is_blind(e));
    if (is_blind_team) code = "blind";
  }
  if (code != nullptr) note(e, code);
  return code != nullptr;
}

Result<bool> tell_end(Examination& e) {
  std::array<std::array<double, 2>, 4> behind{}, before{};  // by colour and half
  double best = 0.0;
  for (std::size_t i = 0; i < behind.size(); ++i) {
    const Team team = i < 2 ? Team::blue : Team::yellow;
    MIROCUP_TRY(before[i], pushes_of(e, team, i % 2, false));
    MIROCUP_TRY(behind[i], pushes_of(e, team, i % 2, true));
    best = std::max(best, behind[i][0]);
  }
  unsigned wrong = 0;
  for (std::size_t i = 0; i < behind.size(); ++i) {
    const bool has_played = before[i][0] + before[i][1] + behind[i][0] + behind[i][1] > pushed;
    const bool is_worse = has_played && behind[i][0] < best - told_difference;
    const bool is_backwards = behind[i][0] < pushed && before[i][1] > pushed;
    wrong |= (is_worse || is_backwards ? 1U : 0U) << i;
  }
  constexpr std::pair<unsigned, const char*> places[] = {{0b1111, ""},
                                                         {0b0011, " as blue"},
                                                         {0b1100, " as yellow"},
                                                         {0b0101, " in the first half"},
                                                         {0b1010, " in the second half"}};
  for (const auto& [bits, where] : places) {
    if (bits == wrong) return note(e, "own_end", where), true;
  }
  return false;
}

}  // namespace mirocup::app
