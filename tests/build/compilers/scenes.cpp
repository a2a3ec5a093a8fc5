// SPDX-License-Identifier: MIT
//
// Plays a hundred scenes without a game, of all three fields: bodies at random places in motion,
// driven by random commands, so that crowds, walls and shots meet. Prints one hash of all their
// ticks, which every build of the simulator must print.
#include "core/base/random.hpp"
#include "core/base/state_hash.hpp"
#include "core/field/field.hpp"
#include "core/simulator/model/tolerances.hpp"
#include "core/simulator/world.hpp"

#include <cstdio>
#include <vector>

using namespace mirocup;

namespace {

constexpr double spacing = 0.12;  // m: robots at any heading do not overlap

void add(StateHash& hash, const simulator::World& world) {
  for (int i = 0; i < world.robots(); ++i) {
    const simulator::BodyState robot = world.robot(i);
    for (const double number :
         {robot.position.x(), robot.position.y(), robot.heading.cos, robot.heading.sin,
          robot.twist.forward, robot.twist.left, robot.twist.omega}) {
      hash.add(number);
    }
  }
  const simulator::BallState ball = world.ball();
  for (const double number :
       {ball.position.x(), ball.position.y(), ball.velocity.x(), ball.velocity.y()}) {
    hash.add(number);
  }
}

void play_scene(std::uint64_t seed, StateHash& hash) {
  Random random(seed);
  const field::Field field = field::make_field(static_cast<RobotLeague>(seed % 3));
  const int robots = 2 * field.robots_per_team;
  simulator::World world(&field, simulator::Parameters{}, simulator::Tolerances{}, robots, true);
  const double speed = 0.5 * static_cast<double>(seed % 5);  // m/s, at most
  const double left = -0.5 * spacing * robots / 2.0;
  for (int i = 0; i < robots; ++i) {
    const Vec2 place{left + spacing * (i / 2), (i % 2 == 0 ? -0.5 : 0.5) * spacing};
    world.set_robot(i, {place,
                        Heading::from_angle(random.uniform(-3.0, 3.0)),
                        {random.uniform(-speed, speed), 0.0, random.uniform(-speed, speed)}});
  }
  world.set_ball({{random.uniform(left, -left), 0.3},
                  {random.uniform(-speed, speed), -random.uniform(0.0, speed)}});
  std::vector<simulator::WheelCommand> commands(static_cast<std::size_t>(robots));
  for (int tick = 0; tick < 60; ++tick) {
    for (auto& command : commands) {
      if (tick % 10 == 0)
        command = simulator::WheelSpeeds{random.uniform(-40.0, 40.0), random.uniform(-40.0, 40.0)};
    }
    world.advance(commands, 0.033);
    add(hash, world);
  }
}

}  // namespace

int main() {
  StateHash hash;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) play_scene(seed, hash);
  std::printf("%s\n", to_hex(hash.value()).c_str());
}
