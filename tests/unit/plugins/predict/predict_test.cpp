// SPDX-License-Identifier: MIT
//
// Prediction against what it predicts: legs of core/match.
#include "mirocup/predict.hpp"

#include "core/match/leg.hpp"
#include "plugins/abi/convert.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <new>
#include <vector>

namespace {
long allocations = 0;  // by operator new in this program
}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size == 0 ? 1 : size)) return p;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size == 0 ? 1 : size);
}
void operator delete(void* p) noexcept {
  std::free(p);
}
void operator delete(void* p, std::size_t) noexcept {
  std::free(p);
}

namespace mirocup::strategy {
namespace {

// A leg under exact conditions in which both teams push the ball with all their robots, and what
// each team sees of it.
class PushingLeg {
 public:
  explicit PushingLeg(RobotLeague league) : leg_(setup_of(league)) {
    for (const mirocup::Team team : both_teams)
      setups_[index_of(team)] = abi::to_setup(leg_.briefing(team));
  }

  const match::Leg& leg() const { return leg_; }
  const Setup& setup(mirocup::Team team) const { return setups_[index_of(team)]; }
  bool is_ready() const { return leg_.snapshot().state == match::State::READY; }

  Observation seen_by(mirocup::Team team) const {
    return abi::to_observation(match::observe(leg_.view(), team, setups_[0].robots));
  }

  // Returns the answer that is driven in the coming tick.
  Command driven(mirocup::Team team) const { return driven_[index_of(team)]; }

  void advance() {
    std::array<match::Answer, 2> answers;
    std::array<Command, 2> commands{};
    for (const mirocup::Team team : both_teams) {
      const Observation now = seen_by(team);
      for (int i = 0; i < now.robots; ++i)
        commands[index_of(team)].wheels[i] = push(setup(team), now, i);
      answers[index_of(team)] = abi::to_command(commands[index_of(team)]);
    }
    leg_.advance(answers);
    driven_ = commands;
  }

  // Returns the true scene in the frame of a team.
  Scene truth(mirocup::Team team) const {
    const bool is_left = leg_.snapshot().left == team;
    const double sign = is_left ? 1.0 : -1.0;
    const auto body = [&](mirocup::Team of, int i) {
      const simulator::BodyState s = leg_.robot(of, i);
      return Body{.at = {sign * s.position.x(), sign * s.position.y()},
                  .cos = sign * s.heading.cos,
                  .sin = sign * s.heading.sin,
                  .forward = s.twist.forward,
                  .left = s.twist.left,
                  .turn = s.twist.omega};
    };
    Scene scene;
    scene.robots = setups_[0].robots;
    const simulator::BallState ball = leg_.ball();
    scene.ball = {{sign * ball.position.x(), sign * ball.position.y()},
                  {sign * ball.velocity.x(), sign * ball.velocity.y()}};
    for (int i = 0; i < scene.robots; ++i) {
      scene.own[i] = body(team, i);
      scene.opponent[i] = body(opponent_of(team), i);
    }
    return scene;
  }

 private:
  static match::Setup setup_of(RobotLeague league) {
    match::Setup setup;
    setup.league = league;
    setup.seed = 3;
    return setup;
  }

  static Wheels push(const Setup& setup, const Observation& now, int i) {
    return drive_to(setup, now.own[i], ball(now) + Point{0.0, 0.02 * i}, 1.7, 1.7);
  }

  match::Leg leg_;
  std::array<Setup, 2> setups_{};
  std::array<Command, 2> driven_{};
};

bool are_equal(const Body& a, const Body& b) {
  return a.at.x == b.at.x && a.at.y == b.at.y && a.cos == b.cos && a.sin == b.sin &&
         a.forward == b.forward && a.left == b.left && a.turn == b.turn;
}

bool are_equal(const Scene& a, const Scene& b) {
  bool equal = a.ball.at.x == b.ball.at.x && a.ball.at.y == b.ball.at.y &&
               a.ball.velocity.x == b.ball.velocity.x && a.ball.velocity.y == b.ball.velocity.y;
  for (int i = 0; i < a.robots; ++i)
    equal &= are_equal(a.own[i], b.own[i]) && are_equal(a.opponent[i], b.opponent[i]);
  return equal;
}

class PredictedLeg : public testing::TestWithParam<RobotLeague> {};

// Both teams predict each tick of play from their last prediction. In between, the same simulator
// plays another scene. Catches a body in the wrong order, a frame that is mirrored, a command that
// is not rounded as the match does, memory that stays in the simulator, and memory that is lost:
// without it, the same leg is not met.
TEST_P(PredictedLeg, IsTheMatchBitForBit) {
  PushingLeg played(GetParam());
  const int ticks = GetParam() == RobotLeague::large ? 300 : 400;
  for (const mirocup::Team team : both_teams) {
    ASSERT_EQ(played.setup(team).team, index_of(team));
  }
  Simulator blue(played.setup(mirocup::Team::blue));
  Simulator yellow(played.setup(mirocup::Team::yellow));
  std::array<Simulator*, 2> simulators{&blue, &yellow};
  std::array<Scene, 2> scenes{played.truth(mirocup::Team::blue),
                              played.truth(mirocup::Team::yellow)};
  Scene forgetful = scenes[0];
  int touches = 0, forgotten = 0, compared = 0;
  for (int t = 0; t < ticks; ++t) {
    if (played.is_ready()) {
      played.advance();
      for (const mirocup::Team team : both_teams) scenes[index_of(team)] = played.truth(team);
      forgetful = scenes[0];
      continue;
    }
    for (const mirocup::Team team : both_teams) {
      const PredictedTick tick = simulators[index_of(team)]->advance(
          scenes[index_of(team)], played.driven(team), played.driven(opponent_of(team)));
      touches += tick.own_touched_ball != 0 || tick.touched_opponent[1] != 0;
    }
    forgetful.memory = {};
    blue.advance(forgetful, played.driven(mirocup::Team::blue),
                 played.driven(mirocup::Team::yellow));
    played.advance();
    if (played.is_ready()) {
      for (const mirocup::Team team : both_teams) scenes[index_of(team)] = played.truth(team);
      forgetful = scenes[0];
      continue;
    }
    for (const mirocup::Team team : both_teams) {
      ASSERT_TRUE(are_equal(scenes[index_of(team)], played.truth(team)))
          << "tick " << t << ", team " << index_of(team);
    }
    forgotten += are_equal(forgetful, scenes[0]) ? 0 : 1;
    ++compared;
  }
  EXPECT_GT(compared, ticks / 3);
  EXPECT_GT(touches, 20);
  // Eleven a side seldom press against each other for long.
  if (GetParam() != RobotLeague::large) {
    EXPECT_GT(forgotten, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(AllLeagues, PredictedLeg,
                         testing::Values(RobotLeague::small, RobotLeague::middle,
                                         RobotLeague::large));

// A small league, as a team is told of it.
Setup small_league() {
  static const PushingLeg leg(RobotLeague::small);
  return leg.setup(mirocup::Team::blue);
}

// A scene in which nobody meets anybody within a third of a second.
Scene free_scene() {
  Scene scene;
  scene.robots = 3;
  scene.ball = {{0.1, 0.0}, {0.3, 0.4}};
  for (int i = 0; i < 3; ++i) {
    const double y = 0.4 * (i - 1);
    scene.own[i] = {.at = {-0.45, y}, .forward = 0.1 * i, .turn = 1.0};
    scene.opponent[i] = {.at = {0.5, y}, .cos = 0.6, .sin = 0.8, .forward = -0.2, .turn = -0.5 * i};
  }
  return scene;
}

// A team predicts from what it observes, from its own commands and from what the tracker says of
// the opponents. Catches an estimate of the opponents' wheels that is a tick or a sign off.
TEST(Prediction, FromAnObservationIsWithinAMillimetreAfterTenFreeTicks) {
  const mirocup_setup setup = small_league();
  Simulator simulator(setup);
  Scene truth = free_scene();
  Command own{}, opponent{};
  own.wheels[0] = {10.0, 12.0};
  own.wheels[1] = {-8.0, -3.0};
  own.wheels[2] = {15.0, 9.0};
  opponent.wheels[0] = {5.0, 3.0};
  opponent.wheels[1] = {-6.0, -6.5};
  opponent.wheels[2] = {2.0, -2.0};
  Tracker tracker(setup);
  Observation now{};
  now.robots = 3;
  now.state = MIROCUP_PLAY;
  for (; now.tick < 3; ++now.tick) {
    show(truth, now);
    tracker.saw(now);
    tracker.sent(own);
    if (now.tick < 2) simulator.advance(truth, own, opponent);
  }
  Scene predicted = scene_of(now);
  for (int t = 0; t < 10; ++t) {
    simulator.advance(truth, own, opponent);
    const PredictedTick tick =
        simulator.advance(predicted, tracker.in_flight(), tracker.opponents());
    ASSERT_EQ(tick.own_touched_ball + tick.opponent_touched_ball, 0u);
  }
  EXPECT_LT(length(predicted.ball.at - truth.ball.at), 1e-9);
  for (int i = 0; i < 3; ++i) {
    EXPECT_LT(length(predicted.own[i].at - truth.own[i].at), 1e-9);
    EXPECT_LT(length(predicted.opponent[i].at - truth.opponent[i].at), 1e-3);
  }
}

// Catches a robot alone that has another clamp, another direction or another grip than the match.
TEST(Prediction, ARobotAloneDrivesAsInTheSimulator) {
  const mirocup_setup setup = small_league();
  Simulator simulator(setup);
  const std::array<Wheels, 4> commands{{{20.0, 30.0}, {200.0, 20.0}, {-70.0, 5.0}, {80.0, 45.0}}};
  bool slid = false;
  for (const Wheels& wheels : commands) {
    Scene scene = free_scene();
    scene.own[1] = {.at = {-0.2, -0.05}, .forward = 1.2, .turn = 4.0};
    scene.ball = {{0.5, 0.5}, {}};
    const Body start = scene.own[1];
    Command own{};
    own.wheels[1] = wheels;
    for (int t = 0; t < 8; ++t) {
      simulator.advance(scene, own, {});
      slid |= scene.own[1].left != 0.0;
    }
    const Body alone = robot_after(setup, start, wheels, 8 * setup.control_period);
    EXPECT_LT(length(alone.at - scene.own[1].at), 1e-9) << wheels.left;
    EXPECT_NEAR(alone.sin, scene.own[1].sin, 1e-9) << wheels.left;
    EXPECT_NEAR(alone.forward, scene.own[1].forward, 1e-9) << wheels.left;
  }
  EXPECT_TRUE(slid);
}

// Catches a sign or a side that is exchanged.
TEST(Prediction, TheWheelsOfATickAreFoundFromWhatIsSeenBeforeAndAfter) {
  const mirocup_setup setup = small_league();
  const Body before{.at = {0.1, 0.2}, .cos = 0.6, .sin = -0.8, .forward = 0.4, .turn = -3.0};
  const Wheels wheels{12.5, 31.25};
  const Body after = robot_after(setup, before, wheels, setup.control_period);
  const Wheels found = driven_wheels(setup, robot_of(before), robot_of(after));
  EXPECT_NEAR(found.left, wheels.left, 1e-9);
  EXPECT_NEAR(found.right, wheels.right, 1e-9);
}

// Catches a view of the opponents that is mirrored instead of turned.
TEST(Prediction, TheOpponentsSeeTheSceneTurned) {
  const Scene scene = free_scene();
  Observation own{}, turned{};
  own.robots = turned.robots = 3;
  show(scene, own);
  show_to_opponents(scene, turned);
  EXPECT_EQ(turned.ball_x, -own.ball_x);
  EXPECT_EQ(turned.ball_vy, -own.ball_vy);
  EXPECT_EQ(turned.own[2].x, -own.opponent[2].x);
  EXPECT_EQ(turned.own[2].vy, -own.opponent[2].vy);
  EXPECT_EQ(turned.own[2].turn, own.opponent[2].turn);
  EXPECT_NEAR(std::cos(turned.own[2].heading), -std::cos(own.opponent[2].heading), 1e-15);
  EXPECT_EQ(turned.opponent[1].y, -own.own[1].y);
}

// Catches an allocation in a tick: a team rolls thousands of them.
TEST(Prediction, ARolloutAllocatesNothing) {
  PushingLeg played(RobotLeague::middle);
  Simulator simulator(played.setup(mirocup::Team::blue));
  while (played.is_ready()) played.advance();
  for (int t = 0; t < 60; ++t) played.advance();
  const Scene start = played.truth(mirocup::Team::blue);
  const long before = allocations;
  for (int rollout = 0; rollout < 3; ++rollout) {
    Scene scene = start;
    Observation now{};
    now.robots = scene.robots;
    Command own{}, opponent{};
    for (int i = 0; i < scene.robots; ++i) own.wheels[i] = opponent.wheels[i] = {30.0, 30.0};
    for (int t = 0; t < 20; ++t) {
      simulator.advance(scene, own, opponent);
      show(scene, now);
    }
  }
  EXPECT_EQ(allocations, before);
}

// A camera's noise makes bodies overlap. Catches a scene from which the simulator does not come
// back, or only with numbers that are none.
TEST(Prediction, BodiesThatOverlapArePushedApart) {
  const mirocup_setup setup = small_league();
  Simulator simulator(setup);
  Random random(7);
  const auto noise = [&](double size) { return size * (2.0 * random.uniform() - 1.0); };
  for (int n = 0; n < 200; ++n) {
    Scene scene;
    scene.robots = 3;
    for (int i = 0; i < 3; ++i) {
      const Point heap{noise(0.1), noise(0.1)};
      const double heading = noise(pi);
      scene.own[i] = {.at = heap, .cos = std::cos(heading), .sin = std::sin(heading)};
      scene.opponent[i].at = {heap.x + 0.07, heap.y + noise(0.01)};
    }
    scene.ball = {{noise(0.1), noise(0.1)}, {noise(1.0), noise(1.0)}};
    Command push{};
    for (int i = 0; i < 3; ++i) push.wheels[i] = {40.0, 40.0};
    for (int t = 0; t < 10; ++t) simulator.advance(scene, push, push);
    for (int i = 0; i < 3; ++i) ASSERT_LT(length(scene.own[i].at), 1.5) << n;
    ASSERT_LT(length(scene.ball.at), 1.5) << n;
  }
}

}  // namespace
}  // namespace mirocup::strategy
