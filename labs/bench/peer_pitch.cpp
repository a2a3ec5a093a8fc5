// SPDX-License-Identifier: MIT
//
// peer_pitch [ENGINE] [SECONDS] [SEED]: a pitch that another engine plays, identified.
//
// Two robots drive on a pitch that is not the default one. The engine plays them in steps of 1 ms,
// and a camera of 60 pictures a second records them. The first recording is identified. The second
// one, which was not fitted, is predicted with the default pitch, with the identified one and with
// the one that the engine was given. With the last, what is off is the difference of the engines.
// Exit 0 if the identified pitch predicts better than the default one at every horizon.
#include "labs/bench/peer.hpp"
#include "labs/pitch/identify.hpp"
#include "labs/pitch/validate.hpp"
#include "labs/tests/support/driven_pitch.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace {

using namespace mirocup;
using test_support::driven_robots;

constexpr double period = 1.0 / 60.0;  // s
constexpr int steps_of_picture = 16;   // of 1.04 ms
constexpr double episode = 10.0;       // s: then everything is put down anew
constexpr double pause = 1.0;          // s, without pictures

// Robots in their halves and a ball that rolls, apart from each other and from the walls.
bench::Start random_start(const simulator::Parameters& parameters, Random& random) {
  bench::Start start;
  start.league = RobotLeague::small;
  start.parameters = parameters;
  start.period = period;
  for (int i = 0; i < driven_robots; ++i) {
    const double x = (i == 0 ? -1.0 : 1.0) * random.uniform(0.25, 0.5);
    const double y = random.uniform(-0.4, 0.4);
    start.robots.push_back({{x, y}, Heading::from_angle(random.uniform(-pi, pi)), {}});
  }
  const double y = random.uniform(-0.4, 0.4);
  const Vec2 direction = Heading::from_angle(random.uniform(-pi, pi)).forward();
  start.ball = {{random.uniform(-0.1, 0.1), y}, random.uniform(0.5, 1.8) * direction};
  return start;
}

pitch::CameraLog recording_of(const bench::Contender& contender,
                              const simulator::Parameters& parameters, double seconds,
                              std::uint64_t seed) {
  Random random(seed);
  pitch::CameraLog recording;
  recording.path = contender.engine;
  recording.robots = 1;
  recording.period = period;
  for (double begin = 0.0; begin < seconds; begin += episode + pause) {
    const auto engine = contender.make(random_start(parameters, random));
    test_support::Driver driver(std::min(70.0, parameters.wheel_speed_limit));
    for (double t = 0.0; t < episode; t += period) {
      const test_support::DrivenStates robots{engine->robot(0), engine->robot(1)};
      const auto wheels = driver.at(t, robots, engine->ball().position, random);
      pitch::Frame frame;
      frame.t = begin + t;
      frame.ball = engine->ball().position;
      for (int i = 0; i < driven_robots; ++i) {
        frame.robots[i].push_back(pitch::SeenPose{robots[i].position, robots[i].heading.angle()});
        frame.commands[i].push_back(wheels[i]);
      }
      recording.frames.push_back(std::move(frame));
      const bench::Commands commands(wheels.begin(), wheels.end());
      engine->advance(commands);
    }
  }
  pitch::CameraNoise noise;
  noise.seed = seed + 1000;
  pitch::look_through(noise, recording);
  return recording;
}

struct Predicted {
  const char* name;
  pitch::Validation validation;
};

// Of all kinds of events together, m. Their predictions are the same for every pitch.
double error_of(const pitch::Validation& v, std::size_t horizon) {
  double square = 0.0, count = 0.0;
  for (const auto& cells : v.cells) {
    const pitch::ErrorCell& cell = cells[horizon];
    square += cell.count * cell.rms[0] * cell.rms[0];
    count += cell.count;
  }
  return std::sqrt(square / std::max(1.0, count));
}

void print_row(const char* kind, const char* name, const auto& error, const auto& count) {
  std::printf("%-16s %-11s", kind, name);
  for (std::size_t h = 0; h < pitch::horizons.size(); ++h) std::printf(" %8.2f", 1e3 * error(h));
  std::printf("   of");
  for (std::size_t h = 0; h < pitch::horizons.size(); ++h) std::printf(" %d", count(h));
  std::printf("\n");
}

void print_errors(const std::vector<Predicted>& all) {
  std::printf("\nerrors in mm, pictures ahead:");
  for (const int h : pitch::horizons) std::printf(" %d", h);
  std::printf("\n");
  for (std::size_t kind = 0; kind < enum_names<pitch::EventKind>.size(); ++kind) {
    for (const Predicted& p : all) {
      const auto& cells = p.validation.cells[kind];
      print_row(
          std::string(enum_names<pitch::EventKind>[kind]).c_str(), p.name,
          [&](std::size_t h) { return cells[h].rms[0]; },
          [&](std::size_t h) { return cells[h].count; });
    }
  }
  for (const Predicted& p : all) {
    print_row(
        "all", p.name, [&](std::size_t h) { return error_of(p.validation, h); },
        [&](std::size_t h) {
          int count = 0;
          for (const auto& cells : p.validation.cells) count += cells[h].count;
          return count;
        });
  }
}

void print_numbers(const pitch::Guess& truth, const pitch::Identified& found) {
  std::printf("%-26s %10s %10s   interval of 95 %%\n", "", "given", "found");
  for (int u = 0; u < pitch::unknown_count; ++u) {
    const pitch::Unknown& unknown = pitch::unknowns()[u];
    const double value = value_of(truth, u);
    if (!found.known[u]) {
      std::printf("%-26s %10.4g %10s   %s\n", std::string(unknown.name).c_str(),
                  unknown.is_ratio ? std::exp(value) : value, "-", found.why_not[u].c_str());
      continue;
    }
    const pitch::Estimate& e = *found.known[u];
    std::printf("%-26s %10.4g %10.4g   %.4g to %.4g\n", std::string(unknown.name).c_str(),
                unknown.is_ratio ? std::exp(value) : value, e.value, e.low, e.high);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::string name = argc > 1 ? argv[1] : "chipmunk";
  const double seconds = argc > 2 ? std::atof(argv[2]) : 60.0;
  const std::uint64_t seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 5;
  const auto contender = bench::peer_engine(name, steps_of_picture);
  if (!contender) {
    std::fprintf(stderr, "peer_pitch: no engine \"%s\" (box2d, chipmunk, ode) was built in\n",
                 name.c_str());
    return 3;
  }
  // The peers' motors have one lag.
  pitch::Guess truth = test_support::random_pitch(seed);
  truth.parameters.turn_time_constant = truth.parameters.brake_time_constant = 0.0;
  truth.command_delay = 0.0;
  const auto fitted = recording_of(*contender, truth.parameters, seconds, seed);
  const auto unseen = recording_of(*contender, truth.parameters, seconds, seed + 1);
  const auto found = pitch::identify({fitted}, {});
  if (!found) {
    std::fprintf(stderr, "peer_pitch: %s\n", found.error().what.c_str());
    return 5;
  }
  std::printf("%s, %.0f s, pitch %llu: %d windows, %d left out, noise %.2f mm\n", name.c_str(),
              seconds, static_cast<unsigned long long>(seed), found->windows, found->unexplained,
              1e3 * found->position_noise.value);
  truth.parameters.turn_time_constant = truth.parameters.turn_lag();
  truth.parameters.brake_time_constant = truth.parameters.brake_lag();
  print_numbers(truth, *found);
  const std::vector<Predicted> all{{"default", pitch::validate({unseen}, {})},
                                   {"identified", pitch::validate({unseen}, found->guess)},
                                   {"given", pitch::validate({unseen}, truth)}};
  print_errors(all);
  for (const std::string& o : all[1].validation.objections) std::printf("%s\n", o.c_str());
  bool is_better = true;
  for (std::size_t h = 0; h < pitch::horizons.size(); ++h)
    is_better = is_better && error_of(all[1].validation, h) < error_of(all[0].validation, h);
  std::printf("the identified pitch predicts better than the default one at every horizon: %s\n",
              is_better ? "yes" : "no");
  return is_better ? 0 : 1;
}
