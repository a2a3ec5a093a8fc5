// SPDX-License-Identifier: MIT
//
// A team that plays like a beginner's and makes one mistake, the one of mistakes.hpp whose number
// its parameter "mistake" is.
#include "tests/programs/check/teams/mistakes.hpp"

#include "mirocup/strategy.hpp"

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <time.h>
#include <unistd.h>
#include <vector>

namespace {

using namespace mirocup::strategy;
using mirocup::check_test::Mistake;

constexpr int late = 900;

int recursion(volatile int* depth) {
  volatile int frame[256];
  frame[0] = *depth + 1;
  return recursion(frame) + frame[0];
}

void throws_in_noexcept() noexcept {
  throw std::runtime_error("no route");
}

// Uses that much processor time, ms.
void burn(double ms) {
  const std::clock_t start = std::clock();
  while (std::clock() - start < ms * CLOCKS_PER_SEC / 1000) {
  }
}

// Gives each wheel one of seven speeds that follow from `number`. Two draws of a number give the
// same speeds once in 117 649 times, although slow and clamped wheels leave few values for each.
void answer_by(std::uintptr_t number, Command& command) {
  constexpr int speeds = 7;
  for (int i = 0; i < 3; ++i) {
    for (double* wheel : {&command.wheels[i].left, &command.wheels[i].right}) {
      *wheel = 2.0 * static_cast<double>(number % speeds);  // rad/s
      number /= speeds;
    }
  }
}

[[gnu::noinline]] std::uintptr_t never_set() {
  unsigned char unset[4096];                   // deeper than other calls of a tick reach
  asm volatile("" : : "r"(unset) : "memory");  // or the compiler would keep one byte of it only
  return unset[40];
}

// The number at that place of a vector, also behind its last.
[[gnu::noinline]] int beside(const std::vector<int>& numbers, volatile int index) {
  return numbers[static_cast<std::size_t>(index)];
}

double seconds_of(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

class Mistakes : public Team {
 public:
  explicit Mistakes(const Setup& setup)
      : Team(setup), mistake_(static_cast<Mistake>(static_cast<int>(parameter("mistake", 0.0)))) {
    if (mistake_ == Mistake::seed_of_time) std::srand(static_cast<unsigned>(std::time(nullptr)));
    if (mistake_ == Mistake::seed_of_process) std::srand(static_cast<unsigned>(getpid()));
    if (mistake_ == Mistake::thread) std::thread([] {}).join();
    if (mistake_ == Mistake::variable_that_is_missing)
      log(std::string(std::getenv("HOME")).c_str());
  }

  void decide(const Observation& now, Command& command) override {
    for (int i = 0; i < now.robots; ++i)
      command.wheels[i] = drive_to(setup(), now.own[i], ball(now), 0.5);
    chance_.reset();
    make_mistake(now, command);
    if (chance_) answer_by(*chance_, command);
  }

  void place(const Observation& now, Placement& placement) override {
    fail_at_a_restart(now);
    if (mistake_ == Mistake::throws_in_place && now.tick > 300) throw std::out_of_range("places");
    if (mistake_ != Mistake::illegal_places) return;
    for (int i = 0; i < now.robots; ++i) placement.robots[i] = {0.0, 0.0, 0.0};
  }

 private:
  void make_mistake(const Observation& now, Command& command);
  void use_memory(std::uint32_t tick);
  void steer(const Observation& now, Command& command);
  void fail_at_a_restart(const Observation& now) const;

  Mistake mistake_;
  std::optional<std::uintptr_t> chance_;
  std::vector<char*> leaked_;
  const Observation* last_ = nullptr;
  Point first_ball_;
  std::vector<int> marks_ = std::vector<int>(6, 1);
};

// Robot 0 keeps the goal, and the others steer to the ball.
void Mistakes::steer(const Observation& now, Command& command) {
  if (now.tick == 0) first_ball_ = ball(now);
  command.wheels[0] = keep_goal(setup(), now, now.own[0]);
  for (int i = 1; i < now.robots; ++i) {
    const Robot& robot = mistake_ == Mistake::drives_opponents
                             ? now.opponent[i]
                             : now.own[mistake_ == Mistake::robots_exchanged ? now.robots - i : i];
    Point at = mistake_ == Mistake::keeps_the_first_ball ? first_ball_ : ball(now);
    if (mistake_ == Mistake::ball_in_ticks) at = at + 15.0 * ball_velocity(now);
    Point to = at - position(robot) - Point{0.03, 0.0};
    if (mistake_ == Mistake::axes_exchanged) to = {to.y, to.x};
    double change = math::atan2(to.y, to.x) - robot.heading;
    if (mistake_ == Mistake::heading_offset) change -= pi / 2.0;
    const double error = mistake_ == Mistake::turns_unwrapped ? change : wrapped(change);
    const double sign = mistake_ == Mistake::wheels_negated ? -1.0 : 1.0;
    command.wheels[i] = wheels_for(setup(), sign * math::cos(error), 8.0 * sign * error);
  }
}

void Mistakes::use_memory(std::uint32_t tick) {
  volatile std::size_t size = 24;
  auto* block = static_cast<volatile unsigned char*>(std::malloc(size));
  if (mistake_ == Mistake::heap_not_set) chance_ = block[size - 5];
  // True with all memory but zeros: here it was used before.
  if (tick > 10 && mistake_ == Mistake::bool_not_set) chance_ = block[size - 5] != 0 ? 5 : 3;
  block[size - 5] = 1;
  if (tick > 50 && mistake_ == Mistake::writes_behind) block[size] = 0;
  std::free(const_cast<unsigned char*>(block));
  if (tick > 50 && mistake_ == Mistake::writes_freed) block[size - 5] = 1;
  if (tick > 50 && mistake_ == Mistake::frees_twice) std::free(const_cast<unsigned char*>(block));
}

void Mistakes::make_mistake(const Observation& now, Command& command) {
  volatile int zero = 0;
  switch (mistake_) {
    case Mistake::null_pointer_late:
      if (now.tick > late) *reinterpret_cast<volatile int*>(static_cast<std::uintptr_t>(zero)) = 1;
      return;
    case Mistake::throws_in_second_half:
      if (now.phase == MIROCUP_SECOND_HALF) throw std::runtime_error("second half");
      return;
    case Mistake::throws_when_trailing:
      if (now.own_score < now.opponent_score) throw std::logic_error("trailing");
      return;
    case Mistake::throws_in_a_shoot_out:
      if (now.phase == MIROCUP_SHOOT_OUT) throw std::runtime_error("shoot-out");
      return;
    case Mistake::slow:
      burn(6.0);
      return;
    case Mistake::a_little_slow:
      burn(1.5);
      return;
    case Mistake::sleeps:
      std::this_thread::sleep_for(std::chrono::milliseconds(30));
      return;
    case Mistake::leaks:
      leaked_.push_back(new char[2u << 20]);
      leaked_.back()[0] = 1;  // the limit counts addresses
      return;
    case Mistake::endless_loop:
      while (now.tick > late) zero = zero + 1;
      return;
    case Mistake::seed_of_time:
    case Mistake::seed_of_process:
      chance_ = static_cast<std::uintptr_t>(std::rand());
      return;
    case Mistake::address:
      chance_ = reinterpret_cast<std::uintptr_t>(this) >> 12;
      return;
    case Mistake::stack_not_set:
      chance_ = never_set();
      return;
    case Mistake::recursion:
      zero = recursion(&zero);
      return;
    case Mistake::division_by_zero:
      command.wheels[0].left = 100 / zero;
      return;
    case Mistake::writes_behind_command:
      reinterpret_cast<volatile char*>(&command)[sizeof command + 8] = 1;
      return;
    case Mistake::throws_a_text:
      throw "ball lost";
    case Mistake::throws_in_noexcept:
      throws_in_noexcept();
      return;
    case Mistake::exits:
      std::exit(0);
    case Mistake::writes_observation:
      const_cast<Observation&>(now).ball_x = 0.0;
      return;
    case Mistake::file: {
      std::ifstream map("map.txt");
      map.exceptions(std::ios::failbit);
      return;
    }
    case Mistake::bad_values:
      command.wheels[0].left = 1e9;
      return;
    case Mistake::not_finite:
      if (now.tick >= 20) command.wheels[1].left = std::sqrt(-1.0 - zero);
      return;
    case Mistake::wheels_exchanged:
    case Mistake::end_by_colour:
    case Mistake::wrong_end:
      for (int i = 0; i < now.robots; ++i) {
        const bool is_wrong = mistake_ == Mistake::wrong_end || setup().team == MIROCUP_YELLOW;
        const double end = is_wrong && mistake_ != Mistake::wheels_exchanged ? -1.0 : 1.0;
        const Wheels w = kick_to(setup(), now, now.own[i], {end * setup().half_length, 0.0});
        command.wheels[i] = mistake_ == Mistake::wheels_exchanged ? Wheels{w.right, w.left} : w;
      }
      return;
    case Mistake::targets_outside:
      for (int i = 0; i < now.robots; ++i)
        command.wheels[i] =
            drive_to(setup(), now.own[i], {setup().half_length + 0.5, now.own[i].y});
      return;
    case Mistake::never_moves:
      command = {};
      return;
    case Mistake::tries_a_file:
      if (now.tick == 10) log(std::ifstream("notes.txt") ? "read" : "not there");
      return;
    case Mistake::measures_time:
      (void)std::chrono::steady_clock::now();
      return;
    case Mistake::tries_a_thread:
      if (now.tick != 10) return;
      try {
        std::thread([] {}).join();
      } catch (const std::system_error& e) {
        log(e.what());
      }
      return;
    case Mistake::keeps_observation:
      if (last_ != nullptr) command.wheels[0].left += 100.0 * (now.ball_x - last_->ball_x);
      last_ = &now;
      return;
    case Mistake::reads_behind:
      chance_ = static_cast<unsigned>(beside(marks_, static_cast<int>(marks_.size())));
      return;
    case Mistake::thinks_by_the_clock: {
      const double begin = seconds_of(CLOCK_MONOTONIC);
      std::uintptr_t plans = 0;
      while (seconds_of(CLOCK_MONOTONIC) - begin < 100e-6) ++plans;
      chance_ = plans;
      return;
    }
    case Mistake::time_stamp_counter:
      chance_ = static_cast<std::uintptr_t>(__builtin_ia32_rdtsc());
      return;
    case Mistake::program: {
      if (now.tick != 10) return;
      char line[80];
      std::FILE* answer = popen("hostname", "r");
      (void)!std::fgets(line, sizeof line, answer);
      return;
    }
    case Mistake::as_yellow:
      if (setup().team == MIROCUP_YELLOW && now.tick > late) throw std::runtime_error("as yellow");
      return;
    case Mistake::throws_without_keeper:
      if (now.own_counts.keeper < 0) throw std::runtime_error("no keeper");
      return;
    case Mistake::one_robot_too_many:
      for (int i = 0; i <= now.robots; ++i)
        command.wheels[i] = drive_to(setup(), now.own[i], ball(now));
      return;
    case Mistake::turns_in_degrees:
      for (int i = 0; i < now.robots; ++i) {
        const double angle = atan2(now.ball_y - now.own[i].y, now.ball_x - now.own[i].x);
        command.wheels[i] = turn_to(setup(), now.own[i], angle * 180.0 / pi);
      }
      return;
    case Mistake::turns_unwrapped:
    case Mistake::axes_exchanged:
    case Mistake::robots_exchanged:
    case Mistake::wheels_negated:
    case Mistake::heading_offset:
    case Mistake::ball_in_ticks:
    case Mistake::keeps_the_first_ball:
    case Mistake::drives_opponents:
      steer(now, command);
      return;
    case Mistake::chance_without_seed: {
      static std::mt19937 engine;
      chance_ = engine() + static_cast<unsigned>(std::rand());
      return;
    }
    default:
      use_memory(static_cast<std::uint32_t>(now.tick));
  }
}

void Mistakes::fail_at_a_restart(const Observation& now) const {
  const auto fail_at = [&](Mistake mistake, int restart, int own) {
    if (mistake_ == mistake && now.restart == restart && now.own_restart == own)
      throw std::runtime_error("no place");
  };
  fail_at(Mistake::throws_at_own_penalty, MIROCUP_PENALTY_KICK, 1);
  fail_at(Mistake::throws_at_free_ball, MIROCUP_FREE_BALL, 1);
}

}  // namespace

MIROCUP_EXPORT_TEAM(Mistakes, "mistakes")
