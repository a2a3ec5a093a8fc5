// SPDX-License-Identifier: MIT
#include "labs/bench/peer.hpp"

#include "labs/pitch/report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <unistd.h>

namespace mirocup::bench {

namespace {

constexpr double step = 1e-3;           // s
constexpr double least_step = 1e-9;     // s, by which commands are looked up early
const Vec2 out_of_the_way{20.0, 20.0};  // m: of a ball that was not seen

// Plays a window as pitch::Peer says.
void play_window(const Contender& contender, const pitch::CameraLog& recording,
                 const pitch::Footage& footage, const pitch::Guess& guess,
                 const pitch::Window& window, const std::vector<simulator::BodyState>& states,
                 const pitch::Peer::See& see) {
  const bool has_ball = window.bodies.back() == footage.ball();
  const double usual = footage.usual_period();
  Start start;
  start.league = recording.league;
  start.parameters = guess.parameters;
  start.period = usual / std::max(1.0, std::round(usual / step));
  start.ball = {out_of_the_way, {0.0, 0.0}};
  for (std::size_t i = 0; i < states.size(); ++i) {
    const bool is_ball = has_ball && i + 1 == states.size();
    if (is_ball) {
      start.ball = {states[i].position, states[i].velocity()};
    } else {
      start.robots.push_back(states[i]);
    }
  }
  const auto engine = contender.make(start);
  // Robots whose commands are not known keep the speeds that they start with.
  Commands commands;
  for (const simulator::BodyState& robot : start.robots) {
    const double mean = robot.twist.forward / guess.parameters.wheel_radius;
    const double half =
        robot.twist.omega * guess.parameters.wheel_distance / (2.0 * guess.parameters.wheel_radius);
    commands.push_back(simulator::WheelSpeeds{mean - half, mean + half});
  }
  double t = footage.time(window.first);
  for (int frame = window.first + 1; frame <= window.last; ++frame) {
    while (t + 0.5 * start.period < footage.time(frame)) {
      for (std::size_t i = 0; i < commands.size(); ++i) {
        const auto& told = footage.told(window.bodies[i]);
        const auto next = std::upper_bound(
            told.begin(), told.end(), t - guess.command_delay + least_step,
            [](double time, const pitch::Footage::Told& command) { return time < command.t; });
        if (!told.empty())
          commands[i] = next == told.begin() ? simulator::WheelSpeeds{} : std::prev(next)->wheels;
      }
      engine->advance(commands);
      t += start.period;
    }
    for (std::size_t i = 0; i < states.size(); ++i) {
      const bool is_ball = has_ball && i + 1 == states.size();
      see(frame, i,
          is_ball ? engine->ball().position : engine->robot(static_cast<int>(i)).position);
    }
  }
}

struct Words {
  std::string against;
  pitch::ValidationRequest request;
};

std::optional<Words> parse(const std::vector<std::string>& words) {
  Words parsed;
  const std::map<std::string, std::string*> options{{"--against", &parsed.against},
                                                    {"--pitch", &parsed.request.pitch},
                                                    {"-o", &parsed.request.page}};
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--") {
      parsed.request.recordings.assign(words.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                       words.end());
      break;
    }
    const auto option = options.find(words[i]);
    if (words[i] == "--json") {
      parsed.request.json = true;
    } else if (option != options.end() && i + 1 < words.size()) {
      *option->second = words[++i];
    } else {
      return std::nullopt;
    }
  }
  if (parsed.against.empty() || parsed.request.recordings.empty()) return std::nullopt;
  return parsed;
}

}  // namespace

std::optional<Contender> peer_engine(const std::string& name, int steps) {
  const std::map<std::string, std::vector<Contender>> engines{{"box2d", box2d_contenders()},
                                                              {"chipmunk", chipmunk_contenders()},
                                                              {"ode", ode_contenders()}};
  const auto found = engines.find(name);
  if (found == engines.end()) return std::nullopt;
  for (const Contender& c : found->second) {
    if (c.steps_per_tick == steps) return c;
  }
  return std::nullopt;
}

std::optional<pitch::Peer> peer_of(const std::string& name) {
  const auto contender = peer_engine(name, 1);
  if (!contender) return std::nullopt;
  return pitch::Peer{name, [contender = *contender](const auto&... arguments) {
                       play_window(contender, arguments...);
                     }};
}

int run_validation(const std::vector<std::string>& words) {
  const auto parsed = parse(words);
  if (!parsed) {
    std::fputs(
        "usage: mirocup validate --against ENGINE [--pitch NAME|FILE] [-o PAGE] [--json] "
        "RECORDING...\n",
        stderr);
    return 2;
  }
  if (parsed->against != "box2d" && parsed->against != "chipmunk" && parsed->against != "ode") {
    std::fprintf(stderr, "mirocup: --against %s: engines are box2d, chipmunk and ode\n",
                 parsed->against.c_str());
    return 2;
  }
  const auto peer = peer_of(parsed->against);
  if (!peer) {
    std::fprintf(stderr,
                 "mirocup: --against %s: mirocup-bench is built without it, because its package of "
                 "cmake/packages-bench.txt was not installed then\n",
                 parsed->against.c_str());
    return 3;
  }
  // Engines that greet their users on standard output do so on standard error.
  const int out = dup(STDOUT_FILENO);
  dup2(STDERR_FILENO, STDOUT_FILENO);
  const auto report = pitch::report_of(parsed->request, &*peer);
  std::fflush(stdout);
  dup2(out, STDOUT_FILENO);
  close(out);
  if (!report) {
    std::fprintf(stderr, "mirocup: %s\n", report.error().what.c_str());
    return exit_code(report.error().code);
  }
  std::fputs(report->text.c_str(), stdout);
  return report->is_worse ? 1 : 0;
}

}  // namespace mirocup::bench
