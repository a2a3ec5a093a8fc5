// SPDX-License-Identifier: MIT
#include "plugins/host/team_clocks.hpp"

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <dlfcn.h>
#include <optional>
#include <sys/time.h>

namespace mirocup::plugins {

namespace {

constexpr std::int64_t second = 1'000'000'000;  // ns
constexpr time_t for_ever = 4'000'000'000;      // s: longer than any leg, and few enough as ns

// A global variable, because the functions below get no pointer of ours. All in ns.
struct Shown {
  std::int64_t to_time_of_day = 0;  // is added to CLOCK_MONOTONIC
  std::int64_t to_uptime = 0;
  std::int64_t passed = 0;  // besides, on every clock
  std::int64_t between_calls = 0;
  std::int64_t each_reading = 0;
  std::int64_t at_start = 0;  // what CLOCK_MONOTONIC showed at start_clocks()
};
Shown shown;

std::int64_t to_ns(const timespec& t) {
  return t.tv_sec * second + t.tv_nsec;
}

timespec to_timespec(std::int64_t ns) {
  return {ns / second, ns % second};
}

// The C library's own functions, which those below hide from the team.
int real_clock_gettime(clockid_t clock, timespec* now) {
  static const auto real =
      reinterpret_cast<int (*)(clockid_t, timespec*)>(dlsym(RTLD_NEXT, "clock_gettime"));
  return real(clock, now);
}

int real_clock_nanosleep(clockid_t clock, int flags, const timespec* time, timespec* rest) {
  static const auto real = reinterpret_cast<int (*)(clockid_t, int, const timespec*, timespec*)>(
      dlsym(RTLD_NEXT, "clock_nanosleep"));
  return real(clock, flags, time, rest);
}

// ns
std::int64_t monotonic() {
  timespec now{};
  real_clock_gettime(CLOCK_MONOTONIC, &now);
  return to_ns(now);
}

// Returns what the clock shows more than CLOCK_MONOTONIC, ns; nothing for a clock of processor
// time.
std::optional<std::int64_t> offset_of(clockid_t clock) {
  switch (clock) {
    case CLOCK_REALTIME:
    case CLOCK_REALTIME_COARSE:
    case CLOCK_REALTIME_ALARM:
    case CLOCK_TAI:
      return shown.to_time_of_day;
    case CLOCK_MONOTONIC:
    case CLOCK_MONOTONIC_RAW:
    case CLOCK_MONOTONIC_COARSE:
    case CLOCK_BOOTTIME:
    case CLOCK_BOOTTIME_ALARM:
      return shown.to_uptime;
    default:
      return std::nullopt;
  }
}

}  // namespace

void start_clocks(const ClockReadings& readings) {
  // A clock that counts its readings begins with the same number in each leg.
  shown.at_start = readings.each_reading != 0 ? 0 : monotonic();
  shown.to_time_of_day = readings.time_of_day * second - shown.at_start;
  shown.to_uptime = -std::min(readings.uptime_behind * second, shown.at_start);
  shown.between_calls = readings.between_calls;
  shown.each_reading = readings.each_reading;
}

void pass_time_between_calls() {
  shown.passed += shown.between_calls;
}

}  // namespace mirocup::plugins

// The program exports these, so that the libraries which it loads find them before those of the C
// library.
extern "C" {

int clock_gettime(clockid_t clock, timespec* now) noexcept {
  using namespace mirocup::plugins;
  const auto offset = offset_of(clock);
  if (!offset && real_clock_gettime(clock, now) != 0) return -1;
  shown.passed += shown.each_reading;
  std::int64_t measured = offset ? monotonic() : to_ns(*now);
  if (shown.each_reading != 0) measured = offset ? shown.at_start : 0;
  *now = to_timespec(measured + offset.value_or(0) + shown.passed);
  return 0;
}

std::clock_t clock() noexcept {
  timespec used{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
  return used.tv_sec * CLOCKS_PER_SEC + used.tv_nsec * CLOCKS_PER_SEC / mirocup::plugins::second;
}

time_t time(time_t* copy) noexcept {
  timespec now{};
  clock_gettime(CLOCK_REALTIME, &now);
  if (copy != nullptr) *copy = now.tv_sec;
  return now.tv_sec;
}

int gettimeofday(timeval* now, void* zone) noexcept {
  timespec precise{};
  clock_gettime(CLOCK_REALTIME, &precise);
  *now = {precise.tv_sec, precise.tv_nsec / 1000};
  if (zone != nullptr) *static_cast<struct timezone*>(zone) = {};
  return 0;
}

int timespec_get(timespec* now, int base) noexcept {
  if (base != TIME_UTC) return 0;
  clock_gettime(CLOCK_REALTIME, now);
  return base;
}

// A sleep until a time of a clock becomes a sleep for the time that is left.
int clock_nanosleep(clockid_t clock, int flags, const timespec* time, timespec* rest) {
  using namespace mirocup::plugins;
  const auto offset = offset_of(clock);
  if (!offset || (flags & TIMER_ABSTIME) == 0)
    return real_clock_nanosleep(clock, flags, time, rest);
  if (time->tv_nsec < 0 || time->tv_nsec >= second) return EINVAL;
  const timespec soon{std::clamp<time_t>(time->tv_sec, 0, for_ever), time->tv_nsec};
  const std::int64_t left = to_ns(soon) - monotonic() - *offset - shown.passed;
  if (left <= 0) return 0;
  const timespec pause = to_timespec(left);
  return real_clock_nanosleep(CLOCK_MONOTONIC, 0, &pause, nullptr);
}

}  // extern "C"
