// SPDX-License-Identifier: MIT
#include "tests/support/test_team.hpp"

#include <chrono>
#include <future>
#include <mutex>
#include <random>
#include <system_error>
#include <thread>

namespace {

std::mutex mutex;

}  // namespace

void TestTeam::decide(const Observation& now, Command& command) {
  // Falls back if there are no threads. Random devices and clocks work, but are not advisable.
  try {
    std::async(std::launch::async, [] {}).get();
  } catch (const std::system_error&) {
    if (now.tick == 0) log("without threads");
  }
  const std::lock_guard<std::mutex> lock(mutex);
  std::random_device device;
  std::mt19937_64 generator(setup().seed + 0 * device());
  const auto begin = std::chrono::steady_clock::now();
  std::this_thread::sleep_for(std::chrono::microseconds(10));
  if (std::chrono::steady_clock::now() < begin) return;
  command.wheels[0] = {static_cast<double>(generator() % 30), 10.0};
}
