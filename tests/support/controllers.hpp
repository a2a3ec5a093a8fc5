// SPDX-License-Identifier: MIT
//
// Controllers that run in the test's own process.
#pragma once

#include "core/base/random.hpp"
#include "core/match/leg.hpp"
#include "core/replay/recording.hpp"

#include <functional>
#include <utility>

namespace mirocup::test_support {

// A controller whose answers are those of a function of the observation.
class Scripted final : public match::Controller {
 public:
  using Script = std::function<match::Answer(const match::Observation&)>;
  explicit Scripted(Script script) : script_(std::move(script)) {}

  void post(const match::Observation& observation) override { observation_ = observation; }
  match::Answer collect() override { return script_(observation_); }

 private:
  Script script_;
  match::Observation observation_;
};

// Gives the same wheel speeds to all robots, rad/s.
inline match::Command both_wheels(double left, double right) {
  match::Command command;
  for (auto& wheels : command.wheels) wheels = {left, right};
  return command;
}

// Never moves.
inline Scripted idle_team() {
  return Scripted([](const match::Observation&) { return match::Command{}; });
}

// Drives at random, whatever it observes; the same seed gives the same commands.
inline Scripted random_team(std::uint64_t seed) {
  return Scripted([random = Random(seed), command = match::Command{}](
                      const match::Observation& o) mutable -> match::Answer {
    if (o.tick % 8 == 0) {
      for (auto& wheels : command.wheels) {
        wheels = {random.uniform(-60.0, 60.0), random.uniform(-60.0, 60.0)};
      }
    }
    return command;
  });
}

// Every robot turns towards the ball and drives at it.
inline Scripted ball_hunter() {
  return Scripted([](const match::Observation& o) -> match::Answer {
    match::Command command;
    for (int i = 0; i < o.robots; ++i) {
      const Vec2 to = o.ball - o.own[i].position;
      const Vec2 seen = Heading::from_angle(o.own[i].heading).to_body(to);
      const double turn = 20.0 * atan2(seen.y(), seen.x());
      command.wheels[i] = {40.0 - turn, 40.0 + turn};
    }
    return command;
  });
}

inline match::Setup short_setup(std::uint64_t seed, double half_s = 3.0,
                                RobotLeague league = RobotLeague::small) {
  match::Setup setup;
  setup.league = league;
  setup.rules.half_s = half_s;
  setup.seed = seed;
  return setup;
}

inline void play(match::Leg& leg, match::Controller& blue, match::Controller& yellow) {
  while (!leg.is_over()) leg.advance(blue, yellow);
}

// Plays a leg and returns its recording with the states of all ticks.
inline replay::Recording played_and_traced(match::Leg& leg, match::Controller& blue,
                                           match::Controller& yellow) {
  replay::StateTrace trace;
  while (!leg.is_over()) {
    leg.advance(blue, yellow);
    trace.add(leg);
  }
  return replay::record(leg, trace);
}

}  // namespace mirocup::test_support
