// SPDX-License-Identifier: MIT
#include "mirocup/strategy.hpp"

#include <chrono>
#include <future>
#include <mutex>
#include <random>
#include <system_error>
#include <thread>

namespace {

using namespace mirocup::strategy;

class Honest : public Team {
 public:
  using Team::Team;
  void decide(const Observation& now, Command& command) override {
    // Falls back if there are no threads; chance and clocks are there, if not wise.
    try {
      std::async(std::launch::async, [] {}).get();
    } catch (const std::system_error&) {
      if (now.tick == 0) log("without threads");
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    std::random_device device;
    std::mt19937_64 generator(setup().seed + 0 * device());
    const auto begin = std::chrono::steady_clock::now();
    std::this_thread::sleep_for(std::chrono::microseconds(10));
    if (std::chrono::steady_clock::now() < begin) return;
    command.wheels[0] = {static_cast<double>(generator() % 30), 10.0};
  }

 private:
  std::mutex mutex_;
};

}  // namespace

MIROCUP_EXPORT_TEAM(Honest, "honest")
