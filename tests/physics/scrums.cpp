// SPDX-License-Identifier: MIT
//
// Crowds: six robots on the ball, and the large league's twenty-two.
#include "tests/physics/bars.hpp"
#include "tests/physics/encounter.hpp"
#include "tests/physics/scene.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

namespace mirocup::scenes {

using test_support::Outline;

namespace {

// A match in real time keeps its pace if the dearest tick takes half of its own length.
constexpr double most_cpu_of_a_tick = 0.5 * tick;  // s of CPU time
// A tick of 23 bodies can have 307 events of two or more bodies, and in addition events of one.
constexpr double most_events_a_tick = 500.0;

struct Crowd {
  const char* name;
  RobotLeague league;
  int robots;
};

struct Measured {
  double overlap = 0.0;
  double excess_energy = 0.0;       // J in a tick, above the most that motors can do
  double excess_energy_fine = 0.0;  // J in a fine tick, above what the motors do
  double worst_tick = 0.0;          // s of CPU time
  int most_events = 0;
  int stepped = 0;
  int not_finite = 0;
};

// Robots on a grid around the ball, headings at random.
Start start_of(const Crowd& crowd, const field::Field& field, Random& random) {
  Start s;
  s.field = &field;
  s.ball.push_back({{0.0, 0.0}, {0.0, 0.0}});
  const int columns = crowd.robots > 6 ? 6 : 3;
  for (int i = 0; i < crowd.robots; ++i) {
    const double x = 0.16 * (i % columns) - 0.08 * (columns - 1);
    const double y = (i / columns % 2 == 0 ? 1.0 : -1.0) * (0.1 + 0.16 * (i / columns / 2));
    s.robots.push_back({{x, y}, random_heading(random), {}});
  }
  return s;
}

// Everybody turns to the ball and drives at it, with moods that change now and then.
class Hunters {
 public:
  Hunters(int robots, std::uint64_t seed) : random_(seed), moods_(robots) {}

  const std::vector<WheelCommand>& commands(const World& world) {
    commands_.clear();
    for (std::size_t i = 0; i < moods_.size(); ++i) {
      if (random_.below(12) == 0)
        moods_[i] = {random_.uniform(-20.0, 70.0), random_.uniform(-20.0, 20.0)};
      const BodyState r = world.robot(static_cast<int>(i));
      const Vec2 to = r.heading.to_body(world.ball().position - r.position);
      const double turn = 15.0 * std::atan2(to.y(), to.x()) + moods_[i].turn;
      commands_.push_back(WheelSpeeds{moods_[i].speed - turn, moods_[i].speed + turn});
    }
    return commands_;
  }

 private:
  struct Mood {
    double speed = 50.0, turn = 0.0;
  };
  Random random_;
  std::vector<Mood> moods_;
  std::vector<WheelCommand> commands_;
};

struct Aims {
  double forward, turn;
};

Aims aims_of(const Parameters& p, const WheelCommand& c) {
  const double left = std::clamp(c->left, -p.wheel_speed_limit, p.wheel_speed_limit);
  const double right = std::clamp(c->right, -p.wheel_speed_limit, p.wheel_speed_limit);
  return {p.wheel_radius * (right + left) / 2.0,
          p.wheel_radius * (right - left) / p.wheel_distance};
}

// No motor can do more than M v_ref^2 / 4T, whatever the speed.
double most_power(const Parameters& p, const std::vector<WheelCommand>& commands) {
  double sum = 0.0;
  for (const WheelCommand& c : commands) {
    const Aims aims = aims_of(p, c);
    sum += (p.robot_mass * aims.forward * aims.forward + inertia(p) * aims.turn * aims.turn) /
           (4.0 * p.motor_time_constant);
  }
  return sum;
}

// What the motors do now.
double power(const World& world, const std::vector<WheelCommand>& commands) {
  const Parameters& p = world.parameters();
  double sum = 0.0;
  for (int i = 0; i < world.robots(); ++i) {
    const simulator::Twist v = world.robot(i).twist;
    const Aims aims = aims_of(p, commands[i]);
    sum += (p.robot_mass * (aims.forward - v.forward) * v.forward +
            inertia(p) * (aims.turn - v.omega) * v.omega) /
           p.motor_time_constant;
  }
  return sum;
}

double cpu_seconds() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Returns the CPU time of each tick.
std::vector<double> play(const Crowd& crowd, std::uint64_t seed, double duration, Measured& m) {
  const field::Field field = field::make_field(crowd.league);
  const auto solids = test_support::solids_around(field);
  Random random(seed);
  const auto world = world_of(start_of(crowd, field, random));
  Hunters hunters(crowd.robots, seed);
  std::vector<double> times;
  double energy = kinetic_energy(*world);
  for (int i = 0; i < static_cast<int>(duration / tick); ++i) {
    const auto& commands = hunters.commands(*world);
    const double begin = cpu_seconds();
    const simulator::TickEvents& events = world->advance(commands, tick);
    times.push_back(cpu_seconds() - begin);
    m.overlap = std::max({m.overlap, events.deepest_overlap, deepest_overlap(*world, solids)});
    m.most_events = std::max(m.most_events, events.events);
    m.stepped += events.stepped;
    m.not_finite += !is_finite(*world);
    const double now = kinetic_energy(*world);
    const double most = energy + tick * most_power(world->parameters(), commands);
    m.excess_energy = std::max(m.excess_energy, now - most);
    energy = now;
  }
  return times;
}

// A slow tick may be the machine's fault: the same ticks are played again, and the faster count.
void play_for_time(const Crowd& crowd, std::uint64_t seed, double duration, Measured& m) {
  const std::vector<double> first = play(crowd, seed, duration, m);
  Measured same;
  const std::vector<double> again = play(crowd, seed, duration, same);
  for (std::size_t k = 0; k < first.size(); ++k)
    m.worst_tick = std::max(m.worst_tick, std::min(first[k], again[k]));
}

// The same in ticks so short that the most work of the motors in one is known from the speeds at
// its ends, if nothing bounced in it. An impact that ends a series is no bounce, and changes the
// power somewhere in the tick: so the greater of both powers counts.
void play_finely(const Crowd& crowd, std::uint64_t seed, double duration, Measured& m) {
  constexpr int parts = 264;
  const double fine = tick / parts;
  const field::Field field = field::make_field(crowd.league);
  Random random(seed);
  const auto world = world_of(start_of(crowd, field, random));
  Hunters hunters(crowd.robots, seed);
  for (int i = 0; i < static_cast<int>(duration / tick); ++i) {
    const auto& commands = hunters.commands(*world);
    for (int k = 0; k < parts; ++k) {
      const double energy = kinetic_energy(*world);
      const double begin = power(*world, commands);
      const bool bounced = world->advance(commands, fine).impacts > 0;
      const double end = power(*world, commands);
      const double work =
          fine * (bounced ? most_power(world->parameters(), commands) : std::max(begin, end));
      m.excess_energy_fine = std::max(m.excess_energy_fine, kinetic_energy(*world) - energy - work);
    }
  }
}

// Returns the events of a tick of `coarse`. Catches a heap that is followed from bounce to bounce
// after a tick that ended in a step: that is 5 events.
double events_at_coarse(const Crowd& crowd) {
  constexpr int ticks = 300;
  constexpr int seeds = 3;
  const field::Field field = field::make_field(crowd.league);
  int events = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    Random random(seed);
    const auto world = world_of(start_of(crowd, field, random),
                                simulator::tolerances_of(simulator::Accuracy::coarse));
    Hunters hunters(crowd.robots, seed);
    for (int k = 0; k < ticks; ++k) events += world->advance(hunters.commands(*world), tick).events;
  }
  return static_cast<double>(events) / (seeds * ticks);
}

}  // namespace

Bars scrums(Size size) {
  Bars bars;
  const Crowd crowds[] = {{"six robots on the ball", RobotLeague::small, 6},
                          {"22 robots on the ball", RobotLeague::large, 22}};
  for (const Crowd& crowd : crowds) {
    Measured m;
    const bool large = crowd.robots > 6;
    const int seeds = cases(size, large ? 1 : 3, 100);
    for (int seed = 1; seed <= seeds; ++seed) {
      play_for_time(crowd, seed, size == Size::small ? 10.0 : 60.0, m);
    }
    for (int seed = 1; seed <= cases(size, 1, large ? 2 : 10); ++seed) {
      play_finely(crowd, seed, size == Size::small ? 1.0 : 10.0, m);
    }
    const std::string scene = crowd.name;
    bars.push_back({scene, "overlap, m", m.overlap, 1e-6});
    bars.push_back({scene, "energy above the motors' most work a tick, J", m.excess_energy, 0.0});
    // The error of the powers at both ends: h^3 / 12 of their second derivative.
    bars.push_back(
        {scene, "energy above the motors' work in 0.125 ms, J", m.excess_energy_fine, 2e-7});
    bars.push_back(
        {scene, "ticks with numbers that are not finite", static_cast<double>(m.not_finite), 0.0});
    bars.push_back({scene, "worst tick, CPU time, s", m.worst_tick, most_cpu_of_a_tick, true});
    bars.push_back(
        {scene, "most events in a tick", static_cast<double>(m.most_events), most_events_a_tick});
    bars.push_back({scene, "ticks with small steps", static_cast<double>(m.stepped), HUGE_VAL});
  }
  bars.push_back({crowds[0].name, "events in a tick of coarse", events_at_coarse(crowds[0]), 4.0});
  return bars;
}

}  // namespace mirocup::scenes
