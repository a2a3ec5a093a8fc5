// SPDX-License-Identifier: MIT
//
// mirocup-bench: speed against error of the simulator and of the engines that people would use
// instead. `mirocup bench` runs it; labs/docs/bench.md describes the comparison.
#include "labs/bench/peer.hpp"
#include "labs/bench/report.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sched.h>
#include <unistd.h>

using namespace mirocup;
using namespace mirocup::bench;

namespace {

struct Options {
  bool quick = false;
  bool json = false;
  std::string plot;    // where the picture goes
  std::string engine;  // "": all
  std::string point;   // "": all
  std::string scene;   // not "": play this one once, for instructions.sh
  int rounds = 0;      // 0: as many as it takes
};

constexpr const char* usage =
    "usage: mirocup bench [--quick] [--json] [--plot FILE.svg] [--rounds N]\n"
    "                     [--engine NAME] [--point POINT]\n"
    "       mirocup bench --scene NAME --engine NAME --point POINT    plays it once\n";

bool parse(int argc, char** argv, Options& options) {
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto value = [&](std::string& to) {
      if (++i >= argc) return false;
      to = argv[i];
      return true;
    };
    if (word == "--quick") {
      options.quick = true;
    } else if (word == "--json") {
      options.json = true;
    } else if (word == "--plot") {
      if (!value(options.plot)) return false;
    } else if (word == "--engine") {
      if (!value(options.engine)) return false;
    } else if (word == "--scene") {
      if (!value(options.scene)) return false;
    } else if (word == "--point") {
      if (!value(options.point)) return false;
    } else if (word == "--rounds") {
      std::string number;
      if (!value(number) || (options.rounds = std::atoi(number.c_str())) < 1) return false;
    } else {
      return false;
    }
  }
  return true;
}

std::vector<Contender> contenders(const Options& options) {
  std::vector<Contender> all;
  for (const auto& some : {own_contenders(), box2d_contenders(), chipmunk_contenders(),
                           ode_contenders(), mujoco_contenders()}) {
    all.insert(all.end(), some.begin(), some.end());
  }
  std::erase_if(all, [&](const Contender& c) {
    const bool is_between = c.steps_per_tick != 0 && c.steps_per_tick != millisecond_steps &&
                            c.steps_per_tick != 8 && c.steps_per_tick != 1;
    return (!options.engine.empty() && c.engine != options.engine) ||
           (!options.point.empty() && c.point != options.point) ||
           (options.quick && options.point.empty() && is_between);
  });
  return all;
}

// Everything runs on one core, so that other programs disturb every contender alike.
void stay_on_this_core() {
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(sched_getcpu(), &one);
  sched_setaffinity(0, sizeof one, &one);
}

Report measure(const Options& options) {
  Report report;
  report.quick = options.quick;
  report.rounds = options.rounds > 0 ? options.rounds : options.quick ? 3 : 7;
  report.scenes = scenes(options.quick);
  const Moments alone = free_motion(options.quick ? 20 : 200);
  const Moments together = options.quick ? crowds(10, 1e-4) : crowds(100, 2e-5);
  report.yardstick_one = together.after_one;
  report.yardstick_five = together.after_all;
  for (Contender& contender : contenders(options)) {
    Row row{std::move(contender), {}, {}, {}, {}};
    for (const Scene& scene : report.scenes) {
      row.timings.push_back({{}, play(scene, row.contender)});
    }
    row.free = errors(alone, row.contender);
    row.crowd = errors(together, row.contender);
    row.shots = shots(row.contender);
    report.rows.push_back(std::move(row));
  }
  for (int round = 0; round < report.rounds; ++round) {
    for (std::size_t i = 0; i < report.scenes.size(); ++i) {
      for (Row& row : report.rows) {
        Timing& timing = row.timings[i];
        timing.rounds_us.push_back(time_round(report.scenes[i], timing.play, row.contender));
      }
    }
  }
  report.legs = play_legs(options.quick ? 1 : report.rounds);
  if (!options.quick) report.league = play_leagues();
  return report;
}

// Plays one scene once; prints how many ticks play_timed() played.
int play_once(const Options& options) {
  const auto all = contenders(options);
  const auto kind = from_string<SceneKind>(options.scene);
  if (!kind || all.size() != 1) {
    std::fprintf(stderr, "mirocup-bench: %s, %s, %s: no such scene, engine or point\n",
                 options.scene.c_str(), options.engine.c_str(), options.point.c_str());
    return 2;
  }
  for (const Scene& scene : scenes(true)) {
    if (scene.kind != *kind) continue;
    time_round(scene, play(scene, all.front()), all.front());
    std::printf("%d\n", scene.ticks * scene.repeats);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1 && std::strcmp(argv[1], "validate") == 0)
    return run_validation({argv + 2, argv + argc});
  Options options;
  if (!parse(argc, argv, options)) {
    std::fputs(usage, stderr);
    return argc == 2 && std::strcmp(argv[1], "--help") == 0 ? 0 : 2;
  }
  if (!options.scene.empty()) return play_once(options);
  if (contenders(options).empty()) {
    std::fprintf(stderr, "mirocup-bench: no engine \"%s\" with a point \"%s\" was built in\n",
                 options.engine.c_str(), options.point.c_str());
    return 2;
  }
  stay_on_this_core();
  // Engines that greet their users on standard output do so on standard error.
  const int out = dup(STDOUT_FILENO);
  dup2(STDERR_FILENO, STDOUT_FILENO);
  const Report report = measure(options);
  std::fflush(stdout);
  dup2(out, STDOUT_FILENO);
  std::fputs((options.json ? to_json(report) : to_text(report)).c_str(), stdout);
  if (!options.plot.empty() && !(std::ofstream(options.plot) << to_svg(report))) {
    std::fprintf(stderr, "mirocup-bench: %s cannot be written\n", options.plot.c_str());
    return 3;
  }
  return 0;
}
