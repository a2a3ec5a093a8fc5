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

// Robots are seen on both sides of the heading pi, rad. A turn that jumps there by so much is told,
// if the robot also turns with the heading 0. Turns are differences of wheels, rad/s.
constexpr double at_pi = pi - 0.01;
constexpr double told_jump = 10.0;
constexpr double least_error = 1.0;
constexpr Vec2 seen_balls[] = {{-0.4, 0.2}, {0.3, -0.3}};
constexpr std::uint32_t blind_ticks = 20;  // in which a ball is seen elsewhere
// A robot drives to a ball so far away, m, in these directions, rad, until it has driven so far, m.
constexpr double ball_distance = 0.35;
constexpr std::array bearings{-0.8, -0.3, 0.3, 0.8};
constexpr double driven = 0.1;
constexpr std::uint32_t driven_ticks = 40;
// It drives to a place between the ball and one so far behind it, m.
constexpr double behind_ball = 0.12;
constexpr int driving_robots = 2;
// A robot is seen turned by so little, rad, a ball so much farther to the left, rad, or it rolls
// there so fast that it is there so soon, s. The robot turns more if a unit is wrong.
constexpr double small_turn = 0.01;
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

// Plays a scene as the team on the left, against a team that stands. `show` changes or watches what
// the entry sees.
Result<TrialLeg> play_scene(Examination& e, const match::Start& start, std::uint32_t ticks,
                            const WatchedTeam::Show& show) {
  TrialTerms terms{e.setup, &*e.idle, start.left};
  terms.setup.start = start;
  // The seed is fixed, so chance does not decide what is told.
  terms.setup.seed = 1 + 2 * index_of(start.left) + static_cast<int>(start.phase);
  terms.max_ticks = ticks;
  terms.show = show;
  return play(e, terms);
}

// Puts robot j beside a resting ball, and all others but the keepers away from it.
match::Start start_at_ball(const Examination& e, Team team, int j, Vec2 from, Vec2 ball) {
  const field::Field field = field::make_field(e.setup.league);
  match::Start start;
  start.left = team;
  start.ball = simulator::BallState{ball, {}};
  for (int i = 1; i < field.robots_per_team; ++i) {
    const Vec2 away(-0.8 * field.half_length, (i % 2 == 0 ? 0.1 : -0.1) * (i + 1));
    start.robots[index_of(team)][i].state = {i == j ? from : away, {}, {}};
    start.robots[1 - index_of(team)][i].state = {-away, {}, {}};
  }
  return start;
}

double turn_of(const match::DrivenCommand& command, int robot) {
  return command.speeds(robot).right - command.speeds(robot).left;
}

Result<Ways> ways_to_ball(Examination& e) {
  const Vec2 from(-0.3, 0.013);
  Ways found;
  for (int j = 1; j <= driving_robots; ++j) {
    std::array<double, bearings.size()> ways{}, places{};  // directions, rad
    Vec2 sum(0.0, 0.0);
    bool is_away = true;
    for (std::size_t k = 0; k < bearings.size(); ++k) {
      const Vec2 to = ball_distance * Heading::from_angle(bearings[k]).forward();
      places[k] = atan2(to.y(), to.x() - behind_ball);
      ways[k] = NAN;
      const auto watch = [&](const match::Observation& seen) {
        const auto& [position, heading, velocity, turn, age] = seen.own[j];
        if (std::isnan(ways[k]) && (position - from).norm() > driven)
          ways[k] = atan2(velocity.y(), velocity.x());
      };
      MIROCUP_TRY(const auto leg, play_scene(e, start_at_ball(e, Team::blue, j, from, from + to),
                                             driven_ticks, watch));
      if (!std::isnan(ways[k])) sum += Heading::from_angle(ways[k]).forward();
      const match::DrivenCommand first = leg.answer(0);
      is_away &= turn_of(first, j) * bearings[k] < 0.0;
      found.forward += first.speeds(j).left + first.speeds(j).right;
    }
    // The mean error of a row, rad. If the robot did not drive, its way counts pi.
    const auto error = [&](const WayRow& row) {
      double all = 0.0;
      for (std::size_t k = 0; k < ways.size(); ++k) {
        const double one = std::remainder(ways[k] - row.slope * places[k] - row.offset, 2.0 * pi);
        all += std::isnan(one) ? pi : std::abs(one);
      }
      return all / std::size(bearings);
    };
    const WayRow& best = *std::ranges::min_element(way_rows, {}, error);
    // The error if it drives to one place.
    const double of_place = error({0.0, atan2(sum.y(), sum.x()), nullptr});
    const bool fits = error(best) <= std::min(fitting, 0.5 * of_place);
    found.is_away |= !fits && is_away && of_place > 2.0 * fitting;
    found.is_right |= fits && best.code == nullptr;
    if (fits && found.code == nullptr) found.code = best.code;
  }
  return found;
}

// True if all robots but the keeper do the same wherever the ball is after the first tick, and they
// move.
Result<bool> is_blind(Examination& e) {
  std::array<TrialLeg, 2> legs;
  for (const std::size_t k : {0u, 1u}) {
    MIROCUP_TRY(legs[k], play_scene(e, {}, blind_ticks, [k](match::Observation& seen) {
                  if (seen.tick > 0) seen.ball = seen_balls[k];
                }));
  }
  bool has_moved = false;
  for (std::uint32_t tick = 0; tick < blind_ticks; ++tick) {
    const auto one = legs[0].answer(tick).wheels, other = legs[1].answer(tick).wheels;
    if (!std::equal(one.begin() + 1, one.end(), other.begin() + 1)) return false;
    has_moved |= std::any_of(one.begin() + 1, one.end(), [](const auto& w) { return w[0] != 0; });
  }
  return has_moved;
}

// What the entry sees otherwise in the first tick: angles, rad, and a speed of the ball, rad/s.
struct Change {
  int robot = 0;
  double turn = 0.0;                   // of the robot, to the right
  double bearing = 0.0, rolls = 0.0;   // of the ball, to the left as seen by the robot
  double opponents = 0.0;              // their turn to the right
  std::optional<double> heading = {};  // of all own robots
};

// Returns the answer to the first tick of a leg in which the ball is seen at that place, and the
// own robots at odd places, whose order differs from ball to ball, and then the change is made.
Result<match::DrivenCommand> answer_to(Examination& e, Vec2 ball, const Change& change) {
  MIROCUP_TRY(const auto leg, play_scene(e, {}, 1, [&](match::Observation& seen) {
                for (std::size_t i = 0; i < seen.own.size(); ++i) {
                  const double odd = ball.x() < 0.0 ? 0.021 : -0.1 * static_cast<double>(i % 3);
                  seen.own[i].position += Vec2(0.013, odd);
                  seen.own[i].heading = change.heading.value_or(seen.own[i].heading);
                  seen.opponent[i].heading -= change.opponents;
                }
                match::ObservedRobot& robot = seen.own[change.robot];
                const Vec2 to = ball - robot.position;
                robot.heading -= change.turn;
                seen.ball = ball + change.bearing * Vec2(-to.y(), to.x());
                seen.ball_velocity = change.rolls * Vec2(-to.y(), to.x());
              }));
  return leg.answer(0);
}

}  // namespace

Result<bool> tell_steering(Examination& e, bool is_slow, bool is_at_wall) {
  const int robots = field::make_field(e.setup.league).robots_per_team;
  int away = 0, followers = 0, opponents = 0;
  bool is_degrees = true, is_ticks = true;  // with each of the balls
  std::array<int, max_robots_per_team> jumps{};
  for (const Vec2 ball : seen_balls) {
    MIROCUP_TRY(const auto usual, answer_to(e, ball, {}));
    MIROCUP_TRY(const auto beyond, answer_to(e, ball, {.opponents = small_turn}));
    MIROCUP_TRY(const auto left, answer_to(e, ball, {.heading = at_pi}));
    MIROCUP_TRY(const auto right, answer_to(e, ball, {.heading = -at_pi}));
    MIROCUP_TRY(const auto ahead, answer_to(e, ball, {.heading = 0.0}));
    opponents += beyond != usual ? 1 : 0;
    bool is_far_beside = false, is_far_later = false;
    for (int j = 0; j < robots; ++j) {
      MIROCUP_TRY(const auto turned, answer_to(e, ball, {.robot = j, .turn = small_turn}));
      const bool follows = turned.wheels[j] != usual.wheels[j];
      for (int i = 0; i < robots && !follows; ++i) {
        if (turned.wheels[i] == usual.wheels[i]) continue;
        return note(e, "order", std::to_string(i), std::to_string(j)), true;
      }
      if (j == 0) continue;
      followers += follows ? 1 : 0;
      const double turn = turn_of(turned, j) - turn_of(usual, j);
      away += ball.x() < 0.0 && turn < 0.0 ? 1 : 0;
      // A robot with its target straight ahead turns otherwise on both sides, rightly.
      const bool is_beside = std::abs(turn_of(ahead, j)) > least_error;
      jumps[j] += is_beside && std::abs(turn_of(left, j) - turn_of(right, j)) > told_jump ? 1 : 0;
      if (j > driving_robots || turn == 0.0) continue;
      MIROCUP_TRY(const auto beside, answer_to(e, ball, {.robot = j, .bearing = small_bearing}));
      MIROCUP_TRY(const auto later, answer_to(e, ball, {.robot = j, .rolls = rolls}));
      const auto times = [&](const match::DrivenCommand& command) {
        return std::abs((turn_of(command, j) - turn_of(usual, j)) / turn) * small_turn;
      };
      is_far_beside |= times(beside) > many_times * small_bearing;
      is_far_later |= times(later) > few_seconds * rolls;
    }
    is_degrees &= is_far_beside;
    is_ticks &= is_far_later;
  }
  MIROCUP_TRY(const Ways ways, ways_to_ball(e));
  const bool is_unwrapped = std::ranges::count(jumps, std::ssize(seen_balls)) > 0;
  const bool is_away =
      !ways.is_right && (away == robots - 1 || (ways.is_away && ways.code == nullptr));
  const char* code = followers == 0 && opponents > 0          ? "opponents"
                     : is_degrees                             ? "degrees"
                     : is_away && ways.forward < 0.0          ? "backwards_all"
                     : is_away                                ? "wrong_turn"
                     : is_unwrapped                           ? "unwrapped"
                     : !ways.is_right && ways.code != nullptr ? ways.code
                     : is_slow && ways.forward != 0.0         ? "slow_wheels"
                     : is_ticks                               ? "ticks"
                                                              : nullptr;
  if (code == nullptr && !is_at_wall) {
    MIROCUP_TRY(const bool is_blind_team, is_blind(e));
    if (is_blind_team) code = "blind";
  }
  if (code != nullptr) note(e, code);
  return code != nullptr;
}

Result<bool> tell_end(Examination& e) {
  const double half_length = field::make_field(e.setup.league).half_length;
  const Vec2 ball(0.05, 0.3);
  // By colour and half: how far robot 1 pushes the ball to the opponents' end and to its own, from
  // before the ball, in line with its own goal, and from behind it.
  std::array<std::array<double, 2>, 4> before{}, behind{};
  double best = 0.0;
  for (std::size_t i = 0; i < behind.size(); ++i) {
    for (auto* const pushes : {&before[i], &behind[i]}) {
      const Vec2 goal(pushes == &before[i] ? -half_length : half_length, 0.0);
      const Vec2 from = ball - beside_ball / (goal - ball).norm() * (goal - ball);
      match::Start start = start_at_ball(e, both_teams[i / 2], 1, from, ball);
      if (i % 2 == 1) start.phase = referee::Phase::SECOND_HALF;
      MIROCUP_TRY_VOID(play_scene(e, start, pushing_ticks, [&](const match::Observation& seen) {
        (*pushes)[0] = std::max((*pushes)[0], seen.ball.x() - ball.x());
        (*pushes)[1] = std::max((*pushes)[1], ball.x() - seen.ball.x());
      }));
    }
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
  for (const auto& [bits, where] : places)
    if (bits == wrong) return note(e, "own_end", where), true;
  return false;
}

}  // namespace mirocup::app
