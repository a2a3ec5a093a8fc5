// SPDX-License-Identifier: MIT
//
// sandbox_cost: the cost of the sandbox, with everything pinned to one core. It judges nothing.
//
// The same leg is played by turns in process and in each tier. The fastest round of each piece of
// the leg counts, so that other work on the machine disturbs little. Printed are microseconds of a
// tick (simulation and two teams), the same less the tick in process, and milliseconds from nothing
// to a team that is ready (median).
#include "core/match/leg.hpp"
#include "plugins/host/process_controller.hpp"
#include "plugins/host/sandbox/probe.hpp"
#include "plugins/host/trusted_controller.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <numeric>
#include <sched.h>
#include <string>
#include <vector>

using namespace mirocup;
using namespace mirocup::plugins;
using Clock = std::chrono::steady_clock;

namespace {

constexpr int rounds = 15;
constexpr int pieces = 60;
constexpr int ticks_of_piece = 30;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

struct Measured {
  double tick_us() const {
    return 1e6 * std::accumulate(fastest.begin(), fastest.end(), 0.0) / (pieces * ticks_of_piece);
  }

  std::vector<double> fastest = std::vector<double>(pieces, 1e9);  // s, of each piece
  std::vector<double> start_ms;
};

[[noreturn]] void give_up(const std::string& why) {
  std::fprintf(stderr, "sandbox_cost: %s\n", why.c_str());
  std::exit(exit_code(Errc::unavailable));
}

class Bench {
 public:
  Bench(std::string host_program, std::string library)
      : host_program_(std::move(host_program)),
        library_(std::move(library)),
        entry_(SealedEntry::open(library_)) {
    if (!entry_) give_up(entry_.error().what);
  }

  void play(Isolation isolation, Measured& measured) {
    match::Setup setup;
    setup.rules.half_s = 3600.0;
    match::Leg match(setup);
    const auto bell = std::make_shared<Doorbell>();
    const auto blue = seat(isolation, match.briefing(Team::blue), bell, measured);
    const auto yellow = seat(isolation, match.briefing(Team::yellow), bell, measured);
    for (double& fastest : measured.fastest) {
      const auto begin = Clock::now();
      for (int i = 0; i < ticks_of_piece; ++i) match.advance(*blue, *yellow);
      fastest = std::min(fastest, seconds_since(begin));
    }
  }

 private:
  std::unique_ptr<match::Controller> seat(Isolation isolation, const match::Briefing& briefing,
                                          const std::shared_ptr<Doorbell>& bell,
                                          Measured& measured) {
    const auto begin = Clock::now();
    if (isolation == Isolation::none) {
      auto controller = TrustedController::load(library_, briefing, {});
      if (!controller) give_up(controller.error().text);
      measured.start_ms.push_back(1e3 * seconds_since(begin));
      return std::move(*controller);
    }
    ProcessTerms terms;
    terms.isolation = isolation;
    terms.bell = bell;
    auto controller = ProcessController::start(host_program_, *entry_, briefing, {}, terms);
    if (!controller) give_up(controller.error().what);
    if (!(*controller)->wait_until_ready()) give_up("the team does not start");
    measured.start_ms.push_back(1e3 * seconds_since(begin));
    return std::move(*controller);
  }

  std::string host_program_;
  std::string library_;
  Result<SealedEntry> entry_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) give_up("usage: sandbox_cost MIROCUP-PLUGIN-HOST LIBRARY (with a slash in it)");
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(sched_getcpu(), &one);
  sched_setaffinity(0, sizeof one, &one);
  const auto strongest = strongest_isolation();
  if (!strongest) give_up(strongest.error().what);

  Bench bench(argv[1], argv[2]);
  std::vector<Measured> measured(static_cast<std::size_t>(*strongest) + 1);
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < measured.size(); ++i)
      bench.play(static_cast<Isolation>(i), measured[i]);
  }
  const double in_process = measured[0].tick_us();
  std::printf("%-9s %10s %10s %10s\n", "isolation", "tick us", "extra us", "start ms");
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const double tick = measured[i].tick_us();
    std::printf("%-9s %10.2f %10.2f %10.2f\n",
                std::string(to_string(static_cast<Isolation>(i))).c_str(), tick, tick - in_process,
                median(measured[i].start_ms));
  }
}
