// SPDX-License-Identifier: MIT
//
// What the scenes share: states at random, a world to play them in, and differences of states.
#pragma once

#include "core/base/random.hpp"
#include "core/simulator/world.hpp"
#include "tests/support/exact_motion.hpp"
#include "tests/support/outline.hpp"

#include <vector>

namespace mirocup::scenes {

using simulator::BallState;
using simulator::BodyState;
using simulator::Parameters;
using simulator::WheelCommand;
using simulator::WheelSpeeds;
using simulator::World;

inline constexpr double tick = 0.033;  // s: the control period

struct Start {
  const field::Field* field = nullptr;
  Parameters parameters;
  std::vector<BodyState> robots;
  std::vector<BallState> ball;  // one or none
};

// A world in that state, with standard tolerances if no others are given.
std::unique_ptr<World> world_of(const Start& start, const simulator::Tolerances& tolerances = {});

inline constexpr simulator::Accuracy levels[] = {
    simulator::Accuracy::coarse, simulator::Accuracy::standard, simulator::Accuracy::reference};

Parameters without_rolling_friction();

WheelCommand random_wheels(Random& random, double fastest);

// The same, but robots whose motors brake are told to stand in a third of the cases.
WheelCommand random_wheels(Random& random, double fastest, const Parameters& parameters);

// Motors other than the default's, which have one lag.
struct Motors {
  const char* name;
  double turn;   // s: lag of turning; 0: that of driving
  double brake;  // s: lag of driving while the robot is told to stand; 0: that of driving
};
inline constexpr Motors other_motors[] = {{"motors that turn faster", 0.025, 0.0},
                                          {"motors that turn slower", 0.13, 0.0},
                                          {"motors with a brake", 0.0, 0.0145},
                                          {"two lags and a brake", 0.025, 0.0145}};
Parameters with(const Motors& motors, Parameters parameters = {});
BodyState robot_at(const Vec2& at, double angle, const simulator::Twist& twist = {});
Heading random_heading(Random& random);
Vec2 random_in(Random& random, double half_x, double half_y);

// From `least` to `most`, as many slow ones as fast ones.
double random_logarithmic(Random& random, double least, double most);

// Do the bodies overlap each other or anything solid?
bool overlap(const Start& start);

// The deepest overlap of the world's bodies now, m; 0 if there is none.
double deepest_overlap(const World& world, const std::vector<test_support::Outline>& solids);

// Kinetic energy, J, with the ball's rotation.
double kinetic_energy(const World& world);

bool is_finite(const World& world);

// The larger of the distance (m) and the turn (rad) between two states of a robot.
double difference(const BodyState& a, const BodyState& b);

// The largest of the differences of their velocities, m/s and rad/s.
double velocity_difference(const BodyState& a, const BodyState& b);

}  // namespace mirocup::scenes
