// SPDX-License-Identifier: MIT
//
// A team that plays like a beginner's and makes one mistake, the one of mistakes.hpp whose number
// its parameter "mistake" is.
#include "tests/programs/check/teams/mistakes.hpp"

#include "mirocup/strategy.hpp"

#include <array>
#include <cassert>
#include <chrono>
#include <clocale>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <limits>
#include <locale>
#include <memory>
#include <optional>
#include <random>
#include <sched.h>
#include <stdexcept>
#include <string>
#include <sys/socket.h>
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
  volatile unsigned char unset[64];
  return unset[40];
}

// What a student keeps between two ticks, half of it without a value.
struct Memories {
  double integral;
  double second_half_speed;
  const Observation* last = nullptr;
  std::vector<int> marks = std::vector<int>(6, 1);
  std::function<double()> speed_of_last_tick;
  unsigned char small = 0;
};

// The number that stands behind a vector's last, or before its first.
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
    if (mistake_ == Mistake::keeps_much_memory) kept_.resize(200u << 20, 'x');
    if (mistake_ == Mistake::variable_that_is_missing)
      log(std::string(std::getenv("HOME")).c_str());
    if (mistake_ == Mistake::locale) std::locale::global(std::locale("de_DE.UTF-8"));
    if (mistake_ == Mistake::sets_locale) std::setlocale(LC_ALL, "de_DE.UTF-8");
    if (mistake_ == Mistake::alarm) ::alarm(1);
    if (mistake_ == Mistake::asks_for_a_variable) log(std::getenv("TEAM_MODE") ? "set" : "not set");
  }

  void decide(const Observation& now, Command& command) override {
    for (int i = 0; i < now.robots; ++i)
      command.wheels[i] = drive_to(setup(), now.own[i], ball(now), 0.5);
    chance_.reset();
    make_mistake(now, command);
    read_wrongly(now, command);
    live_by_a_clock(now, command);
    ask_the_system(now);
    fail_in_some_state(now, command);
    do_no_harm(now, command);
    if (chance_) answer_by(*chance_, command);
    own_score_ = now.own_score;
    opponent_score_ = now.opponent_score;
  }

  void place(const Observation& now, Placement& placement) override {
    fail_at_a_restart(now);
    if (mistake_ == Mistake::throws_in_place && now.tick > 300) throw std::out_of_range("places");
    if (mistake_ == Mistake::places_in_degrees) placement.robots[1].heading = 90.0;
    if (mistake_ != Mistake::illegal_places) return;
    for (int i = 0; i < now.robots; ++i) placement.robots[i] = {0.0, 0.0, 0.0};
  }

 private:
  void make_mistake(const Observation& now, Command& command);
  void use_memory(std::uint32_t tick);
  void read_wrongly(const Observation& now, Command& command);
  void live_by_a_clock(const Observation& now, Command& command);
  void ask_the_system(const Observation& now);
  void fail_in_some_state(const Observation& now, Command& command);
  void fail_at_a_restart(const Observation& now) const;
  void do_no_harm(const Observation& now, Command& command);

  Mistake mistake_;
  std::optional<std::uintptr_t> chance_;
  int own_score_ = 0;
  int opponent_score_ = 0;
  std::vector<char> kept_;
  std::vector<char*> leaked_;
  std::unique_ptr<Memories> memories_{new Memories};  // () would set its numbers to 0
  double last_moment_ = 0.0;
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
    case Mistake::counts_processors:
      chance_ = std::thread::hardware_concurrency();
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

void Mistakes::read_wrongly(const Observation& now, Command& command) {
  Memories& kept = *memories_;
  switch (mistake_) {
    case Mistake::integral_not_set:
      kept.integral += 0.01 * now.ball_y;
      command.wheels[0].left += kept.integral;
      return;
    case Mistake::unset_in_second_half:
      if (now.phase == MIROCUP_SECOND_HALF) command.wheels[1].left = kept.second_half_speed;
      return;
    case Mistake::keeps_observation:
      if (kept.last != nullptr) command.wheels[0].left += 100.0 * (now.ball_x - kept.last->ball_x);
      kept.last = &now;
      return;
    case Mistake::reads_behind:
      chance_ = static_cast<unsigned>(beside(kept.marks, static_cast<int>(kept.marks.size())));
      return;
    case Mistake::reads_before:
      // What is left after a division has the sign of the number that is divided.
      chance_ = static_cast<unsigned>(beside(kept.marks, (static_cast<int>(now.tick % 2) - 1) % 6));
      return;
    case Mistake::grown_vector: {
      int& first = kept.marks.front();
      kept.marks.push_back(now.own_score);
      first = static_cast<int>(now.tick);  // where the vector was before it grew
      return;
    }
    case Mistake::dangling_capture: {
      if (kept.speed_of_last_tick) command.wheels[2].left = kept.speed_of_last_tick();
      const double speed = 10.0 * now.ball_x;
      kept.speed_of_last_tick = [&speed] { return speed; };
      return;
    }
    case Mistake::text_too_long: {
      const std::unique_ptr<char[]> text(new char[24]);
      std::sprintf(text.get(), "ball %f %f in tick %u", now.ball_x, now.ball_y, now.tick);
      return;
    }
    case Mistake::number_as_text: {
      const volatile std::uintptr_t number = now.tick + 1;
      char text[32];
      if (now.tick > late) std::snprintf(text, sizeof text, "%s", reinterpret_cast<char*>(number));
      return;
    }
    default:
      return;
  }
}

void Mistakes::live_by_a_clock(const Observation& now, Command& command) {
  const auto has_waited = [this](clockid_t clock) {
    const double moment = seconds_of(clock);
    if (last_moment_ == 0.0) last_moment_ = moment;
    return moment - last_moment_ > 2.0;
  };
  switch (mistake_) {
    case Mistake::derivative_by_the_clock: {
      const double moment = seconds_of(CLOCK_MONOTONIC);
      command.wheels[0].left += 1e-3 * now.own[0].y / (moment - last_moment_);
      last_moment_ = moment;
      return;
    }
    case Mistake::waits_by_the_clock:
      if (has_waited(CLOCK_MONOTONIC)) command.wheels[1] = {20.0, -20.0};
      return;
    case Mistake::waits_by_its_processor_time:
      if (last_moment_ == 0.0) last_moment_ = static_cast<double>(std::clock());
      if (static_cast<double>(std::clock()) - last_moment_ > 2.0 * CLOCKS_PER_SEC)
        command.wheels[1] = {20.0, -20.0};
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
    default:
      return;
  }
}

void Mistakes::ask_the_system(const Observation& now) {
  if (now.tick != 10) return;
  switch (mistake_) {
    case Mistake::program: {
      char line[80];
      std::FILE* answer = popen("hostname", "r");
      (void)!std::fgets(line, sizeof line, answer);
      return;
    }
    case Mistake::tries_a_program:
      log(std::system("hostname") == 0 ? "done" : "not done");
      return;
    case Mistake::tries_a_connection:
      log(socket(AF_INET, SOCK_STREAM, 0) < 0 ? "no connection" : "a connection");
      return;
    case Mistake::writes_a_file:
      std::ofstream("notes.txt") << "tick " << now.tick << std::endl;
      return;
    case Mistake::reads_input: {
      std::string line;
      std::getline(std::cin, line);
      return;
    }
    default:
      return;
  }
}

void Mistakes::fail_in_some_state(const Observation& now, Command&) {
  constexpr double near = 0.12;  // m
  switch (mistake_) {
    case Mistake::as_yellow:
      if (setup().team == MIROCUP_YELLOW && now.tick > late) throw std::runtime_error("as yellow");
      return;
    case Mistake::endless_angle:
      for (double angle = 1.0 / (now.tick > 200 ? 0.0 : 1.0); angle > pi;) angle -= 2.0 * pi;
      return;
    case Mistake::throws_in_a_corner:
      if (std::abs(now.ball_x) > setup().half_length - near &&
          std::abs(now.ball_y) > setup().half_width - near)
        throw std::runtime_error("in a corner");
      return;
    case Mistake::throws_without_keeper:
      if (now.own_counts.keeper < 0) throw std::runtime_error("no keeper");
      return;
    case Mistake::leaks_a_little: {
      constexpr std::size_t size = 100;
      leaked_.push_back(new char[size]);
      for (std::size_t i = 0; i < size; i += 64) leaked_.back()[i] = 1;
      return;
    }
    default:
      return;
  }
}

void Mistakes::fail_at_a_restart(const Observation& now) const {
  const auto fail_at = [&](Mistake mistake, int restart, int own) {
    if (mistake_ == mistake && now.restart == restart && now.own_restart == own)
      throw std::runtime_error("no place");
  };
  fail_at(Mistake::throws_at_own_penalty, MIROCUP_PENALTY_KICK, 1);
  fail_at(Mistake::throws_at_penalty_against, MIROCUP_PENALTY_KICK, 0);
  fail_at(Mistake::throws_at_own_free_kick, MIROCUP_FREE_KICK, 1);
  fail_at(Mistake::throws_at_free_kick_against, MIROCUP_FREE_KICK, 0);
  fail_at(Mistake::throws_at_own_goal_kick, MIROCUP_GOAL_KICK, 1);
  fail_at(Mistake::throws_at_goal_kick_against, MIROCUP_GOAL_KICK, 0);
  fail_at(Mistake::throws_at_free_ball, MIROCUP_FREE_BALL, 1);
}

void Mistakes::do_no_harm(const Observation& now, Command& command) {
  switch (mistake_) {
    case Mistake::not_a_number:
      command.wheels[0].left = 0.0 / (now.tick > 5 ? 0.0 : 1.0);
      return;
    case Mistake::small_counter:
      command.wheels[0].left += ++memories_->small;
      return;
    case Mistake::opponent_that_is_not_there:
      command.wheels[0].left += now.opponent[now.robots].x;
      return;
    case Mistake::one_robot_too_many:
      for (int i = 0; i <= now.robots; ++i)
        command.wheels[i] = drive_to(setup(), now.own[i], ball(now));
      return;
    case Mistake::one_wheel:
      for (int i = 0; i < now.robots; ++i) command.wheels[i] = {30.0, 0.0};
      return;
    case Mistake::turns_in_degrees:
      for (int i = 0; i < now.robots; ++i) {
        const double angle = atan2(now.ball_y - now.own[i].y, now.ball_x - now.own[i].x);
        command.wheels[i] = turn_to(setup(), now.own[i], angle * 180.0 / pi);
      }
      return;
    case Mistake::chance_without_seed: {
      static std::mt19937 engine;
      chance_ = engine() + static_cast<unsigned>(std::rand());
      return;
    }
    default:
      return;
  }
}

}  // namespace

MIROCUP_EXPORT_TEAM(Mistakes, "mistakes")
