// SPDX-License-Identifier: MIT
//
// The speed of training: what a step of a whole environment costs, beside the tick of `mirocup
// bench` and beside the engine of rSim. build/training_bench prints a table with ratios; all
// contenders are timed in turn, so that other programs disturb them alike.
//
//   build/training_bench [--rounds N] [--quick] [--json]
//   build/training_bench --steps N [--matches M] [--yellow TEAM]   plays steps once, for callgrind
#include "labs/bench/rsim_engine.hpp"
#include "labs/bench/scenes.hpp"
#include "mirocup/training.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

using namespace mirocup;
using namespace mirocup::bench;

namespace {

double seconds_of(clockid_t clock) {
  timespec now;
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double cpu_seconds() {
  return seconds_of(CLOCK_THREAD_CPUTIME_ID);
}

double wall_seconds() {
  return seconds_of(CLOCK_MONOTONIC);
}

// A batch with its buffers and random actions.
class Environment {
 public:
  Environment(int matches, int threads, const std::string& yellow, double range = 1.0) {
    const nlohmann::json configuration{{"matches", matches},      {"threads", threads},
                                       {"league", "small"},       {"conditions", "hall"},
                                       {"blue", "agent"},         {"yellow", yellow},
                                       {"autoreset", "same_step"}};
    char error[500] = "";
    training_ = mirocup_training_create(configuration.dump().c_str(), error, sizeof error);
    if (training_ == nullptr) {
      std::fprintf(stderr, "training_bench: %s\n", error);
      std::exit(3);
    }
    const auto size = *mirocup_training_get_sizes(training_);
    const auto rows = static_cast<std::size_t>(size.rows);
    numbers_ = rows * static_cast<std::size_t>(size.action);
    observations_.resize(rows * static_cast<std::size_t>(size.observation));
    final_observations_.resize(observations_.size());
    terms_.resize(rows * static_cast<std::size_t>(size.terms));
    rewards_.resize(rows);
    ends_.resize(2 * rows);
    matches_ = size.matches;
    // Actions are drawn before they are timed: a learner's own time does not count.
    Random random(7);
    for (auto& actions : actions_) {
      actions.resize(numbers_);
      for (float& a : actions) a = static_cast<float>(range * random.uniform(-1.0, 1.0));
    }
    bind(0);
    if (mirocup_training_reset(training_, nullptr, nullptr) != 0) std::exit(3);
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;
  ~Environment() { mirocup_training_destroy(training_); }

  int matches() const { return matches_; }

  // Plays steps of all matches.
  void play(int steps) {
    for (int i = 0; i < steps; ++i) {
      bind(static_cast<std::size_t>(step_++) % actions_.size());
      if (mirocup_training_step(training_) != 0) {
        std::fprintf(stderr, "training_bench: %s\n", mirocup_training_error(training_));
        std::exit(3);
      }
    }
  }

 private:
  void bind(std::size_t actions) {
    const std::size_t rows = rewards_.size();
    const mirocup_training_buffers buffers{.size = sizeof buffers,
                                           .actions = actions_[actions].data(),
                                           .observations = observations_.data(),
                                           .rewards = rewards_.data(),
                                           .terminations = ends_.data(),
                                           .truncations = ends_.data() + rows,
                                           .final_observations = final_observations_.data(),
                                           .terms = terms_.data(),
                                           .statistics = nullptr};
    mirocup_training_bind(training_, &buffers);
  }

  mirocup_training* training_ = nullptr;
  int matches_ = 0;
  int step_ = 0;
  std::size_t numbers_ = 0;
  std::array<std::vector<float>, 61> actions_;  // not a divisor of an episode
  std::vector<float> observations_, final_observations_, terms_, rewards_;
  std::vector<std::uint8_t> ends_;
};

// Something that is timed: each round gives the seconds of a unit of work.
struct Timed {
  std::string name;
  std::function<double()> round;
  std::vector<double> seconds;
};

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

// The median over the rounds of a's seconds divided by b's.
double ratio(const Timed& a, const Timed& b) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < a.seconds.size(); ++i) ratios.push_back(a.seconds[i] / b.seconds[i]);
  return median(ratios);
}

double cpu_seconds_a_step(Environment& environment, int steps) {
  const double begin = cpu_seconds();
  environment.play(steps);
  return (cpu_seconds() - begin) / steps / environment.matches();
}

// Processes that divide the matches among themselves and start and end together, each with a number
// of threads. All play the same steps of the same episodes, however many processes and threads
// there are: a step from a kick-off costs less than one in a crowd.
double wall_seconds_of_processes(int processes, int threads, int matches, int steps) {
  int ready[2], go[2], done[2];
  if (pipe(ready) != 0 || pipe(go) != 0 || pipe(done) != 0) std::exit(5);
  const auto child = [&] {
    Environment environment(matches / processes, threads, "agent", 1.0 / 1.8);
    environment.play(20);
    char c = 0;
    (void)!write(ready[1], &c, 1);
    (void)!read(go[0], &c, 1);
    environment.play(steps);
    (void)!write(done[1], &c, 1);
    _exit(0);
  };
  for (int i = 0; i < processes; ++i) {
    if (fork() == 0) child();
  }
  char c = 0;
  for (int i = 0; i < processes; ++i) (void)!read(ready[0], &c, 1);
  const double begin = wall_seconds();
  for (int i = 0; i < processes; ++i) (void)!write(go[1], "g", 1);
  for (int i = 0; i < processes; ++i) (void)!read(done[0], &c, 1);
  const double seconds = wall_seconds() - begin;
  for (int i = 0; i < processes; ++i) wait(nullptr);
  for (const int* both : {ready, go, done}) {
    close(both[0]);
    close(both[1]);
  }
  return seconds / steps / matches;
}

// What training_python.py prints: microseconds a step, and the share of the C library in it. Zeros
// if Python or numpy is not there.
std::pair<double, double> through_python(const std::string& build) {
  const std::string script = MIROCUP_SOURCE_FOLDER "/labs/bench/training_python.py";
  const std::string command =
      "PYTHONPATH=" + build + "/python /usr/bin/python3 -B " + script + " 2>/dev/null";
  std::pair<double, double> figures{};
  std::FILE* const pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return figures;
  if (std::fscanf(pipe, "%lf %lf", &figures.first, &figures.second) != 2) figures = {};
  pclose(pipe);
  return figures;
}

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  }
  return "unknown processor";
}

}  // namespace

int main(int argc, char** argv) {
  int rounds = 7;
  bool quick = false, json = false;
  int steps_once = 0, matches_once = 64;
  std::string yellow_once = "agent";
  double range_once = 1.0;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto value = [&] { return i + 1 < argc ? argv[++i] : ""; };
    if (word == "--rounds") {
      rounds = std::max(1, std::atoi(value()));
    } else if (word == "--quick") {
      quick = true;
    } else if (word == "--json") {
      json = true;
    } else if (word == "--steps") {
      steps_once = std::atoi(value());
    } else if (word == "--matches") {
      matches_once = std::atoi(value());
    } else if (word == "--yellow") {
      yellow_once = value();
    } else if (word == "--range") {
      range_once = std::atof(value());
    } else {
      std::fputs(
          "usage: training_bench [--rounds N] [--quick] [--json]\n"
          "       training_bench --steps N [--matches M] [--yellow TEAM]\n",
          stderr);
      return 2;
    }
  }
  if (steps_once > 0) {
    Environment environment(matches_once, 1, yellow_once, range_once);
    std::printf("%.3f us a step\n", 1e6 * cpu_seconds_a_step(environment, steps_once));
    return 0;
  }
  if (quick) rounds = std::min(rounds, 3);
  const int steps = quick ? 100 : 300;

  Scene game;
  for (const Scene& scene : scenes(true)) {
    if (scene.kind == SceneKind::game) game = scene;
  }
  const auto contenders = own_contenders();
  const auto& standard =
      *std::find_if(contenders.begin(), contenders.end(),
                    [](const bench::Contender& c) { return c.point == "standard"; });
  const Play recorded = play(game, standard);

  // The game scene drives its wheels at up to 1 m/s; the whole range of the actions is 1.8 m/s, at
  // which wheels slide most of the time.
  constexpr double as_in_game = 1.0 / 1.8;
  Environment both(64, 1, "agent", as_in_game), one(64, 1, "idle", as_in_game),
      chaser(64, 1, "chaser", as_in_game), fast(64, 1, "agent"), many(1024, 1, "agent", as_in_game);
  RsimEngine rsim;
  std::vector<Timed> all{
      {"game tick of mirocup bench",
       [&] { return 1e-6 * time_round(game, recorded, standard); },
       {}},
      {"step, both teams learn", [&] { return cpu_seconds_a_step(both, steps); }, {}},
      {"step, against idle", [&] { return cpu_seconds_a_step(one, steps); }, {}},
      {"step, against chaser", [&] { return cpu_seconds_a_step(chaser, steps); }, {}},
      {"step, whole range of actions", [&] { return cpu_seconds_a_step(fast, steps); }, {}},
      {"step, 1024 matches", [&] { return cpu_seconds_a_step(many, steps / 10); }, {}},
      {"two threads, 1024 matches",
       [&] { return wall_seconds_of_processes(1, 2, 1024, steps / 5); },
       {}},
      {"two processes, 512 matches each",
       [&] { return wall_seconds_of_processes(2, 1, 1024, steps / 5); },
       {}},
      {"step of rSim's engine (25 ms)",
       [&] {
         const double begin = cpu_seconds();
         for (int i = 0; i < 40; ++i) rsim.step();
         return (cpu_seconds() - begin) / 40;
       },
       {}}};
  for (int round = 0; round <= rounds; ++round) {
    for (Timed& c : all) {
      const double seconds = c.round();
      if (round > 0) c.seconds.push_back(seconds);  // the first one warms up
    }
  }
  const auto [python_us, share] = through_python(MIROCUP_BUILD_FOLDER);
  const double to_game = ratio(all[1], all[0]);
  const double of_processes = ratio(all[7], all[6]);
  const double of_rsim = ratio(all[8], all[1]);
  if (json) {
    nlohmann::ordered_json report{{"processor", processor()}};
    for (const Timed& c : all) report["us"][c.name] = 1e6 * median(c.seconds);
    report["ratios"] = {{"step to game tick", to_game},
                        {"two threads to two processes", of_processes},
                        {"steps to those of rSim's engine", of_rsim},
                        {"C in a step through Python", share}};
    std::printf("%s\n", report.dump(1).c_str());
    return 0;
  }
  std::printf("%s, 3 a side, hall, referee, random actions; %d rounds, medians\n\n",
              processor().c_str(), rounds);
  std::printf("%-34s %10s %12s\n", "", "us", "1/s");
  for (const Timed& c : all) {
    const double s = median(c.seconds);
    std::printf("%-34s %10.2f %12.0f\n", c.name.c_str(), 1e6 * s, 1.0 / s);
  }
  std::printf("%-34s %10.2f %12.0f\n", "step through Python, 512 matches", python_us,
              1e6 / python_us);
  std::printf("\n%-52s %6.2f   (at most 2.5)\n", "step, both teams learn / game tick", to_game);
  std::printf("%-52s %6.2f   (at least 0.95)\n", "two threads / two processes", of_processes);
  if (RsimEngine::is_built_in()) {
    std::printf("%-52s %6.1f   (at least 60)\n", "steps / steps of rSim's engine", of_rsim);
  } else {
    std::printf("steps / steps of rSim's engine: built without ODE (libode-dev)\n");
  }
  std::printf("%-52s %6.2f   (at least 0.9)\n", "C / Python, 1024 environments", share);
  return 0;
}
