// SPDX-License-Identifier: MIT
//
// A team that plays like a beginner's and makes one mistake, the one of mistakes.hpp whose number
// its parameter "mistake" is.
#include "tests/programs/check/teams/mistakes.hpp"

#include "mirocup/strategy.hpp"

#include <cassert>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <optional>
#include <random>
#include <sched.h>
#include <stdexcept>
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
  volatile unsigned char unset[64];
  return unset[40];
}

class Mistakes : public Team {
 public:
  explicit Mistakes(const Setup& setup)
      : Team(setup), mistake_(static_cast<Mistake>(static_cast<int>(parameter("mistake", 0.0)))) {
    if (mistake_ == Mistake::seed_of_time) std::srand(static_cast<unsigned>(std::time(nullptr)));
    if (mistake_ == Mistake::seed_of_process) std::srand(static_cast<unsigned>(getpid()));
    if (mistake_ == Mistake::thread) std::thread([] {}).join();
    if (mistake_ == Mistake::keeps_much_memory) kept_.resize(200u << 20, 'x');
    if (mistake_ == Mistake::asks_for_a_variable) log(std::getenv("TEAM_MODE") ? "set" : "not set");
  }

  void decide(const Observation& now, Command& command) override {
    for (int i = 0; i < now.robots; ++i)
      command.wheels[i] = drive_to(setup(), now.own[i], ball(now), 0.5);
    chance_.reset();
    make_mistake(now, command);
    if (chance_) answer_by(*chance_, command);
    own_score_ = now.own_score;
    opponent_score_ = now.opponent_score;
  }

  void place(const Observation& now, Placement& placement) override {
    if (mistake_ == Mistake::throws_in_place && now.tick > 300) throw std::out_of_range("places");
    if (mistake_ != Mistake::illegal_places) return;
    for (int i = 0; i < now.robots; ++i) placement.robots[i] = {0.0, 0.0, 0.0};
  }

 private:
  void make_mistake(const Observation& now, Command& command);
  void use_memory(std::uint32_t tick);

  Mistake mistake_;
  std::optional<std::uintptr_t> chance_;
  int own_score_ = 0;
  int opponent_score_ = 0;
  std::vector<char> kept_;
  std::vector<char*> leaked_;
};

void Mistakes::use_memory(std::uint32_t tick) {
  volatile std::size_t size = 24;
  auto* block = static_cast<volatile unsigned char*>(std::malloc(size));
  if (mistake_ == Mistake::heap_not_set) chance_ = block[size - 5];
  if (tick > 50 && mistake_ == Mistake::writes_behind) block[size] = 0;
  if (tick > 50 && mistake_ == Mistake::writes_before) block[-1] = 0;
  std::free(const_cast<unsigned char*>(block));
  if (mistake_ == Mistake::reads_freed) chance_ = block[size - 5];
  if (tick > 50 && mistake_ == Mistake::writes_freed) block[size - 5] = 1;
  if (tick > 50 && mistake_ == Mistake::frees_twice) std::free(const_cast<unsigned char*>(block));
}

void Mistakes::make_mistake(const Observation& now, Command& command) {
  const int goals = own_score_ + opponent_score_;
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
    case Mistake::throws_after_a_goal:
      if (now.own_score + now.opponent_score > goals) std::vector<int>(1).at(5) = 1;
      return;
    case Mistake::throws_in_a_shoot_out:
      if (now.phase == MIROCUP_SHOOT_OUT) throw std::runtime_error("shoot-out");
      return;
    case Mistake::slow: {
      const std::clock_t start = std::clock();
      while (std::clock() - start < 6 * CLOCKS_PER_SEC / 1000) {
      }
      return;
    }
    case Mistake::sleeps:
      std::this_thread::sleep_for(std::chrono::milliseconds(30));
      return;
    case Mistake::leaks:
      leaked_.push_back(new char[2u << 20]);
      for (std::size_t i = 0; i < 2u << 20; i += 4096) leaked_.back()[i] = 1;
      return;
    case Mistake::endless_loop:
      while (now.tick > late) zero = zero + 1;
      return;
    case Mistake::seed_of_time:
    case Mistake::seed_of_process:
      chance_ = static_cast<std::uintptr_t>(std::rand());
      return;
    case Mistake::random_device:
      chance_ = std::random_device()();
      return;
    case Mistake::address:
      chance_ = reinterpret_cast<std::uintptr_t>(this) >> 12;
      return;
    case Mistake::processor:
      chance_ = static_cast<std::uintptr_t>(sched_getcpu());
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
    case Mistake::throws_in_noexcept:
      throws_in_noexcept();
      return;
    case Mistake::assertion:
      std::abort();
    case Mistake::exits:
      std::exit(0);
    case Mistake::wild_pointer:
      *reinterpret_cast<volatile int*>(0x5000'0000'0000 + zero) = 1;
      return;
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
    case Mistake::never_moves:
      command = {};
      return;
    case Mistake::long_log:
      log("a line of a log that is much too long, in every tick of the leg, again and again");
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
    default:
      use_memory(static_cast<std::uint32_t>(now.tick));
  }
}

}  // namespace

MIROCUP_EXPORT_TEAM(Mistakes, "mistakes")
