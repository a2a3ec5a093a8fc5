// SPDX-License-Identifier: MIT
#include "tests/support/test_team.hpp"

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <ctime>
#include <mutex>
#include <pthread.h>
#include <thread>

namespace {

using namespace std::chrono;
using namespace std::chrono_literals;

// Runs f, and returns the milliseconds that passed on that clock.
template <class Clock, class F>
double milliseconds_of(F f) {
  const auto begin = Clock::now();
  f();
  return duration<double, std::milli>(Clock::now() - begin).count();
}

double processor_ms() {
  return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

bool is_processor_time(clockid_t clock) {
  timespec time{};
  if (clock_gettime(clock, &time) != 0) return false;
  const double ms =
      1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
  return std::fabs(ms - processor_ms()) < 50.0;
}

// Differences of time are true, waits for a time are as long as they should be, and the own
// processor time may be asked for in every way.
const char* first_wrong_clock() {
  const auto nap = [] { std::this_thread::sleep_for(3ms); };
  if (milliseconds_of<steady_clock>(nap) < 2.9) return "steady";
  if (milliseconds_of<system_clock>(nap) < 2.9) return "system";
  const auto until = [] {
    std::this_thread::sleep_until(steady_clock::now() + 3ms);
    std::this_thread::sleep_until(system_clock::now() + 3ms);
    timespec then{};
    clock_gettime(CLOCK_MONOTONIC, &then);
    then.tv_sec += (then.tv_nsec + 3'000'000) / 1'000'000'000;
    then.tv_nsec = (then.tv_nsec + 3'000'000) % 1'000'000'000;
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &then, nullptr);
  };
  if (milliseconds_of<steady_clock>(until) < 8.9) return "sleep_until";
  std::mutex mutex;
  std::condition_variable never;
  std::unique_lock lock(mutex);
  if (never.wait_for(lock, 1ms) != std::cv_status::timeout) return "wait_for";
  clockid_t own = 0;
  if (pthread_getcpuclockid(pthread_self(), &own) != 0 || !is_processor_time(own)) return "thread";
  if (clock_getcpuclockid(0, &own) != 0 || !is_processor_time(own)) return "process";
  if (!is_processor_time(CLOCK_PROCESS_CPUTIME_ID)) return "cpu";
  timespec resolution{};
  if (clock_getres(CLOCK_MONOTONIC, &resolution) != 0) return "resolution";
  return nullptr;
}

}  // namespace

void TestTeam::decide(const Observation& now, Command& command) {
  if (now.tick == 10) {
    const char* wrong = first_wrong_clock();
    setup().log(setup().host, wrong == nullptr ? "with clocks" : wrong);
  }
  command.wheels[1] = drive_to(setup(), now.own[1], {now.ball_x, now.ball_y});
}
